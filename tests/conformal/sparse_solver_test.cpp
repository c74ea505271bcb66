#include "conformal/sparse_solver.h"

#include <gtest/gtest.h>

#include "oracle/laplacians.h"

namespace ucvt {
namespace {

using oracle::grid_laplacian;
using oracle::noise;
using oracle::residual;

TEST(SymmetricSolver, SolvesSmallAndLargeSystems) {
  for (const int side : {5, 30, 70}) {
    for (const double stretch : {1.0, 1000.0}) {
      const SymmetricMatrix a = grid_laplacian(side, side, 1e-3, stretch);
      const auto b = noise(a.size(), 7);
      std::vector<double> x;
      EXPECT_TRUE(SymmetricSolver().solve_positive_definite(a, b, 1e-12, x));
      EXPECT_LT(residual(a, x, b), 1e-7);
    }
  }
}

TEST(SymmetricSolver, SolvesWithAFewNegativeEigenvalues) {
  for (const int side : {20, 80}) {
    // The Laplacian's least eigenvalue on a torus is 0, the next 4 (pi/side)^2.
    SymmetricMatrix a = grid_laplacian(side, side, 0, 1);
    for (double& d : a.diagonal) {
      d -= 10.0 / (side * side);
    }
    const auto b = noise(a.size(), 7);
    std::vector<double> x;
    EXPECT_TRUE(SymmetricSolver().solve(a, b, 1e-10, x));
    EXPECT_LT(residual(a, x, b), 1e-6) << side;
  }
}

TEST(SymmetricSolver, FollowsAMatrixThatChanges) {
  SymmetricSolver solver;
  std::vector<double> x;
  for (const double stretch : {1.0, 3.0, 100.0, 1e4, 1.0}) {
    const SymmetricMatrix a = grid_laplacian(60, 60, 1e-3, stretch);
    const auto b = noise(a.size(), 9);
    EXPECT_TRUE(solver.solve_positive_definite(a, b, 1e-12, x));
    EXPECT_LT(residual(a, x, b), 1e-7) << stretch;
  }
}

TEST(SymmetricSolver, RefusesWhatIsNotDefinite) {
  for (const int side : {20, 60}) {
    SymmetricMatrix a = grid_laplacian(side, side, 0, 1);
    a.diagonal[17] = -1;
    std::vector<double> x;
    EXPECT_FALSE(SymmetricSolver().solve_positive_definite(a, noise(a.size(), 1), 1e-6, x));
  }
}

}  // namespace
}  // namespace ucvt
