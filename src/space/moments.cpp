#include "space/moments.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "space/lane_moments.h"
#include "space/quadrature.h"

namespace ucvt {
namespace {

/// sum_{u<v} l_u l_v c_uv^2 of barycentric coordinates or of differences of them.
double chord_form(const ChordTriangle& t, double l0, double l1, double l2) {
  return l0 * l1 * t.chord2[0] + l1 * l2 * t.chord2[1] + l2 * l0 * t.chord2[2];
}

/// Triangles whose squared sides are all below `near_side2` stretch no piece by more than `near_stretch`.
constexpr double near_side2 = 0.1, near_stretch = 1.04;

/// Degree of the rule that resolves a piece of the given squared size (its longest side in the space,
/// roughly); 0 when the piece must be cut first.
///
/// The integrands are cubics times a power series in f = kappa chord_form <= size2/3, so a rule of
/// degree d leaves f^((d - 1)/2) times its quadrature error. The bounds were measured: with them errors
/// stay below 1e-11, relative to the mass and the piece's own size, with a twentieth of them below
/// 1e-13.
int degree_for(double size2) {
  struct Bound {
    double size2;
    int degree;
  };
  for (const Bound b : {Bound{8e-5, 5}, {1e-3, 6}, {1e-2, 8}, {0.15, 12}, {0.6, 18}}) {
    if (size2 < b.size2) {
      return b.degree;
    }
  }
  return 0;
}

constexpr double strict_bounds = 1.0 / 20;

constexpr int max_depth = 40;

/// Outside of these the fourth power of a chord is out of the range of doubles.
constexpr double tiny_chord = 1e-60, huge_chord = 1e60;

/// Four nodes of a rule.
struct LaneNodes {
  Lanes b0, b1, b2, weight;
};

/// triangle_rule(degree) by fours, filled up with nodes of weight zero. For the degrees of `degree_for`.
const std::vector<LaneNodes>& lane_rule(int degree) {
  static const auto rules = [] {
    std::array<std::vector<LaneNodes>, 19> all;
    for (const std::size_t d : {5, 6, 8, 12, 18}) {
      const auto& rule = triangle_rule(static_cast<int>(d));
      all[d].resize((rule.size() + 3) / 4);
      for (std::size_t i = 0; i < rule.size(); ++i) {
        LaneNodes& n = all[d][i / 4];
        n.b0[i % 4] = rule[i].b0, n.b1[i % 4] = rule[i].b1, n.b2[i % 4] = rule[i].b2;
        n.weight[i % 4] = rule[i].weight;
      }
    }
    return all;
  }();
  return rules[static_cast<std::size_t>(degree)];
}

double sum(const Lanes& v) {
  return (v[0] + v[1]) + (v[2] + v[3]);
}

/// Piece::one_rule for small triangles, where w is its power series: no root, no division.
template <int terms>
[[gnu::always_inline]] inline Weights add_series(const std::vector<LaneNodes>& rule, double kappa,
                                                 const ChordTriangle& t,
                                                 const std::array<double, 3>& rho, Barycentric a,
                                                 Barycentric b, Barycentric c) {
  const double jacobian =
      t.det / 2 * ((b.b1 - a.b1) * (c.b2 - a.b2) - (b.b2 - a.b2) * (c.b1 - a.b1));
  const std::array<Lanes, 3> chord2{Lanes{} + t.chord2[0], Lanes{} + t.chord2[1],
                                    Lanes{} + t.chord2[2]};
  const std::array<Lanes, 3> density{Lanes{} + rho[0], Lanes{} + rho[1], Lanes{} + rho[2]};
  LaneWeights w;
  for (const LaneNodes& q : rule) {
    const Lanes l1 = q.b0 * a.b1 + q.b1 * b.b1 + q.b2 * c.b1;
    const Lanes l2 = q.b0 * a.b2 + q.b1 * b.b2 + q.b2 * c.b2;
    add_nodes<terms>(kappa, chord2, density, {1 - l1 - l2, l1, l2}, q.weight * jacobian, w);
  }
  return {{sum(w.mu0), sum(w.mu1), sum(w.mu2)}, sum(w.excess)};
}

UCVT_WIDE Weights by_series(const std::vector<LaneNodes>& rule, double kappa,
                            const ChordTriangle& t, const std::array<double, 3>& rho, Barycentric a,
                            Barycentric b, Barycentric c) {
  return add_series<short_series>(rule, kappa, t, rho, a, b, c);
}

UCVT_WIDE Weights by_long_series(const std::vector<LaneNodes>& rule, double kappa,
                                 const ChordTriangle& t, const std::array<double, 3>& rho,
                                 Barycentric a, Barycentric b, Barycentric c) {
  return add_series<long_series>(rule, kappa, t, rho, a, b, c);
}

struct Piece {
  Space space;
  const ChordTriangle& triangle;
  const std::array<double, 3>& rho;
  double bounds = 1;  ///< part of the bounds of `degree_for` that is used

