// Small surfaces with boundary made by code.
#pragma once

#include <cmath>
#include <cstddef>

#include "oracle/meshes.h"

namespace ucvt::oracle {

/// An L-shaped plate with cells of side 1/n: a disk with six corners.
inline TriangleMesh plate(std::int32_t n) {
  TriangleMesh mesh;
  const std::int32_t row = 2 * n + 1;
  for (std::int32_t j = 0; j < row; ++j) {
    for (std::int32_t i = 0; i < row; ++i) {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
      mesh.positions.push_back({x, y, 0.2 * x * x});
    }
  }
  for (std::int32_t j = 0; j < 2 * n; ++j) {
    for (std::int32_t i = 0; i < (j < n ? 2 * n : n); ++i) {
      const std::int32_t a = j * row + i;
      mesh.faces.push_back({a, a + 1, a + row + 1});
      mesh.faces.push_back({a, a + row + 1, a + row});
    }
  }
  return mesh;
}

/// A tube of revolution without ends: an annulus of boundary circles with no corner.
inline TriangleMesh tube(std::int32_t around, std::int32_t along) {
  TriangleMesh mesh;
  for (std::int32_t j = 0; j <= along; ++j) {
    for (std::int32_t i = 0; i < around; ++i) {
      const double a = 2 * 3.14159265358979 * i / around, z = 3.0 * j / along;
      const double r = 1 + 0.3 * std::sin(2 * z);
      mesh.positions.push_back({r * std::cos(a), r * std::sin(a), z});
      if (j < along) {
        const std::int32_t p = j * around + i, q = j * around + (i + 1) % around;
        mesh.faces.push_back({p, q, q + around});
        mesh.faces.push_back({p, q + around, p + around});
      }
    }
  }
  return mesh;
}

/// A torus without the faces round some of its vertices, one hole each.
inline TriangleMesh torus_with_holes(int holes) {
  TriangleMesh mesh = grid_torus(24, 14);
  for (std::int32_t k = 0; k < holes; ++k) {
    const std::int32_t centre = 40 + 97 * k;
    std::erase_if(mesh.faces, [&](const Corners& f) {
      return f[0] == centre || f[1] == centre || f[2] == centre;
    });
  }
  return mesh;
}

}  // namespace ucvt::oracle
