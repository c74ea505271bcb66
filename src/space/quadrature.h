// Quadrature on the triangle, for integrands that are analytic and nearly polynomial.
#pragma once

#include <vector>

namespace ucvt {

/// One node of a rule on a triangle: barycentric coordinates and a weight; weights sum to 1.
struct QuadratureNode {
  double b0, b1, b2, weight;
};

/// A rule that integrates polynomials of the given degree exactly.
///
/// Degree up to 5, 6 and 8: symmetric rules with 7, 12 and 16 nodes (Radon 1948; Dunavant 1985).
/// Above: Gauss-Legendre on the square collapsed to the triangle (Duffy 1982). Rules are built once; thread-safe. Requires
/// degree <= 64.
const std::vector<QuadratureNode>& triangle_rule(int degree);

}  // namespace ucvt
