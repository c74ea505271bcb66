// Which faces are neighbours, also round edges of more than two, and the fans they form at vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/disjoint_sets.h"
#include "ucvt/mesh.h"

namespace ucvt {

/// Corner i of face f and side i, which leaves from it, have number 3 f + i.
struct Fans {
  std::vector<std::int32_t> twin;  ///< of each side; -1: open
  DisjointSets fan;                ///< of the corners: those of one fan round a vertex
  std::vector<bool> crowded;       ///< vertices at edges of more than two faces
  std::int64_t crowded_edges = 0;

  /// The corner of a side's face that lies at the side's end.
  static std::int32_t end_corner(std::int32_t side) { return side - side % 3 + (side + 1) % 3; }
};

/// Pairs the faces at every edge. Round an edge of more than two they are sorted by angle, and two
/// neighbours that enclose the inside of the surface become a pair; what is left is paired as it
/// comes, and an odd one stays open. Requires no repeated corners.
Fans find_fans(const TriangleMesh& mesh);

}  // namespace ucvt
