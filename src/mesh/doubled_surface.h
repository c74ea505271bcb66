// A surface with boundary and its mirror image, glued along the boundary to a closed surface.
//
// With genus g and b boundary loops the double has genus 2 g + b - 1. Its mirror symmetry exchanges
// the halves and leaves the boundary where it is.
#pragma once

#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

struct DoubledSurface {
  ClosedSurface surface;             ///< the half's vertices and faces first, in their order
  std::vector<std::int32_t> mirror;  ///< image of each vertex; itself on the boundary
};

/// Requires an oriented manifold of the given genus with these boundary loops, and no edge inside it
/// that joins two boundary vertices (`bisect_edges` cuts them).
DoubledSurface doubled(const TriangleMesh& half, int genus,
                       const std::vector<std::vector<std::int32_t>>& boundary);

}  // namespace ucvt
