#include "conformal/sparse_solver.h"

#include <algorithm>
#include <cmath>
#include <iostream>  // MetisSupport forgets it

#include <Eigen/MetisSupport>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "conformal/krylov.h"
#include "conformal/multigrid.h"

namespace ucvt {
namespace {

/// Nested dissection pays from this size on; below, minimum degree orders in no time.
constexpr Eigen::Index least_dissected = 2000;

/// Iterations under one preconditioner after which to give up, and after which the next system is
/// better served by a new one.
constexpr int most_under_multigrid = 100, renew_multigrid_after = 40;
constexpr int most_under_factors = 25, renew_factors_after = 12;

/// What the residual is reduced to at least where the factors are at hand.
constexpr double under_factors = 1e-6;

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
using Natural = Eigen::NaturalOrdering<int>;

Matrix lower_triangle(const SymmetricMatrix& a) {
  const auto n = static_cast<Eigen::Index>(a.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(a.size() + a.column.size() / 2);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int row = static_cast<int>(i);
    entries.emplace_back(row, row, a.diagonal[i]);
    a.for_row(i, [&](std::size_t j, double value) {
      if (j < i) {
        entries.emplace_back(row, static_cast<int>(j), value);
      }
    });
  }
  Matrix out(n, n);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

Permutation elimination_order(const Matrix& lower) {
  Permutation inverse;
  const Matrix full = lower.selfadjointView<Eigen::Lower>();
  if (full.rows() < least_dissected) {
    Eigen::AMDOrdering<int>()(full, inverse);
  } else {
    Eigen::MetisOrdering<int>()(full, inverse);
  }
  return inverse.inverse();
}

}  // namespace

struct SymmetricSolver::State {
  enum class Kind { None, Multigrid, Factors } kind = Kind::None;
  bool multigrid_fails = false;
  Multigrid multigrid;
  Permutation order;
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Natural> factors;
  bool worn = false;

  Matrix ordered(const SymmetricMatrix& a) {
    const Matrix lower = lower_triangle(a);
    if (order.size() != lower.rows()) {
      order = elimination_order(lower);
    }
    Matrix out(lower.rows(), lower.rows());
    out.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order);
    return out;
  }

  /// Makes a preconditioner of the matrix; false when it has none.
  bool renew(const SymmetricMatrix& a) {
    worn = false;
    if (a.size() >= least_iterated && !multigrid_fails) {
      kind = Kind::Multigrid;
      if (multigrid.build(a)) {
        return true;
      }
      multigrid_fails = true;
    }
    kind = Kind::Factors;
    factors.compute(ordered(a));
    kind = factors.info() == Eigen::Success ? Kind::Factors : Kind::None;
    return kind == Kind::Factors;
  }

  void apply(const std::vector<double>& b, std::vector<double>& x) {
    if (kind == Kind::Multigrid) {
      multigrid.apply(b, x);
      return;
    }
    const auto n = static_cast<Eigen::Index>(b.size());
    const Vector y = factors.solve(order * Eigen::Map<const Vector>(b.data(), n));
    Eigen::Map<Vector>(x.data(), n) = order.inverse() * y;
  }

  /// Iterates with the preconditioner at hand, then with new ones; `made_of` is what those are made of.
  template <class Method>
  bool iterate(const Method& method, const SymmetricMatrix& a, const SymmetricMatrix& made_of,
               const std::vector<double>& b, double reduction, std::vector<double>& x) {
    const Preconditioner m = [this](const auto& from, auto& to) { apply(from, to); };
    for (;;) {
      const bool fresh = kind == Kind::None || worn;
      if (fresh && !renew(made_of)) {
        return false;
      }
      const bool by_multigrid = kind == Kind::Multigrid;
      const int limit = by_multigrid ? most_under_multigrid : most_under_factors;
      // Under factors there is little to save.
      const double wanted = by_multigrid ? reduction : std::min(reduction, under_factors);
      const KrylovResult done = method(a, m, b, wanted, limit, x);
      if (done.converged) {
        worn = done.iterations > (by_multigrid ? renew_multigrid_after : renew_factors_after);
        return true;
      }
      if (fresh && kind == Kind::Factors) {
        return false;
      }
      multigrid_fails = multigrid_fails || fresh;
      worn = true;
    }
  }
};

SymmetricSolver::SymmetricSolver() : state_(std::make_unique<State>()) {}
SymmetricSolver::~SymmetricSolver() = default;

bool SymmetricSolver::solve_positive_definite(const SymmetricMatrix& matrix,
                                              const std::vector<double>& right, double reduction,
                                              std::vector<double>& solution) {
  return state_->iterate(conjugate_gradients, matrix, matrix, right, reduction, solution);
}

bool SymmetricSolver::solve(const SymmetricMatrix& matrix, const std::vector<double>& right,
                            double reduction, std::vector<double>& solution) {
  if (matrix.size() >= least_iterated && !state_->multigrid_fails) {
    // What is positive in the matrix is its part that is like a Laplacian.
    SymmetricMatrix dominant = matrix;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      double sum = 0;
      matrix.for_row(i, [&](std::size_t, double value) { sum += std::abs(value); });
      dominant.diagonal[i] = std::max(sum, matrix.diagonal[i]);
    }
    if (state_->iterate(minimal_residuals, matrix, dominant, right, reduction, solution)) {
      return true;
    }
  }
  const Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Natural> factors(state_->ordered(matrix));
  if (factors.info() != Eigen::Success) {
    return false;
  }
  const auto n = static_cast<Eigen::Index>(right.size());
  const Permutation& order = state_->order;
  const Vector x = factors.solve(order * Eigen::Map<const Vector>(right.data(), n));
  solution.resize(right.size());
  Eigen::Map<Vector>(solution.data(), n) = order.inverse() * x;
  return true;
}

}  // namespace ucvt
