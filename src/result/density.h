// The density that makes a CVT on T uniform on the input surface.
#pragma once

#include <vector>

#include "conformal/uniformize.h"

namespace ucvt {

/// The conformal factor at every vertex of T: area of its star on the input over area on T (the
/// paper's section 6.2).
std::vector<double> conformal_factor(const Uniformized& t);

/// rho = cf^2 (the paper's equation 12), scaled so that its largest value is 1.
std::vector<double> uniform_sizing_density(const std::vector<double>& conformal_factor);

}  // namespace ucvt
