#include "conformal/uniformize.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "conformal/metric_solver.h"
#include "conformal/punctured_sphere.h"
#include "triangulation/hilbert_order.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

constexpr int max_newton_steps = 200;
constexpr double angle_tolerance = 1e-10;

/// Angle errors, in radians, with which log scales tell where the surface is to be refined.
constexpr double rough_angles = 1e-2;

/// Most that the log scale may change along an edge of the refined surface (the density then changes
/// by a factor of e^2 at most), rounds of refinement towards it, and the share of steep edges that is
/// not worth a round.
constexpr double steepest_edge = 0.5;
constexpr int max_refinements = 2;
constexpr double ignored_share = 1e-3;

/// The mesh's faces along a space-filling curve: cells then read T in runs instead of all over memory.
std::vector<std::int32_t> spatial_order(const TriangleMesh& mesh) {
  std::vector<Position> centroids;
  centroids.reserve(mesh.faces.size());
  for (const Corners& face : mesh.faces) {
    Position centroid{};
    for (const std::int32_t v : face) {
      for (std::size_t c = 0; c < 3; ++c) {
        centroid[c] += mesh.positions[static_cast<std::size_t>(v)][c] / 3;
      }
    }
    centroids.push_back(centroid);
  }
  std::vector<std::int32_t> out;
  for (const std::size_t f : hilbert_order(centroids)) {
    out.push_back(static_cast<std::int32_t>(f));
  }
  return out;
}

double sum(const std::vector<double>& terms) {
  return std::accumulate(terms.begin(), terms.end(), 0.0);
}

struct Solution {
  std::vector<double> u;
  MetricSolver::Result result;
};

/// In the plane and the hyperbolic plane, from `u`.
Solution solve_from(std::vector<double> u, Space space, IntrinsicTriangulation& t,
                    const MetricSolver::Enough& enough, const MetricSolver::Watch& watch) {
  std::vector<VertexRole> role(u.size(), VertexRole::Solved);
  if (space.kappa == 0) {
    role[0] = VertexRole::Held;
  }
  Solution out{std::move(u), {}};
  MetricSolver solver(space, t, out.u, std::move(role));
  out.result = solver.solve(rough_angles, max_newton_steps, watch);
  if (out.result.converged && !enough(out.u)) {
    const int before = out.result.iterations;
    out.result = solver.solve(angle_tolerance, max_newton_steps, [&](int iteration, double error) {
      return watch(before + iteration, error);
    });
    out.result.iterations += before;
  }
  return out;
}

/// Flat metrics scale freely: this makes the surface's area `area`.
void scale_plane(const IntrinsicTriangulation& t, double area, std::vector<double>& u) {
  double total = 0;
  const auto& c = t.connectivity;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    std::array<double, 3> chord{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Halfedge h = halfedges({static_cast<std::int32_t>(f)})[i];
      chord[i] =
          std::exp(t.log_length[h.index()] + (u[c.origin(h).index()] + u[c.head(h).index()]) / 2);
    }
    total += triangle_determinant({0}, chord) / 2;
  }
  for (double& x : u) {
    x -= std::log(total / area) / 2;
  }
}

std::vector<double> chords(const IntrinsicTriangulation& t, const std::vector<double>& u) {
  std::vector<double> out(t.log_length.size());
  const auto& c = t.connectivity;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const double ui = u[std::min(c.origin(h), c.head(h)).index()];
    const double uj = u[std::max(c.origin(h), c.head(h)).index()];
    out[i] = std::exp(t.log_length[i] + (ui + uj) / 2);
  }
  return out;
}

/// All that T and the way to it tell; genus, steps, certificate and time are still to come.
UniformizationReport report_of(const UniformSurface& uniform, const IntrinsicTriangulation& t,
                               const std::vector<double>& u) {
  UniformizationReport out;
  const double kappa = uniform.space().kappa;
  out.geometry = kappa > 0 ? "spherical" : kappa < 0 ? "hyperbolic" : "euclidean";
  out.euclidean_flips = t.euclidean_flips;
  out.ptolemy_flips = t.ptolemy_flips;
  out.refined_vertices = t.splits;
  out.vertices = static_cast<std::int64_t>(uniform.connectivity().vertex_count());
  out.faces = static_cast<std::int64_t>(uniform.connectivity().face_count());
  const auto [low, high] = std::minmax_element(u.begin(), u.end());
  out.log_scale_min = *low, out.log_scale_max = *high;
  return out;
}

/// Measures what was reached by formulas other than the solver's, and throws when it is not enough.
void certify(const UniformSurface& t, double input_area, UniformizationReport& report) {
  const Connectivity& c = t.connectivity();
  std::vector<double> sum(c.vertex_count());
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    sum[c.origin(h).index()] += t.angle(h);
  }
  report.max_angle_error = 0;
  for (const double s : sum) {
    report.max_angle_error = std::max(report.max_angle_error, std::abs(s - 2 * std::numbers::pi));
  }
  report.area = 0;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    report.area += t.area({static_cast<std::int32_t>(f)});
  }
  if (report.max_angle_error > angle_tolerance) {
    throw NumericalError(fmt::format("uniformization left an angle error of {:.1e} radians",
                                     report.max_angle_error));
  }
  const double wanted =
      t.space().kappa == 0 ? input_area
                           : 2 * std::numbers::pi * std::abs(static_cast<double>(c.euler_number()));
  if (std::abs(report.area - wanted) > 1e-8 * wanted) {
    throw NumericalError("uniformization missed the area that Gauss and Bonnet ask for");
  }
}

