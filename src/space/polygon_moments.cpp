#include "space/polygon_moments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ucvt {
namespace {

/// sin, id or sinh.
double sin_kappa(Space s, double t) {
  if (s.kappa == 0) {
    return t;
  }
  return s.kappa > 0 ? std::sin(t) : std::sinh(t);
}

/// An edge as far as its length goes: d and G = kappa (d / sin_kappa(d) - 1), in the plane d^2/6.
struct EdgeLength {
  double length = 0, sine = 0, g = 0;
};

/// kappa (d - sin_kappa(d)), by its power series where the difference would cancel.
double excess_over_sine(Space s, double d, double sine) {
  if (d >= 1) {
    return s.kappa == 0 ? d * d * d / 6 : s.kappa * (d - sine);
  }
  const double t = s.kappa * d * d;
  // The first term left out is below 1e-18 of the first.
  double sum = 0;
  for (int n = 20; n >= 4; n -= 2) {
    sum = (1 - sum) * t / (n * (n + 1));
  }
  return d * d * d / 6 * (1 - sum);
}

EdgeLength edge_length(Space s, const Offset& a, const Offset& b) {
  const double c2 = std::max(0.0, chord2(s, a, b)), c = std::sqrt(c2);
  double half = std::sqrt(std::max(0.0, 1 - s.kappa * c2 / 4));
  double d = s.kappa < 0 ? 2 * std::asinh(c / 2) : c;
  if (s.kappa > 0) {
    if (c2 > 2) {  // 4 - c^2 = |P_a + P_b|^2 keeps the digits that 1 - c^2/4 loses near pi
      half = std::hypot(a.x + b.x, a.y + b.y, model_z(s, a) + model_z(s, b)) / 2;
    }
    d = 2 * std::atan2(c / 2, half);
  }
  const double sine = c * half;
  return {d, sine, sine > 0 ? excess_over_sine(s, d, sine) / sine : 0};
}

struct LineNode {
  double u, weight;
};
/// Gauss-Legendre on [0, 1] with 3, 5 and 10 nodes; node n - 1 - i mirrors node i.
constexpr std::array<LineNode, 2> gauss_3{
    {{0.11270166537925831148, 0.27777777777777777778}, {0.5, 0.44444444444444444444}}};
constexpr std::array<LineNode, 3> gauss_5{{{0.046910077030668003601, 0.11846344252809454376},
                                           {0.23076534494715845448, 0.23931433524968323402},
                                           {0.5, 0.28444444444444444444}}};
constexpr std::array<LineNode, 5> gauss_10{{{0.013046735741414139961, 0.033335672154344068797},
                                            {0.067468316655507744634, 0.074725674575290296573},
                                            {0.16029521585048779688, 0.109543181257991022},
                                            {0.2833023029353764046, 0.13463335965499817755},
                                            {0.42556283050918439456, 0.14776211235737643509}}};

/// The nodes that integrate h/(1 + z) along an edge to rounding (docs/polygon-moments.md).
std::span<const LineNode> nodes_for(double length) {
  if (length < 1e-3) {
    return gauss_3;
  }
  return length < 0.1 ? std::span<const LineNode>(gauss_5) : gauss_10;
}

/// The mean of h/(2 (1 + z)) along an edge all of whose points have h <= far_h.
double edge_mean(Space s, const Offset& a, const Offset& b, const EdgeLength& e) {
  // The point at u is (P_a sin((1 - u) d) + P_b sin(u d)) / sin d; h/(1 + z) = (x^2 + y^2)/(1 + z)^2.
  const auto at = [&](double wa, double wb) {
    const double x = wa * a.x + wb * b.x, y = wa * a.y + wb * b.y, q = x * x + y * y;
    const double z1 = 1 + std::sqrt(1 - s.kappa * q);
    return q / (2 * z1 * z1);
  };
  double mean = 0;
  for (const auto& [u, weight] : nodes_for(e.length)) {
    const double near = sin_kappa(s, u * e.length) / e.sine;
    if (u == 0.5) {
      mean += weight * at(near, near);
    } else {
      const double far = sin_kappa(s, (1 - u) * e.length) / e.sine;
      mean += weight * (at(far, near) + at(near, far));
    }
  }
  return mean;
}

/// Where z and the area are so different that int h is their difference without loss.
constexpr double far_h = 0.5;

/// The signed moments of the triangle (origin, a, b) that Lambert's sum ascribes to an edge.
Moments edge_moments(Space s, const Offset& a, const Offset& b) {
  const EdgeLength e = edge_length(s, a, b);
  if (e.length == 0) {
    return {};
  }
  const double k = s.kappa, lambert = (1 + k * e.g) / 2, z = lambert * cross(a, b);
  Moments out;
  out.x = lambert * (a.h * b.y - a.y * b.h) + e.g / 2 * (a.y - b.y);
  out.y = lambert * (a.x * b.h - a.h * b.x) + e.g / 2 * (b.x - a.x);
  if (k != 0 && std::max(a.h, b.h) > far_h) {
    out.m = central_triangle_area(s, a, b);
    out.h = k * (out.m - z);
  } else {
    out.h = 2 * z * edge_mean(s, a, b, e);
    out.m = z + k * out.h;
  }
  return out;
}

Moments sum_over_edges(Space s, std::span<const Offset> corners) {
  Moments out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    out += edge_moments(s, corners[i], corners[(i + 1) % corners.size()]);
  }
  return out;
}

