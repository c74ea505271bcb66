#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "mesh/edge_bisection.h"
#include "oracle/open_meshes.h"
#include "result/boundary_curves.h"
#include "ucvt/error.h"
#include "ucvt/remesh.h"

namespace ucvt {
namespace {

double distance(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double distance_to_segment(const Position& p, const Position& a, const Position& b) {
  double along = 0, length2 = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    along += (p[c] - a[c]) * (b[c] - a[c]), length2 += (b[c] - a[c]) * (b[c] - a[c]);
  }
  const double s = std::clamp(along / length2, 0.0, 1.0);
  return distance(p,
                  {a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2])});
}

double distance_to_boundary(const TriangleMesh& mesh, const Position& p) {
  double least = HUGE_VAL;
  for (const auto& loop : boundary_loops(mesh)) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto a = static_cast<std::size_t>(loop[i]);
      const auto b = static_cast<std::size_t>(loop[(i + 1) % loop.size()]);
      least = std::min(least, distance_to_segment(p, mesh.positions[a], mesh.positions[b]));
    }
  }
  return least;
}

struct Case {
  const char* name;
  TriangleMesh mesh;
  int genus, loops, sites;
};

class OpenRemeshTest : public testing::TestWithParam<Case> {};

TEST_P(OpenRemeshTest, KeepsTopologyAndBoundary) {
  const Case& c = GetParam();
  const OpenSurface surface = open_surface(c.mesh);
  RemeshOptions options;
  options.sites = c.sites;
  const RemeshResult result = remesh(surface, options);
  EXPECT_TRUE(result.cvt.converged);
  EXPECT_TRUE(result.report.simplicial);
  EXPECT_EQ(result.report.vertices, c.sites + result.report.sites_added);
  const MeshSurvey found = survey(result.mesh);
  EXPECT_EQ(found.unused_vertices, 0);
  EXPECT_EQ(found.misoriented_edges, 0);
  const OpenSurface remeshed = open_surface(result.mesh);
  EXPECT_EQ(remeshed.genus, c.genus);
  EXPECT_EQ(remeshed.boundary_loops, c.loops);
  EXPECT_EQ(result.report.genus, c.genus);
  EXPECT_EQ(result.report.boundary_loops, c.loops);
  for (const auto& loop : boundary_loops(result.mesh)) {
    for (const std::int32_t v : loop) {
      const Position& p = result.mesh.positions[static_cast<std::size_t>(v)];
      EXPECT_LT(distance_to_boundary(surface.mesh, p), 1e-12);
    }
  }
  const MeshSurvey input = survey(surface.mesh);
  EXPECT_NEAR(found.area, input.area, 0.05 * input.area);
  EXPECT_GT(result.report.quality.angle_min_deg, 25);
}

INSTANTIATE_TEST_SUITE_P(Open, OpenRemeshTest,
                         testing::Values(Case{"disk", oracle::plate(8), 0, 1, 150},
                                         Case{"annulus", oracle::tube(30, 20), 0, 2, 150},
                                         Case{"torus", oracle::torus_with_holes(1), 1, 1, 200},
                                         Case{"torus_with_two_holes", oracle::torus_with_holes(2),
                                              1, 2, 200}),
                         [](const auto& c) { return c.param.name; });

TEST(OpenRemesh, LevelsLeadToLessEnergyThanSitesFarApart) {
  for (const TriangleMesh& mesh : {oracle::tube(30, 20), oracle::torus_with_holes(1)}) {
    const OpenSurface surface = open_surface(mesh);
    RemeshOptions options;
    options.sites = 600;
    const RemeshResult levels = remesh(surface, options);
    options.init = InitialSites::Farthest;
    const RemeshResult far = remesh(surface, options);
    EXPECT_EQ(levels.mesh.positions.size(), 600U);
    EXPECT_LT(levels.cvt.energy.back(), 0.999 * far.cvt.energy.back());
    EXPECT_GT(levels.report.quality.regular, far.report.quality.regular);
  }
}

TEST(OpenRemesh, CornersAreVertices) {
  const OpenSurface surface = open_surface(oracle::plate(8));
  RemeshOptions options;
  options.sites = 100;
  const RemeshResult result = remesh(surface, options);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}) {
    const Position corner{x, y, 0.2 * x * x};
    EXPECT_EQ(std::count(result.mesh.positions.begin(), result.mesh.positions.end(), corner), 1)
        << x << " " << y;
  }
}

TEST(OpenRemesh, DoesNotDependOnThreads) {
  RemeshOptions options;
  options.sites = 120;
  options.iterations = 40;
  options.threads = 1;
  const OpenSurface surface = open_surface(oracle::torus_with_holes(2));
  const RemeshResult one = remesh(surface, options);
  options.threads = 3;
  const RemeshResult three = remesh(surface, options);
  EXPECT_EQ(one.mesh.positions, three.mesh.positions);
  EXPECT_EQ(one.mesh.faces, three.mesh.faces);
}

TEST(OpenRemesh, SaysHowManySitesTheBoundaryNeeds) {
  RemeshOptions options;
  options.sites = 5;
  try {
    remesh(open_surface(oracle::plate(8)), options);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("ask for at least"), std::string::npos);
  }
}

TEST(BoundaryCurves, AToothedBoundaryHasNoCornerAtEveryTooth) {
  // A square with teeth of a hundredth of its side: four corners to coarse cells, all to fine ones.
  TriangleMesh square{{{0.5, 0.5, 0}}, {}};
  const auto add = [&](double x, double y) { square.positions.push_back({x, y, 0}); };
  const int n = 50;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < n; ++i) {
      const double s = static_cast<double>(i) / n, tooth = i % 2 == 1 ? 0.02 : 0.0;
      side == 0   ? add(s, tooth)
      : side == 1 ? add(1 - tooth, s)
      : side == 2 ? add(1 - s, 1 - tooth)
                  : add(tooth, 1 - s);
    }
  }
  for (std::int32_t i = 0; i < 4 * n; ++i) {
    square.faces.push_back({0, 1 + i, 1 + (i + 1) % (4 * n)});
  }
  EXPECT_EQ(boundary_curves(square, 0.4).arcs.size(), 4U);
  EXPECT_GT(boundary_curves(square, 0.01).arcs.size(), 150U);
}

TEST(BoundarySites, AreSpreadAtTheSpacingThreeAtLeast) {
  const TriangleMesh tube = oracle::tube(60, 10);
  const BoundaryCurves curves = boundary_curves(tube, 0.5);
  ASSERT_EQ(curves.loops.size(), 2U);
  const auto wide = boundary_sites(tube, curves, 100);
  EXPECT_EQ(wide[0].size(), 3U);
  EXPECT_EQ(wide[1].size(), 3U);
  const auto sites = boundary_sites(tube, curves, 0.5);
  EXPECT_EQ(sites[0].size(), 13U);  // of a circle of radius 1
  std::set<std::int32_t> seen;
  for (const BoundarySite& site : sites[0]) {
    EXPECT_TRUE(seen.insert(site.vertex).second);
    EXPECT_FALSE(site.fixed);
  }
}

TEST(OpenRemesh, ATriangleOfNoWidthEndsInAnError) {
  // The plane that it is laid out in overflows.
  const TriangleMesh mesh{{{0, 0, 0}, {1, 2, 3}, {-1, -2, -3 + 1e-11}}, {{0, 1, 2}}};
  RemeshOptions options;
  options.sites = 20;
  EXPECT_THROW(remesh(open_surface(mesh), options), NumericalError);
}

}  // namespace
}  // namespace ucvt
