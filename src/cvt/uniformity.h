// The paper's measures of how uniform a tessellation is (its section 5.3).
#pragma once

#include <vector>

#include "cvt/tessellation.h"
#include "ucvt/remesh.h"

namespace ucvt {

/// Mean, coefficient of variation, least and greatest of some values.
Spread spread_of(const std::vector<double>& values);

/// Radius, distance to the nearest neighbour and area of every cell, and how many neighbours sites
/// have. Requires Voronoi vertices within a quarter turn of their sites on the sphere.
UniformityReport measure_uniformity(const DelaunayTriangulation& d);

}  // namespace ucvt
