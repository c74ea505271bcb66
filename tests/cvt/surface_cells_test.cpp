// Cells on triangulations that are fine next to them, where faces are cut four at a time.
#include "cvt/surface_cells.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "cvt/tessellation.h"
#include "oracle/brute_voronoi.h"
#include "oracle/surfaces.h"
#include "space/polygon_moments.h"

namespace ucvt {
namespace {

/// Squared sides of faces, and so the rule they are integrated by, differ from surface to surface.
std::shared_ptr<const UniformSurface> fine_surface(const std::string& name) {
  const auto shared = [](UniformSurface t) {
    return std::make_shared<const UniformSurface>(std::move(t));
  };
  if (name == "sphere") {
    return shared(oracle::sphere(oracle::icosphere(4)));
  }
  if (name == "fineSphere") {
    return shared(oracle::sphere(oracle::icosphere(6)));
  }
  if (name == "finestSphere") {
    return shared(oracle::sphere(oracle::icosphere(7)));
  }
  if (name == "torus") {
    return shared(oracle::flat_torus(40, 30));
  }
  if (name == "fineTorus") {
    return shared(oracle::flat_torus(150, 120));
  }
  const UniformizedSurface genus2 = uniformize(oracle::closed(oracle::voxel_frame(2)), {0.05, {}});
  return shared(genus2.value().surface);
}

/// Compares every so many of the cells of n random sites.
void expect_polygons_moments(const UniformSurface& t, std::size_t n, std::size_t stride) {
  const SurfaceMass mass(t, std::vector<double>(t.connectivity().vertex_count(), 1.0));
  const Tessellation sites(mass, oracle::random_points(t, n, 11));
  const auto points = sites.sites();
  const auto moments = sites.cell_moments();
  for (std::size_t i = 0; i < n; i += stride) {
    const Vertex site{static_cast<std::int32_t>(i)};
    const auto cell = oracle::brute_cell(t, sites.place(site), points);
    const Moments exact = uniform_moments(t.space(), cell.corners);
    const double m = exact.m, r = cell.radius;
    EXPECT_NEAR(moments[i].m, m, 1e-9 * m);
    EXPECT_NEAR(moments[i].x, exact.x, 1e-9 * m * r);
    EXPECT_NEAR(moments[i].y, exact.y, 1e-9 * m * r);
    EXPECT_NEAR(moments[i].h, exact.h, 1e-9 * m * r * r);
  }
}

class FineCellsTest : public testing::TestWithParam<const char*> {
 protected:
  const std::shared_ptr<const UniformSurface> t = fine_surface(GetParam());
};

TEST_P(FineCellsTest, MomentsAreThoseOfTheCellsPolygons) {
  expect_polygons_moments(*t, 300, 8);
}

TEST_P(FineCellsTest, TheGradientIsThatOfTheEnergyWhateverTheDensity) {
  std::vector<double> density;
  for (std::size_t v = 0; v < t->connectivity().vertex_count(); ++v) {
    density.push_back(1.5 + std::sin(3.0 * static_cast<double>(v)));
  }
  const SurfaceMass mass(*t, std::move(density));
  const auto energy = [](const Tessellation& sites) {
    double sum = 0;
    for (const Moments& m : sites.cell_moments()) {
      sum += 2 * m.h;
    }
    return sum;
  };
  Tessellation sites(mass, oracle::random_points(*t, 60, 12));
  const auto before = sites.cell_moments();
  for (const std::size_t i : {3, 30, 59}) {
    const double step = 1e-3 * std::sqrt(2 * before[i].h / before[i].m);
    for (const bool along_x : {true, false}) {
      double found = 0;
      for (const double sign : {1.0, -1.0}) {
        std::vector<Offset> target(60);
        target[i] = from_central(t->space(), along_x ? sign * step : 0, along_x ? 0 : sign * step);
        sites.save();
        sites.move(target);
        found += sign * energy(sites) / (2 * step);
        sites.restore();
      }
      const double gradient = -2 * (along_x ? before[i].x : before[i].y);
      EXPECT_NEAR(found, gradient, 1e-4 * std::sqrt(before[i].m * before[i].h));
    }
  }
}

TEST_P(FineCellsTest, SomeCellsAreMeasuredWithoutTheOthers) {
  const SurfaceMass mass(*t, std::vector<double>(t->connectivity().vertex_count(), 1.0));
  const Tessellation sites(mass, oracle::random_points(*t, 60, 13));
  const auto all = sites.cell_moments();
  std::vector<bool> near(60);
  const Connectivity& d = sites.delaunay().connectivity();
  const Vertex one{17};
  near[one.index()] = true;
  d.for_outgoing(one, [&](Halfedge h) { near[d.head(h).index()] = true; });
  std::vector<CellState> some;
  sites.measure({one}, near, some);
  ASSERT_EQ(some.size(), 1U);
  EXPECT_NEAR(some[0].moments.m / all[17].m, 1, 1e-12);
  EXPECT_NEAR(some[0].moments.h / all[17].h, 1, 1e-12);
}

TEST(FewSites, CellsThatMeetThemselvesAreCutRight) {
  for (const std::size_t n : {1, 2, 3, 4, 5}) {
    expect_polygons_moments(oracle::fine_surface_of(0), n, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, FineCellsTest,
                         testing::Values("sphere", "fineSphere", "finestSphere", "torus",
                                         "fineTorus", "genus2"),
                         [](const auto& surface) { return std::string(surface.param); });

}  // namespace
}  // namespace ucvt
