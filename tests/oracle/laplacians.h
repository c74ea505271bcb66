// Matrices for tests of sparse solvers.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "conformal/symmetric_matrix.h"

namespace ucvt::oracle {

/// The graph Laplacian of a width x height grid on a torus plus `shift` on the diagonal; ties between
/// rows have the weight 1, those along every third row `stretch`.
inline SymmetricMatrix grid_laplacian(int width, int height, double shift, double stretch) {
  SymmetricMatrix out;
  for (int y = 0; y < height; ++y) {
    const double along = y % 3 == 0 ? stretch : 1;
    for (int x = 0; x < width; ++x) {
      const auto tie = [&](int i, int j, double weight) {
        out.column.push_back((j + height) % height * width + (i + width) % width);
        out.value.push_back(-weight);
      };
      tie(x - 1, y, along), tie(x + 1, y, along), tie(x, y - 1, 1), tie(x, y + 1, 1);
      out.end_row(2 * along + 2 + shift);
    }
  }
  return out;
}

inline Eigen::MatrixXd dense(const SymmetricMatrix& a) {
  const auto n = static_cast<Eigen::Index>(a.size());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    out(row, row) = a.diagonal[i];
    a.for_row(
        i, [&](std::size_t j, double value) { out(row, static_cast<Eigen::Index>(j)) += value; });
  }
  return out;
}

inline std::vector<double> noise(std::size_t n, std::uint32_t seed) {
  std::vector<double> out(n);
  for (double& x : out) {
    seed = 1664525 * seed + 1013904223;
    x = static_cast<double>(seed) / 4294967296.0 - 0.5;
  }
  return out;
}

inline Eigen::VectorXd as_vector(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// Largest entry of b - a x.
inline double residual(const SymmetricMatrix& a, const std::vector<double>& x,
                       const std::vector<double>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double sum = b[i] - a.diagonal[i] * x[i];
    a.for_row(i, [&](std::size_t j, double value) { sum -= value * x[j]; });
    worst = std::max(worst, std::abs(sum));
  }
  return worst;
}

}  // namespace ucvt::oracle
