// Points and isometries of the sphere, the plane and the hyperbolic plane, in one model.
//
// Notation: kappa in {+1, 0, -1} is the curvature. A point is an Offset X = (x, y, h) in an
// orthonormal frame of the tangent plane at some origin, on the tangent quadric
//     x^2 + y^2 + kappa h^2 = 2 h.
// 2h is the squared chord to the origin. The linear model is P = (x, y, z), z = 1 - kappa h, on
// which isometries act linearly; (x, y)/z are central coordinates (gnomonic, Cartesian, Klein), in
// which geodesics are straight. docs/tangent-quadric.md derives every formula used here.
#pragma once

#include <cmath>

namespace ucvt {

/// Which of the three spaces: its curvature, as a value.
struct Space {
  double kappa = 0;
};

/// A point in the tangent frame of some origin. The origin itself is {0, 0, 0}.
struct Offset {
  double x = 0, y = 0, h = 0;
};

/// z of the linear model, 1 - kappa h.
inline double model_z(Space s, const Offset& p) {
  return 1 - s.kappa * p.h;
}

/// Squared chord between two points given in the same frame.
inline double chord2(Space s, const Offset& p, const Offset& q) {
  const double dx = q.x - p.x, dy = q.y - p.y, dh = q.h - p.h;
  return dx * dx + dy * dy + s.kappa * dh * dh;
}

/// x_p y_q - y_p x_q, the z component of P x Q: positive when q is counterclockwise from p as seen
/// from the origin, and det[O, P, Q].
inline double cross(const Offset& p, const Offset& q) {
  return p.x * q.y - p.y * q.x;
}

/// The point at central coordinates (kx, ky); exact to rounding at every scale.
/// Requires 1 + kappa k^2 > 0.
inline Offset from_central(Space s, double kx, double ky) {
  const double q = kx * kx + ky * ky;
  const double z = 1 / std::sqrt(1 + s.kappa * q);
  return {kx * z, ky * z, z * z * q / (1 + z)};
}

/// The point at chord c from the origin in direction (cosine, sine), a unit vector.
inline Offset from_chord(Space s, double chord, double cosine, double sine) {
  const double r = chord * std::sqrt(1 - s.kappa * chord * chord / 4);
  return {r * cosine, r * sine, chord * chord / 2};
}

/// h at half the distance of a point at height h.
inline double half_way(Space s, double h) {
  return h / 2 / (1 + std::sqrt(std::fmax(0, 1 - s.kappa * h / 2)));
}

/// The point half way from the origin to p. Requires p off the origin, and not its antipode.
inline Offset half_way(Space s, const Offset& p) {
  const double r = std::hypot(p.x, p.y);
  return from_chord(s, std::sqrt(2 * half_way(s, p.h)), p.x / r, p.y / r);
}

/// The same point with h recomputed from (x, y), so that rounding never leaves the quadric.
///
/// Near and past the sphere's horizon (h > 1/2) h carries the information and is kept.
inline Offset on_quadric(Space s, const Offset& p) {
  if (s.kappa > 0 && p.h > 0.5) {
    return p;
  }
  const double q = p.x * p.x + p.y * p.y;
  return {p.x, p.y, q / (1 + std::sqrt(1 - s.kappa * q))};
}

/// The transvection along the geodesic from the origin to `a`, applied to `p`: coordinates in the
/// frame carried parallel to `a` become coordinates in the origin's frame.
inline Offset transvect(Space s, const Offset& a, const Offset& p) {
  const double dot = a.x * p.x + a.y * p.y;
  const double f = 1 - s.kappa * (p.h + dot / (2 - s.kappa * a.h));
  return {p.x + a.x * f, p.y + a.y * f, a.h + p.h - s.kappa * a.h * p.h + dot};
}

/// The inverse: coordinates in the origin's frame become those in the frame carried parallel to a.
inline Offset transvect_back(Space s, const Offset& a, const Offset& p) {
  return transvect(s, {-a.x, -a.y, a.h}, p);
}

/// A rotation of a tangent frame, as a unit complex number.
struct Rotation {
  double cosine = 1, sine = 0;

  [[nodiscard]] Offset operator()(const Offset& p) const {
    return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y, p.h};
  }
  [[nodiscard]] Rotation inverse() const { return {cosine, -sine}; }
};

/// The rotation that turns the direction of `from` into that of `to`. Requires both off the origin.
inline Rotation rotation_between(const Offset& from, const Offset& to) {
  const double c = from.x * to.x + from.y * to.y, s = cross(from, to), norm2 = c * c + s * s;
  // Of tiny offsets the fourth power is below the range of doubles.
  const double norm = norm2 > 1e-290 ? std::sqrt(norm2) : std::hypot(c, s);
  return {c / norm, s / norm};
}

/// An orientation-preserving isometry X -> transvect(translation, rotation(X)): the change of
/// coordinates from a frame at `translation` to the frame that `translation` is given in.
struct Isometry {
  Offset translation;
  Rotation rotation;

  [[nodiscard]] Offset apply(Space s, const Offset& p) const {
    return transvect(s, translation, rotation(p));
  }
  [[nodiscard]] Offset apply_inverse(Space s, const Offset& p) const {
    return rotation.inverse()(transvect_back(s, translation, p));
  }
};

/// The isometry that puts a frame at `tail` so that the point `head_local` of that frame falls on
/// `head` (both given in the outer frame; distances must agree).
inline Isometry placing(Space s, const Offset& head_local, const Offset& tail, const Offset& head) {
  return {tail, rotation_between(head_local, transvect_back(s, tail, head))};
}

/// The change of coordinates from the frame of j to that of i, when i sees j at `ij` and j sees i
/// at `ji`.
inline Isometry between_frames(const Offset& ij, const Offset& ji) {
  return {ij, rotation_between(ji, {-ij.x, -ij.y, ij.h})};
}

/// det[P, Q, R] of the linear model in a form without cancellation for nearby points: positive when
/// p, q, r run counterclockwise and span less than a hemisphere.
double orientation(Space s, const Offset& p, const Offset& q, const Offset& r);

/// det of rows (x, y, h): negative iff d lies inside the circle through the origin, a and b, where
/// origin, a, b run counterclockwise.
inline double in_circle(const Offset& a, const Offset& b, const Offset& d) {
  return a.x * (b.y * d.h - b.h * d.y) - a.y * (b.x * d.h - b.h * d.x) +
         a.h * (b.x * d.y - b.y * d.x);
}

/// Central coordinates of the Voronoi vertex of the origin, a and b.
struct Central {
  double x = 0, y = 0;
};
inline Central circumcentre(const Offset& a, const Offset& b) {
  const double det = cross(a, b);
  return {(a.h * b.y - b.h * a.y) / det, (a.x * b.h - b.x * a.h) / det};
}

/// Geodesic length of a chord, and its inverse.
double length_of_chord(Space s, double chord);
double chord_of_length(Space s, double length);

/// Area of the geodesic triangle (origin, a, b), signed by its orientation.
double central_triangle_area(Space s, const Offset& a, const Offset& b);

}  // namespace ucvt
