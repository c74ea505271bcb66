#include "conformal/krylov.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "oracle/laplacians.h"

namespace ucvt {
namespace {

using oracle::as_vector;
using oracle::dense;
using oracle::grid_laplacian;
using oracle::noise;

void copy(const std::vector<double>& from, std::vector<double>& to) {
  to = from;
}

TEST(Krylov, MinimalResidualsSolveWhatIsNotDefinite) {
  SymmetricMatrix a = grid_laplacian(9, 8, 0, 20);
  for (double& d : a.diagonal) {
    d -= 0.7;
  }
  ASSERT_LT(dense(a).selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -0.5);
  const auto b = noise(a.size(), 2);
  std::vector<double> x;
  EXPECT_TRUE(minimal_residuals(a, copy, b, 1e-11, 500, x).converged);
  const Eigen::VectorXd expected = dense(a).partialPivLu().solve(as_vector(b));
  EXPECT_LT((as_vector(x) - expected).norm(), 1e-8 * expected.norm());
  EXPECT_FALSE(conjugate_gradients(a, copy, b, 1e-11, 500, x).converged);
}

TEST(Krylov, SaysWhenItRanOutOfIterations) {
  const SymmetricMatrix a = grid_laplacian(30, 30, 1e-6, 1);
  std::vector<double> x;
  for (const auto& method : {conjugate_gradients, minimal_residuals}) {
    const KrylovResult done = method(a, copy, noise(a.size(), 4), 1e-9, 5, x);
    EXPECT_FALSE(done.converged);
    EXPECT_EQ(done.iterations, 5);
  }
}

}  // namespace
}  // namespace ucvt
