#include "conformal/moebius_balance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

namespace ucvt {
namespace {

/// Where a point of the plane lies on the sphere of the frame.
Eigen::Vector3d on_sphere(const StereographicFrame& at, const PlanePoint& p) {
  const double x = (p.x - at.centre.x) / at.scale, y = (p.y - at.centre.y) / at.scale;
  const double q = x * x + y * y;
  return q < 1e100 ? Eigen::Vector3d(2 * x, 2 * y, q - 1) / (1 + q) : Eigen::Vector3d(0, 0, 1);
}

/// Goes along the geodesic of hyperbolic 3-space in direction d, a unit vector.
void advance(StereographicFrame& at, const Eigen::Vector3d& d, double length) {
  const double bottom = std::cosh(length) - d.z() * std::sinh(length);
  at.centre.x += at.scale * d.x() * std::sinh(length) / bottom;
  at.centre.y += at.scale * d.y() * std::sinh(length) / bottom;
  at.scale /= bottom;
}

}  // namespace

StereographicFrame conformal_barycentre(const std::vector<PlanePoint>& point,
                                        const std::vector<double>& weight, std::size_t infinite,
                                        StereographicFrame start) {
  const double total = std::accumulate(weight.begin(), weight.end(), 0.0);
  StereographicFrame at = start;
  for (int step = 0; step < 200; ++step) {
    // Seen from `at`, points are unit vectors P; the sum has gradient -sum w P and Hessian
    // sum w (I - P P^T).
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double w = std::min(weight[i] / total, 0.25);
      const Eigen::Vector3d p = i == infinite ? Eigen::Vector3d(0, 0, 1) : on_sphere(at, point[i]);
      pull += w * p;
      hessian += w * (Eigen::Matrix3d::Identity() - p * p.transpose());
    }
    const Eigen::Vector3d v = hessian.ldlt().solve(pull);
    if (pull.norm() < 1e-10 || !(v.norm() > 0)) {
      break;
    }
    advance(at, v.normalized(), std::min(v.norm(), 2.0));
  }
  return at;
}

}  // namespace ucvt
