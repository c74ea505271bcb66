// Remeshing of surfaces with boundary, on their doubles (docs/boundaries.md).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "cvt/mirror_sites.h"
#include "cvt/uniformity.h"
#include "mesh/doubled_surface.h"
#include "mesh/edge_bisection.h"
#include "result/boundary_curves.h"
#include "result/cell_complex.h"
#include "result/density.h"
#include "result/half_mesh.h"
#include "result/uniformize_double.h"
#include "ucvt/error.h"
#include "ucvt/remesh.h"

namespace ucvt {
namespace {

/// The mesh's edges in units of the spacing of the sites, as for closed surfaces.
constexpr double edge_per_spacing = 0.7;

/// Most that the log scale may change along an edge of the mesh, and rounds of making it finer.
constexpr double steepest_edge = 0.5;
constexpr int max_refinements = 2;

/// Times that boundary sites are spread wider when they are too many.
constexpr int max_tries = 20;

/// Rounds of mending the boundary and the mesh, and the iterations of a round.
constexpr int max_rounds = 40, round_iterations = 30;

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

/// Distance between neighbours in a hexagonal lattice of n sites, those on the boundary among them:
/// their cells are halves, so that n - L/(2h) cells of area sqrt(3)/2 h^2 fill the surface.
double hexagonal_spacing(const TriangleMesh& mesh, int n) {
  const double half = boundary_length(mesh) / 2, area = surface_area(mesh);
  return (half + std::sqrt(half * half + 8 * n * area / std::numbers::sqrt3)) / (2 * n);
}

/// A surface point at a vertex of T.
SurfacePoint at_vertex(const UniformSurface& t, std::int32_t v) {
  const Halfedge h = t.connectivity().outgoing({v});
  SurfacePoint p{h.face(), {0, 0, 0}};
  p.bary[static_cast<std::size_t>(h.id % 3)] = 1;
  return p;
}

/// The double of a surface made fine enough for n sites, and its T.
struct Double {
  TriangleMesh half;
  BoundaryCurves curves;
  DoubledSurface doubled;
  UniformizedSurface surface;
  std::vector<std::int32_t> input_face;  ///< of the half's faces
};

/// Lowers the sizes at the ends of edges over which the log scale changes too fast for a density that
/// is linear in the faces; false when there are none.
bool resolve_log_scale(const Double& made, std::vector<double>& size) {
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

Double make_double(const OpenSurface& open, double spacing, const Monitor& monitor) {
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
    Double out{half, boundary_curves(half, spacing), std::move(both), std::move(surface),
               input_face};
    if (round == max_refinements || !resolve_log_scale(out, size)) {
      return out;
    }
  }
}

class OpenRemesher {
 public:
  OpenRemesher(const OpenSurface& open, const RemeshOptions& options)
      : open_(open),
        options_(options),
        spacing_(hexagonal_spacing(open.mesh, options.sites)),
        double_(make_double(open, spacing_, options.monitor)),
        t_(double_.surface.value()),
        factor_(conformal_factor(t_)),
        size_(factor_.size(), 1.0),
        mass_(t_.surface, sizing_density(factor_, size_)) {}

  RemeshResult run() {
    place_sites();
    optimize(options_.iterations);
    for (int round = 0; round < max_rounds && mend(); ++round) {
      optimize(std::min(round_iterations, options_.iterations));
      if (!needs_mending()) {
        optimize(options_.iterations);
      }
    }
    cvt_.method = options_.method == Method::Lloyd ? "lloyd" : "lbfgs";
    return collect();
  }

 private:
  /// Sites on the boundary: fewer than asked for in all, if its loops and corners allow that.
  [[nodiscard]] std::vector<std::vector<BoundarySite>> sparse_boundary(std::size_t asked) const {
    double spacing = spacing_;
    for (int tries = 0;; ++tries, spacing *= 1.25) {
      auto out = boundary_sites(double_.half, double_.curves, spacing);
      std::size_t count = 0;
      for (const auto& loop : out) {
        count += loop.size();
      }
      if (count < asked || tries == max_tries) {
        return out;
      }
    }
  }

