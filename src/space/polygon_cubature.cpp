// The adaptive cubature of polygon_moments.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "space/polygon_moments.h"
#include "space/quadrature.h"

namespace ucvt {
namespace {

/// A triangle of the cubature: what the finest rule so far gave, and how far the last two differ.
struct Piece {
  std::array<Offset, 3> corner;
  ChordTriangle triangle;
  Moments value{};
  double error = 0;
  std::size_t level = 0;
  bool smooth = false;
};

/// Rules of the levels: the piece's value comes from degree[level + 1], its error from the
/// difference to degree[level].
constexpr std::array<int, 4> degree{6, 8, 12, 18};
constexpr std::size_t top_level = degree.size() - 2;
/// Pieces start below this squared chord where the space is curved.
constexpr double first_chord2 = 0.25;
/// Rounding of one piece's value: some tens of nodes, weights of 15 digits.
constexpr double piece_rounding = 2e-15;
/// The difference of two rules is the coarser one's error only where the finer is much better: in
/// 40,000 random trials the true error came to 1.4 times the sum of the differences at most.
constexpr double safety = 2;
constexpr double tightest_tolerance = 1e-14;

class Cubator {
 public:
  Cubator(Space s, const OffsetDensity& density, double height)
      : space_(s), density_(density), height_(height), reach_(std::sqrt(2 * height)) {}

  void add(const Piece& p) {
    const auto longest = longest_side(p);
    if (space_.kappa != 0 && p.triangle.chord2[longest] > first_chord2) {
      const auto [left, right] = halves(p, longest);
      add(left);
      add(right);
      return;
    }
    push(measured(p));
  }

  [[nodiscard]] Cubature run(const CubatureOptions& options) {
    const double tolerance = std::max(options.relative_tolerance, tightest_tolerance);
    while (error_ > tolerance * mass_ && evaluations_ < options.max_evaluations) {
      refine();
    }
    Cubature out;
    double error = 0;
    for (const Piece& p : pieces_) {
      out.moments += p.value;
      error += p.error;
    }
    out.error = error > 0 ? error / out.moments.m : 0;
    out.evaluations = evaluations_;
    out.converged = error_ <= tolerance * mass_;
    return out;
  }

 private:
  static bool less_urgent(const Piece& a, const Piece& b) { return a.error < b.error; }

  static std::size_t longest_side(const Piece& p) {
    const auto& c = p.triangle.chord2;
    return static_cast<std::size_t>(std::max_element(c.begin(), c.end()) - c.begin());
  }

  /// The two triangles on either side of the median to the middle of side i.
  [[nodiscard]] std::array<Piece, 2> halves(const Piece& p, std::size_t i) const {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Offset &a = p.corner[i], &b = p.corner[j], &c = p.corner[k];
    const auto& side2 = p.triangle.chord2;
    const double quarter = side2[i] / 4, root = std::sqrt(1 - space_.kappa * quarter);
    const double w = 1 / (2 * root), half2 = 2 * quarter / (1 + root);
    const Offset middle{w * (a.x + b.x), w * (a.y + b.y),
                        w * (a.h + b.h - 2 * quarter / (1 + root))};
    const double median2 = 2 * w * ((side2[j] + side2[k]) / 2 - half2);
    const double det = w * p.triangle.det;
    return {Piece{.corner = {a, middle, c}, .triangle = {{half2, median2, side2[k]}, det}},
            Piece{.corner = {middle, b, c}, .triangle = {{half2, side2[j], median2}, det}}};
  }

  [[nodiscard]] Moments apply(const Piece& p, int rule_degree) {
    const auto& rule = triangle_rule(rule_degree);
    const auto& c2 = p.triangle.chord2;
    const auto& [a, b, c] = p.corner;
    Moments out;
    for (const auto& [b0, b1, b2, weight] : rule) {
      const double f = b0 * b1 * c2[0] + b1 * b2 * c2[1] + b2 * b0 * c2[2];
      const double root = std::sqrt(1 - space_.kappa * f), w = 1 / root;
      const Offset at{w * (b0 * a.x + b1 * b.x + b2 * c.x), w * (b0 * a.y + b1 * b.y + b2 * c.y),
                      w * (b0 * a.h + b1 * b.h + b2 * c.h - f / (1 + root))};
      const double dm = weight * p.triangle.det / 2 * w * w * w * density_(at);
      out.m += dm;
      out.x += dm * at.x;
      out.y += dm * at.y;
      out.h += dm * at.h;
    }
    evaluations_ += static_cast<std::int64_t>(rule.size());
    return out;
  }

  /// Bound on the error of `p`, given a coarser `q`, relative to (1, r, r, r^2/2).
  [[nodiscard]] double bound(const Moments& p, const Moments& q) const {
    const double rounding = piece_rounding * std::abs(p.m);
    return rounding +
           safety * std::max({std::abs(p.m - q.m), std::abs(p.x - q.x) / reach_,
                              std::abs(p.y - q.y) / reach_, std::abs(p.h - q.h) / height_});
  }

  [[nodiscard]] Piece measured(Piece p) {
    const Moments coarse = apply(p, degree[0]);
    p.value = apply(p, degree[1]);
    p.error = bound(p.value, coarse);
    p.smooth = p.error < 1e-2 * std::abs(p.value.m);
    return p;
  }

  void push(const Piece& p) {
    error_ += p.error;
    mass_ += p.value.m;
    pieces_.push_back(p);
    std::push_heap(pieces_.begin(), pieces_.end(), less_urgent);
  }

  /// Betters the worst piece: by a rule of higher degree while that pays, else by halving it.
  void refine() {
    std::pop_heap(pieces_.begin(), pieces_.end(), less_urgent);
    Piece p = pieces_.back();
    pieces_.pop_back();
    error_ -= p.error;
    mass_ -= p.value.m;
    if (p.smooth && p.level < top_level) {
      ++p.level;
      const Moments finer = apply(p, degree[p.level + 1]);
      const double before = p.error;
      p.error = bound(finer, p.value);
      p.value = finer;
      p.smooth = p.error < before / 10;
      push(p);
      return;
    }
    for (const Piece& half : halves(p, longest_side(p))) {
      push(measured(half));
    }
  }

  Space space_;
  const OffsetDensity& density_;
  double height_, reach_;
  std::vector<Piece> pieces_;
  double error_ = 0, mass_ = 0;
  std::int64_t evaluations_ = 0;
};

}  // namespace

Cubature density_moments(Space s, std::span<const Offset> corners, const OffsetDensity& density,
                         const CubatureOptions& options) {
  const Moments uniform = uniform_moments(s, corners);
  if (uniform.m <= 0) {
    return {};
  }
  double height = 0;
  for (const Offset& c : corners) {
    height = std::max(height, c.h);
  }
  Cubator cubator(s, density, height);
  // About its centroid even a hemisphere is a fan of proper triangles.
  const Offset centre = centroid_anywhere(s, uniform);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Offset &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const ChordTriangle triangle{{chord2(s, centre, a), chord2(s, a, b), chord2(s, b, centre)},
                                 orientation(s, centre, a, b)};
    if (triangle.det > 0) {
      cubator.add({.corner = {centre, a, b}, .triangle = triangle});
    }
  }
  return cubator.run(options);
}

}  // namespace ucvt
