// A density given as a formula, for the CVTs of the bare spaces (docs/polygon-moments.md).
#pragma once

#include <memory>
#include <string>

#include "ucvt/spaces.h"

namespace ucvt {

/// A density read from a formula such as "exp(-20*x^2 - 20*y^2) + 0.05*sin(pi*x)^2".
///
/// Variables are the model coordinates x, y, z; on the sphere also lon = atan2(y, x) and
/// lat = atan2(z, hypot(x, y)) in radians; in the plane and the hyperbolic plane also the central
/// coordinates klein_x = x/z and klein_y = y/z. Constants: pi, e. Operators: + - * / ^, comparisons,
/// && || and a ? b : c. Functions: those of muParser (sin ... atanh, atan2, exp, ln, log2, log10,
/// sqrt, abs, sign, rint, min, max, sum, avg). Numbers have a decimal point in every locale.
///
/// Copies share one formula; may be called from several threads at once.
class DensityFormula {
 public:
  /// Throws InvalidInput, naming the position (from 1) and the token, when the formula cannot be
  /// read, and when it is a constant that is not positive and finite.
  DensityFormula(const std::string& formula, double kappa);

  /// The density there. Throws InvalidInput, naming the point and the value, unless it is finite and
  /// not negative.
  double operator()(const ModelPoint& p) const;

  /// Whether the formula names no variable, so that uniform density serves.
  [[nodiscard]] bool is_constant() const;

 private:
  class Parsers;
  std::shared_ptr<Parsers> parsers_;
};

}  // namespace ucvt
