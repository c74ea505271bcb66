#include "cvt/stiffness.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cvt/tessellation.h"
#include "oracle/surfaces.h"

namespace ucvt {
namespace {

TEST(Stiffness, SolvesTwoSitesOnASpring) {
  // Along the spring: its stiffness 3 and each site's rest 10 - 2 * 3; across: 10.
  const Stiffness stiffness({{0, 1, {1, 0}, {0, -1}, 3}}, {10, 10});
  ASSERT_TRUE(stiffness.is_usable());
  std::vector<Vector2> v{{4, 10}, {20, -4}};
  stiffness.solve(v);
  EXPECT_NEAR(v[0].x, 4.0 / (4 + 3 + 3), 1e-14);
  EXPECT_NEAR(v[0].y, 1, 1e-14);
  EXPECT_NEAR(v[1].x, 2, 1e-14);
  EXPECT_NEAR(v[1].y, -4.0 / (4 + 3 + 3), 1e-14);
}

TEST(Stiffness, SitesResistHoweverStiffTheirSprings) {
  const Stiffness stiffness({{0, 1, {1, 0}, {-1, 0}, 1e9}}, {1, 1});
  ASSERT_TRUE(stiffness.is_usable());
  std::vector<Vector2> v{{1, 0}, {1, 0}};  // both the same way: the spring stays as long as it is
  stiffness.solve(v);
  EXPECT_GT(v[0].x, 10);
  EXPECT_LT(v[0].x, 100);
}

/// The energy along moves of all sites, to second order, against the springs'.
TEST(Stiffness, IsNearlyTheSecondDerivativeOfTheEnergy) {
  const UniformSurface& t = oracle::surface_of(0);
  const SurfaceMass mass(t, std::vector<double>(t.connectivity().vertex_count(), 1.0));
  Tessellation sites(mass, oracle::random_points(t, 60, 3));
  optimize(sites, {Method::Lbfgs, 500, 1e-8}, {});
  const std::size_t n = sites.site_count();
  const auto energy_after = [&](double step) {
    std::vector<Offset> to;
    for (std::size_t i = 0; i < n; ++i) {
      const double x = static_cast<double>(i);
      to.push_back(from_central({0}, step * std::sin(7 * x), step * std::cos(5 * x)));
    }
    sites.save();
    sites.move(to);
    double sum = 0;
    for (const Moments& m : sites.cell_moments()) {
      sum += 2 * m.h;
    }
    sites.restore();
    return sum;
  };
  double springs = 0;
  for (const Spring& s : sites.springs()) {
    const double a = s.from, b = s.to;
    const double stretch = s.at_from.x * std::sin(7 * a) + s.at_from.y * std::cos(5 * a) +
                           s.at_to.x * std::sin(7 * b) + s.at_to.y * std::cos(5 * b);
    springs += s.stiffness * stretch * stretch;
  }
  const double step = 1e-3;
  const double second =
      (energy_after(step) + energy_after(-step) - 2 * energy_after(0)) / (step * step);
  EXPECT_GT(springs / second, 0.9);
  EXPECT_LT(springs / second, 1.3);
}

}  // namespace
}  // namespace ucvt
