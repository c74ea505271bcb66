#include "conformal/aggregation.h"

#include <cmath>

namespace ucvt {
namespace {

constexpr std::int32_t alone = -2, free_yet = -1;

/// Weight of the Jacobi step that smooths the interpolation, for rows scaled by their sum of
/// magnitudes: 4/3 over the largest eigenvalue, which is 3/4 on the triangular lattice and at most 1
/// whatever the signs; less than 2 smooths.
constexpr double damping = 1.6;

/// Strong ties of every unknown.
struct Ties {
  std::vector<std::int32_t> begin{0}, column;
  template <class Visit>
  void for_row(std::size_t i, Visit visit) const {
    for (auto k = static_cast<std::size_t>(begin[i]); k < static_cast<std::size_t>(begin[i + 1]);
         ++k) {
      visit(static_cast<std::size_t>(column[k]));
    }
  }
};

bool is_strong(const SymmetricMatrix& a, std::size_t i, std::size_t j, double value,
               double strength) {
  return value * value > strength * strength * a.diagonal[i] * a.diagonal[j];
}

Ties strong_ties(const SymmetricMatrix& a, double strength) {
  Ties out;
  out.begin.reserve(a.size() + 1);
  out.column.reserve(a.column.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    a.for_row(i, [&](std::size_t j, double value) {
      if (is_strong(a, i, j, value, strength)) {
        out.column.push_back(static_cast<std::int32_t>(j));
      }
    });
    out.begin.push_back(static_cast<std::int32_t>(out.column.size()));
  }
  return out;
}

/// The aggregate of every unknown, `alone` for those with no ties at all: first whole
/// neighbourhoods that are free yet, then what touches one of those, then the rest.
std::vector<std::int32_t> aggregates(const SymmetricMatrix& a, const Ties& ties,
                                     std::int32_t& count) {
  const std::size_t n = a.size();
  std::vector<std::int32_t> of(n, free_yet);
  const auto gather = [&](std::size_t i) {
    of[i] = count;
    ties.for_row(i, [&](std::size_t j) { of[j] = of[j] == free_yet ? count : of[j]; });
    ++count;
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (a.begin[i] == a.begin[i + 1]) {
      of[i] = alone;
      continue;
    }
    bool is_free = of[i] == free_yet && ties.begin[i] < ties.begin[i + 1];
    ties.for_row(i, [&](std::size_t j) { is_free = is_free && of[j] == free_yet; });
    if (is_free) {
      gather(i);
    }
  }
  const std::vector<std::int32_t> first = of;
  for (std::size_t i = 0; i < n; ++i) {
    ties.for_row(
        i, [&](std::size_t j) { of[i] = of[i] == free_yet && first[j] >= 0 ? first[j] : of[i]; });
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (of[i] == free_yet) {
      gather(i);
    }
  }
  return of;
}

/// Sums of numbers by column, for one row after the other.
class RowSum {
 public:
  RowSum(std::int32_t columns, SparseRows& out)
      : place_(static_cast<std::size_t>(columns), -1), out_(out) {}
  void add(std::int32_t column, double value) {
    std::int32_t& place = place_[static_cast<std::size_t>(column)];
    if (place < out_.begin.back()) {
      place = static_cast<std::int32_t>(out_.column.size());
      out_.column.push_back(column);
      out_.value.push_back(value);
    } else {
      out_.value[static_cast<std::size_t>(place)] += value;
    }
  }
  void end_row() { out_.begin.push_back(static_cast<std::int32_t>(out_.column.size())); }

 private:
  std::vector<std::int32_t> place_;
  SparseRows& out_;
};

template <class Visit>
void for_entries(const SparseRows& m, std::size_t i, Visit visit) {
  for (auto k = static_cast<std::size_t>(m.begin[i]); k < static_cast<std::size_t>(m.begin[i + 1]);
       ++k) {
    visit(m.column[k], m.value[k]);
  }
}

}  // namespace

Interpolation smoothed_aggregation(const SymmetricMatrix& a, double strength) {
  Interpolation out;
  const auto of = aggregates(a, strong_ties(a, strength), out.coarse_size);
  RowSum row(out.coarse_size, out.rows);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (of[i] == alone) {
      row.end_row();
      continue;
    }
    // Weak ties go to the diagonal, so that constants stay what they are.
    double diagonal = a.diagonal[i], strong = 0;
    a.for_row(i, [&](std::size_t j, double value) {
      is_strong(a, i, j, value, strength) ? strong += std::abs(value) : diagonal += value;
    });
    diagonal = diagonal > 0 ? diagonal : a.diagonal[i];
    const double step = damping / (diagonal + strong);
    row.add(of[i], 1 - step * diagonal);
    a.for_row(i, [&](std::size_t j, double value) {
      if (is_strong(a, i, j, value, strength)) {
        row.add(of[j], -step * value);
      }
    });
    row.end_row();
  }
  return out;
}

SparseRows transpose(const SparseRows& m, std::int32_t columns) {
  SparseRows out;
  out.begin.assign(static_cast<std::size_t>(columns) + 1, 0);
  for (const std::int32_t j : m.column) {
    ++out.begin[static_cast<std::size_t>(j) + 1];
  }
  for (std::size_t j = 1; j < out.begin.size(); ++j) {
    out.begin[j] += out.begin[j - 1];
  }
  out.column.resize(m.column.size());
  out.value.resize(m.value.size());
  std::vector<std::int32_t> next(out.begin.begin(), out.begin.end() - 1);
  for (std::size_t i = 0; i < m.size(); ++i) {
    for_entries(m, i, [&](std::int32_t j, double value) {
      const auto k = static_cast<std::size_t>(next[static_cast<std::size_t>(j)]++);
      out.column[k] = static_cast<std::int32_t>(i);
      out.value[k] = value;
    });
  }
  return out;
}

SymmetricMatrix galerkin_product(const SymmetricMatrix& a, const Interpolation& p,
                                 const SparseRows& transposed) {
  SparseRows ap;
  {
    RowSum row(p.coarse_size, ap);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto add = [&](std::size_t j, double a_ij) {
        for_entries(p.rows, j, [&](std::int32_t c, double value) { row.add(c, a_ij * value); });
      };
      add(i, a.diagonal[i]);
      a.for_row(i, add);
      row.end_row();
    }
  }
  SparseRows product;
  RowSum row(p.coarse_size, product);
  SymmetricMatrix out;
  for (std::size_t i = 0; i < transposed.size(); ++i) {
    for_entries(transposed, i, [&](std::int32_t f, double weight) {
      for_entries(ap, static_cast<std::size_t>(f),
                  [&](std::int32_t c, double value) { row.add(c, weight * value); });
    });
    row.end_row();
    double diagonal = 0;
    for_entries(product, i, [&](std::int32_t c, double value) {
      if (static_cast<std::size_t>(c) == i) {
        diagonal = value;
      } else {
        out.column.push_back(c);
        out.value.push_back(value);
      }
    });
    out.end_row(diagonal);
  }
  return out;
}

}  // namespace ucvt
