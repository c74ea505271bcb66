// The restricted Voronoi diagram that the figures compare with is a right one.
#include "restricted_voronoi/restricted_voronoi.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "oracle/meshes.h"
#include "ucvt/error.h"
#include "ucvt/remesh.h"

namespace ucvt {
namespace {

std::vector<Position> sites_on(const TriangleMesh& mesh, int n) {
  RemeshOptions options;
  options.sites = n;
  options.init = InitialSites::Random;
  options.iterations = 0;
  options.ensure_simplicial = false;
  return remesh(oracle::closed(mesh), options).mesh.positions;
}

TEST(RestrictedVoronoi, CellsShareOutTheSurface) {
  for (const auto& mesh : {oracle::icosphere(3), oracle::grid_torus(30, 12)}) {
    for (const int n : {10, 300, 1000}) {
      double area = 0;
      Position moment{};
      for (const auto& cell : restricted::restricted_voronoi(mesh, sites_on(mesh, n)).cells) {
        area += cell.area;
        for (std::size_t k = 0; k < 3; ++k) {
          moment[k] += cell.area * cell.centroid[k];
        }
      }
      EXPECT_NEAR(area, survey(mesh).area, 1e-9);
      EXPECT_NEAR(std::hypot(moment[0], moment[1], moment[2]), 0, 1e-9);
    }
  }
}

TEST(RestrictedVoronoi, DualOfManySitesIsTheSurface) {
  for (const auto& [mesh, genus] :
       {std::pair{oracle::icosphere(3), 0}, std::pair{oracle::grid_torus(30, 12), 1}}) {
    const auto sites = sites_on(mesh, 2000);
    const auto d = restricted::restricted_voronoi(mesh, sites);
    for (const auto& cell : d.cells) {
      EXPECT_EQ(cell.parts, 1);
    }
    EXPECT_EQ(closed_surface({sites, d.dual}).genus, genus);
    EXPECT_EQ(closed_surface({sites, d.dual}).reoriented_faces, 0);
  }
}

TEST(RestrictedVoronoi, CellsOfSheetsThatNearlyTouchHaveSeveralParts) {
  // A flat ring, its two sheets 0.02 apart and the sites ten times that.
  TriangleMesh mesh = oracle::grid_torus(60, 24);
  for (Position& p : mesh.positions) {
    p[2] *= 0.025;
  }
  const auto sites = sites_on(mesh, 200);
  const auto d = restricted::restricted_voronoi(mesh, sites);
  EXPECT_TRUE(std::ranges::any_of(d.cells, [](const auto& cell) { return cell.parts > 1; }));
  EXPECT_THROW(closed_surface({sites, d.dual}), InvalidInput);
}

}  // namespace
}  // namespace ucvt
