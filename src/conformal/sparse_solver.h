// Sparse symmetric systems: the one place that knows which library solves them.
#pragma once

#include <cstdint>
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

/// Solves for the right-hand side by an LDL^T factorization. Returns false when the matrix is
/// singular or, where that is asked for, not positive definite to rounding.
bool solve_symmetric(const SymmetricEntries& matrix, const std::vector<double>& right,
                     std::vector<double>& solution, bool positive_definite);

}  // namespace ucvt
