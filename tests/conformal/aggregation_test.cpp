#include "conformal/aggregation.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "oracle/laplacians.h"

namespace ucvt {
namespace {

using oracle::dense;
using oracle::grid_laplacian;

TEST(Aggregation, InterpolatesConstantsWhereRowsSumToZero) {
  const SymmetricMatrix a = grid_laplacian(17, 13, 0, 1);
  const Interpolation p = smoothed_aggregation(a, 0.08);
  EXPECT_LT(p.coarse_size, 17 * 13 / 3);
  for (std::size_t i = 0; i < a.size(); ++i) {
    double sum = 0;
    for (auto k = p.rows.begin[i]; k < p.rows.begin[i + 1]; ++k) {
      sum += p.rows.value[static_cast<std::size_t>(k)];
    }
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

TEST(Aggregation, GalerkinProductIsThatOfDenseMatrices) {
  const SymmetricMatrix a = grid_laplacian(9, 7, 0.3, 5);
  const Interpolation p = smoothed_aggregation(a, 0.08);
  const SparseRows transposed = transpose(p.rows, p.coarse_size);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(a.size()), p.coarse_size);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (auto k = p.rows.begin[i]; k < p.rows.begin[i + 1]; ++k) {
      full(static_cast<Eigen::Index>(i), p.rows.column[static_cast<std::size_t>(k)]) +=
          p.rows.value[static_cast<std::size_t>(k)];
    }
  }
  const Eigen::MatrixXd expected = full.transpose() * dense(a) * full;
  EXPECT_LT((dense(galerkin_product(a, p, transposed)) - expected).norm(), 1e-12 * expected.norm());
}

TEST(Aggregation, LeavesUnknownsWithoutTiesAlone) {
  SymmetricMatrix a = grid_laplacian(8, 8, 0.1, 1);
  a.end_row(1);
  const Interpolation p = smoothed_aggregation(a, 0.08);
  EXPECT_EQ(p.rows.begin[64], p.rows.begin[65]);
}

}  // namespace
}  // namespace ucvt
