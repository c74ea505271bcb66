// From one level of a multigrid solver to the next coarser one.
#pragma once

#include <vector>

#include "conformal/symmetric_matrix.h"

namespace ucvt {

/// Any sparse matrix, by rows.
struct SparseRows {
  std::vector<std::int32_t> begin{0}, column;
  std::vector<double> value;
  [[nodiscard]] std::size_t size() const { return begin.size() - 1; }
};

/// How fine unknowns depend on coarse ones.
struct Interpolation {
  SparseRows rows;  ///< one per fine unknown; empty for those with no ties at all
  std::int32_t coarse_size = 0;
};

/// Smoothed aggregation (Vanek, Mandel, Brezina 1996). A tie is strong when |a_ij| is more than
/// `strength` times the geometric mean of the diagonal's entries.
Interpolation smoothed_aggregation(const SymmetricMatrix& a, double strength);

SparseRows transpose(const SparseRows& m, std::int32_t columns);

/// P^T A P for the interpolation P; `transposed` is P^T.
SymmetricMatrix galerkin_product(const SymmetricMatrix& a, const Interpolation& p,
                                 const SparseRows& transposed);

}  // namespace ucvt
