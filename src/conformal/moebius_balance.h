// The Moebius map that balances points of the sphere.
#pragma once

#include <vector>

#include "conformal/plane_layout.h"

namespace ucvt {

/// Where the sphere touches down: the inverse stereographic projection of (p - centre)/scale.
struct StereographicFrame {
  PlanePoint centre;
  double scale = 1;
};

/// The frame in which the weighted points, those of the plane and one at infinity, have their
/// centroid at the sphere's centre.
///
/// Newton's method on the sum of Busemann functions over hyperbolic 3-space (upper half-space above
/// the plane), which is convex along geodesics; `start` is where it begins. Weights are capped at a
/// quarter of their sum, so that the minimum exists. Stops after 200 steps at the latest: balance is
/// wanted, not needed.
StereographicFrame conformal_barycentre(const std::vector<PlanePoint>& point,
                                        const std::vector<double>& weight, std::size_t infinite,
                                        StereographicFrame start);

}  // namespace ucvt
