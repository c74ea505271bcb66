#include "cvt/thinned_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "cvt/surface_start.h"
#include "cvt/tessellation.h"
#include "oracle/surfaces.h"

namespace ucvt {
namespace {

/// Surfaces of the three geometries with a few hundred vertices or more.
class ThinnedSurfaceTest : public testing::TestWithParam<double> {
 protected:
  static const UniformSurface& t() { return oracle::fine_surface_of(GetParam()); }
};

TEST_P(ThinnedSurfaceTest, IsTheSameSurface) {
  const std::size_t n = t().connectivity().vertex_count();
  const auto steps = thin_out(t(), t().chords(), {n / 3, n / 9});
  ASSERT_EQ(steps.size(), 2U);
  std::size_t more = n;
  for (std::size_t k = 0; k < 2; ++k) {
    const UniformSurface& thin = steps[k].surface();
    const auto wanted = static_cast<double>(n / (k == 0 ? 3 : 9));
    EXPECT_NEAR(static_cast<double>(thin.connectivity().vertex_count()), wanted, 0.5 * wanted);
    EXPECT_LT(thin.connectivity().vertex_count(), more);
    more = thin.connectivity().vertex_count();
    EXPECT_EQ(thin.connectivity().euler_number(), t().connectivity().euler_number());
    EXPECT_LT(oracle::worst_angle_error(thin), 1e-10);
    const double area = oracle::gauss_bonnet_area(t());
    EXPECT_NEAR(steps[k].delaunay().area(), area, 1e-10 * area);
    for (std::size_t i = 0; i < thin.connectivity().halfedge_count(); ++i) {
      EXPECT_TRUE(steps[k].delaunay().is_delaunay({static_cast<std::int32_t>(i)}));
    }
  }
}

TEST_P(ThinnedSurfaceTest, PointsGoThereAndBack) {
  const std::size_t n = t().connectivity().vertex_count();
  const auto steps = thin_out(t(), t().chords(), {n / 8});
  ASSERT_EQ(steps.size(), 1U);
  std::set<std::int32_t> faces;
  for (const SurfacePoint& p : oracle::random_points(t(), 200, 3)) {
    const SurfacePoint thin = steps[0].from_t(p), back = steps[0].to_t(thin);
    faces.insert(thin.face.id);
    // The point itself, unless it lies on an edge to rounding.
    ASSERT_EQ(back.face, p.face);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(back.bary[i], p.bary[i], 1e-10);
    }
  }
  EXPECT_GT(faces.size(), 30U);
}

TEST_P(ThinnedSurfaceTest, CarriesWhatVerticesHave) {
  const std::size_t n = t().connectivity().vertex_count();
  const auto steps = thin_out(t(), t().chords(), {n / 5});
  ASSERT_EQ(steps.size(), 1U);
  std::vector<double> value(n);
  std::iota(value.begin(), value.end(), 1.0);
  const std::vector<double> sum = steps[0].summed(value);
  EXPECT_EQ(sum.size(), steps[0].surface().connectivity().vertex_count());
  const double n1 = static_cast<double>(n);
  EXPECT_NEAR(std::accumulate(sum.begin(), sum.end(), 0.0), n1 * (n1 + 1) / 2, 1e-9 * n1 * n1);
  for (const double mean : steps[0].averaged(std::vector<double>(n, 2.5))) {
    EXPECT_NEAR(mean, 2.5, 1e-14);
  }
  const std::vector<double> mean = steps[0].averaged(value);
  EXPECT_GE(*std::ranges::min_element(mean), 1);
  EXPECT_LE(*std::ranges::max_element(mean), n1);
}

TEST_P(ThinnedSurfaceTest, GivesTheSameDelaunayTriangulation) {
  const std::size_t n = t().connectivity().vertex_count();
  const auto steps = thin_out(t(), t().chords(), {n / 8});
  ASSERT_EQ(steps.size(), 1U);
  const SurfaceMass mass(t(), std::vector<double>(n, 1.0));
  const auto points = oracle::random_points(t(), 60, 5);
  const Tessellation plain(mass, points), by_base(mass, points, &steps[0]);
  // The edges, by their ends and lengths.
  const auto edges = [](const DelaunayTriangulation& d) {
    std::vector<std::array<double, 3>> out;
    for (std::size_t i = 0; i < d.connectivity().halfedge_count(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)};
      out.push_back({static_cast<double>(d.connectivity().origin(h).id),
                     static_cast<double>(d.connectivity().head(h).id), d.offset(h).h});
    }
    std::sort(out.begin(), out.end());
    return out;
  };
  const auto a = edges(plain.delaunay()), b = edges(by_base.delaunay());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i][0], b[i][0]);
    EXPECT_EQ(a[i][1], b[i][1]);
    EXPECT_NEAR(a[i][2], b[i][2], 1e-9 * a[i][2]);
  }
  // Frames of D and of the places are the same ones: cells have the same moments.
  const auto p = plain.cell_moments(), q = by_base.cell_moments();
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p[i].m, q[i].m, 1e-10 * p[i].m);
    EXPECT_NEAR(p[i].h, q[i].h, 1e-9 * p[i].h);
    EXPECT_NEAR(std::hypot(p[i].x, p[i].y), std::hypot(q[i].x, q[i].y), 1e-9 * p[i].m);
  }
}

TEST_P(ThinnedSurfaceTest, AStartLevelByLevelHasFewDefects) {
  const std::size_t n = t().connectivity().vertex_count();
  const SurfaceMass mass(t(), std::vector<double>(n, 1.0));
  const std::vector<double> weight(n, 1.0);
  constexpr int sites = 400;
  const auto thinned = thin_out(t(), t().chords(), thinned_counts(t(), sites));
  const auto start = [&](std::uint64_t seed) {
    return multilevel_start({mass, weight, thinned}, sites, seed, Method::Lbfgs, {});
  };
  const auto points = start(1), same = start(1), other = start(2);
  ASSERT_EQ(points.size(), static_cast<std::size_t>(sites));
  std::size_t moved = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].face, same[i].face);
    EXPECT_EQ(points[i].bary, same[i].bary);
    moved += points[i].bary != other[i].bary ? 1 : 0;
  }
  EXPECT_GT(moved, points.size() / 2);
  const Tessellation level_by_level(mass, points);
  const auto random = random_tessellation(mass, weight, sites, 1);
  const auto irregular = [](const Tessellation& s) {
    int count = 0;
    for (std::size_t i = 0; i < s.site_count(); ++i) {
      count += s.delaunay().connectivity().degree({static_cast<std::int32_t>(i)}) != 6 ? 1 : 0;
    }
    return count;
  };
  EXPECT_LT(irregular(level_by_level), sites / 5);
  EXPECT_GT(irregular(*random), sites / 2);
}

INSTANTIATE_TEST_SUITE_P(Spaces, ThinnedSurfaceTest, testing::Values(1.0, 0.0, -1.0));

}  // namespace
}  // namespace ucvt
