// The convex hull of points in three dimensions, by Qhull (Barber, Dobkin, Huhdanpaa 1996).
//
// Delaunay triangulations of the three spaces are hulls of lifted sites.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ucvt {

struct HullTriangle {
  std::array<std::int32_t, 3> corner;  ///< numbers of points, in either orientation
  std::array<double, 3> normal;        ///< outward
};

/// The facets of the hull, cut into triangles; none when the points lie in a plane.
///
/// Qhull's tolerances are absolute: give points of about unit size.
std::vector<HullTriangle> convex_hull(std::vector<std::array<double, 3>> points);

}  // namespace ucvt
