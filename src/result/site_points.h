// Sites of the interface and points on T are the same things under two names.
#pragma once

#include <vector>

#include "triangulation/uniform_surface.h"
#include "ucvt/remesh.h"

namespace ucvt {

/// Throws InvalidInput for sites that do not lie on a surface with so many faces.
std::vector<SurfacePoint> as_points(const std::vector<Site>& sites, std::size_t faces);

std::vector<Site> as_sites(const std::vector<SurfacePoint>& points);

}  // namespace ucvt
