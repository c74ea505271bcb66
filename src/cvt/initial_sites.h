// Where sites start.
#pragma once

#include <cstdint>
#include <vector>

#include "triangulation/uniform_surface.h"

namespace ucvt {

/// n random points, uniform in the measure with the given density (linear over each face's chord
/// triangle) against T's area. The same seed gives the same points on every machine.
std::vector<SurfacePoint> random_sites(const UniformSurface& t, const std::vector<double>& density,
                                       std::size_t n, std::uint64_t seed);

/// n vertices of T, each as far as possible from those before it, by shortest edge paths with the
/// given length per halfedge; the first is drawn with the seed. Requires n vertices at least.
std::vector<SurfacePoint> farthest_sites(const UniformSurface& t, const std::vector<double>& length,
                                         std::size_t n, std::uint64_t seed);

}  // namespace ucvt
