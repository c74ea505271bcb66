#include "conformal/sparse_solver.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#ifdef UCVT_HAVE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

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

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

bool solve_indefinite(const Matrix& a, const Eigen::Map<const Vector>& right,
                      Eigen::Map<Vector> solution) {
  const Eigen::SimplicialLDLT<Matrix> factors(a);
  if (factors.info() != Eigen::Success) {
    return false;
  }
  solution = factors.solve(right);
  return true;
}

bool solve_positive_definite(const Matrix& a, const Eigen::Map<const Vector>& right,
                             Eigen::Map<Vector> solution) {
#ifdef UCVT_HAVE_CHOLMOD
  const Eigen::CholmodSupernodalLLT<Matrix> factors(a);
#else
  const Eigen::SimplicialLLT<Matrix> factors(a);
#endif
  if (factors.info() != Eigen::Success) {
    return false;
  }
  solution = factors.solve(right);
  return true;
}

}  // namespace

bool solve_symmetric(const SymmetricEntries& matrix, const std::vector<double>& right,
                     std::vector<double>& solution, bool positive_definite) {
  solution.assign(right.size(), 0);
  if (right.empty()) {
    return true;
  }
  Matrix a(matrix.size(), matrix.size());
  const auto& e = matrix.entries();
  a.setFromTriplets(Triplet{e.data()}, Triplet{e.data() + e.size()});
  const auto n = static_cast<Eigen::Index>(right.size());
  const Eigen::Map<const Vector> b(right.data(), n);
  const Eigen::Map<Vector> x(solution.data(), n);
  return positive_definite ? solve_positive_definite(a, b, x) : solve_indefinite(a, b, x);
}

}  // namespace ucvt
