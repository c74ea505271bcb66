// Moments of a density over a geodesic triangle, and over convex pieces of it.
//
// The density is linear over the chord triangle: rho = sum l_v rho_v at the point
// P = w sum l_v P_v, sum l_v = 1, w = (1 - kappa sum_{u<v} l_u l_v c_uv^2)^(-1/2). In these
// coordinates the area element is D w^3 dl, D = det[P_0, P_1, P_2], so
//     int rho P dsigma = sum mu_v P_v,   mu_v = D int rho w^4 l_v dl,
//     int rho h dsigma = sum mu_v h_v + excess,   int rho dsigma = sum mu_v + kappa excess
// in every frame: the weights mu are computed without one. docs/moments.md has the derivation.
#pragma once

#include <array>

#include "space/offset.h"

namespace ucvt {

/// Mass, first moments and h moment of a density, in the frame they are asked for.
struct Moments {
  double m = 0, x = 0, y = 0, h = 0;

  Moments& operator+=(const Moments& o) {
    m += o.m, x += o.x, y += o.y, h += o.h;
    return *this;
  }
  Moments& operator-=(const Moments& o) {
    m -= o.m, x -= o.x, y -= o.y, h -= o.h;
    return *this;
  }
};

/// Frame-free integrals of a density over (a piece of) a triangle; see the head of this file.
struct Weights {
  std::array<double, 3> mu{};
  double excess = 0;  ///< never positive: chords run below the quadric

  [[nodiscard]] double mass(Space s) const { return mu[0] + mu[1] + mu[2] + s.kappa * excess; }

  Weights& operator+=(const Weights& o) {
    for (std::size_t i = 0; i < 3; ++i) {
      mu[i] += o.mu[i];
    }
    excess += o.excess;
    return *this;
  }
  Weights& operator-=(const Weights& o) {
    for (std::size_t i = 0; i < 3; ++i) {
      mu[i] -= o.mu[i];
    }
    excess -= o.excess;
    return *this;
  }
};

/// The moments that the weights stand for, in the frame that the corners are given in.
inline Moments moments_of(Space s, const Weights& w, const std::array<Offset, 3>& corner) {
  Moments out{w.mass(s), 0, 0, w.excess};
  for (std::size_t i = 0; i < 3; ++i) {
    out.x += w.mu[i] * corner[i].x;
    out.y += w.mu[i] * corner[i].y;
    out.h += w.mu[i] * corner[i].h;
  }
  return out;
}

/// A geodesic triangle as far as integrals over it go.
struct ChordTriangle {
  std::array<double, 3> chord2{};  ///< squared chord of the side from corner i to corner i + 1
  double det = 0;                  ///< det[P_0, P_1, P_2] > 0
};

/// det[P_0, P_1, P_2] of a triangle with the given chords (side i from corner i to i + 1) by a stable
/// Heron formula (Kahan); 0 when no such triangle exists.
double triangle_determinant(Space s, const std::array<double, 3>& chord);

/// A point of a triangle in barycentric coordinates of its chord triangle; b0 = 1 - b1 - b2.
struct Barycentric {
  double b1 = 0, b2 = 0;
};

/// Weights of the density with corner values rho over the triangle with corners a, b, c (given in
/// the big triangle's coordinates, counterclockwise). Relative error below 1e-11: the order of the
/// quadrature follows the size of the piece, and pieces too big for one rule are cut in four.
Weights integrate_piece(Space s, const ChordTriangle& t, const std::array<double, 3>& rho,
                        Barycentric a, Barycentric b, Barycentric c);

/// The same over the whole triangle, with a relative error below 1e-13.
Weights integrate(Space s, const ChordTriangle& t, const std::array<double, 3>& rho);

/// Where the moments put the centroid (the paper's model centroid, its equations 3 and 4), as an
/// offset in their frame. Requires m - kappa h > 0: the mass lies within a hemisphere about it.
inline Offset centroid(Space s, const Moments& m) {
  const double scale = m.m - s.kappa * m.h;
  return from_central(s, m.x / scale, m.y / scale);
}

}  // namespace ucvt
