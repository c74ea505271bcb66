// The edges of a triangle mesh, each with the sides of faces that run along it.
//
// Side i of face f is number 3 f + i and runs from corner i to corner i + 1. Faces with a repeated
// corner have no sides here. Sorted by the edges' vertices with a counting sort, in O(n log n) for
// the greatest valence n.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

struct EdgeSide {
  std::int32_t high = 0;  ///< the greater vertex of the edge
  std::int32_t side = 0;
};

class EdgeGroups {
 public:
  explicit EdgeGroups(const TriangleMesh& mesh);

  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(first_.size()) - 1; }
  [[nodiscard]] std::span<const EdgeSide> sides(std::int64_t edge) const {
    const auto e = static_cast<std::size_t>(edge);
    return std::span(sides_).subspan(first_[e], first_[e + 1] - first_[e]);
  }

 private:
  std::vector<EdgeSide> sides_;
  std::vector<std::size_t> first_;  // of each edge, and one past the last
};

inline bool has_repeated_corner(const Corners& f) {
  return f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
}

inline std::size_t face_of(std::int32_t side) {
  return static_cast<std::size_t>(side / 3);
}

/// The vertices that a side runs from and to, and the one opposite.
inline std::int32_t side_tail(const TriangleMesh& mesh, std::int32_t side) {
  return mesh.faces[face_of(side)][static_cast<std::size_t>(side % 3)];
}
inline std::int32_t side_head(const TriangleMesh& mesh, std::int32_t side) {
  return mesh.faces[face_of(side)][static_cast<std::size_t>((side % 3 + 1) % 3)];
}
inline std::int32_t side_apex(const TriangleMesh& mesh, std::int32_t side) {
  return mesh.faces[face_of(side)][static_cast<std::size_t>((side % 3 + 2) % 3)];
}

}  // namespace ucvt
