#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "mesh/disjoint_sets.h"
#include "mesh/edge_groups.h"
#include "mesh/repair_steps.h"

namespace ucvt {
namespace {

using GridCell = std::array<std::int64_t, 3>;

struct GridHash {
  std::size_t operator()(const GridCell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

std::vector<std::int32_t> open_vertices(const TriangleMesh& mesh) {
  std::vector<bool> open(mesh.positions.size(), false);
  const EdgeGroups edges(mesh);
  for (std::int64_t e = 0; e < edges.size(); ++e) {
    const auto sides = edges.sides(e);
    if (sides.size() == 1) {
      open[static_cast<std::size_t>(side_tail(mesh, sides[0].side))] = true;
      open[static_cast<std::size_t>(side_head(mesh, sides[0].side))] = true;
    }
  }
  std::vector<std::int32_t> out;
  for (std::size_t v = 0; v < open.size(); ++v) {
    if (open[v]) {
      out.push_back(static_cast<std::int32_t>(v));
    }
  }
  return out;
}

/// Vertices in a grid whose cells are as wide as the tolerance: near ones lie in cells that touch.
class Welder {
 public:
  Welder(const TriangleMesh& mesh, double tolerance)
      : mesh_(mesh), tolerance_(tolerance), sets_(mesh.positions.size()) {}

  void add(std::int32_t v) {
    const GridCell home = cell(v);
    for (std::int64_t x = -1; x <= 1; ++x) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        for (std::int64_t z = -1; z <= 1; ++z) {
          join_near(v, {home[0] + x, home[1] + y, home[2] + z});
        }
      }
    }
    grid_[home].push_back(v);
  }

  std::int32_t find(std::int32_t v) { return sets_.find(v); }

 private:
  [[nodiscard]] const Position& at(std::int32_t v) const {
    return mesh_.positions[static_cast<std::size_t>(v)];
  }

  [[nodiscard]] GridCell cell(std::int32_t v) const {
    // Far from the origin doubles are coarser than the tolerance; cells stay apart by what they hold.
    constexpr double most = 1e18;
    GridCell out{};
    for (std::size_t k = 0; k < 3; ++k) {
      out[k] =
          static_cast<std::int64_t>(std::clamp(std::floor(at(v)[k] / tolerance_), -most, most));
    }
    return out;
  }

  void join_near(std::int32_t v, const GridCell& where) {
    const auto found = grid_.find(where);
    if (found == grid_.end()) {
      return;
    }
    for (const std::int32_t w : found->second) {
      const Position &p = at(v), &q = at(w);
      if (std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= tolerance_) {
        sets_.join(v, w);
      }
    }
  }

  const TriangleMesh& mesh_;
  double tolerance_;
  DisjointSets sets_;
  std::unordered_map<GridCell, std::vector<std::int32_t>, GridHash> grid_;
};

}  // namespace

void weld_open_vertices(Repaired& r, double tolerance) {
  // Coincident vertices are welded at any scale.
  constexpr double least = 1e-300, most = 1e300;
  Welder welder(r.mesh, std::clamp(tolerance, least, most));
  const std::vector<std::int32_t> open = open_vertices(r.mesh);
  for (const std::int32_t v : open) {
    welder.add(v);
  }
  for (const std::int32_t v : open) {
    r.report.welded_vertices += welder.find(v) != v;
  }
  for (Corners& f : r.mesh.faces) {
    for (std::int32_t& v : f) {
      v = welder.find(v);
    }
  }
}

}  // namespace ucvt
