#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "oracle/generators.h"
#include "space/polygon_moments.h"
#include "space/polygon_test_support.h"

namespace ucvt {
namespace {

using oracle::number;
using oracle::scale;
using oracle::space;
using std::numbers::pi;

RC_GTEST_PROP(PolygonCubature, OfADensityLinearInTheModelAreThoseOfTheSurface, ()) {
  // src/space/moments.h takes rho = sum l_v rho_v; by Cramer's rule l is a quotient of determinants.
  const Space s = space();
  const double size = scale(), x = size * number(-0.2, 0.2), y = size * number(-0.2, 0.2);
  const std::array<Offset, 3> c{ucvt::from_central(s, x + 0.5 * size, y),
                                ucvt::from_central(s, x - 0.2 * size, y + 0.4 * size),
                                ucvt::from_central(s, x - 0.3 * size, y - 0.4 * size)};
  const std::array<double, 3> rho{number(0.1, 3), number(0.1, 3), number(0.1, 3)};
  const auto density = [&](const Offset& p) {
    const double l0 = orientation(s, p, c[1], c[2]), l1 = orientation(s, c[0], p, c[2]);
    const double l2 = orientation(s, c[0], c[1], p);
    return (l0 * rho[0] + l1 * rho[1] + l2 * rho[2]) / (l0 + l1 + l2);
  };
  const ChordTriangle t{{chord2(s, c[0], c[1]), chord2(s, c[1], c[2]), chord2(s, c[2], c[0])},
                        orientation(s, c[0], c[1], c[2])};
  const Moments exact = moments_of(s, integrate(s, t, rho), c);
  const Cubature got = density_moments(s, c, density, {.relative_tolerance = 1e-13});
  RC_ASSERT(got.converged);
  RC_ASSERT(difference(got.moments, exact, size) < 2e-13);
}

TEST(PolygonCubature, OfASharpDensityAgreeWithBruteForce) {
  const std::vector<Central> corner{
      {1, -0.1}, {0.5, 0.85}, {-0.5, 0.7}, {-0.95, -0.2}, {0.2, -0.9}};
  for (const double kappa : {1.0, 0.0, -1.0}) {
    for (const double size : {0.9, 0.3, 0.02}) {
      const Space s{kappa};
      const Polygon c = from_central(s, corner, size);
      const Moments exact = brute_force(s, c, sharp, 16);
      for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
        const Cubature got = density_moments(s, c, sharp, {.relative_tolerance = tolerance});
        EXPECT_TRUE(got.converged);
        EXPECT_LE(got.error, tolerance);
        EXPECT_LE(difference(got.moments, exact, reach_of(c)), got.error + 1e-14)
            << kappa << " " << size << " " << tolerance;
      }
    }
  }
}

TEST(PolygonCubature, OfQuadraticDensitiesOverAHemisphereAreKnown) {
  const Polygon hemisphere{{1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
  const auto mass = [&](const OffsetDensity& density) {
    return density_moments({1}, hemisphere, density, {.relative_tolerance = 1e-11}).moments.m;
  };
  EXPECT_NEAR(mass([](const Offset& p) { return p.x * p.x; }), 2 * pi / 3, 1e-10);
  EXPECT_NEAR(mass([](const Offset& p) { return (1 - p.h) * (1 - p.h); }), 2 * pi / 3, 1e-10);
  // exp(20 z): int_0^1 2 pi exp(20 z - 20) dz, and the same about a point of the rim.
  const double exact = 2 * pi * (1 - std::exp(-20)) / 20;
  EXPECT_NEAR(mass([](const Offset& p) { return std::exp(-20 * p.h); }), exact, 1e-10);
  EXPECT_NEAR(mass([](const Offset& p) { return std::exp(20 * p.x - 20); }), exact / 2, 1e-8);
}

RC_GTEST_PROP(PolygonCubature, ErrorBoundIsHonest, ()) {
  const Space s = space();
  const double size = *rc::gen::element(0.05, 0.3, 1.0);
  const Polygon c = convex(s, size);
  const double x = number(-0.7, 0.7), y = number(-0.7, 0.7), sharpness = number(0, 40);
  const double floor = *rc::gen::element(0.0, 0.1, 1.0), wave = number(0, 12);
  const auto density = [&](const Offset& p) {
    const double dx = p.x - x, dy = p.y - y;
    return std::exp(-sharpness * (dx * dx + dy * dy)) +
           floor * (1 + std::sin(wave * p.x) * std::cos(wave * p.y)) + 1 / (1 + 30 * dx * dx);
  };
  const Moments exact = density_moments(s, c, density, {.relative_tolerance = 1e-13}).moments;
  const double tolerance = std::pow(10.0, -*rc::gen::inRange(2, 13));
  const Cubature got = density_moments(s, c, density, {.relative_tolerance = tolerance});
  RC_ASSERT(got.converged);
  RC_ASSERT(got.error <= std::max(tolerance, 1e-14) * (1 + 1e-12));
  RC_ASSERT(difference(got.moments, exact, reach_of(c)) <= got.error + 1e-13);
}

TEST(PolygonCubature, BudgetThatRunsOutIsReported) {
  const Space s{-1};
  const Polygon c = from_central(s, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, 0.8);
  const auto step = [](const Offset& p) { return p.x + 0.3 * p.y > 0.1 ? 1.0 : 0.0; };
  const Cubature fine = density_moments(s, c, step, {1e-10, 4'000'000});
  const Cubature got = density_moments(s, c, step, {1e-10, 100'000});
  EXPECT_FALSE(got.converged);
  EXPECT_GE(got.evaluations, 100'000);
  EXPECT_LT(got.evaluations, 101'000);
  EXPECT_GT(got.error, 1e-10);
  EXPECT_LT(got.error, 1e-2);
  EXPECT_LE(difference(got.moments, fine.moments, reach_of(c)), got.error);
}

TEST(PolygonCubature, OfASmoothDensityOnASmallCellTakeOneRule) {
  for (const double kappa : {1.0, 0.0, -1.0}) {
    const Space s{kappa};
    std::vector<Central> hexagon;
    for (int i = 0; i < 6; ++i) {
      hexagon.push_back({std::cos(i * pi / 3), std::sin(i * pi / 3)});
    }
    const Polygon c = from_central(s, hexagon, 0.02);
    const auto density = [](const Offset& p) { return sharp({p.x + 0.2, p.y - 0.1, 0}); };
    const Cubature got = density_moments(s, c, density);
    EXPECT_EQ(got.evaluations, 6 * (12 + 16));
    EXPECT_LE(difference(got.moments, brute_force(s, c, density, 2), 0.02), got.error);
  }
}

TEST(PolygonCubature, RulesOfHigherDegreeSpareEvaluations) {
  const Space s{1};
  const Polygon c = from_central(s, {{1, 0}, {0.3, 0.9}, {-0.8, 0.1}, {0, -0.7}}, 0.3);
  EXPECT_LT(density_moments(s, c, sharp, {.relative_tolerance = 1e-12}).evaluations, 8000);
}

TEST(PolygonCubature, NarrowBumpInAHemisphereIsSeen) {
  // exp(-600 c^2): its mass is pi/600. It must not fall between nodes.
  const Polygon hemisphere{{1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
  for (int i = 0; i < 60; ++i) {
    const double r = 0.014 * i, t = 0.7 * i;
    const Offset at = ucvt::from_central({1}, r * std::cos(t), r * std::sin(t));
    const auto bump = [&](const Offset& p) { return std::exp(-600 * chord2({1}, p, at)); };
    const Cubature got = density_moments({1}, hemisphere, bump);
    EXPECT_NEAR(got.moments.m, pi / 600, 1e-10) << i;
  }
}

TEST(PolygonCubature, OfNoMassAreZero) {
  const Polygon c = from_central({1}, {{1, 0}, {0, 1}, {-1, -1}}, 0.1);
  const Cubature got = density_moments({1}, c, [](const Offset&) { return 0.0; });
  EXPECT_TRUE(got.converged);
  EXPECT_EQ(got.error, 0);
  EXPECT_EQ(got.moments.m, 0);
}

}  // namespace
}  // namespace ucvt
