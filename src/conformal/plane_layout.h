// Positions in the plane of a flat triangulation, for genus 0 on its way to the sphere.
#pragma once

#include <vector>

#include "conformal/intrinsic_triangulation.h"

namespace ucvt {

struct PlanePoint {
  double x = 0, y = 0;
};

/// Lays out the faces without the puncture, from `root` at the origin outwards.
///
/// Directions are accumulated from angles, never derived from positions, so errors do not grow
/// exponentially; near the root positions are accurate relative to their distance from it. Requires
/// angle sums of 2 pi at every vertex off the puncture's link. The puncture's own entry is unused.
std::vector<PlanePoint> lay_out_plane(const IntrinsicTriangulation& t, const std::vector<double>& u,
                                      Vertex puncture, Vertex root);

}  // namespace ucvt
