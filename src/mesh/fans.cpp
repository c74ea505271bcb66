#include "mesh/fans.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "mesh/topology.h"

namespace ucvt {
namespace {

using Vector = std::array<double, 3>;

Vector difference(const Position& a, const Position& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// To length 1, without overflow; zero stays zero.
Vector unit(Vector v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  for (double& x : v) {
    x = length > 0 && std::isfinite(length) ? x / length : 0;
  }
  return v;
}

/// A face at an edge, seen along it from its lower to its higher vertex.
struct Wing {
  double angle_rad = 0;  ///< counterclockwise
  std::int32_t side = 0;
  bool inside_before = false;  ///< the inside of the surface lies clockwise of it
};

class Pairing {
 public:
  explicit Pairing(const TriangleMesh& mesh)
      : mesh_(mesh), turned_(analyze_topology(mesh).turned), twin_(3 * mesh.faces.size(), -1) {}

  void pair(std::int32_t a, std::int32_t b) {
    twin_[static_cast<std::size_t>(a)] = b;
    twin_[static_cast<std::size_t>(b)] = a;
  }

  void pair_crowd(std::span<const EdgeSide> sides) {
    std::vector<Wing> ring = wings(sides);
    ring = pair_round_the_inside(ring);
    // What is left has its insides before first; turned so that they come last, it pairs again.
    std::stable_partition(ring.begin(), ring.end(), [](const Wing& w) { return !w.inside_before; });
    ring = pair_round_the_inside(ring);
    for (std::size_t i = 0; i + 1 < ring.size(); i += 2) {
      pair(ring[i].side, ring[i + 1].side);
    }
  }

  std::vector<std::int32_t> take() { return std::move(twin_); }

 private:
  [[nodiscard]] std::vector<Wing> wings(std::span<const EdgeSide> sides) const {
    const std::int32_t first = sides[0].side;
    const std::int32_t low = std::min(side_tail(mesh_, first), side_head(mesh_, first));
    const std::int32_t high = std::max(side_tail(mesh_, first), side_head(mesh_, first));
    const auto at = [&](std::int32_t v) { return mesh_.positions[static_cast<std::size_t>(v)]; };
    const Position origin = at(low);
    const Vector axis = unit(difference(at(high), origin));
    const Vector x = unit(cross(axis, unit(difference(at(side_apex(mesh_, first)), origin))));
    const Vector y = cross(axis, x);
    std::vector<Wing> ring;
    for (const EdgeSide& s : sides) {
      const Vector to = unit(difference(at(side_apex(mesh_, s.side)), origin));
      const bool along = side_tail(mesh_, s.side) == low;
      ring.push_back(
          {std::atan2(dot(to, y), dot(to, x)), s.side, along != turned_[face_of(s.side)]});
    }
    std::sort(ring.begin(), ring.end(), [](const Wing& a, const Wing& b) {
      return a.angle_rad != b.angle_rad ? a.angle_rad < b.angle_rad : a.side < b.side;
    });
    return ring;
  }

  /// Pairs neighbours with the inside between them, like parentheses; gives what is left.
  std::vector<Wing> pair_round_the_inside(const std::vector<Wing>& ring) {
    std::vector<Wing> open;
    for (const Wing& w : ring) {
      if (!open.empty() && !open.back().inside_before && w.inside_before) {
        pair(open.back().side, w.side);
        open.pop_back();
      } else {
        open.push_back(w);
      }
    }
    return open;
  }

  const TriangleMesh& mesh_;
  std::vector<bool> turned_;
  std::vector<std::int32_t> twin_;
};

}  // namespace

Fans find_fans(const TriangleMesh& mesh) {
  Pairing pairing(mesh);
  Fans out{{}, DisjointSets(3 * mesh.faces.size()), {}, 0};
  out.crowded.assign(mesh.positions.size(), false);
  const EdgeGroups edges(mesh);
  for (std::int64_t e = 0; e < edges.size(); ++e) {
    const auto sides = edges.sides(e);
    if (sides.size() == 2) {
      pairing.pair(sides[0].side, sides[1].side);
    } else if (sides.size() > 2) {
      pairing.pair_crowd(sides);
      ++out.crowded_edges;
      out.crowded[static_cast<std::size_t>(side_tail(mesh, sides[0].side))] = true;
      out.crowded[static_cast<std::size_t>(side_head(mesh, sides[0].side))] = true;
    }
  }
  out.twin = pairing.take();
  for (std::size_t i = 0; i < out.twin.size(); ++i) {
    const std::int32_t side = static_cast<std::int32_t>(i), twin = out.twin[i];
    if (twin < side) {
      continue;
    }
    const bool same = side_tail(mesh, side) == side_tail(mesh, twin);
    out.fan.join(side, same ? twin : Fans::end_corner(twin));
    out.fan.join(Fans::end_corner(side), same ? Fans::end_corner(twin) : twin);
  }
  return out;
}

}  // namespace ucvt
