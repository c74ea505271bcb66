// The half of a double's partition: that of a surface with boundary.
#pragma once

#include "result/half_mesh.h"
#include "ucvt/partition.h"

namespace ucvt {

/// The part of the double's partition that lies on the half, numbered as the input and as the mesh's
/// vertices are. Cells on the boundary, which are their own mirror images, are cut in two; of their
/// sides those with other cells of the half count. Positions of sites, areas on the input and colours
/// are left as they are. Throws NumericalError when a cell of the mirror image reaches into the half.
Partition half_partition(const Partition& whole, const HalfOfDouble& half);

}  // namespace ucvt
