// Sparse symmetric systems: the one place that knows which library solves them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace ucvt {

/// The lower triangle of a symmetric matrix, as a sum of entries in any order. Entries with a
/// negative index are dropped, so that unknowns held fixed need no care.
class SymmetricEntries {
 public:
  struct Entry {
    std::int32_t row, column;
    double value;
  };
  explicit SymmetricEntries(std::int32_t size) : size_(size) {}
  void add(std::int32_t p, std::int32_t q, double value) {
    if (p >= 0 && q >= 0) {
      entries_.push_back(p >= q ? Entry{p, q, value} : Entry{q, p, value});
    }
  }
  [[nodiscard]] std::int32_t size() const { return size_; }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::int32_t size_;
  std::vector<Entry> entries_;
};

/// Solves a sequence of systems whose matrices have one size and change little from one to the next.
///
/// The order of elimination is found once, by nested dissection (METIS). A factorization serves the
/// matrices after its own as the preconditioner of conjugate gradients, until those take too long.
class SymmetricSolver {
 public:
  SymmetricSolver();
  SymmetricSolver(const SymmetricSolver&) = delete;
  SymmetricSolver& operator=(const SymmetricSolver&) = delete;
  ~SymmetricSolver();

  /// Solves a positive definite system to a relative residual of 1e-6, or directly. Returns false
  /// when the matrix is not positive definite to rounding.
  bool solve_positive_definite(const SymmetricEntries& matrix, const std::vector<double>& right,
                               std::vector<double>& solution);

  /// Solves directly by an LDL^T factorization. Returns false when the matrix is singular.
  bool solve(const SymmetricEntries& matrix, const std::vector<double>& right,
             std::vector<double>& solution);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ucvt
