#include "conformal/multigrid.h"

#include <algorithm>
#include <cmath>

#include "conformal/aggregation.h"

namespace ucvt {
namespace {

/// What makes a tie strong on the finest level, halved from level to level (Vanek et al. 1996).
constexpr double finest_strength = 0.08;

/// Unknowns that are left to a dense factorization, and the share of a level's unknowns that the
/// next one may have at most.
constexpr std::size_t dense_size = 100;
constexpr double least_coarsening = 0.8;

}  // namespace

Multigrid::Level Multigrid::make_level(const SymmetricMatrix& a) {
  Level out;
  const std::size_t n = a.size();
  out.a.begin.reserve(n + 1);
  out.a.column.reserve(a.column.size());
  out.a.value.reserve(a.column.size());
  out.diagonal.reserve(n);
  out.inverse.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (const bool above : {false, true}) {
      if (above) {
        out.diagonal.push_back(static_cast<std::int32_t>(out.a.column.size()));
      }
      a.for_row(i, [&](std::size_t j, double value) {
        if ((j > i) == above) {
          out.a.column.push_back(static_cast<std::int32_t>(j));
          out.a.value.push_back(static_cast<float>(value));
        }
      });
    }
    out.a.begin.push_back(static_cast<std::int32_t>(out.a.column.size()));
    out.inverse.push_back(static_cast<float>(1 / a.diagonal[i]));
  }
  out.x.resize(n);
  out.b.resize(n);
  return out;
}

bool Multigrid::build(const SymmetricMatrix& a) {
  levels_.clear();
  SymmetricMatrix coarse;
  const SymmetricMatrix* at = &a;
  double strength = finest_strength;
  const auto in_floats = [](const SparseRows& m) {
    return Rows{m.begin, m.column, {m.value.begin(), m.value.end()}};
  };
  while (at->size() > dense_size) {
    if (!std::ranges::all_of(at->diagonal, [](double d) { return d > 0 && std::isfinite(d); })) {
      return false;
    }
    const Interpolation p = smoothed_aggregation(*at, strength);
    if (static_cast<double>(p.coarse_size) > least_coarsening * static_cast<double>(at->size())) {
      return false;
    }
    const SparseRows transposed = transpose(p.rows, p.coarse_size);
    levels_.push_back(make_level(*at));
    levels_.back().to_fine = in_floats(p.rows);
    levels_.back().to_coarse = in_floats(transposed);
    coarse = galerkin_product(*at, p, transposed);
    at = &coarse;
    strength /= 2;
  }
  const auto n = static_cast<Eigen::Index>(at->size());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < at->size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    dense(row, row) += at->diagonal[i];
    at->for_row(
        i, [&](std::size_t j, double value) { dense(row, static_cast<Eigen::Index>(j)) += value; });
  }
  coarsest_.compute(dense);
  coarsest_x_.resize(n);
  return coarsest_.info() == Eigen::Success;
}

void Multigrid::cycle(std::size_t level) {
  if (level == levels_.size()) {
    coarsest_.solveInPlace(coarsest_x_);
    return;
  }
  Level& l = levels_[level];
  const std::size_t n = l.inverse.size();
  const auto row = [](const Rows& m, const std::vector<float>& x, std::int32_t from,
                      std::int32_t to) {
    float sum = 0;
    for (auto k = static_cast<std::size_t>(from); k < static_cast<std::size_t>(to); ++k) {
      sum += m.value[k] * x[static_cast<std::size_t>(m.column[k])];
    }
    return sum;
  };
  // Forwards from zero, what lies above the diagonal counts for nothing as yet; afterwards it is
  // all that the residual has.
  for (std::size_t i = 0; i < n; ++i) {
    l.x[i] = (l.b[i] - row(l.a, l.x, l.a.begin[i], l.diagonal[i])) * l.inverse[i];
  }
  std::vector<float> residual(n);
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] = -row(l.a, l.x, l.diagonal[i], l.a.begin[i + 1]);
  }
  const bool last = level + 1 == levels_.size();
  for (std::size_t c = 0; c + 1 < l.to_coarse.begin.size(); ++c) {
    const float b = row(l.to_coarse, residual, l.to_coarse.begin[c], l.to_coarse.begin[c + 1]);
    last ? coarsest_x_[static_cast<Eigen::Index>(c)] = b : levels_[level + 1].b[c] = b;
  }
  cycle(level + 1);
  std::vector<float> corrected;
  if (last) {
    corrected.resize(static_cast<std::size_t>(coarsest_x_.size()));
    for (std::size_t c = 0; c < corrected.size(); ++c) {
      corrected[c] = static_cast<float>(coarsest_x_[static_cast<Eigen::Index>(c)]);
    }
  }
  const std::vector<float>& y = last ? corrected : levels_[level + 1].x;
  for (std::size_t i = 0; i < n; ++i) {
    l.x[i] += row(l.to_fine, y, l.to_fine.begin[i], l.to_fine.begin[i + 1]);
  }
  for (std::size_t i = n; i-- > 0;) {
    l.x[i] = (l.b[i] - row(l.a, l.x, l.a.begin[i], l.a.begin[i + 1])) * l.inverse[i];
  }
}

void Multigrid::apply(const std::vector<double>& b, std::vector<double>& x) {
  // In units of the largest entry, so that floats hold them.
  double unit = 0;
  for (const double v : b) {
    unit = std::max(unit, std::abs(v));
  }
  x.assign(b.size(), 0);
  if (!(unit > 0)) {
    return;
  }
  if (levels_.empty()) {
    coarsest_x_ = Eigen::Map<const Eigen::VectorXd>(b.data(), coarsest_x_.size());
    cycle(0);
    Eigen::Map<Eigen::VectorXd>(x.data(), coarsest_x_.size()) = coarsest_x_;
    return;
  }
  std::vector<float>& finest = levels_.front().b;
  for (std::size_t i = 0; i < b.size(); ++i) {
    finest[i] = static_cast<float>(b[i] / unit);
  }
  cycle(0);
  for (std::size_t i = 0; i < b.size(); ++i) {
    x[i] = static_cast<double>(levels_.front().x[i]) * unit;
  }
}

}  // namespace ucvt
