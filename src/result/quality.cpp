#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ucvt/remesh.h"

namespace ucvt {
namespace {

double distance(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

struct TriangleShape {
  double q, least_angle;  ///< radians
};

TriangleShape shape_of(const Position& a, const Position& b, const Position& c) {
  std::array<double, 3> l{distance(a, b), distance(b, c), distance(c, a)};
  std::sort(l.begin(), l.end());
  const double s = (l[0] + l[1] + l[2]) / 2;
  const double area2 = s * (s - l[2]) * (s - l[1]) * (s - l[0]);
  const double area = area2 > 0 ? std::sqrt(area2) : 0;
  const double cosine = (l[2] * l[2] + (l[1] - l[0]) * (l[1] + l[0])) / 2;
  return {l[2] > 0 ? 6 / std::numbers::sqrt3 * area / (s * l[2]) : 0, std::atan2(2 * area, cosine)};
}

}  // namespace

MeshQuality measure_quality(const TriangleMesh& mesh) {
  MeshQuality out;
  out.q_min = 1;
  double least = std::numbers::pi;
  std::vector<int> degree(mesh.positions.size(), 0);
  const auto n = static_cast<double>(mesh.faces.size());
  for (const Corners& f : mesh.faces) {
    const auto at = [&](std::size_t i) -> const Position& {
      return mesh.positions[static_cast<std::size_t>(f[i])];
    };
    for (const std::int32_t v : f) {
      ++degree[static_cast<std::size_t>(v)];
    }
    const TriangleShape t = shape_of(at(0), at(1), at(2));
    out.q_min = std::min(out.q_min, t.q);
    out.q_avg += t.q / n;
    least = std::min(least, t.least_angle);
    out.angle_min_avg_deg += t.least_angle / n * 180 / std::numbers::pi;
    if (t.least_angle < std::numbers::pi / 6) {
      out.below_30 += 1 / n;
    }
  }
  out.angle_min_deg = least * 180 / std::numbers::pi;
  const auto used = std::count_if(degree.begin(), degree.end(), [](int d) { return d > 0; });
  const auto six = std::count(degree.begin(), degree.end(), 6);
  out.regular = static_cast<double>(six) / static_cast<double>(used);
  return out;
}

}  // namespace ucvt
