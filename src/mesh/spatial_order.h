// An order of faces in which neighbours in space are neighbours in memory.
#pragma once

#include "ucvt/mesh.h"

namespace ucvt {

/// The same mesh with its faces sorted along a Z-order curve through their centroids (Morton 1966);
/// faces at one place keep their order. Cells then read T in runs instead of all over memory.
TriangleMesh with_faces_in_spatial_order(const TriangleMesh& mesh);

}  // namespace ucvt
