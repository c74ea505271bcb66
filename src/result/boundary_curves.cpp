#include "result/boundary_curves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "mesh/edge_bisection.h"

namespace ucvt {
namespace {

/// Turning by more makes a corner: 30 degrees, as its cosine.
constexpr double corner_cosine = 0.86602540378443865;

/// The boundary is looked at over no more than this part of a loop either way.
constexpr double shortest_loop = 6;

/// Sites of a loop, at least: fewer make no simplicial complex.
constexpr std::size_t least_sites = 3;

Position minus(const Position& a, const Position& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Position& a, const Position& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

const Position& at(const TriangleMesh& mesh, std::int32_t v) {
  return mesh.positions[static_cast<std::size_t>(v)];
}

double distance(const TriangleMesh& mesh, std::int32_t a, std::int32_t b) {
  const Position d = minus(at(mesh, b), at(mesh, a));
  return std::hypot(d[0], d[1], d[2]);
}

double cosine_between(const Position& in, const Position& out) {
  const double lengths = std::hypot(in[0], in[1], in[2]) * std::hypot(out[0], out[1], out[2]);
  return lengths > 0 ? dot(in, out) / lengths : 1;
}

/// A boundary loop as a closed curve.
class Loop {
 public:
  Loop(const TriangleMesh& mesh, const std::vector<std::int32_t>& vertices)
      : mesh_(mesh), vertices_(vertices) {
    for (std::size_t i = 0; i < size(); ++i) {
      length_ += edge(i);
    }
  }

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] double length() const { return length_; }

  /// Cosine of the turn at vertex i, seen from the points at the given distance along the loop; from
  /// the neighbours when these are farther.
  [[nodiscard]] double turn(std::size_t i, double reach) const {
    const Position& p = position(i);
    return cosine_between(minus(p, point(i, reach, size() - 1)), minus(point(i, reach, 1), p));
  }

  /// The sharpest turn, as its cosine, of the candidates within reach of vertex i along the loop.
  [[nodiscard]] double sharpest(std::size_t i, double reach,
                                const std::vector<double>& cosine) const {
    double least = cosine[i];
    for (const std::size_t step : {std::size_t{1}, size() - 1}) {
      double gone = 0;
      std::size_t j = i;
      for (std::size_t n = 0; n < size() && gone <= reach; ++n) {
        least = std::min(least, cosine[j]);
        gone += edge(step == 1 ? j : (j + step) % size());
        j = (j + step) % size();
      }
    }
    return least;
  }

 private:
  [[nodiscard]] const Position& position(std::size_t i) const {
    return at(mesh_, vertices_[i % size()]);
  }
  [[nodiscard]] double edge(std::size_t i) const {
    return distance(mesh_, vertices_[i], vertices_[(i + 1) % size()]);
  }

  /// The point at a distance from vertex i along the loop, forwards (step 1) or backwards (size - 1);
  /// the next vertex when that is farther.
  [[nodiscard]] Position point(std::size_t i, double reach, std::size_t step) const {
    const auto length_from = [&](std::size_t j) {
      return edge(step == 1 ? j : (j + step) % size());
    };
    double gone = length_from(i);
    std::size_t j = (i + step) % size();
    for (std::size_t n = 0; n < size() && gone + length_from(j) <= reach; ++n) {
      gone += length_from(j);
      j = (j + step) % size();
    }
    if (gone >= reach) {
      return position(j);
    }
    const Position &p = position(j), &q = position(j + step);
    const double s = (reach - gone) / length_from(j);
    return {p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]), p[2] + s * (q[2] - p[2])};
  }

  const TriangleMesh& mesh_;
  const std::vector<std::int32_t>& vertices_;
  double length_ = 0;
};

/// The corners of a loop, by number in it.
std::vector<std::size_t> corners_of(const Loop& loop, double spacing) {
  const double reach = std::min(spacing / 2, loop.length() / shortest_loop);
  std::vector<double> cosine(loop.size(), 1.0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop.turn(i, 0) < corner_cosine) {
      cosine[i] = loop.turn(i, reach);
    }
  }
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (cosine[i] < corner_cosine && cosine[i] == loop.sharpest(i, reach, cosine)) {
      out.push_back(i);
    }
  }
  return out;
}

/// Distance from the arc's first vertex to each.
std::vector<double> along(const TriangleMesh& mesh, const std::vector<std::int32_t>& arc) {
  std::vector<double> out{0};
  for (std::size_t i = 1; i < arc.size(); ++i) {
    out.push_back(out.back() + distance(mesh, arc[i - 1], arc[i]));
  }
  return out;
}

/// Into how many pieces each arc of a loop is cut.
std::vector<std::size_t> pieces_of(const TriangleMesh& mesh, const BoundaryCurves& curves,
                                   const std::vector<std::size_t>& loop, double spacing) {
  std::vector<std::size_t> pieces;
  std::size_t total = 0;
  for (const std::size_t a : loop) {
    const auto& arc = curves.arcs[a];
    const double wanted = std::round(along(mesh, arc).back() / spacing);
    const auto edges = static_cast<double>(arc.size() - 1);
    pieces.push_back(static_cast<std::size_t>(std::clamp(wanted, 1.0, edges)));
    total += pieces.back();
  }
  for (std::size_t i = 0; total < least_sites; i = (i + 1) % loop.size()) {
    if (pieces[i] + 1 < curves.arcs[loop[i]].size()) {
      ++pieces[i], ++total;
    }
  }
  return pieces;
}

}  // namespace