/// Moments in the frame carried parallel to `a` as moments in the frame that a is given in.
Moments carried_back(Space s, const Offset& a, const Moments& m) {
  const double dot = a.x * m.x + a.y * m.y;
  const double f = m.m - s.kappa * (m.h + dot / (2 - s.kappa * a.h));
  return {m.m, m.x + a.x * f, m.y + a.y * f, a.h * m.m + m.h - s.kappa * a.h * m.h + dot};
}

/// Moments by way of the frame at `base`.
Moments moments_about(Space s, const Offset& base, std::span<const Offset> corners) {
  const bool beyond = s.kappa > 0 && base.h > 1;
  // The half-turn about the x axis brings the sphere's far side here: (x, y, z) -> (x, -y, -z).
  const auto turned = [&](const Offset& p) {
    return beyond ? on_quadric(s, {p.x, -p.y, 2 - p.h}) : p;
  };
  const Offset to = turned(base);
  std::vector<Offset> moved(corners.size());
  std::transform(corners.begin(), corners.end(), moved.begin(),
                 [&](const Offset& p) { return on_quadric(s, transvect_back(s, to, turned(p))); });
  Moments out = carried_back(s, to, sum_over_edges(s, moved));
  if (beyond) {
    out.y = -out.y;
    out.h = 2 * out.m - out.h;
  }
  return out;
}

/// Past this h (120 degrees away) the edges' triangles come near to the origin's antipode, where
/// their areas are ill-conditioned.
constexpr double farthest_h = 1.5;

bool serves_as_origin(Space s, std::span<const Offset> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (cross(corners[i], corners[(i + 1) % corners.size()]) < 0 ||
        (s.kappa > 0 && corners[i].h > farthest_h)) {
      return false;
    }
  }
  return true;
}

}  // namespace

Moments uniform_moments(Space s, std::span<const Offset> corners) {
  if (corners.size() < 3) {
    return {};
  }
  if (serves_as_origin(s, corners)) {
    return sum_over_edges(s, corners);
  }
  const Offset& nearest = *std::min_element(corners.begin(), corners.end(),
                                            [](const auto& p, const auto& q) { return p.h < q.h; });
  // From a corner no two triangles cancel; a polygon wider than a quarter turn is big enough that
  // its centroid, where nothing is far, is found well from here.
  const bool wide = s.kappa > 0 && std::any_of(corners.begin(), corners.end(), [&](const auto& p) {
                      return chord2(s, nearest, p) > 2;
                    });
  return moments_about(s, wide ? centroid_anywhere(s, sum_over_edges(s, corners)) : nearest,
                       corners);
}

Offset centroid_anywhere(Space s, const Moments& m) {
  const double z = m.m - s.kappa * m.h, length = std::hypot(m.x, m.y, z);
  if (s.kappa > 0 && 2 * z < length) {
    return {m.x / length, m.y / length, 1 - z / length};
  }
  return centroid(s, m);
}

}  // namespace ucvt
