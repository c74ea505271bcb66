// Where sites start.
#pragma once

#include <cstdint>
#include <vector>

#include "triangulation/uniform_surface.h"

namespace ucvt {

/// n random points: a vertex of T drawn by the given weights, then a place in its share of one of
/// its faces. With the area on the input round every vertex for weights they are uniform on the
/// input surface. The same seed gives the same points on every machine.
std::vector<SurfacePoint> random_sites(const UniformSurface& t, const std::vector<double>& weight,
                                       std::size_t n, std::uint64_t seed);

/// n vertices of T, each as far as possible from those before it, by shortest edge paths with the
/// given length per halfedge; the first is drawn with the seed. Requires n vertices at least.
std::vector<SurfacePoint> farthest_sites(const UniformSurface& t, const std::vector<double>& length,
                                         std::size_t n, std::uint64_t seed);

}  // namespace ucvt
