#include "space/offset.h"

#include <algorithm>

namespace ucvt {

double orientation(Space s, const Offset& p, const Offset& q, const Offset& r) {
  // det of rows (x, y, 1) minus kappa det of rows (x, y, h), both expanded about p.
  const Offset u{q.x - p.x, q.y - p.y, q.h - p.h}, v{r.x - p.x, r.y - p.y, r.h - p.h};
  return cross(u, v) - s.kappa * in_circle(p, u, v);
}

double length_of_chord(Space s, double chord) {
  if (s.kappa > 0) {
    return 2 * std::asin(std::min(1.0, chord / 2));
  }
  return s.kappa < 0 ? 2 * std::asinh(chord / 2) : chord;
}

double chord_of_length(Space s, double length) {
  if (s.kappa > 0) {
    return 2 * std::sin(length / 2);
  }
  return s.kappa < 0 ? 2 * std::sinh(length / 2) : length;
}

double central_triangle_area(Space s, const Offset& a, const Offset& b) {
  // tan(area/2) = det / (1 + z_a + z_b + <a, b>), van Oosterom and Strackee 1983, and its
  // hyperbolic twin; in the plane the denominator is 4.
  const double c = cross(a, b);
  if (s.kappa == 0) {
    return c / 2;
  }
  const double za = model_z(s, a), zb = model_z(s, b);
  const double inner = za * zb + s.kappa * (a.x * b.x + a.y * b.y);
  return 2 * std::atan2(c, 1 + za + zb + inner);
}

}  // namespace ucvt
