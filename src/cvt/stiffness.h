// What the energy's Hessian is near a minimum: a network of springs along D's edges.
//
// With d the length of an edge, l that of its dual and rho the density there, the Hessian of
// sum int rho |x - p|^2 has blocks 2 m I - d l rho n n^T / 2 - ... on and -d l rho n n^T / 2 + ... off
// the diagonal, n being the edge's direction. What is left out acts across the edge, is a ninth of
// that in a hexagonal tessellation, and negative (docs/optimisation.md).
#pragma once

#include <array>
#include <cstdint>
#include <iostream>  // MetisSupport forgets it
#include <vector>

#include <Eigen/MetisSupport>
#include <Eigen/SparseCholesky>

namespace ucvt {

struct Vector2 {
  double x = 0, y = 0;
};

/// Two neighbouring sites: the energy rises by stiffness (a.u + b.v)^2 / 2 when they move by u and v,
/// a and b being the unit vectors from one to the other, each in its own site's frame.
struct Spring {
  std::int32_t from = 0, to = 0;
  Vector2 at_from, at_to;
  double stiffness = 0;
};

/// Nested dissection leaves a third less in the factors of large networks than least degree, which is found
/// sooner for small ones.
struct EliminationOrder {
  using PermutationType = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

  template <typename Matrix>
  void operator()(const Matrix& matrix, PermutationType& order) const {
    constexpr Eigen::Index large = 10000;
    if (matrix.cols() < large) {
      Eigen::AMDOrdering<int>()(matrix, order);
    } else {
      Eigen::MetisOrdering<int>()(matrix, order);
    }
  }
};

class Stiffness {
 public:
  /// `diagonal` has 2 m of every site: what the springs leave of it, as far as that is positive,
  /// resists the site's own moves.
  Stiffness(const std::vector<Spring>& springs, const std::vector<double>& diagonal);

  /// False when rounding left the matrix without factors; then there is nothing to solve with.
  [[nodiscard]] bool is_usable() const { return factors_.info() == Eigen::Success; }

  /// Overwrites forces with the moves that balance them.
  void solve(std::vector<Vector2>& v) const;

 private:
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, EliminationOrder> factors_;
};

}  // namespace ucvt
