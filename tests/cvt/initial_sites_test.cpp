#include "cvt/initial_sites.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "oracle/surfaces.h"

namespace ucvt {
namespace {

TEST(RandomSites, AreDeterministicForASeed) {
  const UniformSurface t = oracle::flat_torus(6, 5);
  const std::vector<double> weight(30, 1.0);
  const auto a = random_sites(t, weight, 50, 7), b = random_sites(t, weight, 50, 7);
  const auto c = random_sites(t, weight, 50, 8);
  int same = 0;
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_EQ(a[i].face, b[i].face);
    EXPECT_EQ(a[i].bary, b[i].bary);
    EXPECT_NEAR(a[i].bary[0] + a[i].bary[1] + a[i].bary[2], 1, 1e-15);
    EXPECT_GE(*std::ranges::min_element(a[i].bary), 0);
    same += a[i].bary == c[i].bary ? 1 : 0;
  }
  EXPECT_EQ(same, 0);
}

TEST(RandomSites, FollowTheWeights) {
  const UniformSurface t = oracle::flat_torus(6, 5);
  std::vector<double> weight(30, 1.0);
  // Vertices 0 to 9 weigh three: 30 of 50 parts.
  std::fill_n(weight.begin(), 10, 3.0);
  const std::size_t n = 20000;
  std::vector<double> share(30);
  for (const SurfacePoint& p : random_sites(t, weight, n, 1)) {
    const auto top = std::ranges::max_element(p.bary) - p.bary.begin();
    const Halfedge h = halfedges(p.face)[static_cast<std::size_t>(top)];
    share[t.connectivity().origin(h).index()] += 1 / static_cast<double>(n);
  }
  for (std::size_t v = 0; v < 30; ++v) {
    // Five standard deviations of a binomial.
    const double wanted = weight[v] / 50;
    EXPECT_NEAR(share[v], wanted, 5 * std::sqrt(wanted / static_cast<double>(n)));
  }
}

TEST(RandomSites, NeverFallWhereTheWeightIsZero) {
  const UniformSurface t = oracle::flat_torus(6, 5);
  std::vector<double> weight(30, 0.0);
  weight[17] = 1;
  for (const SurfacePoint& p : random_sites(t, weight, 100, 2)) {
    const auto top = std::ranges::max_element(p.bary) - p.bary.begin();
    EXPECT_EQ(t.connectivity().origin(halfedges(p.face)[static_cast<std::size_t>(top)]).id, 17);
  }
}

TEST(FarthestSites, AreVerticesWellSpread) {
  const UniformSurface t = oracle::flat_torus(12, 12, 0, 1);
  const auto sites = farthest_sites(t, t.chords(), 16, 3);
  ASSERT_EQ(sites.size(), 16U);
  std::set<std::int32_t> used;
  for (const SurfacePoint& p : sites) {
    const auto top = std::ranges::max_element(p.bary) - p.bary.begin();
    EXPECT_EQ(p.bary[static_cast<std::size_t>(top)], 1);
    used.insert(t.connectivity().origin(halfedges(p.face)[static_cast<std::size_t>(top)]).id);
  }
  EXPECT_EQ(used.size(), 16U);
  // Sixteen sites on the unit torus: the best spacing is near 0.27, and a farthest-point
  // sequence has at least half of that.
  for (const std::int32_t a : used) {
    for (const std::int32_t b : used) {
      if (a == b) {
        continue;
      }
      const auto wrapped = [](int d) { return std::min(std::abs(d), 12 - std::abs(d)) / 12.0; };
      EXPECT_GT(std::hypot(wrapped(a / 12 - b / 12), wrapped(a % 12 - b % 12)), 0.13);
    }
  }
}

TEST(FarthestSites, CanTakeEveryVertex) {
  const UniformSurface t = oracle::flat_torus(6, 5);
  EXPECT_EQ(farthest_sites(t, t.chords(), 30, 3).size(), 30U);
}

}  // namespace
}  // namespace ucvt
