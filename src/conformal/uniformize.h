// From a closed surface to T, its discretely conformal surface of constant curvature.
#pragma once

#include <vector>

#include "conformal/intrinsic_triangulation.h"
#include "triangulation/uniform_surface.h"
#include "ucvt/uniformize.h"

namespace ucvt {

/// T and everything that ties it to the input.
struct Uniformized {
  IntrinsicTriangulation intrinsic;    ///< T's triangulation, Penner coordinates, and the log
  std::vector<double> log_scale;       ///< u at every vertex of T
  std::vector<double> vertex_area_3d;  ///< a third of the input area round every vertex
  UniformSurface surface;              ///< T
  UniformizationReport report;
};

/// Uniformizes; `longest_edge` > 0 refines the surface first until no edge is longer.
///
/// The result is certified: angle sums within 1e-10 of 2 pi, every face a true triangle, area
/// 2 pi |chi|. Throws NumericalError otherwise, Cancelled when the monitor asked to stop.
Uniformized uniformize(const ClosedSurface& surface, double longest_edge, const Monitor& monitor);

/// Positions on the input surface of points on T.
std::vector<Position> positions_on_input(const Uniformized& t, const TriangleMesh& input,
                                         const std::vector<SurfacePoint>& points);

}  // namespace ucvt
