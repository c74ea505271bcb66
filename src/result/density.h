// The density that makes a CVT on T uniform on the input surface.
#pragma once

#include <vector>

#include "conformal/uniformize.h"

namespace ucvt {

/// The conformal factor at every vertex of T, area on the input over area on T (the paper's section
/// 6.2): exp(-2 u), corrected by areas over two rings, and such that the whole area is right. Stars
/// alone would not do: those on the input and on T are of different triangulations
/// (docs/optimisation.md).
std::vector<double> conformal_factor(const Uniformized& t);

/// rho = cf^2/size^4 (the paper's equation 12) for cells whose size on the input is `size` at every
/// vertex of T. Scaled such that its largest value times its smallest is 1: log scales that span up to
/// 300 stay in the range of doubles.
std::vector<double> sizing_density(const std::vector<double>& conformal_factor,
                                   const std::vector<double>& size);

/// The energy of so many small regular hexagons fitted to the density at T's vertices,
/// 5/(18 sqrt 3) (int sqrt rho)^2/N (Gersho 1979).
double hexagonal_energy(const UniformSurface& t, const std::vector<double>& density,
                        std::size_t sites);

/// Lowers sizes until they grow by at most `growth` per unit of length on the input.
void limit_growth(const Uniformized& t, double growth, std::vector<double>& size);

}  // namespace ucvt
