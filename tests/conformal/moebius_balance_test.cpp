#include "conformal/moebius_balance.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "oracle/surfaces.h"

namespace ucvt {
namespace {

/// Length of the weighted centroid of the points on the sphere, over the sum of the weights.
double imbalance(const std::vector<PlanePoint>& point, const std::vector<double>& weight,
                 std::size_t infinite, const StereographicFrame& at) {
  double x = 0, y = 0, z = 0, total = 0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    total += weight[i];
    if (i == infinite) {
      z += weight[i];
      continue;
    }
    const double p = (point[i].x - at.centre.x) / at.scale,
                 q = (point[i].y - at.centre.y) / at.scale;
    const double r = p * p + q * q;
    x += weight[i] * 2 * p / (1 + r);
    y += weight[i] * 2 * q / (1 + r);
    z += weight[i] * (r - 1) / (1 + r);
  }
  return std::hypot(x, y, z) / total;
}

TEST(MoebiusBalance, PutsTheCentroidAtTheCentre) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<PlanePoint> point;
    std::vector<double> weight;
    for (int i = 0; i < 30; ++i) {
      // Scales from 1e-4 to 1e4 about a centre far from the start.
      const double r = std::pow(10, 8 * oracle::uniform(random) - 4),
                   a = 6.3 * oracle::uniform(random);
      point.push_back({5 + r * std::cos(a), -3 + r * std::sin(a)});
      weight.push_back(0.1 + oracle::uniform(random));
    }
    const StereographicFrame at = conformal_barycentre(point, weight, 4, {});
    EXPECT_LT(imbalance(point, weight, 4, at), 1e-9) << seed;
  }
}

TEST(MoebiusBalance, HoldsOutWhenOnePointHasNearlyAllTheWeight) {
  const std::vector<PlanePoint> point{{0, 0}, {1, 0}, {0, 1}, {-1, -1}, {7, 7}};
  const StereographicFrame at = conformal_barycentre(point, {1000, 1, 1, 1, 1}, 4, {});
  EXPECT_TRUE(std::isfinite(at.centre.x) && std::isfinite(at.centre.y));
  EXPECT_GT(at.scale, 0);
}

}  // namespace
}  // namespace ucvt
