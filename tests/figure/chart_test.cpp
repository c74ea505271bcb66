#include "figure/chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "figure/samples.h"
#include "figure/svg_reader.h"

namespace ucvt {
namespace {

using oracle::PathStep;

Chart sphere_chart(double lon_deg, double lat_deg) {
  return {Projection::Orthographic, sphere_view(lon_deg, lat_deg), 300, {320, 310}};
}

double signed_area(const std::vector<PathStep>& steps) {
  double twice = 0;
  const std::size_t n = steps.size() - 1;
  for (std::size_t i = 0; i < n; ++i) {
    const PathStep &a = steps[i], &b = steps[(i + 1) % n];
    twice += a.x * b.y - a.y * b.x;
  }
  return -twice / 2;  // y runs down
}

RC_GTEST_PROP(Chart, CellsCutAtTheHorizonFillTheDisk, ()) {
  const Chart chart = sphere_chart(*rc::gen::inRange(-180, 181), *rc::gen::inRange(-90, 91));
  double sum = 0;
  for (const SpaceCell& c : oracle::cube(*rc::gen::inRange(1, 6)).cells) {
    const Path path = outline(chart, c.corners);
    if (path.empty()) {
      continue;
    }
    const auto steps = oracle::read_path(path.data());
    for (const PathStep& s : steps) {
      if (s.command == 'Z') {
        continue;
      }
      RC_ASSERT(std::hypot(s.x - 320, s.y - 310) <= 300.002);
    }
    const double area = signed_area(steps);
    RC_ASSERT(area > -2);  // of a sliver at the horizon nothing but the polyline's error is left
    sum += area;
  }
  const double disk = std::numbers::pi * 300 * 300;
  // The polylines run up to 0.0002 of a radius within the horizon.
  RC_ASSERT(sum <= disk + 5);
  RC_ASSERT(sum >= disk * (1 - 0.0006));
}

TEST(Chart, CellsBehindTheHorizonAreHidden) {
  const SpaceResult cube = oracle::cube(1);
  const Chart chart = sphere_chart(0, 0);
  for (std::size_t i = 0; i < cube.cells.size(); ++i) {
    EXPECT_EQ(outline(chart, cube.cells[i].corners).empty(), cube.sites[i][0] < -0.5) << i;
  }
}

TEST(Chart, ViewPutsNorthUpAndTheAskedPointInTheMiddle) {
  const Chart chart = sphere_chart(30, 40);
  const double lon = std::numbers::pi / 6, lat = std::numbers::pi / 4.5;
  const Pixel middle =
      pixel(chart, {std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)});
  EXPECT_NEAR(middle.x, 320, 1e-9);
  EXPECT_NEAR(middle.y, 310, 1e-9);
  const Pixel north = pixel(chart, {0, 0, 1});
  EXPECT_NEAR(north.x, 320, 1e-9);
  EXPECT_LT(north.y, 310);
  const Pixel from_pole = pixel(sphere_chart(-90, 90), {1, 0, 0});
  EXPECT_NEAR(from_pole.x, 620, 1e-9);
}

TEST(Chart, FromBehindSeesTheOtherHalf) {
  Chart chart = sphere_chart(20, 10);
  const ModelPoint p = oracle::unit(0.3, -0.9, 0.2);
  const bool before = visible(chart, p);
  const Pixel at = pixel(chart, p);
  chart.view = from_behind(chart.view);
  EXPECT_NE(visible(chart, p), before);
  EXPECT_NEAR(pixel(chart, p).x, 640 - at.x, 1e-9);
  EXPECT_NEAR(pixel(chart, p).y, at.y, 1e-9);
}

/// Centre of the shorter arc from a to b with b's radius and direction.
Pixel arc_centre(const PathStep& a, const PathStep& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, half = std::hypot(dx, dy) / 2;
  const double height = std::sqrt(b.radius * b.radius - half * half);
  // Clockwise on a screen with y down, the centre lies along (-dy, dx) from the chord.
  const double sign = b.clockwise ? 1 : -1;
  return {(a.x + b.x) / 2 - sign * dy / (2 * half) * height,
          (a.y + b.y) / 2 + sign * dx / (2 * half) * height};
}

TEST(Chart, PoincareEdgesAreArcsAtRightAnglesToTheUnitCircle) {
  const Chart chart{Projection::Poincare, {}, 400, {410, 420}};
  int arcs = 0, lines = 0;
  for (const SpaceCell& c : oracle::klein_square(3).cells) {
    const auto steps = oracle::read_path(outline(chart, c.corners).data());
    ASSERT_EQ(steps.size(), 6U);
    for (std::size_t i = 0; i < 4; ++i) {
      const PathStep &a = steps[i], &b = steps[i + 1];
      const ModelPoint &p = c.corners[i], &q = c.corners[(i + 1) % 4];
      const double mx = p[0] + q[0], my = p[1] + q[1], mz = p[2] + q[2];
      const double norm = std::sqrt(mz * mz - mx * mx - my * my);
      const Pixel middle = pixel(chart, {mx / norm, my / norm, mz / norm});
      if (b.command == 'L') {
        ++lines;
        EXPECT_NEAR(middle.x, (a.x + b.x) / 2, 0.01);
        EXPECT_NEAR(middle.y, (a.y + b.y) / 2, 0.01);
        continue;
      }
      ++arcs;
      const Pixel centre = arc_centre(a, b);
      const double from_disk = std::hypot(centre.x - 410, centre.y - 420);
      EXPECT_NEAR(std::sqrt(from_disk * from_disk - b.radius * b.radius), 400, 1.5)
          << "rounded ends move the centre";
      EXPECT_NEAR(std::hypot(middle.x - centre.x, middle.y - centre.y), b.radius, 0.005)
          << "the arc passes through the middle of the geodesic";
    }
  }
  EXPECT_GE(arcs, 32);
  EXPECT_LE(lines, 4);
}

TEST(Chart, GeodesicsThroughTheCentreOfThePoincareDiskAreStraight) {
  const Chart chart{Projection::Poincare, {}, 400, {410, 420}};
  const auto steps = oracle::read_path(
      outline(chart, {lifted(-1, {-0.5, 0}), lifted(-1, {0.5, 0}), lifted(-1, {0.5, 0.5})}).data());
  EXPECT_EQ(steps[1].command, 'L');
  EXPECT_EQ(steps[2].command, 'A');
}

TEST(Chart, KleinEdgesAreStraight) {
  const Chart chart{Projection::Klein, {}, 400, {410, 420}};
  const auto steps =
      oracle::read_path(outline(chart, oracle::klein_square(1).cells[0].corners).data());
  ASSERT_EQ(steps.size(), 5U);
  EXPECT_NEAR(steps[0].x, 410 - 400 * 0.7, 0.001);
  EXPECT_NEAR(steps[0].y, 420 + 400 * 0.6, 0.001);
  EXPECT_TRUE(
      std::none_of(steps.begin(), steps.end(), [](const PathStep& s) { return s.command == 'A'; }));
}

TEST(Chart, LiftedPointsLieOnTheModel) {
  const ModelPoint p = lifted(-1, {0.6, 0.3});
  EXPECT_NEAR(p[0] / p[2], 0.6, 1e-15);
  EXPECT_NEAR(p[2] * p[2] - p[0] * p[0] - p[1] * p[1], 1, 1e-14);
}

TEST(Chart, DrawnAreaOfASquare) {
  const Chart chart{Projection::Plane, {}, 10, {0, 0}};
  EXPECT_NEAR(drawn_area(chart, oracle::square(2).cells[0].corners), 50, 1e-9);
}

}  // namespace
}  // namespace ucvt
