// Tessellations made by hand: grids on the cube seen from its centre, and in central coordinates.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "ucvt/spaces.h"

namespace ucvt::oracle {

inline ModelPoint unit(double x, double y, double z) {
  const double n = std::hypot(x, y, z);
  return {x / n, y / n, z / n};
}

inline void add_cell(SpaceResult& r, const std::vector<ModelPoint>& corners,
                     const ModelPoint& site) {
  SpaceCell cell;
  cell.corners = corners;
  cell.centroid = site;
  const auto n = static_cast<int>(r.cells.size());
  cell.degree = 4 + n % 5;
  cell.area = 1 + 0.01 * n, cell.mass = 1, cell.energy = 0, cell.radius = 2 - 0.01 * n;
  cell.nearest = 0.5;
  r.cells.push_back(cell);
  r.sites.push_back(site);
}

/// 6 n^2 cells on the sphere: the geodesic images of an n x n grid on each face of a cube.
inline SpaceResult cube(int n) {
  SpaceResult r;
  const auto at = [n](double i) { return 2 * i / n - 1; };
  for (int face = 0; face < 6; ++face) {
    const auto axis = static_cast<std::size_t>(face / 2);
    const double side = face % 2 == 0 ? 1 : -1;
    const auto point = [&](double u, double v) {
      ModelPoint p{};
      p[axis] = side, p[(axis + 1) % 3] = side * at(u), p[(axis + 2) % 3] = at(v);
      return unit(p[0], p[1], p[2]);
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        add_cell(r, {point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)},
                 point(i + 0.5, j + 0.5));
      }
    }
  }
  return r;
}

/// n x n cells that fill the parallelogram with sides 2a and 2b about the origin.
inline SpaceResult grid(DomainKind kind, double kappa, CentralPoint a, CentralPoint b, int n) {
  SpaceResult r;
  r.domain.kind = kind, r.domain.kappa = kappa;
  const auto central = [&](double u, double v) {
    return CentralPoint{u * a[0] + v * b[0], u * a[1] + v * b[1]};
  };
  const auto point = [&](double i, double j) {
    const CentralPoint k = central(2 * i / n - 1, 2 * j / n - 1);
    const double z = 1 / std::sqrt(1 + kappa * (k[0] * k[0] + k[1] * k[1]));
    return ModelPoint{k[0] * z, k[1] * z, z};
  };
  r.domain.polygon = {central(-1, -1), central(1, -1), central(1, 1), central(-1, 1)};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      add_cell(r, {point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)},
               point(i + 0.5, j + 0.5));
    }
  }
  return r;
}

inline SpaceResult square(int n) {
  return grid(DomainKind::PlanePolygon, 0, {1, 0}, {0, 0.5}, n);
}

inline SpaceResult klein_square(int n) {
  return grid(DomainKind::HyperbolicPolygon, -1, {0.6, 0}, {0.1, 0.6}, n);
}

inline SpaceResult torus(int n) {
  SpaceResult r = grid(DomainKind::Torus, 0, {1, 0}, {0.3, 0.8}, n);
  for (const auto& [x, y] : {CentralPoint{-0.6, -1.6}, {2, 0}, {0.6, 1.6}, {-2, 0}}) {
    r.domain.across.push_back({{{1, 0, x}, {0, 1, y}, {0, 0, 1}}});
  }
  return r;
}

/// A square in the Klein disk with its images under four translations; no surface, but copies.
inline SpaceResult hyperbolic_copies(int n) {
  SpaceResult r = grid(DomainKind::HyperbolicSurface, -1, {0.6, 0}, {0, 0.6}, n);
  const double c = std::cosh(1.4), s = std::sinh(1.4);
  r.domain.across = {{{{1, 0, 0}, {0, c, -s}, {0, -s, c}}},
                     {{{c, 0, s}, {0, 1, 0}, {s, 0, c}}},
                     {{{1, 0, 0}, {0, c, s}, {0, s, c}}},
                     {{{c, 0, -s}, {0, 1, 0}, {-s, 0, c}}}};
  return r;
}

}  // namespace ucvt::oracle