BoundaryCurves boundary_curves(const TriangleMesh& mesh, double spacing) {
  BoundaryCurves out;
  out.is_corner.resize(mesh.positions.size(), false);
  for (auto loop : boundary_loops(mesh)) {
    const std::size_t n = loop.size();
    const std::vector<std::size_t> corners = corners_of(Loop(mesh, loop), spacing);
    for (const std::size_t i : corners) {
      out.is_corner[static_cast<std::size_t>(loop[i])] = true;
    }
    const std::size_t first = corners.empty() ? 0 : corners.front();
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
    loop.push_back(loop.front());
    out.loops.emplace_back();
    for (std::size_t i = 0; i < n; ++i) {
      if (i == 0 || out.is_corner[static_cast<std::size_t>(loop[i])]) {
        out.loops.back().push_back(out.arcs.size());
        out.arcs.push_back({loop[i]});
      }
      out.arcs.back().push_back(loop[i + 1]);
    }
  }
  return out;
}

std::vector<std::vector<BoundarySite>> boundary_sites(const TriangleMesh& mesh,
                                                      const BoundaryCurves& curves,
                                                      double spacing) {
  std::vector<std::vector<BoundarySite>> out;
  for (const auto& loop : curves.loops) {
    out.emplace_back();
    const std::vector<std::size_t> pieces = pieces_of(mesh, curves, loop, spacing);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto& arc = curves.arcs[loop[k]];
      const std::vector<double> s = along(mesh, arc);
      std::size_t i = 0;
      for (std::size_t piece = 0; piece < pieces[k]; ++piece) {
        const double wanted =
            s.back() * static_cast<double>(piece) / static_cast<double>(pieces[k]);
        const std::size_t last = arc.size() - 1 - (pieces[k] - piece);
        i += piece > 0 ? 1 : 0;
        while (i < last && std::abs(s[i + 1] - wanted) <= std::abs(s[i] - wanted)) {
          ++i;
        }
        const bool fixed = curves.is_corner[static_cast<std::size_t>(arc[i])];
        out.back().push_back({arc[i], loop[k], fixed});
      }
    }
  }
  return out;
}

std::vector<std::int32_t> inner_sites(const TriangleMesh& mesh, const BoundaryCurves& curves,
                                      const std::vector<std::vector<BoundarySite>>& boundary,
                                      std::size_t n) {
  std::vector<std::vector<std::int32_t>> neighbours(mesh.positions.size());
  for (const Corners& f : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      neighbours[static_cast<std::size_t>(f[i])].push_back(f[(i + 1) % 3]);
      neighbours[static_cast<std::size_t>(f[(i + 1) % 3])].push_back(f[i]);
    }
  }
  std::vector<bool> allowed(mesh.positions.size(), true);
  for (const auto& arc : curves.arcs) {
    for (const std::int32_t v : arc) {
      allowed[static_cast<std::size_t>(v)] = false;
    }
  }
  using Entry = std::pair<double, std::int32_t>;
  std::vector<double> reached(mesh.positions.size(), HUGE_VAL);
  std::priority_queue<Entry> farthest;
  const auto spread_from = [&](std::int32_t site) {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    reached[static_cast<std::size_t>(site)] = 0;
    front.push({0, site});
    while (!front.empty()) {
      const auto [d, v] = front.top();
      front.pop();
      if (d > reached[static_cast<std::size_t>(v)]) {
        continue;
      }
      for (const std::int32_t w : neighbours[static_cast<std::size_t>(v)]) {
        const double through = d + distance(mesh, v, w);
        if (through < reached[static_cast<std::size_t>(w)]) {
          reached[static_cast<std::size_t>(w)] = through;
          front.push({through, w});
          if (allowed[static_cast<std::size_t>(w)]) {
            farthest.push({through, w});
          }
        }
      }
    }
  };
  for (const auto& loop : boundary) {
    for (const BoundarySite& site : loop) {
      spread_from(site.vertex);
    }
  }
  std::vector<std::int32_t> out;
  while (out.size() < n && !farthest.empty()) {
    const auto [d, v] = farthest.top();
    farthest.pop();
    if (d == reached[static_cast<std::size_t>(v)] && d > 0) {
      out.push_back(v);
      spread_from(v);
    }
  }
  return out;
}

Position nearest_on_arc(const TriangleMesh& mesh, const std::vector<std::int32_t>& arc,
                        const Position& p) {
  Position best{};
  double least = HUGE_VAL;
  for (std::size_t i = 1; i < arc.size(); ++i) {
    const Position &a = at(mesh, arc[i - 1]), &b = at(mesh, arc[i]);
    const Position side = minus(b, a);
    const double length2 = dot(side, side);
    const double s = length2 > 0 ? std::clamp(dot(minus(p, a), side) / length2, 0.0, 1.0) : 0;
    const Position q{a[0] + s * side[0], a[1] + s * side[1], a[2] + s * side[2]};
    const Position off = minus(p, q);
    if (dot(off, off) < least) {
      least = dot(off, off), best = q;
    }
  }
  return best;
}

}  // namespace ucvt
