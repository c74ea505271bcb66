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

bool turns(const TriangleMesh& mesh, std::int32_t before, std::int32_t v, std::int32_t after) {
  const Position in = minus(at(mesh, v), at(mesh, before));
  const Position out = minus(at(mesh, after), at(mesh, v));
  const double lengths = std::hypot(in[0], in[1], in[2]) * std::hypot(out[0], out[1], out[2]);
  return lengths > 0 && dot(in, out) < corner_cosine * lengths;
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

BoundaryCurves boundary_curves(const TriangleMesh& mesh) {
  BoundaryCurves out;
  out.is_corner.resize(mesh.positions.size(), false);
  for (auto loop : boundary_loops(mesh)) {
    const std::size_t n = loop.size();
    std::size_t first = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (turns(mesh, loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n])) {
        out.is_corner[static_cast<std::size_t>(loop[i])] = true;
        first = std::min(first, i);
      }
    }
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first % n), loop.end());
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
