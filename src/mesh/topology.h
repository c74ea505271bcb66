// What a triangle mesh is as an abstract surface, with one example of each fault.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/edge_groups.h"
#include "ucvt/mesh.h"

namespace ucvt {

/// The counts of a MeshSurvey that do not need positions, and the first of each fault (-1: none).
struct Topology {
  MeshSurvey counts;
  std::int32_t repeated_corner_face = -1;
  std::int32_t duplicate_face = -1, duplicate_of = -1;
  std::int32_t nonmanifold_side = -1;
  std::int64_t nonmanifold_side_faces = 0;
  std::int32_t boundary_side = -1;
  std::int32_t nonmanifold_vertex = -1;
  std::int64_t nonmanifold_vertex_fans = 0;
  std::vector<bool> turned;  ///< of each face: against the first of its component
};

Topology analyze_topology(const TriangleMesh& mesh);

}  // namespace ucvt
