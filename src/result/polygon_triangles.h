// Triangles of a polygon inside a face, by cutting off ears.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

struct PolygonTriangles {
  std::vector<Corners> triangles;            ///< of numbers in the polygon, then in `added`
  std::vector<std::array<double, 3>> added;  ///< points within that were needed
};

/// Cuts a polygon, given by its corners' barycentric coordinates in a face, counterclockwise.
///
/// Only ears that are not flat and hold no other corner are cut off, the roundest first; where there is
/// none, or corners fall together, a fan round a new point is made. The triangles therefore always fill
/// the polygon's round, whatever rounding did to the coordinates.
PolygonTriangles triangulate_polygon(std::span<const std::array<double, 3>> corner);

/// A fan round the mean of the corners.
PolygonTriangles fan_of_polygon(std::span<const std::array<double, 3>> corner);

}  // namespace ucvt