/// From `u`, on the sphere from the surface alone.
Solution solve(IntrinsicTriangulation& t, int genus, const std::vector<double>& vertex_area,
               std::vector<double> u, const MetricSolver::Enough& enough,
               const MetricSolver::Watch& watch) {
  Solution out;
  if (genus == 0) {
    out.result = solve_sphere(t, out.u, vertex_area, enough, watch);
  } else if (genus == 1) {
    out = solve_from(std::move(u), {0}, t, enough, watch);
    scale_plane(t, sum(vertex_area), out.u);
  } else {
    out = solve_from(std::move(u), {-1}, t, enough, watch);
  }
  return out;
}

/// Lowers the sizes wanted at the ends of edges over which the log scale changes too fast for a
/// density linear in the faces; true when more than a few edges are in the way.
bool resolve_log_scale(const IntrinsicTriangulation& t, const std::vector<double>& u,
                       std::vector<double>& size) {
  std::size_t steep = 0;
  for (std::size_t i = 0; i < t.log_length.size(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const std::size_t a = t.connectivity.origin(h).index(), b = t.connectivity.head(h).index();
    const double change = std::abs(u[a] - u[b]);
    if (change <= steepest_edge) {
      continue;
    }
    ++steep;
    const double wanted = std::exp(t.log_length[i]) * std::max(steepest_edge / change, 0.1) * 0.9;
    size[a] = std::min(size[a], wanted);
    size[b] = std::min(size[b], wanted);
  }
  return static_cast<double>(steep) > ignored_share * static_cast<double>(t.log_length.size());
}

}  // namespace

Uniformized uniformize_surface(const ClosedSurface& surface, const UniformizeOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  bool cancelled = false;
  const MetricSolver::Watch watch = [&](int iteration, double error) {
    cancelled = options.monitor && !options.monitor({"uniformize", iteration, error});
    return !cancelled;
  };
  // `flat` is the surface before any Ptolemy flip: the place to refine it.
  std::vector<std::int32_t> input_face = spatial_order(surface.mesh);
  TriangleMesh input{surface.mesh.positions, {}};
  for (const std::int32_t f : input_face) {
    input.faces.push_back(surface.mesh.faces[static_cast<std::size_t>(f)]);
  }
  IntrinsicTriangulation flat = intrinsic_triangulation(input), t;
  make_euclidean_delaunay(flat);
  const bool refining = options.longest_edge > 0;
  const std::size_t n = flat.connectivity.vertex_count();
  std::vector<double> size(n, options.longest_edge), vertex_area = euclidean_vertex_areas(flat);
  // Flat metrics keep the input's, hyperbolic ones start with their own area.
  double start_scale = 0;
  if (surface.genus > 1) {
    start_scale = std::log(4 * std::numbers::pi * (surface.genus - 1) / sum(vertex_area)) / 2;
  }
  Solution solution{std::vector<double>(n, start_scale), {}};
  int iterations = 0;
  for (int round = 0;; ++round) {
    if (refining) {
      refine(flat, size, solution.u);
      vertex_area = euclidean_vertex_areas(flat);
    }
    t = flat;
    bool too_coarse = false;
    const auto enough = [&](const std::vector<double>& u) {
      too_coarse = refining && round < max_refinements && resolve_log_scale(flat, u, size);
      return too_coarse;
    };
    solution = solve(t, surface.genus, vertex_area, std::move(solution.u), enough, watch);
    iterations += solution.result.iterations;
    if (cancelled) {
      throw Cancelled("interrupted during uniformization; no output was written");
    }
    if (!solution.result.converged) {
      throw NumericalError(fmt::format("uniformization stopped at an angle error of {:.1e} radians",
                                       solution.result.max_angle_error));
    }
    if (!too_coarse) {
      break;
    }
  }
  const double kappa = surface.genus == 0 ? 1 : surface.genus == 1 ? 0 : -1;
  UniformSurface uniform({kappa}, t.connectivity, chords(t, solution.u));
  UniformizationReport report = report_of(uniform, t, solution.u);
  report.genus = surface.genus, report.newton_iterations = iterations;
  certify(uniform, sum(vertex_area), report);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {std::move(input),   std::move(t), std::move(solution.u), std::move(vertex_area),
          std::move(uniform), report,       std::move(input_face), {}};
}

std::vector<HomogeneousPoint> points_on_input(const Uniformized& t,
                                              const std::vector<SurfacePoint>& points) {
  // A chord triangle of T and the light-cone vectors of its corners differ by the factors exp(u).
  std::vector<HomogeneousPoint> carried;
  carried.reserve(points.size());
  for (const SurfacePoint& p : points) {
    HomogeneousPoint h{p.face, {}};
    const auto side = halfedges(p.face);
    double top = -HUGE_VAL;
    for (const Halfedge s : side) {
      top = std::max(top, t.log_scale[t.intrinsic.connectivity.origin(s).index()]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      h.weight[i] =
          p.bary[i] * std::exp(t.log_scale[t.intrinsic.connectivity.origin(side[i]).index()] - top);
    }
    carried.push_back(h);
  }
  t.intrinsic.log.undo(carried);
  return carried;
}

std::vector<Position> positions_on_input(const Uniformized& t,
                                         const std::vector<SurfacePoint>& points) {
  std::vector<Position> out;
  out.reserve(points.size());
  for (const HomogeneousPoint& h : points_on_input(t, points)) {
    Position at{};
    const double sum = h.weight[0] + h.weight[1] + h.weight[2];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(t.input.faces[h.face.index()][i]);
      for (std::size_t c = 0; c < 3; ++c) {
        at[c] += h.weight[i] / sum * t.input.positions[v][c];
      }
    }
    out.push_back(at);
  }
  return out;
}

}  // namespace ucvt
