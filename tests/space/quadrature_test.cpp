#include "space/quadrature.h"

#include <cmath>

#include <gtest/gtest.h>

namespace ucvt {
namespace {

/// Mean of b0^i b1^j b2^k over the triangle: 2 i! j! k! / (i + j + k + 2)!.
double monomial(int i, int j, int k) {
  return 2 * std::exp(std::lgamma(i + 1) + std::lgamma(j + 1) + std::lgamma(k + 1) -
                      std::lgamma(i + j + k + 3));
}

class TriangleRule : public testing::TestWithParam<int> {};

TEST_P(TriangleRule, IsExactUpToItsDegree) {
  const int degree = GetParam();
  const auto& rule = triangle_rule(degree);
  for (int total = 0; total <= degree; ++total) {
    for (int i = 0; i <= total; ++i) {
      for (int j = 0; i + j <= total; ++j) {
        const int k = total - i - j;
        double sum = 0;
        for (const auto& q : rule) {
          sum += q.weight * std::pow(q.b0, i) * std::pow(q.b1, j) * std::pow(q.b2, k);
        }
        ASSERT_NEAR(sum / monomial(i, j, k), 1, 1e-12) << i << " " << j << " " << k;
      }
    }
  }
}

TEST_P(TriangleRule, NodesLieInsideAndWeightsArePositive) {
  for (const auto& q : triangle_rule(GetParam())) {
    EXPECT_GT(std::min({q.b0, q.b1, q.b2, q.weight}), 0);
    EXPECT_NEAR(q.b0 + q.b1 + q.b2, 1, 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, TriangleRule, testing::Range(0, 31));
INSTANTIATE_TEST_SUITE_P(Greatest, TriangleRule, testing::Values(63, 64));

}  // namespace
}  // namespace ucvt
