// Four faces of T at once, a lane each: what cutting them up takes. Only for functions compiled wide.
#pragma once

#include <algorithm>
#include <vector>

#include "cvt/lifts.h"
#include "cvt/surface_mass.h"
#include "space/lane_moments.h"
#include "space/quadrature.h"

// Lanes are returned by functions that are always inlined: no call depends on how. For all that follows,
// in the files that include this one.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace ucvt {

/// By lane.
struct LaneOffset {
  Lanes x, y, h;
};

/// By lane, as `Moments`.
struct LaneMoments {
  Lanes m, x, y, h;
};

/// Points of faces in barycentric coordinates.
struct LanePoint {
  Lanes b1, b2;
};

/// The sides and densities of faces, counted from the corner that is called 0.
struct LaneFace {
  std::array<Lanes, 3> chord2, density;
  Lanes det;
};

/// By lane, as `CornerShare`.
struct LaneShare {
  Lanes mu, excess;
};

/// Faces of similar size: the rule and the series that integrate pieces of faces with squared sides
/// below the bound to 1e-11, as in space/moments.cpp. In the plane, where the first is exact, all are of it.
struct FaceKind {
  double side2;
  int degree;
};
constexpr std::array<FaceKind, 4> face_kinds{
    {{7.5e-5, 5}, {short_series_side2, 6}, {9.5e-3, 8}, {6e-2, 12}}};

/// The kind of a face; face_kinds.size() where it is too big for all.
inline std::size_t face_kind(Space s, const ChordTriangle& t) {
  const double side2 = s.kappa == 0 ? 0 : std::max({t.chord2[0], t.chord2[1], t.chord2[2]});
  std::size_t kind = 0;
  while (kind < face_kinds.size() && !(side2 < face_kinds[kind].side2)) {
    ++kind;
  }
  return kind;
}

inline void set_lane(LaneOffset& lanes, std::size_t n, const Offset& p) {
  lanes.x[n] = p.x, lanes.y[n] = p.y, lanes.h[n] = p.h;
}

inline void set_lane(LaneFace& lanes, std::size_t n, const FacePieces& face,
                     const std::array<std::size_t, 3>& corner) {
  for (std::size_t c = 0; c < 3; ++c) {
    lanes.chord2[c][n] = face.triangle.chord2[corner[c]];
    lanes.density[c][n] = face.density[corner[c]];
  }
  lanes.det[n] = face.triangle.det;
}

inline void set_lane(LaneShare& lanes, std::size_t n, const CornerShare& share) {
  lanes.mu[n] = share.mu, lanes.excess[n] = share.excess;
}

inline Moments lane(const LaneMoments& lanes, std::size_t n) {
  return {lanes.m[n], lanes.x[n], lanes.y[n], lanes.h[n]};
}

/// 1 where a < b, else 0.
[[gnu::always_inline]] inline Lanes less(const Lanes& a, const Lanes& b) {
  return a < b ? Lanes{} + 1 : Lanes{};
}

/// `beyond_bisector`.
[[gnu::always_inline]] inline Lanes beyond(double kappa, const LaneOffset& p,
                                           const LaneOffset& neighbour) {
  return neighbour.x * p.x + neighbour.y * p.y - neighbour.h * (1 - kappa * p.h);
}

/// 1 where the point is no nearer to the neighbour than to the site, else 0.
[[gnu::always_inline]] inline Lanes is_within(double kappa, const LaneOffset& p,
                                              const LaneOffset& neighbour) {
  return 1 - less(Lanes{}, beyond(kappa, p, neighbour));
}

[[gnu::always_inline]] inline LaneOffset between(const LaneOffset& p, const LaneOffset& q,
                                                 const Lanes& s) {
  return {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.h + s * (q.h - p.h)};
}

/// `transvect` of a point (m = 1), or of the integral of points over a mass m.
[[gnu::always_inline]] inline LaneMoments transvect(double kappa, const LaneOffset& a,
                                                    const LaneMoments& p) {
  const Lanes dot = a.x * p.x + a.y * p.y;
  const Lanes f = p.m - kappa * (p.h + dot / (2 - kappa * a.h));
  return {p.m, p.x + a.x * f, p.y + a.y * f, a.h * p.m + p.h - kappa * a.h * p.h + dot};
}

/// Isometries, as `Isometry`.
struct LaneIsometry {
  LaneOffset translation;
  Lanes cosine, sine;
};

inline void set_lane(LaneIsometry& lanes, std::size_t n, const Isometry& frame) {
  set_lane(lanes.translation, n, frame.translation);
  lanes.cosine[n] = frame.rotation.cosine, lanes.sine[n] = frame.rotation.sine;
}

[[gnu::always_inline]] inline LaneOffset apply(double kappa, const LaneIsometry& f,
                                               const LaneOffset& p) {
  const LaneMoments q =
      transvect(kappa, f.translation,
                {Lanes{} + 1, f.cosine * p.x - f.sine * p.y, f.sine * p.x + f.cosine * p.y, p.h});
  return {q.x, q.y, q.h};
}

[[gnu::always_inline]] inline LaneMoments apply_inverse(double kappa, const LaneIsometry& f,
                                                        const LaneMoments& p) {
  const LaneOffset back{-f.translation.x, -f.translation.y, f.translation.h};
  const LaneMoments q = transvect(kappa, back, p);
  return {q.m, f.cosine * q.x + f.sine * q.y, f.cosine * q.y - f.sine * q.x, q.h};
}

/// 1 where the points can be the ends of an edge, as `joins` has it but for rounding; else 0.
[[gnu::always_inline]] inline Lanes are_joined(double kappa, const LaneOffset& p,
                                               const LaneOffset& q, const Lanes& edge2) {
  if (kappa > 0) {
    return Lanes{} + 1;
  }
  const Lanes x = q.x - p.x, y = q.y - p.y, h = q.h - p.h;
  const Lanes gap = x * x + y * y + kappa * h * h - edge2, most = same_chord2 * edge2;
  return less(gap, most) * less(-most, gap);
}

/// Adds a triangle by its corners.
template <int terms>
[[gnu::always_inline]] inline void add_piece(double kappa, const LaneFace& f,
                                             const std::vector<QuadratureNode>& rule,
                                             const std::array<LanePoint, 3>& p, LaneWeights& out) {
  const Lanes jacobian =
      f.det / 2 *
      ((p[1].b1 - p[0].b1) * (p[2].b2 - p[0].b2) - (p[1].b2 - p[0].b2) * (p[2].b1 - p[0].b1));
  for (const QuadratureNode& q : rule) {
    const Lanes l1 = q.b0 * p[0].b1 + q.b1 * p[1].b1 + q.b2 * p[2].b1;
    const Lanes l2 = q.b0 * p[0].b2 + q.b1 * p[1].b2 + q.b2 * p[2].b2;
    add_nodes<terms>(kappa, f.chord2, f.density, {1 - l1 - l2, l1, l2}, q.weight * jacobian, out);
  }
}

/// The moments that the weights stand for, in the frame that the corners are given in.
[[gnu::always_inline]] inline LaneMoments moments_of(double kappa, const LaneWeights& w,
                                                     const LaneOffset& a, const LaneOffset& b,
                                                     const LaneOffset& c) {
  return {w.mu0 + w.mu1 + w.mu2 + kappa * w.excess, w.mu0 * a.x + w.mu1 * b.x + w.mu2 * c.x,
          w.mu0 * a.y + w.mu1 * b.y + w.mu2 * c.y,
          w.excess + w.mu0 * a.h + w.mu1 * b.h + w.mu2 * c.h};
}

}  // namespace ucvt
