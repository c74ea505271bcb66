// The holes of an oriented mesh as simple loops of vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/fans.h"
#include "ucvt/mesh.h"

namespace ucvt {

/// A hole: side k of a face runs from vertex k + 1 to vertex k, so that faces on the vertices in
/// their order agree with it.
struct BoundaryLoop {
  std::vector<std::int32_t> vertices;
  std::vector<std::int32_t> sides;
};

/// All holes. Where several pass through one vertex, each goes on with the next fan of faces there,
/// the one at the least angle; no loop passes through a vertex twice. Requires oriented faces.
std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh, Fans& fans);

}  // namespace ucvt
