#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_set>

#include "mesh/boundary_loops.h"
#include "mesh/edge_groups.h"
#include "mesh/hole_triangles.h"
#include "mesh/repair_steps.h"

namespace ucvt {
namespace {

/// Longest loop whose triangles are sought: the search is cubic.
constexpr std::size_t most_edges = 200;

/// A hole takes at most a third as many faces as its component has; else it is no hole but the other
/// half of the surface.
constexpr std::size_t least_faces_per_face = 3;

class Closer {
 public:
  Closer(Repaired& r, const RepairOptions& options)
      : r_(r), options_(options), component_(r.mesh.positions.size()) {
    for (const Corners& f : r_.mesh.faces) {
      component_.join(f[0], f[1]);
      component_.join(f[0], f[2]);
      for (std::size_t i = 0; i < 3; ++i) {
        edges_.insert(edge(f[i], f[(i + 1) % 3]));
      }
      triangles_.insert(sorted(f));
    }
    faces_.assign(r.mesh.positions.size(), 0);
    for (const Corners& f : r_.mesh.faces) {
      ++faces_[static_cast<std::size_t>(component_.find(f[0]))];
    }
  }

  void run() {
    Fans fans = find_fans(r_.mesh);
    const double longest = options_.hole_length * survey(r_.mesh).bbox_diagonal;
    for (const BoundaryLoop& loop : boundary_loops(r_.mesh, fans)) {
      const bool is_small = loop.sides.size() <= static_cast<std::size_t>(options_.hole_edges) ||
                            length(loop) <= longest;
      if (is_small && may_close(loop) && close(loop)) {
        ++r_.report.closed_holes;
      } else {
        ++r_.report.left_holes;
      }
    }
  }

 private:
  static Corners sorted(Corners f) {
    std::sort(f.begin(), f.end());
    return f;
  }

  static std::uint64_t edge(std::int32_t a, std::int32_t b) {
    return std::uint64_t{static_cast<std::uint32_t>(std::min(a, b))} << 32 |
           static_cast<std::uint32_t>(std::max(a, b));
  }

  [[nodiscard]] const Position& at(std::int32_t v) const {
    return r_.mesh.positions[static_cast<std::size_t>(v)];
  }

  [[nodiscard]] double length(const BoundaryLoop& loop) const {
    double sum = 0;
    for (const std::int32_t s : loop.sides) {
      const Position &a = at(side_tail(r_.mesh, s)), &b = at(side_head(r_.mesh, s));
      sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return sum;
  }

  bool may_close(const BoundaryLoop& loop) {
    const std::size_t n = loop.sides.size();
    const auto& v = loop.vertices;
    if (n == 3 && triangles_.contains(sorted({v[0], v[1], v[2]}))) {
      return false;
    }
    return n >= 3 && n <= most_edges &&
           least_faces_per_face * (n - 2) <=
               faces_[static_cast<std::size_t>(component_.find(loop.vertices[0]))];
  }

  bool close(const BoundaryLoop& loop) {
    std::vector<Position> corners;
    for (const std::int32_t v : loop.vertices) {
      corners.push_back(at(v));
    }
    const auto exists = [&](std::size_t i, std::size_t j) {
      return edges_.contains(edge(loop.vertices[i], loop.vertices[j]));
    };
    const std::vector<Corners> triangles = hole_triangles(corners, exists);
    for (const Corners& t : triangles) {
      const auto v = [&](std::size_t i) { return loop.vertices[static_cast<std::size_t>(t[i])]; };
      r_.mesh.faces.push_back({v(0), v(1), v(2)});
      r_.input_face.push_back(-1);
      triangles_.insert(sorted(r_.mesh.faces.back()));
      ++r_.report.added_faces;
      for (std::size_t i = 0; i < 3; ++i) {
        edges_.insert(edge(v(i), v((i + 1) % 3)));
      }
    }
    return !triangles.empty();
  }

  Repaired& r_;
  const RepairOptions& options_;
  DisjointSets component_;
  std::vector<std::size_t> faces_;  // of each component, by its least vertex
  std::unordered_set<std::uint64_t> edges_;
  std::set<Corners> triangles_;
};

}  // namespace

void close_holes(Repaired& r, const RepairOptions& options) {
  if (survey(r.mesh).boundary_edges > 0) {
    Closer(r, options).run();
  }
}

}  // namespace ucvt
