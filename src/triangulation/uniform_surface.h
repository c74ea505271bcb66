// T: a closed surface of constant curvature, as a geodesic triangulation known by its chords.
//
// Nothing here has coordinates. Chords of the edges determine the surface; four numbers per
// halfedge develop it, triangle by triangle, into any frame (docs/tangent-quadric.md).
#pragma once

#include <array>
#include <vector>

#include "space/moments.h"
#include "space/offset.h"
#include "triangulation/connectivity.h"
#include "triangulation/vertex_order.h"

namespace ucvt {

/// A point of the surface: a face and barycentric coordinates in its chord triangle (sum 1).
struct SurfacePoint {
  Face face;
  std::array<double, 3> bary{1.0 / 3, 1.0 / 3, 1.0 / 3};
};

class UniformSurface {
 public:
  /// Takes the chord of every halfedge (twins agree). Throws NumericalError when a face violates
  /// the triangle inequality or, on the sphere, does not fit it.
  UniformSurface(Space space, Connectivity connectivity, std::vector<double> chord);

  [[nodiscard]] Space space() const { return space_; }
  [[nodiscard]] const Connectivity& connectivity() const { return connectivity_; }
  [[nodiscard]] const VertexOrder& vertex_order() const { return vertex_order_; }
  [[nodiscard]] double chord(Halfedge h) const { return chord_[h.index()]; }
  [[nodiscard]] const std::vector<double>& chords() const { return chord_; }
  /// det[P_0, P_1, P_2] of the face's corners.
  [[nodiscard]] double det(Face f) const { return det_[f.index()]; }
  [[nodiscard]] ChordTriangle triangle(Face f) const;

  /// Angle of a halfedge's face at the halfedge's origin, in radians.
  [[nodiscard]] double angle(Halfedge h) const;
  /// Area of a face, accurate at every scale.
  [[nodiscard]] double area(Face f) const;

  /// Offset, in the frame that u (origin of h) and v (head of h) are given in, of the corner
  /// opposite to h's edge in the face of h's twin.
  [[nodiscard]] Offset develop(Halfedge h, const Offset& u, const Offset& v) const {
    const Developing& d = developing_[h.index()];
    const double k = space_.kappa;
    const double nx = u.y - v.y - k * (u.y * v.h - u.h * v.y);
    const double ny = v.x - u.x - k * (u.h * v.x - u.x * v.h);
    return on_quadric(space_,
                      {d.u * u.x + d.v * v.x + d.normal * nx, d.u * u.y + d.v * v.y + d.normal * ny,
                       d.h + d.u * u.h + d.v * v.h - d.normal * cross(u, v)});
  }

  /// Asks for what `develop` will read of a face, ahead of time: a walk over a large surface waits
  /// for memory otherwise.
  void prefetch(Face f) const {
    connectivity_.prefetch(f);
    __builtin_prefetch(&developing_[3 * f.index()]);
    __builtin_prefetch(&developing_[3 * f.index() + 2]);
  }

  /// The offset of every halfedge's head in the frame of its origin. At each vertex the frame's
  /// first axis points along outgoing(v); angle sums are scaled to exactly 2 pi.
  [[nodiscard]] std::vector<Offset> vertex_frames() const;

 private:
  /// P_w = u P_u + v P_v + normal N with N = diag(1, 1, kappa) (P_u x P_v), and h likewise.
  struct Developing {
    double u, v, normal, h;
  };

  Space space_;
  Connectivity connectivity_;
  VertexOrder vertex_order_;
  std::vector<double> chord_;
  std::vector<double> det_;
  std::vector<Developing> developing_;
};

/// A place on the surface as something that moves over it knows it: the face under it and that
/// face's corners in its own frame.
struct Place {
  Face face;
  std::array<Offset, 3> corner;
};

/// The offset of a surface point in the frame that its face's corners are given in.
Offset point_in_frame(const UniformSurface& t, const SurfacePoint& p,
                      const std::array<Offset, 3>& corner);

/// A surface point as the nearest corner of its face, in barycentric terms, sees it.
struct CornerView {
  Vertex from;
  Offset at;                     ///< the point, in that vertex' frame
  std::array<Offset, 3> corner;  ///< of the point's face, likewise
};

/// `frames` as of `vertex_frames`.
CornerView seen_from_corner(const UniformSurface& t, const std::vector<Offset>& frames,
                            const SurfacePoint& p);

/// The place of a surface point, in the frame carried parallel from the face's corner 0, whose
/// frame has its first axis along side 0.
Place place_of(const UniformSurface& t, const SurfacePoint& p);

/// The surface point under a place.
SurfacePoint point_of(const Place& place);

/// Moves the place to offset `to` in its own frame, carrying the frame parallel, and walks to the
/// face there. Throws NumericalError when the walk does not end.
void move_place(const UniformSurface& t, Place& place, const Offset& to);

}  // namespace ucvt
