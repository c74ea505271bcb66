// Sparse symmetric systems: the one place that knows how they are solved.
#pragma once

#include <memory>
#include <vector>

#include "conformal/symmetric_matrix.h"

namespace ucvt {

/// Solves a sequence of systems whose matrices have one size and change little from one to the next.
///
/// Large ones by conjugate gradients, or minimal residuals, under a multigrid cycle that serves as
/// long as it is good; small ones, and those on which that fails, by a factorization, its
/// order of elimination found once by nested dissection (METIS).
class SymmetricSolver {
 public:
  SymmetricSolver();
  SymmetricSolver(const SymmetricSolver&) = delete;
  SymmetricSolver& operator=(const SymmetricSolver&) = delete;
  ~SymmetricSolver();

  /// Solves a positive definite system at least to the relative residual `reduction`. Returns false
  /// when the matrix is not positive definite to rounding.
  bool solve_positive_definite(const SymmetricMatrix& matrix, const std::vector<double>& right,
                               double reduction, std::vector<double>& solution);

  /// The same for a matrix with few eigenvalues that are not positive. Returns false when it is
  /// singular.
  bool solve(const SymmetricMatrix& matrix, const std::vector<double>& right, double reduction,
             std::vector<double>& solution);

  /// Unknowns from which on iterations are tried.
  static constexpr std::size_t least_iterated = 3000;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ucvt
