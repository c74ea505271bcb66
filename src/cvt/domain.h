// Points of a domain: which belong to it, where they lie in a fundamental polygon, random ones.
//
// The makers of domains (spaces.h) are implemented beside them. Everything but the sphere is a
// convex polygon in central coordinates, side i from corner i to corner i + 1.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "triangulation/frame.h"
#include "ucvt/spaces.h"

namespace ucvt {

/// (x, y)/z of a model point. Requires z > 0.
CentralPoint central_point(const ModelPoint& p);

/// The model point at central coordinates. Requires 1 + kappa k^2 > 0.
ModelPoint model_point(double kappa, const CentralPoint& k);

/// The polygon's corners as model points.
std::vector<ModelPoint> model_corners(const Domain& domain);

/// A frame inside the polygon, at the mean of its corners; at the model's origin for closed domains.
Frame central_frame(const Domain& domain);

/// True when the point lies on the model (to 1e-9) and in the polygon, its sides included (to 1e-12
/// of its coordinates); false when a coordinate is not finite.
bool contains(const Domain& domain, const ModelPoint& p);

/// The image of a point in the fundamental polygon of a closed domain, found by crossing one side
/// after another towards it; in a 4g-gon, where sides are bisectors, the image nearest to the
/// centre. Points of polygons and of the sphere stay. Throws NumericalError when a point is too far.
ModelPoint into_polygon(const Domain& domain, const ModelPoint& p);

/// n points uniform by area. The same seed gives the same points on every machine.
std::vector<ModelPoint> random_points(const Domain& domain, std::size_t n, std::uint64_t seed);

/// Draws such points one by one.
class PointSampler {
 public:
  explicit PointSampler(const Domain& domain);
  ModelPoint operator()(std::mt19937_64& random) const;

 private:
  [[nodiscard]] ModelPoint in_triangle(std::size_t i, double area, double height) const;

  Frame frame_;
  std::vector<Offset> corners_;  ///< in frame_; empty on the sphere
  std::vector<double> until_;    ///< area of the triangles at the centre over sides 0 to i
};

}  // namespace ucvt
