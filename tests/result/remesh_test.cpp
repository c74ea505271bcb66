#include "ucvt/remesh.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>
#include <unistd.h>

#include "oracle/meshes.h"
#include "oracle/surfaces.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

struct Case {
  const char* name;
  TriangleMesh mesh;
  int genus;
};

class RemeshTest : public testing::TestWithParam<Case> {};

/// Distance of p from the nearest triangle, by its plane and its three sides' half-spaces: 0 inside.
double distance_to(const TriangleMesh& mesh, const Position& p) {
  const auto minus = [](const Position& x, const Position& y) {
    return Position{x[0] - y[0], x[1] - y[1], x[2] - y[2]};
  };
  const auto crossed = [](const Position& x, const Position& y) {
    return Position{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
                    x[0] * y[1] - x[1] * y[0]};
  };
  const auto dot = [](const Position& x, const Position& y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  };
  double least = HUGE_VAL;
  for (const Corners& f : mesh.faces) {
    const Position &a = mesh.positions[static_cast<std::size_t>(f[0])],
                   &b = mesh.positions[static_cast<std::size_t>(f[1])],
                   &c = mesh.positions[static_cast<std::size_t>(f[2])];
    const Position n = crossed(minus(b, a), minus(c, a));
    const double area2 = std::sqrt(dot(n, n));
    double out = std::abs(dot(n, minus(p, a))) / area2;
    for (const auto& [x, y] : {std::pair{a, b}, {b, c}, {c, a}}) {
      out = std::max(out, -dot(n, crossed(minus(y, x), minus(p, x))) / area2);
    }
    least = std::min(least, out);
  }
  return least;
}

TEST_P(RemeshTest, IsAClosedSimplicialMeshOfTheSameGenus) {
  const ClosedSurface surface = oracle::closed(GetParam().mesh);
  ASSERT_EQ(surface.genus, GetParam().genus);
  for (const int n : {10, 60, 300}) {
    SCOPED_TRACE(n);
    RemeshOptions options;
    options.sites = n, options.iterations = 60;
    const RemeshResult out = remesh(surface, options);
    const ClosedSurface again = closed_surface(out.mesh);
    EXPECT_EQ(again.genus, surface.genus);
    EXPECT_EQ(again.reoriented_faces, 0);
    EXPECT_EQ(survey(out.mesh).unused_vertices, 0);
    EXPECT_TRUE(out.report.simplicial);
    EXPECT_EQ(out.report.genus, surface.genus);
    EXPECT_EQ(out.report.vertices, n + out.report.sites_added);
    EXPECT_EQ(out.mesh.positions.size(), static_cast<std::size_t>(out.report.vertices));
    EXPECT_EQ(out.mesh.faces.size(), static_cast<std::size_t>(out.report.faces));
    EXPECT_EQ(out.sites.size(), out.mesh.positions.size());
    for (const Position& p : out.mesh.positions) {
      EXPECT_LT(distance_to(surface.mesh, p), 1e-9);
    }
  }
}

double signed_volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Corners& f : mesh.faces) {
    const auto at = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(f[i])]; };
    const Position a = at(0), b = at(1), c = at(2);
    sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
            a[2] * (b[0] * c[1] - b[1] * c[0])) /
           6;
  }
  return sum;
}

TEST_P(RemeshTest, IsTurnedTheSameSideOutAsTheInput) {
  RemeshOptions options;
  options.sites = 300, options.iterations = 30;
  const RemeshResult out = remesh(oracle::closed(GetParam().mesh), options);
  EXPECT_NEAR(signed_volume(out.mesh) / signed_volume(GetParam().mesh), 1, 0.15);
}

TEST_P(RemeshTest, HasTheSameBytesForEverySeedAndThreadCount) {
  const ClosedSurface surface = oracle::closed(GetParam().mesh);
  RemeshOptions options;
  options.sites = 80, options.iterations = 10;
  options.threads = 1;
  const RemeshResult one = remesh(surface, options);
  options.threads = 2;
  const RemeshResult two = remesh(surface, options);
  EXPECT_EQ(one.mesh.positions, two.mesh.positions);
  EXPECT_EQ(one.mesh.faces, two.mesh.faces);
  options.seed = 2;
  EXPECT_NE(remesh(surface, options).mesh.positions, one.mesh.positions);
}

TEST_P(RemeshTest, CellsShareTheInputsArea) {
  const ClosedSurface surface = oracle::closed(GetParam().mesh);
  RemeshOptions options;
  options.sites = 200, options.iterations = 200;
  const RemeshResult out = remesh(surface, options);
  const double cells = out.cell_area_3d.mean * static_cast<double>(out.sites.size());
  EXPECT_NEAR(cells / survey(surface.mesh).area, 1, 1e-2);
  EXPECT_LT(out.cell_area_3d.cv, 0.4);
  EXPECT_GT(out.report.quality.q_avg, 0.75);
}

