// Repair: closed manifold surfaces out of meshes that are nearly so (docs/repair.md).
//
// Only what is broken is touched: a mesh that is closed, manifold and oriented comes back as it was.
// Steps, in this order: vertices of open edges that lie at one place become one; faces with a repeated
// corner and copies of faces go; faces round an edge of more than two are paired off, and vertices
// whose faces form several fans are split; faces are turned round to agree; small holes are closed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

struct RepairOptions {
  double weld = 1e-9;  ///< vertices of open edges are one up to this part of the bounding box'
                       ///< diagonal
  int hole_edges = 8;  ///< holes of at most so many edges are closed,
  double hole_length = 0.1;  ///< and those at most this part of the diagonal around
};

/// What was done, and what could not be done.
struct RepairReport {
  std::int64_t welded_vertices = 0;   ///< that became another one
  std::int64_t repeated_corners = 0;  ///< faces dropped for a repeated corner
  std::int64_t duplicate_faces = 0;   ///< faces dropped as copies of others
  std::int64_t split_edges = 0;       ///< of more than two faces, taken apart
  std::int64_t split_vertices = 0;    ///< copies made of vertices with several fans of faces
  std::int64_t cut_edges = 0;         ///< middles made vertices, of edges that coincide
  std::int64_t reoriented_faces = 0;  ///< turned round
  std::int64_t closed_holes = 0;
  std::int64_t added_faces = 0;  ///< in those holes
  std::int64_t left_holes = 0;   ///< too large, or not to be closed without folds

  /// Whether the mesh is another than before.
  [[nodiscard]] bool changed() const;
};

struct Repaired {
  TriangleMesh
      mesh;  ///< the input's vertices under their numbers, then copies of some, and middles
  std::vector<std::int32_t> input_vertex;  ///< of each vertex; -1: the middle of an edge
  std::vector<std::int32_t> input_face;    ///< of each face, or of its half; -1: closes a hole
  RepairReport report;
};

/// Repairs what can be repaired; what remains, `faults_of` names. Never throws on a mesh that
/// `read_mesh` returned. Deterministic; about O(n log n), and cubic in the edges of a hole.
Repaired repair(const TriangleMesh& mesh, const RepairOptions& options = {});

/// "welded 3 vertices, closed 1 hole with 2 faces"; "nothing to repair" when unchanged.
std::string summary_of(const RepairReport& report);

/// All that keeps the mesh from being made of closed manifold orientable surfaces, each with its
/// count and first example (numbers of the mesh, from 0), in one line; empty when nothing does.
std::string faults_of(const TriangleMesh& mesh);

}  // namespace ucvt
