// Sparse symmetric matrices, by rows.
#pragma once

#include <cstdint>
#include <vector>

namespace ucvt {

/// Both triangles of a symmetric matrix. Row i has the entries begin[i] to begin[i + 1] off the
/// diagonal, in any order; those at one place add up, as two edges between the same vertices do.
struct SymmetricMatrix {
  std::vector<std::int32_t> begin{0};
  std::vector<std::int32_t> column;
  std::vector<double> value;
  std::vector<double> diagonal;

  [[nodiscard]] std::size_t size() const { return diagonal.size(); }
  /// Calls visit(j, a_ij) for the entries of row i off the diagonal.
  template <class Visit>
  void for_row(std::size_t i, Visit visit) const {
    for (auto k = static_cast<std::size_t>(begin[i]); k < static_cast<std::size_t>(begin[i + 1]);
         ++k) {
      visit(static_cast<std::size_t>(column[k]), value[k]);
    }
  }
  /// Ends the row that was begun by adding to `column` and `value`.
  void end_row(double diagonal_value) {
    diagonal.push_back(diagonal_value);
    begin.push_back(static_cast<std::int32_t>(column.size()));
  }
};

}  // namespace ucvt
