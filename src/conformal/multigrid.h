// Algebraic multigrid: a cheap approximate inverse of a matrix like the Laplacian of a surface.
//
// Smoothed aggregation (Vanek, Mandel, Brezina 1996): unknowns with strong ties form aggregates,
// the next coarser level's unknowns; interpolation is constant on them, then smoothed by a Jacobi
// step. One V-cycle with Gauss-Seidel forwards on the way down and backwards on the way up is a
// symmetric positive definite operator, as conjugate gradients need it (docs/uniformization.md).
#pragma once

#include <vector>

#include <Eigen/Cholesky>

#include "conformal/symmetric_matrix.h"

namespace ucvt {

class Multigrid {
 public:
  /// Prepares the levels for a symmetric positive definite matrix. Returns false when the matrix is
  /// not definite or its unknowns do not group into fewer: another solver must help.
  bool build(const SymmetricMatrix& a);

  /// One V-cycle from zero for the right side b; linear in b to rounding to floats.
  void apply(const std::vector<double>& b, std::vector<double>& x);

 private:
  /// Rows of numbers in single precision: a preconditioner needs no more.
  struct Rows {
    std::vector<std::int32_t> begin{0}, column;
    std::vector<float> value;
  };
  struct Level {
    Rows a;  ///< off the diagonal; in each row lower columns come first
    std::vector<std::int32_t>
        diagonal;                ///< where in each row of `a` those above the diagonal begin
    std::vector<float> inverse;  ///< of the diagonal
    Rows to_fine, to_coarse;     ///< interpolation from the next level, and its transpose
    std::vector<float> x, b;
  };
  void cycle(std::size_t level);
  static Level make_level(const SymmetricMatrix& a);

  std::vector<Level> levels_;  ///< all but the coarsest
  Eigen::LLT<Eigen::MatrixXd> coarsest_;
  Eigen::VectorXd coarsest_x_;
};

}  // namespace ucvt
