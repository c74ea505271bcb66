// From a closed surface to T, its discretely conformal surface of constant curvature.
#pragma once

#include <vector>

#include "conformal/intrinsic_triangulation.h"
#include "triangulation/uniform_surface.h"
#include "ucvt/uniformize.h"

namespace ucvt {

/// T and everything that ties it to the input.
struct Uniformized {
  TriangleMesh input;                  ///< its faces in the order of T's before any change
  IntrinsicTriangulation intrinsic;    ///< T's triangulation, Penner coordinates, and the log
  std::vector<double> log_scale;       ///< u at every vertex of T
  std::vector<double> vertex_area_3d;  ///< a third of the input area round every vertex
  UniformSurface surface;              ///< T
  UniformizationReport report;
  std::vector<std::int32_t> input_face;  ///< number in the closed surface of each face of `input`
  /// Of the double of a surface with boundary: the image of each vertex of `input`; else empty.
  std::vector<std::int32_t> mirror;
};

/// The work behind the public `uniformize`.
Uniformized uniformize_surface(const ClosedSurface& surface, const UniformizeOptions& options);

/// Where points on T lie in the faces of `Uniformized::input`.
std::vector<HomogeneousPoint> points_on_input(const Uniformized& t,
                                              const std::vector<SurfacePoint>& points);

/// Positions on the input surface of points on T.
std::vector<Position> positions_on_input(const Uniformized& t,
                                         const std::vector<SurfacePoint>& points);

}  // namespace ucvt
