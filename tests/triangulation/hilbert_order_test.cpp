#include "triangulation/hilbert_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace ucvt {
namespace {

using Points = std::vector<std::array<double, 3>>;

/// Points of a cube in an order that says nothing.
Points shuffled_grid(int n) {
  Points out;
  for (int i = 0; i < n * n * n; ++i) {
    out.push_back({static_cast<double>(i / (n * n)), static_cast<double>(i / n % n),
                   static_cast<double>(i % n)});
  }
  std::shuffle(out.begin(), out.end(), std::mt19937_64(3));
  return out;
}

Points random_in_cube(std::size_t n) {
  std::mt19937_64 random(5);
  const auto number = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  Points out;
  while (out.size() < n) {
    out.push_back({number(), number(), number()});
  }
  return out;
}

double gap(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

TEST(HilbertOrder, StepsOfAGridGoToNeighbours) {
  for (const int n : {2, 4, 8, 16}) {
    const Points points = shuffled_grid(n);
    const auto order = hilbert_order(points);
    ASSERT_EQ(order.size(), points.size());
    for (std::size_t i = 1; i < order.size(); ++i) {
      EXPECT_EQ(gap(points[order[i - 1]], points[order[i]]), 1) << n << " " << i;
    }
  }
}

TEST(HilbertOrder, IsAPermutationThatKeepsNeighboursNear) {
  const Points points = random_in_cube(10000);
  auto order = hilbert_order(points);
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    length += gap(points[order[i - 1]], points[order[i]]);
  }
  // Spacing 10000^(-1/3) = 0.046; in random order a step is 0.66.
  EXPECT_LT(length / 10000, 0.06);
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) {
    ASSERT_EQ(order[i], i);
  }
}

TEST(HilbertOrder, PointsAtOnePlaceKeepTheirOrder) {
  EXPECT_EQ(hilbert_order(Points(5, {1, 2, 3})), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  const Points two{{1, 1, 1}, {0, 0, 0}, {1, 1, 1}, {0, 0, 0}};
  const auto order = hilbert_order(two);
  EXPECT_EQ(std::abs(std::distance(std::ranges::find(order, 0U), std::ranges::find(order, 2U))), 1);
  EXPECT_LT(std::ranges::find(order, 0U), std::ranges::find(order, 2U));
  EXPECT_LT(std::ranges::find(order, 1U), std::ranges::find(order, 3U));
}

TEST(HilbertOrder, AnyScaleAndNumber) {
  EXPECT_TRUE(hilbert_order({}).empty());
  EXPECT_EQ(hilbert_order({{7, 0, 0}}), std::vector<std::size_t>{0});
  const Points points = random_in_cube(500);
  const auto order = hilbert_order(points);
  // Up to the greatest doubles, where differences of coordinates overflow.
  for (const double scale : {0x1p-1000, 0x1p-30, 0x1p40, 0x1p1023}) {
    Points other = points;
    for (auto& p : other) {
      for (double& x : p) {
        x *= scale;
      }
    }
    EXPECT_EQ(hilbert_order(other), order) << scale;
  }
  constexpr double most = std::numeric_limits<double>::max();
  const auto ends = hilbert_order({{most, 0, 0}, {-most, 0, 0}, {-most, 0, 0}});
  EXPECT_EQ(ends, (std::vector<std::size_t>{1, 2, 0}));
}

}  // namespace
}  // namespace ucvt