  void place_sites() {
    const auto asked = static_cast<std::size_t>(options_.sites);
    const auto boundary = sparse_boundary(asked);
    MirrorLayout layout;
    for (const auto& loop : boundary) {
      loops_.emplace_back();
      for (const BoundarySite& site : loop) {
        loops_.back().push_back(line_.size());
        line_.push_back(site);
        layout.on_line.push_back(at_vertex(t_.surface, site.vertex));
        layout.fixed.push_back(site.fixed);
      }
    }
    if (asked <= line_.size()) {
      const auto corners = std::count(layout.fixed.begin(), layout.fixed.end(), true);
      throw InvalidInput(fmt::format(
          "{} sites are too few for a boundary of {} loop{} with {} corner{}; ask for at least {}",
          asked, open_.boundary_loops, open_.boundary_loops == 1 ? "" : "s", corners,
          corners == 1 ? "" : "s", line_.size() + 1));
    }
    const auto inner = inner_sites(double_.half, double_.curves, boundary, asked - line_.size());
    for (const std::int32_t v : inner) {
      const std::int32_t image = double_.doubled.mirror[static_cast<std::size_t>(v)];
      layout.pairs.push_back({at_vertex(t_.surface, v), at_vertex(t_.surface, image)});
    }
    sites_ = std::make_unique<MirrorSites>(mass_, layout);
  }

  void optimize(int evaluations) {
    const auto start = std::chrono::steady_clock::now();
    OptimizeOptions options = until_converged(options_);
    options.evaluations = evaluations;
    const OptimizeResult result = ucvt::optimize(*sites_, options, options_.monitor);
    cvt_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    cvt_.iterations += result.evaluations;
    cvt_.energy.insert(cvt_.energy.end(), result.energy.begin(), result.energy.end());
    cvt_.max_move.insert(cvt_.max_move.end(), result.max_move.begin(), result.max_move.end());
    cvt_.converged = result.converged;
    if (result.cancelled) {
      throw Cancelled("interrupted; no output was written");
    }
  }

  [[nodiscard]] HalfView view() const {
    return HalfView(*sites_, loops_, sides_in_half(t_, *sites_, double_.half.faces.size()));
  }

  [[nodiscard]] bool needs_mending() const {
    const HalfView half = view();
    return !half.gaps().empty() ||
           (options_.ensure_simplicial && !half.edges_not_simplicial().empty());
  }

  /// Closes gaps in the boundary: a site whose edge to its mirror image crosses the boundary becomes a
  /// boundary site. Without gaps, adds sites at edges that keep the mesh from being simplicial. False
  /// when there is nothing to mend.
  bool mend() {
    const HalfView half = view();
    MirrorLayout layout = sites_->layout();
    const std::vector<HalfView::Gap> gaps = half.gaps();
    if (!gaps.empty()) {
      close_gaps(gaps, layout);
    } else if (options_.ensure_simplicial) {
      const std::vector<Halfedge> edges = half.edges_not_simplicial();
      if (edges.empty()) {
        return false;
      }
      for (const Halfedge h : edges) {
        layout.pairs.push_back(half.middle(h));
        ++added_;
      }
    } else {
      return false;
    }
    sites_ = std::make_unique<MirrorSites>(mass_, layout);
    return true;
  }

  void close_gaps(const std::vector<HalfView::Gap>& gaps, MirrorLayout& layout) {
    std::vector<bool> gone(layout.pairs.size(), false);
    std::vector<std::vector<std::size_t>> loops(loops_.size());
    const auto after = [&](std::size_t p) {
      for (const HalfView::Gap& gap : gaps) {
        if (gap.from == p && gap.pair && !gone[*gap.pair]) {
          gone[*gap.pair] = true;
          return &gap;
        }
      }
      return static_cast<const HalfView::Gap*>(nullptr);
    };
    for (std::size_t k = 0; k < loops_.size(); ++k) {
      for (const std::size_t p : loops_[k]) {
        loops[k].push_back(p);
        if (const HalfView::Gap* gap = after(p)) {
          loops[k].push_back(line_.size());
          line_.push_back({-1, line_[p].arc, false});
          layout.on_line.push_back(gap->foot);
          layout.fixed.push_back(false);
        }
      }
    }
    loops_ = std::move(loops);
    std::vector<std::array<SurfacePoint, 2>> kept;
    for (std::size_t i = 0; i < gone.size(); ++i) {
      if (!gone[i]) {
        kept.push_back(layout.pairs[i]);
      }
    }
    layout.pairs = std::move(kept);
  }

