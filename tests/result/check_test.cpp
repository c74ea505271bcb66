#include "ucvt/check.h"

#include <gtest/gtest.h>

#include "conformal/uniformize.h"
#include "oracle/meshes.h"
#include "oracle/open_meshes.h"
#include "result/cell_complex.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

RemeshResult remeshed(const TriangleMesh& mesh, int sites) {
  RemeshOptions options;
  options.sites = sites, options.iterations = 100;
  return remesh(oracle::closed(mesh), options);
}

/// The result with its tessellation changed.
template <typename Change>
RemeshResult changed(RemeshResult result, Change change) {
  CellComplex cells = *result.cells;
  change(cells);
  result.cells = std::make_shared<const CellComplex>(std::move(cells));
  return result;
}

TEST(SelfCheck, SoundResultsPassByAWideMargin) {
  for (const auto& [mesh, sites] : {std::pair{oracle::bumpy(oracle::icosphere(2), 0.05, 1), 300},
                                    {oracle::grid_torus(20, 12), 300},
                                    {oracle::voxel_frame(2), 200},
                                    {oracle::finger(6, 0.1, 12), 300}}) {
    const RemeshResult result = remeshed(mesh, sites);
    EXPECT_NO_THROW(check(result));
    const SelfCheck found = measure_errors(result);
    EXPECT_LT(found.surface_angle_rad, 1e-10);
    EXPECT_LT(found.site_angle_rad, 1e-10);
    EXPECT_LT(found.area, 1e-10);
    EXPECT_LT(found.mass, 1e-10);
    EXPECT_LT(found.circle, 1e-10);
    EXPECT_LT(found.place, 1e-9);
  }
}

TEST(SelfCheck, LoopsAndDoubleEdgesAreSound) {
  RemeshOptions options;
  options.sites = 3, options.ensure_simplicial = false;
  const RemeshResult result = remesh(oracle::closed(oracle::grid_torus(20, 12)), options);
  ASSERT_FALSE(result.report.simplicial);
  EXPECT_NO_THROW(check(result));
}

TEST(SelfCheck, FindsAnOffsetThatIsWrong) {
  const RemeshResult result = remeshed(oracle::voxel_frame(2), 100);
  EXPECT_THROW(check(changed(result,
                             [](CellComplex& cells) {
                               const Halfedge h{0};
                               Offset o = cells.delaunay.offset(h);
                               o = from_central({-1}, o.x * 1.001 / (1 + o.h),
                                                o.y * 1.001 / (1 + o.h));
                               cells.delaunay.correct(h, o);
                             })),
               NumericalError);
}

TEST(SelfCheck, FindsASiteThatIsElsewhere) {
  const RemeshResult result = remeshed(oracle::grid_torus(20, 12), 100);
  EXPECT_THROW(check(changed(result,
                             [&](CellComplex& cells) {
                               move_place(result.surface.value().surface, cells.places[7],
                                          from_central({0}, 0.003, 0));
                             })),
               NumericalError);
}

TEST(SelfCheck, FindsAMissingFace) {
  RemeshResult result = remeshed(oracle::grid_torus(20, 12), 100);
  result.mesh.faces.pop_back();
  EXPECT_THROW(check(result), NumericalError);
}

RemeshResult open_remeshed(const TriangleMesh& mesh, int sites) {
  RemeshOptions options;
  options.sites = sites, options.iterations = 100;
  return remesh(open_surface(mesh), options);
}

TEST(SelfCheck, SoundOpenResultsPassByAWideMargin) {
  for (const auto& [mesh, sites] : {std::pair{oracle::plate(6), 120},
                                    {oracle::tube(24, 20), 150},
                                    {oracle::torus_with_holes(1), 150},
                                    {oracle::torus_with_holes(2), 150}}) {
    const RemeshResult result = open_remeshed(mesh, sites);
    EXPECT_NO_THROW(check(result));
    const SelfCheck found = measure_errors(result);
    EXPECT_LT(found.site_angle_rad, 1e-9);
    EXPECT_LT(found.mass, 1e-9);
    EXPECT_LT(found.circle, 1e-9);
    EXPECT_LT(found.place, 1e-8);
    EXPECT_LT(found.mirror, 1e-9);
  }
}

TEST(SelfCheck, FindsAnOpenResultThatIsNotItsMirrorImage) {
  RemeshResult result = open_remeshed(oracle::tube(24, 20), 150);
  const UniformSurface& t = result.surface.value().surface;
  const SurfaceMass mass(t, result.density);
  std::vector<SurfacePoint> points;
  for (const Site& s : result.sites) {
    points.push_back({{s.face}, s.bary});
  }
  // The last site by itself, a tenth of the way to the middle of its face.
  for (double& b : points.back().bary) {
    b = 0.9 * b + 0.1 / 3;
  }
  result.cells = cell_complex(Tessellation(mass, points));
  const SelfCheck found = measure_errors(result);
  EXPECT_LT(found.place, 1e-8);
  EXPECT_GT(found.mirror, 1e-4);
  EXPECT_THROW(check(result), NumericalError);
}

TEST(SelfCheck, FindsAHoleTooMany) {
  RemeshResult result = open_remeshed(oracle::tube(24, 20), 150);
  result.mesh.faces.erase(result.mesh.faces.begin());
  EXPECT_THROW(check(result), NumericalError);
}

}  // namespace
}  // namespace ucvt
