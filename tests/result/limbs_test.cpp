// Thin limbs: log scales that span hundreds, and cells as even there as elsewhere.
#include "oracle/limbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "conformal/uniformize.h"
#include "cvt/tessellation.h"
#include "oracle/surfaces.h"
#include "result/density.h"
#include "result/even_sizes.h"
#include "ucvt/remesh.h"

namespace ucvt {
namespace {

/// The coefficient of variation of the areas round a mesh's vertices, a third of each face: cells by a
/// measure that knows nothing of T.
double vertex_area_cv(const TriangleMesh& mesh) {
  std::vector<double> area(mesh.positions.size());
  for (const Corners& f : mesh.faces) {
    const double share = survey({mesh.positions, {f}}).area / 3;
    for (const std::int32_t v : f) {
      area[static_cast<std::size_t>(v)] += share;
    }
  }
  double mean = 0, square = 0;
  for (const double a : area) {
    mean += a, square += a * a;
  }
  const auto n = static_cast<double>(area.size());
  mean /= n;
  return std::sqrt(std::max(0.0, square / n - mean * mean)) / mean;
}

TEST(Limbs, MeshesAreClosedAndOfGenus0) {
  for (const TriangleMesh& mesh : {oracle::capped_cylinder(3, 12), oracle::octopus(2, 2)}) {
    const ClosedSurface surface = closed_surface(mesh);
    EXPECT_EQ(surface.genus, 0);
    EXPECT_EQ(surface.reoriented_faces, 0);
    EXPECT_EQ(survey(mesh).unused_vertices, 0);
  }
  // A tube of girth 1 and two hemispheres, but for the corners that were cut.
  EXPECT_NEAR(survey(oracle::capped_cylinder(3, 60)).area, 3 + 1 / std::numbers::pi, 0.01);
}

TEST(Limbs, AreUniformizedWhereChordsSpanMoreThanDoublesSquared) {
  const Uniformized t =
      uniformize_surface(oracle::closed(oracle::capped_cylinder(80, 6)), UniformizeOptions{});
  EXPECT_GT(t.report.log_scale_max - t.report.log_scale_min, 200);
  EXPECT_LE(t.report.max_angle_error, 1e-10);
  const auto density =
      sizing_density(conformal_factor(t), std::vector<double>(t.log_scale.size(), 1));
  const auto [low, high] = std::minmax_element(density.begin(), density.end());
  EXPECT_GT(*low, std::numeric_limits<double>::min());
  EXPECT_NEAR(*low * *high, 1, 1e-9);
}

TEST(Limbs, TheConformalFactorIsSmoothOnARegularGrid) {
  // Diagonals of its squares are arbitrary, on the input and on T each in their own way.
  const Uniformized t = uniformize_surface(oracle::closed(oracle::capped_cylinder(10, 12)),
                                           UniformizeOptions{0.07, {}});
  const std::vector<double> factor = conformal_factor(t);
  const Connectivity& c = t.surface.connectivity();
  double square = 0;
  for (std::size_t v = 0; v < factor.size(); ++v) {
    double around = 0;
    int degree = 0;
    c.for_outgoing({static_cast<std::int32_t>(v)}, [&](Halfedge h) {
      around += std::log(factor[c.head(h).index()]);
      ++degree;
    });
    square += std::pow(std::log(factor[v]) - around / degree, 2);
  }
  EXPECT_LT(std::sqrt(square / static_cast<double>(factor.size())), 0.15);
}

TEST(Limbs, CellsOfACylinderAreEven) {
  RemeshOptions options;
  options.sites = 700;
  const RemeshResult out = remesh(oracle::closed(oracle::capped_cylinder(10, 12)), options);
  EXPECT_GT(out.surface.report().log_scale_max - out.surface.report().log_scale_min, 30);
  EXPECT_EQ(closed_surface(out.mesh).genus, 0);
  EXPECT_EQ(out.report.sites_added, 0);
  EXPECT_LT(out.cell_area_3d.cv, 0.055);
  EXPECT_LT(vertex_area_cv(out.mesh), 0.08);
  EXPECT_GT(out.report.quality.q_avg, 0.92);
}

TEST(Limbs, CellsOfAnOctopusAreEven) {
  RemeshOptions options;
  options.sites = 400;
  const RemeshResult out = remesh(oracle::closed(oracle::octopus(6, 2)), options);
  EXPECT_EQ(closed_surface(out.mesh).genus, 0);
  EXPECT_EQ(out.report.sites_added, 0);
  EXPECT_LT(out.cell_area_3d.cv, 0.11);
}

TEST(Limbs, SizesAreEvenedWhereTheLogScaleIsSteepOnly) {
  RemeshOptions options;
  options.sites = 60, options.iterations = 60, options.init = InitialSites::Random;
  const RemeshResult out = remesh(oracle::closed(oracle::icosphere(3)), options);
  EXPECT_EQ(*std::min_element(out.size.begin(), out.size.end()), 1);
  EXPECT_EQ(*std::max_element(out.size.begin(), out.size.end()), 1);

  const Uniformized t = uniformize_surface(oracle::closed(oracle::capped_cylinder(3, 12)),
                                           UniformizeOptions{0.05, {}});
  const SurfaceMass area(t.surface, conformal_factor(t));
  const Tessellation sites(area, oracle::random_points(t.surface, 60, 1));
  std::vector<double> size(area.density().size(), 1.0);
  even_sizes(sites, area, size);
  const std::vector<Moments> cells = sites.cell_moments(area);
  for (std::size_t v = 0; v < size.size(); ++v) {
    EXPECT_GT(size[v], 0.83);
    EXPECT_LT(size[v], 1.2);
  }
  const auto largest = std::max_element(
      cells.begin(), cells.end(), [](const Moments& a, const Moments& b) { return a.m < b.m; });
  for (std::size_t v = 0; v < size.size(); ++v) {
    if (sites.owner({static_cast<std::int32_t>(v)}).index() ==
        static_cast<std::size_t>(largest - cells.begin())) {
      EXPECT_LT(size[v], 1);
    }
  }
}

}  // namespace
}  // namespace ucvt
