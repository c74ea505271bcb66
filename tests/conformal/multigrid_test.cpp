#include "conformal/multigrid.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "conformal/krylov.h"
#include "oracle/laplacians.h"

namespace ucvt {
namespace {

using oracle::as_vector;
using oracle::grid_laplacian;
using oracle::noise;
using oracle::residual;

TEST(Multigrid, IsASymmetricPositiveDefiniteOperator) {
  Multigrid m;
  ASSERT_TRUE(m.build(grid_laplacian(40, 31, 0.01, 40)));
  std::vector<double> mx, my;
  for (unsigned seed = 1; seed < 6; ++seed) {
    const std::vector<double> x = noise(40 * 31, seed), y = noise(40 * 31, seed + 10);
    m.apply(x, mx);
    m.apply(y, my);
    const double xmy = as_vector(x).dot(as_vector(my)), ymx = as_vector(y).dot(as_vector(mx));
    const double xmx = as_vector(x).dot(as_vector(mx));
    EXPECT_GT(xmx, 0);
    EXPECT_NEAR(xmy, ymx, 1e-5 * xmx);
  }
}

TEST(Multigrid, TakesAboutAsManyIterationsAtEverySize) {
  for (const int side : {20, 80, 320}) {
    const SymmetricMatrix a = grid_laplacian(side, side, 1e-6, 1);
    Multigrid m;
    ASSERT_TRUE(m.build(a));
    std::vector<double> x;
    const auto b = noise(a.size(), 3);
    const auto cycle = [&](const auto& from, auto& to) { m.apply(from, to); };
    const KrylovResult done = conjugate_gradients(a, cycle, b, 1e-8, 100, x);
    EXPECT_TRUE(done.converged);
    EXPECT_LE(done.iterations, 25) << side;
    EXPECT_LT(residual(a, x, b), 1e-5);
  }
}

TEST(Multigrid, RefusesWhatIsNotDefinite) {
  SymmetricMatrix a = grid_laplacian(20, 20, 0, 1);
  a.diagonal[17] = -1;
  EXPECT_FALSE(Multigrid().build(a));
}

}  // namespace
}  // namespace ucvt
