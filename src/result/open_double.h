// The double of a surface with boundary as its tessellation needs it (docs/boundaries.md).
#pragma once

#include "mesh/doubled_surface.h"
#include "result/boundary_curves.h"
#include "ucvt/uniformize.h"

namespace ucvt {

struct OpenDouble {
  TriangleMesh half;  ///< the surface, made fine enough for the sites
  BoundaryCurves curves;
  DoubledSurface doubled;
  UniformizedSurface surface;            ///< T
  std::vector<std::int32_t> input_face;  ///< of the half's faces
};

/// For sites so far from each other.
OpenDouble make_double(const OpenSurface& open, double spacing, const Monitor& monitor);

/// Distance between neighbours in a hexagonal lattice of n sites, those on the boundary among them:
/// their cells are halves, so that n - L/(2h) cells of area sqrt(3)/2 h^2 fill the surface.
double hexagonal_spacing(const TriangleMesh& mesh, int n);

}  // namespace ucvt
