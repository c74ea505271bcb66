#include "mesh/edge_bisection.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <queue>
#include <utility>

#include "mesh/edge_groups.h"

namespace ucvt {
namespace {

std::int32_t next_side(std::int32_t side) {
  return side % 3 == 2 ? side - 2 : side + 1;
}

/// The side on the other face of every side's edge, -1 on the boundary.
std::vector<std::int32_t> twins(const TriangleMesh& mesh) {
  std::vector<std::int32_t> twin(3 * mesh.faces.size(), -1);
  const EdgeGroups edges(mesh);
  for (std::int64_t e = 0; e < edges.size(); ++e) {
    const auto sides = edges.sides(e);
    if (sides.size() == 2) {
      twin[static_cast<std::size_t>(sides[0].side)] = sides[1].side;
      twin[static_cast<std::size_t>(sides[1].side)] = sides[0].side;
    }
  }
  return twin;
}

class Bisection {
 public:
  Bisection(TriangleMesh& mesh, std::vector<double>& size)
      : mesh_(mesh), size_(size), twin_(twins(mesh)), part_of_(mesh.faces.size()) {
    std::iota(part_of_.begin(), part_of_.end(), 0);
  }

  std::vector<std::int32_t> run() {
    for (std::size_t s = 0; s < twin_.size(); ++s) {
      push(static_cast<std::int32_t>(s));
    }
    while (!queue_.empty()) {
      const auto [length, side] = queue_.top();
      queue_.pop();
      if (length == length_of(side)) {
        cut(side);
      }
    }
    cut_chords_of_boundary();
    return std::move(part_of_);
  }

 private:
  [[nodiscard]] double length_of(std::int32_t side) const {
    const Position& p = mesh_.positions[static_cast<std::size_t>(side_tail(mesh_, side))];
    const Position& q = mesh_.positions[static_cast<std::size_t>(side_head(mesh_, side))];
    return 2 * std::hypot(q[0] / 2 - p[0] / 2, q[1] / 2 - p[1] / 2, q[2] / 2 - p[2] / 2);
  }

  [[nodiscard]] double size_at(std::int32_t vertex) const {
    return size_[static_cast<std::size_t>(vertex)];
  }

  [[nodiscard]] double wanted(std::int32_t side) const {
    return (size_at(side_tail(mesh_, side)) + size_at(side_head(mesh_, side))) / 2;
  }

  void push(std::int32_t side) {
    const double length = length_of(side);
    if (twin_[static_cast<std::size_t>(side)] < side && length > wanted(side)) {
      queue_.push({length, side});
    }
  }

  void glue(std::int32_t a, std::int32_t b) {
    twin_[static_cast<std::size_t>(a)] = b;
    if (b >= 0) {
      twin_[static_cast<std::size_t>(b)] = a;
    }
  }

  /// Cuts the face of the side (a, b, c) into (a, m, c), which keeps its number, and (m, b, c).
  /// Returns the side that runs from m to b.
  std::int32_t cut_face(std::int32_t side, std::int32_t m) {
    const auto added = static_cast<std::int32_t>(3 * mesh_.faces.size());
    const std::int32_t b = side_head(mesh_, side), c = side_apex(mesh_, side);
    const std::int32_t bc = next_side(side);
    mesh_.faces.push_back({m, b, c});
    part_of_.push_back(part_of_[face_of(side)]);
    twin_.resize(twin_.size() + 3, -1);
    mesh_.faces[face_of(side)][static_cast<std::size_t>(bc % 3)] = m;
    glue(added + 1, twin_[static_cast<std::size_t>(bc)]);
    glue(added + 2, bc);
    return added;
  }

  void cut(std::int32_t side) {
    const std::int32_t twin = twin_[static_cast<std::size_t>(side)];
    const Position p = mesh_.positions[static_cast<std::size_t>(side_tail(mesh_, side))];
    const Position q = mesh_.positions[static_cast<std::size_t>(side_head(mesh_, side))];
    size_.push_back(wanted(side));
    const auto m = static_cast<std::int32_t>(mesh_.positions.size());
    mesh_.positions.push_back({p[0] / 2 + q[0] / 2, p[1] / 2 + q[1] / 2, p[2] / 2 + q[2] / 2});
    const std::int32_t half = cut_face(side, m);
    std::vector<std::int32_t> changed{side, next_side(side), half, half + 1};
    if (twin >= 0) {
      const std::int32_t twin_half = cut_face(twin, m);
      glue(side, twin_half);
      glue(half, twin);
      changed.insert(changed.end(), {next_side(twin), twin, twin_half, twin_half + 1});
    }
    for (const std::int32_t s : changed) {
      push(s);
      if (const std::int32_t t = twin_[static_cast<std::size_t>(s)]; t >= 0) {
        push(t);
      }
    }
  }

  void cut_chords_of_boundary() {
    std::vector<bool> on_boundary(mesh_.positions.size(), false);
    for (std::size_t s = 0; s < twin_.size(); ++s) {
      if (twin_[s] < 0) {
        const auto side = static_cast<std::int32_t>(s);
        on_boundary[static_cast<std::size_t>(side_tail(mesh_, side))] = true;
      }
    }
    const auto boundary = [&](std::int32_t v) {
      const auto i = static_cast<std::size_t>(v);
      return i < on_boundary.size() && on_boundary[i];
    };
    for (std::size_t s = 0; s < twin_.size(); ++s) {
      const auto side = static_cast<std::int32_t>(s);
      if (twin_[s] >= 0 && boundary(side_tail(mesh_, side)) && boundary(side_head(mesh_, side))) {
        cut(side);
      }
    }
  }

  TriangleMesh& mesh_;
  std::vector<double>& size_;
  std::vector<std::int32_t> twin_;
  std::vector<std::int32_t> part_of_;  // by face: the face before
  std::priority_queue<std::pair<double, std::int32_t>> queue_;
};

}  // namespace

std::vector<std::int32_t> bisect_edges(TriangleMesh& mesh, std::vector<double>& size) {
  return Bisection(mesh, size).run();
}

std::vector<std::vector<std::int32_t>> boundary_loops(const TriangleMesh& mesh) {
  const std::vector<std::int32_t> twin = twins(mesh);
  std::vector<std::int32_t> next(mesh.positions.size(), -1);
  for (std::size_t s = 0; s < twin.size(); ++s) {
    if (twin[s] < 0) {
      const auto side = static_cast<std::int32_t>(s);
      next[static_cast<std::size_t>(side_tail(mesh, side))] = side_head(mesh, side);
    }
  }
  std::vector<std::vector<std::int32_t>> loops;
  for (std::size_t first = 0; first < next.size(); ++first) {
    if (next[first] < 0) {
      continue;
    }
    loops.emplace_back();
    for (auto v = static_cast<std::int32_t>(first); next[static_cast<std::size_t>(v)] >= 0;) {
      loops.back().push_back(v);
      v = std::exchange(next[static_cast<std::size_t>(v)], -1);
    }
  }
  return loops;
}

}  // namespace ucvt
