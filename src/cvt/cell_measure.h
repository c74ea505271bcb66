// Integrals of the density over the cells of the bare spaces.
//
// Uniform density has a closed form, a formula is integrated by cubature (docs/polygon-moments.md).
#pragma once

#include <optional>

#include "cvt/formula.h"
#include "cvt/space_sites.h"
#include "space/polygon_moments.h"

namespace ucvt {

class CellMeasure {
 public:
  /// Reads the formula of the options. Keeps a reference to the domain. Throws InvalidInput.
  CellMeasure(const Domain& domain, const SpaceOptions& options);

  /// Moments of the density over a cell, in its frame. Raises `error` to the bound on their relative
  /// error. Throws InvalidInput where the density is negative or not finite.
  [[nodiscard]] Moments operator()(const Frame& frame, const SiteCell& cell, double& error) const;

 private:
  const Domain& domain_;
  std::optional<DensityFormula> formula_;
  double constant_ = 1;
  CubatureOptions cubature_;
};

/// Distance from the site to the farthest corner of its cell.
double reach(Space s, const SiteCell& cell);

}  // namespace ucvt
