#include "mesh/hole_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ucvt {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// A loop whose area is less than this part of its squared length is a slit, which has no normal.
constexpr double slit = 1e-3;

/// The least sum of area vectors over area that counts as one sheet.
constexpr double least_flatness = 0.5;

Position area_vector(const Position& a, const Position& b, const Position& c) {
  const Position u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Position v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {(u[1] * v[2] - u[2] * v[1]) / 2, (u[2] * v[0] - u[0] * v[2]) / 2,
          (u[0] * v[1] - u[1] * v[0]) / 2};
}

double length(const Position& p) {
  return std::hypot(p[0], p[1], p[2]);
}

/// The loop in units of its own size, so that areas neither overflow nor vanish.
std::vector<Position> normalized(const std::vector<Position>& loop) {
  std::vector<Position> out = loop;
  double size = 0;
  for (Position& p : out) {
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] -= loop[0][k];
      size = std::max(size, std::abs(p[k]));
    }
  }
  for (Position& p : out) {
    for (double& x : p) {
      x = size > 0 && std::isfinite(size) ? x / size : 0;
    }
  }
  return out;
}

bool is_one_sheet(const std::vector<Position>& loop, const std::vector<Corners>& triangles) {
  Position sum{};
  double area = 0, around = 0;
  for (const Corners& t : triangles) {
    const auto at = [&](std::size_t i) { return loop[static_cast<std::size_t>(t[i])]; };
    const Position v = area_vector(at(0), at(1), at(2));
    area += length(v);
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += v[k];
    }
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Position &a = loop[i], &b = loop[(i + 1) % loop.size()];
    around += length({b[0] - a[0], b[1] - a[1], b[2] - a[2]});
  }
  return area <= slit * around * around || length(sum) >= least_flatness * area;
}

}  // namespace

std::vector<Corners> hole_triangles(
    const std::vector<Position>& loop,
    const std::function<bool(std::size_t, std::size_t)>& is_forbidden) {
  const std::size_t n = loop.size();
  const std::vector<Position> p = normalized(loop);
  // Of the part from corner i to corner j: the least area, and the third corner of the face at i, j.
  std::vector<double> least(n * n, 0);
  std::vector<std::size_t> apex(n * n, 0);
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0, j = span; j < n; ++i, ++j) {
      double& best = least[i * n + j] = none;
      if (span < n - 1 && is_forbidden(i, j)) {
        continue;
      }
      for (std::size_t k = i + 1; k < j; ++k) {
        const double area =
            least[i * n + k] + least[k * n + j] + length(area_vector(p[i], p[k], p[j]));
        if (area < best) {
          best = area, apex[i * n + j] = k;
        }
      }
    }
  }
  if (!(least[n - 1] < none)) {
    return {};
  }
  std::vector<Corners> out;
  std::vector<std::pair<std::size_t, std::size_t>> parts = {{0, n - 1}};
  while (!parts.empty()) {
    const auto [i, j] = parts.back();
    parts.pop_back();
    if (j < i + 2) {
      continue;
    }
    const std::size_t k = apex[i * n + j];
    out.push_back(
        {static_cast<std::int32_t>(i), static_cast<std::int32_t>(k), static_cast<std::int32_t>(j)});
    parts.emplace_back(i, k);
    parts.emplace_back(k, j);
  }
  return is_one_sheet(p, out) ? out : std::vector<Corners>();
}

}  // namespace ucvt
