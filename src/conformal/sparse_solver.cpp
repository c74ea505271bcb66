#include "conformal/sparse_solver.h"

#include <iostream>  // MetisSupport forgets it

#include <Eigen/MetisSupport>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace ucvt {
namespace {

/// Nested dissection pays from this size on; below, minimum degree orders in no time.
constexpr Eigen::Index least_dissected = 2000;

/// Conjugate gradients: their tolerance, and the iterations after which a factorization of the matrix
/// itself is as cheap.
constexpr double relative_residual = 1e-6;
constexpr int most_iterations = 25, refactor_after = 12;

struct Triplet {
  const SymmetricEntries::Entry* entry;
  [[nodiscard]] int row() const { return entry->row; }
  [[nodiscard]] int col() const { return entry->column; }
  [[nodiscard]] double value() const { return entry->value; }
  const Triplet* operator->() const { return this; }
  Triplet& operator++() {
    ++entry;
    return *this;
  }
  bool operator!=(const Triplet& o) const { return entry != o.entry; }
};

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
using Natural = Eigen::NaturalOrdering<int>;

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
  Permutation order;
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Natural> factors;
  bool has_factors = false;

  /// The whole matrix in the order of elimination.
  Matrix ordered(const SymmetricEntries& matrix) {
    Matrix lower(matrix.size(), matrix.size());
    const auto& e = matrix.entries();
    lower.setFromTriplets(Triplet{e.data()}, Triplet{e.data() + e.size()});
    if (order.size() != lower.rows()) {
      order = elimination_order(lower);
      has_factors = false;
    }
    Matrix out(lower.rows(), lower.rows());
    out = lower.selfadjointView<Eigen::Lower>().twistedBy(order);
    return out;
  }

  /// Conjugate gradients from zero, preconditioned by the factors at hand; false: not converged.
  bool iterate(const Matrix& a, const Vector& b, Vector& x) {
    x.setZero(b.size());
    Vector r = b, z = factors.solve(r), p = z, ap;
    double rz = r.dot(z);
    const double wanted = relative_residual * relative_residual * rz;
    for (int k = 1; k <= most_iterations; ++k) {
      ap = a * p;
      const double curvature = p.dot(ap);
      if (!(curvature > 0)) {
        return false;
      }
      const double step = rz / curvature;
      x += step * p;
      r -= step * ap;
      z = factors.solve(r);
      const double next = r.dot(z);
      if (!(next > wanted)) {
        has_factors = k <= refactor_after;
        return next <= wanted;
      }
      p = z + next / rz * p;
      rz = next;
    }
    return false;
  }
};

SymmetricSolver::SymmetricSolver() : state_(std::make_unique<State>()) {}
SymmetricSolver::~SymmetricSolver() = default;

bool SymmetricSolver::solve_positive_definite(const SymmetricEntries& matrix,
                                              const std::vector<double>& right,
                                              std::vector<double>& solution) {
  State& s = *state_;
  solution.assign(right.size(), 0);
  if (right.empty()) {
    return true;
  }
  const Matrix a = s.ordered(matrix);
  const auto n = static_cast<Eigen::Index>(right.size());
  const Vector b = s.order * Eigen::Map<const Vector>(right.data(), n);
  Vector x;
  if (!s.has_factors || !s.iterate(a, b, x)) {
    s.factors.compute(a);
    s.has_factors = s.factors.info() == Eigen::Success;
    if (!s.has_factors) {
      return false;
    }
    x = s.factors.solve(b);
  }
  Eigen::Map<Vector>(solution.data(), n) = s.order.inverse() * x;
  return true;
}

bool SymmetricSolver::solve(const SymmetricEntries& matrix, const std::vector<double>& right,
                            std::vector<double>& solution) {
  solution.assign(right.size(), 0);
  if (right.empty()) {
    return true;
  }
  const Matrix a = state_->ordered(matrix);
  const Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Natural> factors(a);
  if (factors.info() != Eigen::Success) {
    return false;
  }
  const auto n = static_cast<Eigen::Index>(right.size());
  const Vector x = factors.solve(state_->order * Eigen::Map<const Vector>(right.data(), n));
  Eigen::Map<Vector>(solution.data(), n) = state_->order.inverse() * x;
  return true;
}

}  // namespace ucvt
