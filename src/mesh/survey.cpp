#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/topology.h"
#include "mesh/vertex_welder.h"
#include "ucvt/mesh.h"

namespace ucvt {
namespace {

Position difference(const Position& a, const Position& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double length(const Position& v) {
  return std::hypot(v[0], v[1], v[2]);
}

// Lengths of the sides, area, and smallest angle of one triangle, without overflow of squares.
struct TriangleMeasure {
  std::array<double, 3> sides;
  double area = 0;
  double angle_min_rad = 0;
};

TriangleMeasure measure(const Position& a, const Position& b, const Position& c) {
  std::array<Position, 3> edge = {difference(b, a), difference(c, b), difference(a, c)};
  TriangleMeasure m;
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    m.sides[i] = length(edge[i]);
    size = std::max(size, m.sides[i]);
  }
  if (!(size > 0) || !std::isfinite(size)) {
    return m;
  }
  for (Position& e : edge) {
    for (double& x : e) {
      x /= size;
    }
  }
  const auto& [u, v, w] = edge;
  const double doubled =
      std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  m.area = 0.5 * doubled * size * size;
  m.angle_min_rad = std::numbers::pi;
  for (std::size_t i = 0; i < 3; ++i) {
    const Position& p = edge[i];
    const Position& q = edge[(i + 1) % 3];
    const double cosine = -(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
    m.angle_min_rad = std::min(m.angle_min_rad, std::atan2(doubled, cosine));
  }
  return m;
}

void measure_faces(const TriangleMesh& mesh, MeshSurvey& result) {
  double edge_min = std::numeric_limits<double>::infinity();
  double angle_min = std::numbers::pi;
  for (const Corners& f : mesh.faces) {
    const auto at = [&](std::size_t i) -> const Position& {
      return mesh.positions[static_cast<std::size_t>(f[i])];
    };
    const TriangleMeasure m = measure(at(0), at(1), at(2));
    result.area += m.area;
    for (const double side : m.sides) {
      edge_min = std::min(edge_min, side);
      result.edge_max = std::max(result.edge_max, side);
    }
    angle_min = std::min(angle_min, m.angle_min_rad);
  }
  if (mesh.faces.empty()) {
    return;
  }
  result.edge_min = edge_min;
  result.angle_min_deg = angle_min * 180 / std::numbers::pi;
}

void measure_vertices(const TriangleMesh& mesh, MeshSurvey& result) {
  std::vector<bool> used(mesh.positions.size(), false);
  for (const Corners& f : mesh.faces) {
    for (const std::int32_t v : f) {
      used[static_cast<std::size_t>(v)] = true;
    }
  }
  constexpr double far = std::numeric_limits<double>::infinity();
  Position low = {far, far, far}, high = {-far, -far, -far};
  VertexWelder welder(mesh.positions.size());
  std::int64_t count = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) {
      continue;
    }
    ++count;
    welder.number(mesh.positions[v]);
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], mesh.positions[v][k]);
      high[k] = std::max(high[k], mesh.positions[v][k]);
    }
  }
  result.coincident_vertices = count - static_cast<std::int64_t>(welder.positions().size());
  if (count > 0) {
    result.bbox_diagonal = length(difference(high, low));
  }
}

}  // namespace

double face_area(const TriangleMesh& mesh, const Corners& face) {
  const auto at = [&](std::size_t i) -> const Position& {
    return mesh.positions[static_cast<std::size_t>(face[i])];
  };
  const Position u = difference(at(1), at(0)), v = difference(at(2), at(1));
  const double size = std::max(length(u), length(v));
  if (!(size > 0 && std::isfinite(size))) {
    return 0;
  }
  const auto part = [&](std::size_t i, std::size_t j) {
    return u[i] / size * (v[j] / size) - u[j] / size * (v[i] / size);
  };
  return 0.5 * std::hypot(part(1, 2), part(2, 0), part(0, 1)) * size * size;
}

double surface_area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Corners& f : mesh.faces) {
    sum += face_area(mesh, f);
  }
  return sum;
}

MeshSurvey survey(const TriangleMesh& mesh) {
  MeshSurvey result = analyze_topology(mesh).counts;
  measure_faces(mesh, result);
  measure_vertices(mesh, result);
  return result;
}

}  // namespace ucvt
