// What the tests of polygon moments share: random convex polygons and an integral by brute force.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "oracle/generators.h"
#include "space/polygon_moments.h"
#include "space/quadrature.h"

namespace ucvt {

using Polygon = std::vector<Offset>;

inline double one(const Offset&) {
  return 1;
}

/// The bump and ripples of docs/polygon-moments.md.
inline double sharp(const Offset& p) {
  const double wave = std::sin(std::numbers::pi * p.x) * std::sin(std::numbers::pi * p.y);
  return std::exp(-20 * (p.x * p.x + p.y * p.y)) + 0.05 * wave * wave;
}

inline double reach_of(const Polygon& c) {
  double h = 0;
  for (const Offset& p : c) {
    h = std::max(h, p.h);
  }
  return std::sqrt(2 * h);
}

/// How far two moments differ, relative to m, m r, m r and m r^2/2.
inline double difference(const Moments& p, const Moments& q, double reach) {
  return std::max({std::abs(p.m - q.m), std::abs(p.x - q.x) / reach, std::abs(p.y - q.y) / reach,
                   std::abs(p.h - q.h) * 2 / (reach * reach)}) /
         std::abs(q.m);
}

inline Polygon from_central(Space s, const std::vector<Central>& k, double size) {
  Polygon c;
  for (const Central& p : k) {
    c.push_back(from_central(s, p.x * size, p.y * size));
  }
  return c;
}

inline Polygon moved(Space s, const Offset& to, const Polygon& c) {
  Polygon out;
  for (const Offset& p : c) {
    out.push_back(on_quadric(s, transvect_back(s, to, p)));
  }
  return out;
}

/// A convex polygon with 3 to 8 corners on an ellipse; the origin may lie outside.
inline Polygon convex(Space s, double size) {
  const int n = *rc::gen::inRange(3, 9);
  const double x = oracle::number(-0.3, 0.3), y = oracle::number(-0.3, 0.3),
               start = oracle::number(-3, 3);
  const double a = oracle::number(0.2, 0.5), b = oracle::number(0.2, 0.5);
  std::vector<Central> k;
  for (int i = 0; i < n; ++i) {
    const double t = start + 2 * std::numbers::pi * (i + oracle::number(-0.3, 0.3)) / n;
    k.push_back({x + a * std::cos(t), y + b * std::sin(t)});
  }
  return from_central(s, k, size);
}

/// Moments by rules of degree 30 on n^2 pieces of each triangle of a fan in central coordinates: no
/// formula in common with the code under test.
inline Moments brute_force(Space s, const Polygon& c, const OffsetDensity& density, int n = 12) {
  Moments out;
  const auto central = [&](const Offset& p) {
    return Central{p.x / model_z(s, p), p.y / model_z(s, p)};
  };
  for (std::size_t i = 1; i + 1 < c.size(); ++i) {
    const Central o = central(c[0]), a = central(c[i]), b = central(c[i + 1]);
    const double ux = (a.x - o.x) / n, uy = (a.y - o.y) / n;
    const double vx = (b.x - o.x) / n, vy = (b.y - o.y) / n;
    const auto add = [&](double u, double v, double weight) {
      const Offset at = ucvt::from_central(s, o.x + u * ux + v * vx, o.y + u * uy + v * vy);
      const double z = model_z(s, at);
      const double dm = weight * (ux * vy - uy * vx) / 2 * z * z * z * density(at);
      out += {dm, dm * at.x, dm * at.y, dm * at.h};
    };
    for (int j = 0; j < n; ++j) {
      for (int k = 0; j + k < n; ++k) {
        for (const auto& q : triangle_rule(30)) {
          add(j + q.b1, k + q.b2, q.weight);
          if (j + k + 1 < n) {
            add(j + 1 - q.b1, k + 1 - q.b2, q.weight);
          }
        }
      }
    }
  }
  return out;
}

}  // namespace ucvt