TEST_P(RemeshTest, SitesRoundTripExactlyAndRestart) {
  const ClosedSurface surface = oracle::closed(GetParam().mesh);
  RemeshOptions options;
  options.sites = 70, options.iterations = 5, options.ensure_simplicial = false;
  const RemeshResult out = remesh(surface, options);
  std::string folder = (std::filesystem::temp_directory_path() / "ucvt-sites-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const std::string path = folder + "/sites.json";
  write_sites(path, out);
  const SavedSites saved = read_sites(path);
  const auto& back = saved.sites;
  std::filesystem::remove_all(folder);
  EXPECT_EQ(saved.size, out.size);
  EXPECT_EQ(saved.refine_for, out.refined_for);
  ASSERT_EQ(back.size(), out.sites.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(back[i].face, out.sites[i].face);
    EXPECT_EQ(back[i].bary, out.sites[i].bary);
  }
  options.initial_sites = back, options.iterations = 0;
  const RemeshResult restarted = remesh(surface, options);
  ASSERT_EQ(restarted.mesh.positions.size(), out.mesh.positions.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(restarted.mesh.positions[i][k], out.mesh.positions[i][k], 1e-4);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, RemeshTest,
                         testing::Values(Case{"sphere", oracle::icosphere(2), 0},
                                         Case{"cube", oracle::cube(), 0},
                                         Case{"torus", oracle::grid_torus(16, 10), 1},
                                         Case{"double_torus", oracle::voxel_frame(2), 2}),
                         [](const auto& name) { return std::string(name.param.name); });

TEST(Remesh, MakesRoomForThinHandlesByDensity) {
  const ClosedSurface surface = oracle::closed(oracle::voxel_frame(2));
  RemeshOptions options;
  options.sites = 8, options.iterations = 3000, options.tolerance = 1e-7;
  const RemeshResult out = remesh(surface, options);
  ASSERT_GT(out.report.sites_added, 0);
  EXPECT_TRUE(out.report.simplicial);
  EXPECT_TRUE(out.cvt.converged) << "added sites are at their centroids like all others";
  EXPECT_LT(*std::min_element(out.size.begin(), out.size.end()), 0.9);
  EXPECT_LE(*std::max_element(out.size.begin(), out.size.end()), 1.0);

  RemeshOptions again = options;
  again.initial_sites = out.sites, again.initial_size = out.size,
  again.refine_for = out.refined_for;
  const RemeshResult restarted = remesh(surface, again);
  EXPECT_EQ(restarted.density, out.density);
  EXPECT_EQ(restarted.report.sites_added, 0);
  EXPECT_LE(restarted.cvt.iterations, 3);
  again.initial_size.pop_back();
  EXPECT_THROW(remesh(surface, again), InvalidInput);
}

TEST(Remesh, RefusesWhatDoesNotFit) {
  const ClosedSurface surface = oracle::closed(oracle::cube());
  RemeshOptions options;
  options.sites = 3;
  EXPECT_THROW(remesh(surface, options), InvalidInput);
  options.sites = 10;
  options.initial_sites = std::vector<Site>(10, Site{1000000, {1, 0, 0}});
  EXPECT_THROW(remesh(surface, options), InvalidInput);
  options.initial_sites = std::vector<Site>(10, Site{0, {0.2, 0.3, 0.5}});
  EXPECT_THROW(remesh(surface, options), InvalidInput) << "coincident sites";
}

TEST(Remesh, FewSitesOnASphereWorkForManySeeds) {
  // Ten random points lie in one hemisphere once in eleven times.
  const ClosedSurface surface = oracle::closed(oracle::icosphere(2));
  for (const int n : {4, 5, 10}) {
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
      RemeshOptions options;
      options.sites = n, options.seed = seed, options.iterations = 100;
      try {
        const RemeshResult out = remesh(surface, options);
        EXPECT_EQ(closed_surface(out.mesh).genus, 0) << n << " seed " << seed;
        EXPECT_NEAR(out.uniformity.area.mean * static_cast<double>(out.sites.size()),
                    4 * std::numbers::pi, 1e-6)
            << n << " seed " << seed;
      } catch (const std::exception& e) {
        ADD_FAILURE() << n << " sites, seed " << seed << ": " << e.what();
      }
    }
  }
}

TEST(Sites, FilesThatAreNotSitesAreRefused) {
  EXPECT_THROW(read_sites("/no/such/file.json"), IoError);
  EXPECT_THROW(read_sites("/dev/null"), InvalidInput);
}

TEST(Quality, RegularSolids) {
  for (const TriangleMesh& mesh :
       {oracle::tetrahedron(), oracle::octahedron(), oracle::icosahedron()}) {
    const MeshQuality q = measure_quality(mesh);
    EXPECT_NEAR(q.q_min, 1, 1e-14);
    EXPECT_NEAR(q.q_avg, 1, 1e-14);
    EXPECT_NEAR(q.angle_min_deg, 60, 1e-12);
    EXPECT_NEAR(q.angle_min_avg_deg, 60, 1e-12);
    EXPECT_EQ(q.below_30, 0);
    EXPECT_EQ(q.regular, 0);
  }
  EXPECT_EQ(measure_quality(oracle::seven_vertex_torus()).regular, 1);
  const MeshQuality cube = measure_quality(oracle::cube());
  // A right isosceles triangle: 6/sqrt 3 * (1/2) / ((1 + sqrt 2 / 2) sqrt 2).
  const double right = 3 / std::sqrt(3) / ((1 + std::sqrt(2) / 2) * std::sqrt(2));
  EXPECT_NEAR(cube.q_min, right, 1e-14);
  EXPECT_NEAR(cube.angle_min_deg, 45, 1e-12);
}

TEST(Quality, ASliverIsCounted) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-3, 0}, {0.5, 1, 0}},
                          {{0, 1, 2}, {0, 1, 3}}};
  const MeshQuality q = measure_quality(mesh);
  EXPECT_EQ(q.below_30, 0.5);
  EXPECT_NEAR(q.angle_min_deg, std::atan(2e-3) * 180 / std::numbers::pi, 1e-10);
  EXPECT_LT(q.q_min, 0.01);
}

}  // namespace
}  // namespace ucvt