  /// Where the sites of the half lie on the input: those of the boundary on the boundary's own edges.
  [[nodiscard]] std::vector<Position> positions(const std::vector<Vertex>& sites) const {
    const std::vector<SurfacePoint> all = sites_->tessellation().sites();
    std::vector<SurfacePoint> points;
    for (const Vertex v : sites) {
      points.push_back(all[v.index()]);
    }
    std::vector<Position> out = positions_on_input(t_, points);
    for (std::size_t i = 0; i < sites.size(); ++i) {
      if (!sites_->on_line(sites[i])) {
        continue;
      }
      const BoundarySite& site = line_[sites[i].index()];
      out[i] = site.fixed ? double_.half.positions[static_cast<std::size_t>(site.vertex)]
                          : nearest_on_arc(double_.half, double_.curves.arcs[site.arc], out[i]);
    }
    return out;
  }

  [[nodiscard]] Spread cell_areas(const std::vector<Vertex>& sites) const {
    const SurfaceMass area_on_input(t_.surface, factor_);
    const std::vector<Moments> cells = sites_->tessellation().cell_moments(area_on_input);
    std::vector<double> areas;
    for (const Vertex v : sites) {
      areas.push_back(cells[v.index()].m);
    }
    return spread_of(areas);
  }

  [[nodiscard]] RemeshResult collect() {
    const HalfView half = view();
    if (!half.gaps().empty()) {
      throw InvalidInput(
          fmt::format("{} sites are too few: triangles would cross the boundary; ask for more",
                      options_.sites));
    }
    const HalfMesh mesh = half.mesh();
    RemeshResult out{{positions(mesh.sites), mesh.faces},
                     double_.surface,
                     {},
                     options_.sites,
                     mass_.density(),
                     size_,
                     {},
                     hexagonal_energy(double_.surface.value().surface, mass_.density(),
                                      sites_->tessellation().sites().size()),
                     {},
                     {},
                     {}};
    cvt_.sites = static_cast<std::int64_t>(mesh.sites.size());
    out.cvt = cvt_;
    for (const SurfacePoint& p : sites_->tessellation().sites()) {
      out.sites.push_back({p.face.id, p.bary});
    }
    out.uniformity = measure_uniformity(sites_->tessellation().delaunay());
    out.cell_area_3d = cell_areas(mesh.sites);
    RemeshReport& r = out.report;
    r.vertices = static_cast<std::int64_t>(out.mesh.positions.size());
    r.faces = static_cast<std::int64_t>(out.mesh.faces.size());
    r.genus = open_.genus;
    r.boundary_loops = open_.boundary_loops;
    r.simplicial = half.edges_not_simplicial().empty();
    r.sites_added = added_;
    r.quality = measure_quality(out.mesh);
    out.cells = cell_complex(sites_->tessellation());
    out.half = std::make_shared<const HalfOfDouble>(HalfOfDouble{
        mesh.sites, sites_->line_count(), double_.input_face, open_.mesh.positions.size()});
    return out;
  }

  const OpenSurface& open_;
  const RemeshOptions& options_;
  double spacing_;  ///< hexagonal, on the input
  Double double_;
  const Uniformized& t_;
  std::vector<double> factor_, size_;
  SurfaceMass mass_;
  std::unique_ptr<MirrorSites> sites_;
  std::vector<BoundarySite> line_;               ///< by number of the sites on the line
  std::vector<std::vector<std::size_t>> loops_;  ///< their numbers, in order along each loop
  std::int64_t added_ = 0;
  CvtReport cvt_;
};

void check_options(const OpenSurface& surface, const RemeshOptions& options) {
  if (options.sites < 1) {
    throw InvalidInput(fmt::format("{} sites are too few; ask for more", options.sites));
  }
  if (!options.initial_sites.empty() || options.init == InitialSites::Random) {
    throw InvalidInput(fmt::format(
        "the surface is open ({} boundary loop{}), where sites start at places of their own; "
        "leave the initial sites out",
        surface.boundary_loops, surface.boundary_loops == 1 ? "" : "s"));
  }
}

}  // namespace

RemeshResult remesh(const OpenSurface& surface, const RemeshOptions& options) {
  check_options(surface, options);
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(options.threads));
  }
  return OpenRemesher(surface, options).run();
}

}  // namespace ucvt
