#include "result/open_double.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "conformal/uniformize.h"
#include "mesh/edge_bisection.h"
#include "result/uniformize_double.h"

namespace ucvt {
namespace {

/// The mesh's edges in units of the spacing of the sites, as for closed surfaces.
constexpr double edge_per_spacing = 0.7;

/// Most that the log scale may change along an edge of the mesh, and rounds of making it finer.
constexpr double steepest_edge = 0.5;
constexpr int max_refinements = 2;

double boundary_length(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& loop : boundary_loops(mesh)) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Position& p = mesh.positions[static_cast<std::size_t>(loop[i])];
      const Position& q = mesh.positions[static_cast<std::size_t>(loop[(i + 1) % loop.size()])];
      sum += std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    }
  }
  return sum;
}

/// Lowers the sizes at the ends of edges over which the log scale changes too fast for a density that
/// is linear in the faces; false when there are none.
bool resolve_log_scale(const OpenDouble& made, std::vector<double>& size) {
  const std::vector<double>& u = made.surface.value().log_scale;
  bool steep = false;
  for (const Corners& f : made.half.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(f[i]), b = static_cast<std::size_t>(f[(i + 1) % 3]);
      const double change = std::abs(u[a] - u[b]);
      if (change > steepest_edge) {
        const Position &p = made.half.positions[a], &q = made.half.positions[b];
        const double length = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
        const double wanted = length * std::max(steepest_edge / change, 0.1) * 0.9;
        size[a] = std::min(size[a], wanted), size[b] = std::min(size[b], wanted);
        steep = true;
      }
    }
  }
  return steep;
}

}  // namespace

OpenDouble make_double(const OpenSurface& open, double spacing, const Monitor& monitor) {
  TriangleMesh half = open.mesh;
  std::vector<double> size(half.positions.size(), edge_per_spacing * spacing);
  std::vector<std::int32_t> input_face(half.faces.size());
  std::iota(input_face.begin(), input_face.end(), 0);
  for (int round = 0;; ++round) {
    std::vector<std::int32_t> part_of = bisect_edges(half, size);
    for (std::int32_t& f : part_of) {
      f = input_face[static_cast<std::size_t>(f)];
    }
    input_face = std::move(part_of);
    DoubledSurface both = doubled(half, open.genus, boundary_loops(half));
    UniformizedSurface surface = uniformize(both, {0, monitor});
    OpenDouble out{half, boundary_curves(half, spacing), std::move(both), std::move(surface),
                   input_face};
    if (round == max_refinements || !resolve_log_scale(out, size)) {
      return out;
    }
  }
}

double hexagonal_spacing(const TriangleMesh& mesh, int n) {
  const double half = boundary_length(mesh) / 2, area = surface_area(mesh);
  return (half + std::sqrt(half * half + 8 * n * area / std::numbers::sqrt3)) / (2 * n);
}

}  // namespace ucvt
