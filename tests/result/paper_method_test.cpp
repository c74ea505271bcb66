// The tessellation against the paper's own way to it: copies of the sites, a power diagram in the
// Klein disk.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "oracle/meshes.h"
#include "paper_method/lloyd.h"
#include "result/cell_complex.h"
#include "ucvt/remesh.h"

namespace ucvt {
namespace {

std::vector<SurfacePoint> points(const std::vector<Site>& sites) {
  std::vector<SurfacePoint> out;
  for (const Site& s : sites) {
    out.push_back({{s.face}, s.bary});
  }
  return out;
}

RemeshResult remeshed(const TriangleMesh& mesh, int sites, int iterations,
                      InitialSites init = InitialSites::Multilevel) {
  RemeshOptions options;
  options.sites = sites;
  options.iterations = iterations;
  options.init = init;
  return remesh(oracle::closed(mesh), options);
}

void expect_same_triangles(const RemeshResult& r) {
  ASSERT_TRUE(r.report.simplicial);
  const paper::Lloyd method(r.surface.value(), points(r.sites));
  const auto expected = paper::quotient(method.current_diagram());
  const auto found = paper::quotient(r.cells->delaunay);
  std::vector<Corners> differ;
  std::ranges::set_symmetric_difference(found, expected, std::back_inserter(differ));
  EXPECT_EQ(found.size(), expected.size());
  EXPECT_TRUE(differ.empty()) << differ.size() << " triangles differ";
}

TEST(PaperMethod, CopiesGiveTheSameDelaunayTriangles) {
  for (const int genus : {1, 2, 3}) {
    SCOPED_TRACE(genus);
    expect_same_triangles(remeshed(oracle::voxel_frame(genus), 200, 20));
    expect_same_triangles(remeshed(oracle::voxel_frame(genus), 400, 0, InitialSites::Random));
  }
}

TEST(PaperMethod, HullGivesTheSameDelaunayTrianglesOnASphere) {
  expect_same_triangles(remeshed(oracle::bumpy(oracle::icosphere(2), 0.1, 1), 200, 20));
}

TEST(PaperMethod, CopiesAreSixteenGSquaredLessEightG) {
  for (const int genus : {1, 2, 3}) {
    const RemeshResult r = remeshed(oracle::voxel_frame(genus), 100, 0);
    const paper::Lloyd method(r.surface.value(), points(r.sites));
    const auto copies = static_cast<std::size_t>(16 * genus * genus - 8 * genus);
    EXPECT_EQ(method.domain().neighbour.size(), copies);
    EXPECT_EQ(method.current_diagram().points.size(), (copies + 1) * r.sites.size());
  }
}

/// The domain with what lies across the sides of its neighbours as well, as far as doubles tell them.
paper::FundamentalDomain with_second_ring(const paper::FundamentalDomain& d) {
  constexpr double apart = 0.1, far = 1e6;  // of images of the origin, and their largest z
  paper::FundamentalDomain out = d;
  out.neighbour.clear();
  const auto image = [](const ModelMatrix& m) { return ModelPoint{m[0][2], m[1][2], m[2][2]}; };
  std::vector<ModelPoint> known{{0, 0, 1}};
  const auto add = [&](const ModelMatrix& m) {
    const ModelPoint p = image(m);
    if (p[2] < far &&
        std::ranges::none_of(
            known,
            [&](const ModelPoint& q) { return std::hypot(p[0] - q[0], p[1] - q[1]) < apart; })) {
      known.push_back(p), out.neighbour.push_back(m);
    }
  };
  std::ranges::for_each(d.neighbour, add);
  for (const ModelMatrix& m : d.neighbour) {
    for (const ModelMatrix& back : d.back) {
      ModelMatrix product{};
      for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          product[i / 3][i % 3] += m[i / 3][k] * back[k][i % 3];
        }
      }
      add(product);
    }
  }
  return out;
}

TEST(PaperMethod, FewSitesNeedMoreThanTheNeighbours) {
  // Cells so large that they reach past a neighbour: the copies of the paper do not always show every
  // neighbour of theirs. Those of the neighbours' neighbours do, or nearly.
  RemeshOptions options;
  options.sites = 22;
  options.init = InitialSites::Random;
  options.iterations = 0;
  options.ensure_simplicial = false;
  int mended = 0;
  for (options.seed = 1; options.seed <= 40 && mended == 0; ++options.seed) {
    const RemeshResult r = remesh(oracle::closed(oracle::voxel_frame(3)), options);
    const auto expected = paper::quotient(r.cells->delaunay);
    const auto [domain, sites] = paper::laid_out_domain(r.surface.value().surface, points(r.sites));
    if (paper::quotient(paper::diagram(domain, sites)) != expected) {
      const auto with_more = paper::quotient(paper::diagram(with_second_ring(domain), sites));
      mended += with_more == expected ? 1 : 0;
    }
  }
  EXPECT_GT(mended, 0);
}

TEST(PaperMethod, LloydFindsAlmostTheSameCentroids) {
  // The grid's sums and the factor 1/z that they lack leave a part of the cell's size.
  for (const auto& mesh :
       {oracle::icosphere(2), oracle::grid_torus(20, 12), oracle::voxel_frame(2)}) {
    const RemeshResult start = remeshed(mesh, 200, 0, InitialSites::Random);
    RemeshOptions options;
    options.method = Method::Lloyd;
    options.iterations = 30;
    options.tolerance = 1e-300;
    options.ensure_simplicial = false;
    options.initial_sites = start.sites;
    const RemeshResult exact = remesh(oracle::closed(mesh), options);
    paper::Lloyd method(exact.surface.value(), points(start.sites));
    method.run(30);
    options.iterations = 0;
    options.initial_sites.clear();
    for (const SurfacePoint& p : method.sites()) {
      options.initial_sites.push_back({p.face.id, p.bary});
    }
    const RemeshResult summed = remesh(oracle::closed(mesh), options);
    EXPECT_NEAR(summed.cvt.energy.front() / exact.cvt.energy.back(), 1, 0.01);
    EXPECT_LT(summed.cvt.max_move.front(), 0.05);
  }
}

}  // namespace
}  // namespace ucvt
