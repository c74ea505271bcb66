#include "conformal/sparse_solver.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace ucvt {
namespace {

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

}  // namespace

bool solve_symmetric(const SymmetricEntries& matrix, const std::vector<double>& right,
                     std::vector<double>& solution, bool positive_definite) {
  solution.assign(right.size(), 0);
  if (right.empty()) {
    return true;
  }
  Eigen::SparseMatrix<double> a(matrix.size(), matrix.size());
  const auto& e = matrix.entries();
  a.setFromTriplets(Triplet{e.data()}, Triplet{e.data() + e.size()});
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky(a);
  if (cholesky.info() != Eigen::Success ||
      (positive_definite && !(cholesky.vectorD().minCoeff() > 0))) {
    return false;
  }
  const auto n = static_cast<Eigen::Index>(right.size());
  Eigen::Map<Eigen::VectorXd>(solution.data(), n) =
      cholesky.solve(Eigen::Map<const Eigen::VectorXd>(right.data(), n));
  return true;
}

}  // namespace ucvt
