#include "cvt/cell_measure.h"

#include <algorithm>
#include <cmath>

#include "cvt/domain.h"

namespace ucvt {
namespace {

/// Of a formula, at most: smooth ones take some hundreds, and one that jumps has no end.
constexpr std::int64_t evaluations_per_cell = 100'000;

}  // namespace

CellMeasure::CellMeasure(const Domain& domain, const SpaceOptions& options) : domain_(domain) {
  cubature_.relative_tolerance = options.quadrature;
  cubature_.max_evaluations = evaluations_per_cell;
  if (!options.density.empty()) {
    formula_.emplace(options.density, domain.kappa);
    if (formula_->is_constant()) {
      constant_ = (*formula_)({0, 0, 1});
      formula_.reset();
    }
  }
}

Moments CellMeasure::operator()(const Frame& frame, const SiteCell& cell, double& error) const {
  const Space s{domain_.kappa};
  if (!formula_) {
    Moments out = uniform_moments(s, cell.corner);
    out.m *= constant_, out.x *= constant_, out.y *= constant_, out.h *= constant_;
    return out;
  }
  const auto density = [&](const Offset& x) {
    return (*formula_)(into_polygon(domain_, model_point(frame, x)));
  };
  const Cubature out = density_moments(s, cell.corner, density, cubature_);
  error = std::max(error, out.error);
  return out.moments;
}

double reach(Space s, const SiteCell& cell) {
  double h = 0;
  for (const Offset& c : cell.corner) {
    h = std::max(h, c.h);
  }
  return length_of_chord(s, std::sqrt(2 * h));
}

}  // namespace ucvt
