#include "conformal/moebius_balance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

namespace ucvt {

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
      Eigen::Vector3d p(0, 0, 1);
      if (i != infinite) {
        const double x = (point[i].x - at.centre.x) / at.scale;
        const double y = (point[i].y - at.centre.y) / at.scale;
        const double q = x * x + y * y;
        if (q < 1e100) {
          p = Eigen::Vector3d(2 * x, 2 * y, q - 1) / (1 + q);
        }
      }
      pull += w * p;
      hessian += w * (Eigen::Matrix3d::Identity() - p * p.transpose());
    }
    if (pull.norm() < 1e-10) {
      break;
    }
    const Eigen::Vector3d v = hessian.ldlt().solve(pull);
    const double length = std::min(v.norm(), 2.0);
    if (!(length > 0)) {
      break;
    }
    const Eigen::Vector3d d = v.normalized();
    // Along the geodesic of hyperbolic 3-space in direction d.
    const double bottom = std::cosh(length) - d.z() * std::sinh(length);
    at.centre.x += at.scale * d.x() * std::sinh(length) / bottom;
    at.centre.y += at.scale * d.y() * std::sinh(length) / bottom;
    at.scale /= bottom;
  }
  return at;
}

}  // namespace ucvt