  [[nodiscard]] double stretch(Barycentric p) const {
    return 1 / (1 - space.kappa * chord_form(triangle, 1 - p.b1 - p.b2, p.b1, p.b2));
  }
  [[nodiscard]] double longest_side2() const {
    return std::max({triangle.chord2[0], triangle.chord2[1], triangle.chord2[2]});
  }
  [[nodiscard]] double size2(Barycentric a, Barycentric b, Barycentric c) const {
    if (space.kappa == 0) {
      return 0;
    }
    double w2 = near_stretch;
    if (longest_side2() > near_side2) {
      const Barycentric mid{(a.b1 + b.b1 + c.b1) / 3, (a.b2 + b.b2 + c.b2) / 3};
      w2 = std::max({stretch(a), stretch(b), stretch(c), stretch(mid)});
    }
    const auto side2 = [&](Barycentric p, Barycentric q) {
      const double d1 = q.b1 - p.b1, d2 = q.b2 - p.b2;
      return -chord_form(triangle, -d1 - d2, d1, d2);
    };
    return w2 * std::max({side2(a, b), side2(b, c), side2(c, a)});
  }
  [[nodiscard]] Weights one_rule(int degree, Barycentric a, Barycentric b, Barycentric c) const {
    const double kappa = space.kappa;
    const double jacobian =
        triangle.det / 2 * ((b.b1 - a.b1) * (c.b2 - a.b2) - (b.b2 - a.b2) * (c.b1 - a.b1));
    Weights out;
    for (const auto& q : triangle_rule(degree)) {
      const double l1 = q.b0 * a.b1 + q.b1 * b.b1 + q.b2 * c.b1;
      const double l2 = q.b0 * a.b2 + q.b1 * b.b2 + q.b2 * c.b2;
      const double l0 = 1 - l1 - l2;
      const double form = chord_form(triangle, l0, l1, l2);
      const double root = std::sqrt(1 - kappa * form), w = 1 / root;
      const double dm = q.weight * jacobian * w * w * w * (l0 * rho[0] + l1 * rho[1] + l2 * rho[2]);
      out.mu[0] += dm * w * l0;
      out.mu[1] += dm * w * l1;
      out.mu[2] += dm * w * l2;
      out.excess -= dm * w * form / (1 + root);
    }
    return out;
  }
  [[nodiscard]] Weights integrate(Barycentric a, Barycentric b, Barycentric c, int depth) const {
    const double side2 = space.kappa == 0 ? 0 : longest_side2();
    const int degree = degree_for(size2(a, b, c) / bounds);
    if (side2 < long_series_side2) {
      const auto& rule = lane_rule(degree);
      return side2 < short_series_side2 ? by_series(rule, space.kappa, triangle, rho, a, b, c)
                                        : by_long_series(rule, space.kappa, triangle, rho, a, b, c);
    }
    if (degree != 0 || depth == max_depth) {
      return one_rule(degree ? degree : 18, a, b, c);
    }
    const auto middle = [](Barycentric p, Barycentric q) {
      return Barycentric{(p.b1 + q.b1) / 2, (p.b2 + q.b2) / 2};
    };
    const Barycentric ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    Weights out = integrate(a, ab, ca, depth + 1);
    out += integrate(ab, b, bc, depth + 1);
    out += integrate(ca, bc, c, depth + 1);
    out += integrate(ab, bc, ca, depth + 1);
    return out;
  }
};

}  // namespace

double triangle_determinant(Space s, const std::array<double, 3>& chord) {
  std::array<double, 3> c = chord;
  std::sort(c.begin(), c.end(), std::greater<>());
  if ((c[0] > 0 && c[0] < tiny_chord) || (s.kappa == 0 && c[0] > huge_chord)) {
    // So small a triangle is flat in every space.
    const double unit = triangle_determinant({0}, {1, c[1] / c[0], c[2] / c[0]});
    return unit * c[0] * c[0];
  }
  // 16 Area^2 of the chord triangle; the order of the operations matters (Kahan 2014).
  const double heron = (c[0] + (c[1] + c[2])) * (c[2] - (c[0] - c[1])) * (c[2] + (c[0] - c[1])) *
                       (c[0] + (c[1] - c[2]));
  const double product = c[0] * c[1] * c[2];
  const double det2 = (heron - s.kappa * product * product) / 4;
  return det2 > 0 ? std::sqrt(det2) : 0;
}

Weights integrate_piece(Space s, const ChordTriangle& t, const std::array<double, 3>& rho,
                        Barycentric a, Barycentric b, Barycentric c) {
  return Piece{s, t, rho}.integrate(a, b, c, 0);
}

Weights integrate(Space s, const ChordTriangle& t, const std::array<double, 3>& rho) {
  return Piece{s, t, rho, strict_bounds}.integrate({0, 0}, {1, 0}, {0, 1}, 0);
}

}  // namespace ucvt
