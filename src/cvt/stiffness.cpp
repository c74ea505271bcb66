#include "cvt/stiffness.h"

#include <algorithm>
#include <cmath>

namespace ucvt {
namespace {

/// Least resistance of a site to its own moves, relative to 2 m: keeps the matrix definite, and long
/// waves, along which the springs are loose, within bounds.
constexpr double least_own = 0.02;

/// A symmetric 2 x 2 matrix.
struct Block {
  double xx = 0, xy = 0, yy = 0;
};

/// The matrix with eigenvalues below `least` raised to it.
Block raised(const Block& m, double least) {
  const double mean = (m.xx + m.yy) / 2, half = (m.xx - m.yy) / 2;
  const double radius = std::sqrt(half * half + m.xy * m.xy);
  const double high = std::max(mean + radius, least), low = std::max(mean - radius, least);
  const double cosine = radius > 0 ? half / radius : 1, sine = radius > 0 ? m.xy / radius : 0;
  const double middle = (high + low) / 2, spread = (high - low) / 2;
  return {middle + spread * cosine, spread * sine, middle - spread * cosine};
}

std::vector<Block> own_resistance(const std::vector<Spring>& springs,
                                  const std::vector<double>& diagonal) {
  std::vector<Block> own;
  for (const double d : diagonal) {
    own.push_back({d, 0, d});
  }
  const auto take = [&own](std::int32_t site, const Vector2& u, double stiffness) {
    Block& b = own[static_cast<std::size_t>(site)];
    b.xx -= 2 * stiffness * u.x * u.x;
    b.xy -= 2 * stiffness * u.x * u.y;
    b.yy -= 2 * stiffness * u.y * u.y;
  };
  for (const Spring& s : springs) {
    take(s.from, s.at_from, s.stiffness);
    take(s.to, s.at_to, s.stiffness);
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    own[i] = raised(own[i], least_own * diagonal[i]);
  }
  return own;
}

}  // namespace

Stiffness::Stiffness(const std::vector<Spring>& springs, const std::vector<double>& diagonal) {
  std::vector<Eigen::Triplet<double, std::int32_t>> entries;
  entries.reserve(10 * springs.size() + 3 * diagonal.size());
  std::int32_t row = 0;
  for (const Block& b : own_resistance(springs, diagonal)) {
    entries.emplace_back(row, row, b.xx);
    entries.emplace_back(row + 1, row, b.xy);
    entries.emplace_back(row + 1, row + 1, b.yy);
    row += 2;
  }
  for (const Spring& s : springs) {
    const std::array<std::int32_t, 4> at{2 * s.from, 2 * s.from + 1, 2 * s.to, 2 * s.to + 1};
    const std::array<double, 4> u{s.at_from.x, s.at_from.y, s.at_to.x, s.at_to.y};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        if (at[i] >= at[j]) {
          entries.emplace_back(at[i], at[j], s.stiffness * u[i] * u[j]);
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(row, row);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors_.compute(matrix);
}

void Stiffness::solve(std::vector<Vector2>& v) const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(2 * v.size()));
  for (std::size_t i = 0; i < v.size(); ++i) {
    x[static_cast<Eigen::Index>(2 * i)] = v[i].x;
    x[static_cast<Eigen::Index>(2 * i + 1)] = v[i].y;
  }
  x = factors_.solve(x).eval();
  for (std::size_t i = 0; i < v.size(); ++i) {
    v[i] = {x[static_cast<Eigen::Index>(2 * i)], x[static_cast<Eigen::Index>(2 * i + 1)]};
  }
}

}  // namespace ucvt
