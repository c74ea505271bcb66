// Making a mesh finer without changing the surface: edges are cut in their middle, longest first.
//
// The longest edge of all is the longest of its own faces, so that this is longest-edge bisection
// (Rivara 1984): the smallest angle never falls below half of the input's.
#pragma once

#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

/// Cuts edges until none is longer than the mean of the sizes wanted at its ends, then every edge
/// inside the surface that joins two boundary vertices. Vertices keep their numbers; new ones follow
/// and get the mean of the sizes at the ends of their edge. Returns for every face the one before that it
/// is a part of. Requires an oriented manifold, with boundary or without; sizes are positive, one a
/// vertex.
std::vector<std::int32_t> bisect_edges(TriangleMesh& mesh, std::vector<double>& size);

/// The boundary of an oriented manifold: loops of vertices, each with the surface on its left.
std::vector<std::vector<std::int32_t>> boundary_loops(const TriangleMesh& mesh);

}  // namespace ucvt
