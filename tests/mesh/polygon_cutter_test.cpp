#include "mesh/polygon_cutter.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "mesh_test_support.h"

namespace ucvt::test {
namespace {

std::vector<Corners> cut(const std::vector<Position>& positions) {
  std::vector<std::int32_t> corners(positions.size());
  std::iota(corners.begin(), corners.end(), 0);
  PolygonCutter cutter(positions, 16);
  cutter.add_boundary(corners);
  std::vector<Corners> triangles;
  cutter.cut(corners, triangles);
  return triangles;
}

double doubled_area(const std::vector<Position>& p, const Corners& t) {
  const Position &a = p[static_cast<std::size_t>(t[0])], &b = p[static_cast<std::size_t>(t[1])],
                 &c = p[static_cast<std::size_t>(t[2])];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Positive triangles whose areas add up to the polygon's and whose inner sides match cover it once.
void expect_valid(const std::vector<Position>& p, const std::vector<Corners>& triangles) {
  ASSERT_EQ(triangles.size(), p.size() - 2);
  double sum = 0, whole = 0;
  std::map<std::pair<std::int32_t, std::int32_t>, int> sides;
  for (const Corners& t : triangles) {
    EXPECT_GT(doubled_area(p, t), 0);
    sum += doubled_area(p, t);
    for (std::size_t i = 0; i < 3; ++i) {
      ++sides[{t[i], t[(i + 1) % 3]}];
    }
  }
  const auto n = static_cast<std::int32_t>(p.size());
  for (std::int32_t i = 0; i < n; ++i) {
    if (i > 0 && i + 1 < n) {
      whole += doubled_area(p, {0, i, i + 1});
    }
    EXPECT_EQ((sides[{i, (i + 1) % n}]), 1);
    sides[{(i + 1) % n, i}] += 1;
  }
  EXPECT_NEAR(sum, whole, 1e-12 * whole);
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ((sides.count({side.second, side.first})), 1U);
  }
}

const std::vector<Position> concave = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 4, 0},
                                       {3, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};

TEST(PolygonCutter, CutsConcavePolygons) {
  expect_valid(concave, cut(concave));
  const std::vector<Position> dart = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}};
  expect_valid(dart, cut(dart));
  for (int shift = 0; shift < 4; ++shift) {
    std::vector<Position> turned = dart;
    std::rotate(turned.begin(), turned.begin() + shift, turned.end());
    expect_valid(turned, cut(turned));
  }
}

TEST(PolygonCutter, CutsPolygonsWithCollinearCorners) {
  const std::vector<Position> p = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0},
                                   {3, 1, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}};
  expect_valid(p, cut(p));
  const std::vector<Position> triangle = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 3, 0}};
  expect_valid(triangle, cut(triangle));
}

TEST(PolygonCutter, CutsRandomStars) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.05, 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Position> p;
    const int n = 4 + trial % 40;
    for (int i = 0; i < n; ++i) {
      const double r = radius(random), a = 2 * std::numbers::pi * i / n;
      p.push_back({r * std::cos(a), r * std::sin(a), 0});
    }
    expect_valid(p, cut(p));
  }
}

TEST(PolygonCutter, DoesNotDependOnScaleOrPlace) {
  for (const double scale : {0x1p-1000, 0x1p-40, 0x1p40, 0x1p1000}) {
    std::vector<Position> p = concave;
    for (Position& point : p) {
      for (double& c : point) {
        c *= scale;
      }
    }
    EXPECT_EQ(cut(p), cut(concave)) << scale;
  }
  std::vector<Position> upright;
  for (const Position& point : concave) {
    upright.push_back({point[2], point[0], point[1]});
  }
  EXPECT_EQ(cut(upright).size(), concave.size() - 2);
}

TEST(PolygonCutter, NothingIsAnEar) {
  EXPECT_EQ(cut(std::vector<Position>(7, Position{1, 2, 3})).size(), 5U);
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}).size(), 3U);
  EXPECT_EQ(cut({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, 3, 0}}).size(), 3U);
}

TEST(PolygonCutter, DoesNotUseAnEdgeTwice) {
  // Two quads back to back and a fin on one diagonal: both must take the other diagonals.
  const auto mesh = read_bytes("a.off",
                               "OFF\n6 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 1\n0 2 1\n4 0 1 2 3\n3 "
                               "0 2 4\n3 2 0 5\n3 1 2 4\n");
  const std::vector<Corners> expected = {{1, 2, 3}, {1, 3, 0}, {0, 2, 4}, {2, 0, 5}, {1, 2, 4}};
  EXPECT_EQ(mesh.faces, expected);
  const auto pillow =
      read_bytes("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n4 3 2 1 0\n");
  EXPECT_EQ(closed_surface(pillow).genus, 0);
}

TEST(PolygonCutter, RepeatedCornersStayVisible) {
  const auto mesh = read_bytes("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 2 4\n");
  EXPECT_GT(survey(mesh).repeated_corner_faces, 0);
  const auto pinched = read_bytes("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 1 4\n");
  EXPECT_GT(survey(pinched).repeated_corner_faces, 0);
}

TEST(EdgeSet, KeepsEdgesWhileItGrows) {
  EdgeSet set(1);
  for (std::int32_t i = 0; i < 1000; ++i) {
    set.insert(i, 3 * i + 1);
  }
  for (std::int32_t i = 0; i < 1000; ++i) {
    EXPECT_TRUE(set.contains(3 * i + 1, i));
    EXPECT_FALSE(set.contains(i, 3 * i + 2));
  }
}

}  // namespace
}  // namespace ucvt::test
