// Cell sizes that make up for what a CVT on T cannot see of steep parts of the input
// (docs/optimisation.md, "Steep surfaces").
#pragma once

#include <vector>

#include "cvt/tessellation.h"

namespace ucvt {

/// Lowers the size asked for at T's vertices where cells are larger on the input than the average, and
/// raises it where they are smaller, by half of what is amiss.
///
/// `area` holds areas on the input, with the conformal factor for its density; `size` has a value at
/// every vertex of T. Cells count by how much the log scale changes over them, in full from 1.5 on: on
/// others the density alone makes a CVT even. They are taken together with their neighbours, lest
/// defects of the pattern be held against them.
void even_sizes(const Tessellation& sites, const SurfaceMass& area, std::vector<double>& size);

}  // namespace ucvt
