// Iterations for sparse symmetric systems that need a matrix and an approximate inverse only.
#pragma once

#include <functional>
#include <vector>

#include "conformal/symmetric_matrix.h"

namespace ucvt {

/// x = M b for a symmetric positive definite M near the inverse of the matrix.
using Preconditioner = std::function<void(const std::vector<double>& b, std::vector<double>& x)>;

struct KrylovResult {
  int iterations = 0;
  bool converged = false;
};

/// Preconditioned conjugate gradients from x = 0, for a positive definite matrix, until the residual r
/// has fallen to `reduction` of what it was, in the norm sqrt(r M r). Not converged after `limit`
/// iterations, or as soon as the matrix proves not definite.
KrylovResult conjugate_gradients(const SymmetricMatrix& a, const Preconditioner& m,
                                 const std::vector<double>& b, double reduction, int limit,
                                 std::vector<double>& x);

/// The same for any symmetric matrix, by preconditioned minimal residuals (Paige, Saunders 1975).
KrylovResult minimal_residuals(const SymmetricMatrix& a, const Preconditioner& m,
                               const std::vector<double>& b, double reduction, int limit,
                               std::vector<double>& x);

}  // namespace ucvt
