// Voronoi cells on a closed surface the paper's way, as an oracle: T is laid out in the universal
// cover about a site, every lift of every site near enough is found, and the cell is what all their
// bisectors leave of the tangent plane. Shares only `develop` and `point_in_frame` with the library.
#pragma once

#include <vector>

#include "triangulation/uniform_surface.h"

namespace ucvt::oracle {

struct Lift {
  std::int32_t site;
  Offset at;
};

struct BruteCell {
  std::vector<Lift> neighbours;  ///< with an edge of nonzero length, counterclockwise
  std::vector<Offset> corners;   ///< counterclockwise; some may coincide
  double area = 0;
  double radius = 0;  ///< greatest distance of a corner, as tan_kappa
};

/// Every lift of the given points within reach (tan_kappa of the distance; all of them on the
/// sphere) of the origin of the place's frame, nearest first; the one at the origin is left out.
std::vector<Lift> lifts_about(const UniformSurface& t, const Place& place,
                              const std::vector<SurfacePoint>& sites, double reach);

/// The Voronoi cell of the site at the origin of the place's frame. Requires a cell within a
/// hemisphere on the sphere.
BruteCell brute_cell(const UniformSurface& t, const Place& place,
                     const std::vector<SurfacePoint>& sites);

}  // namespace ucvt::oracle
