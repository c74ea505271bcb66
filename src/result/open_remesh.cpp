// Remeshing of surfaces with boundary, on their doubles (docs/boundaries.md).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "cvt/mirror_sites.h"
#include "cvt/uniformity.h"
#include "result/cell_complex.h"
#include "result/density.h"
#include "result/half_mesh.h"
#include "result/open_start.h"
#include "ucvt/error.h"
#include "ucvt/remesh.h"

namespace ucvt {
namespace {

/// Rounds of mending the boundary and the mesh, and the iterations of a round.
constexpr int max_rounds = 40, round_iterations = 30;

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
    made_of_ = open_start(double_, mass_, spacing_, options_);
    sites_ = std::make_unique<MirrorSites>(mass_, made_of_.layout);
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
    return HalfView(*sites_, made_of_.loops, sides_in_half(t_, *sites_, double_.half.faces.size()));
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
    made_of_.layout = sites_->layout();
    const std::vector<HalfView::Gap> gaps = half.gaps();
    if (!gaps.empty()) {
      close_gaps(gaps, made_of_);
    } else if (options_.ensure_simplicial) {
      const std::vector<Halfedge> edges = half.edges_not_simplicial();
      if (edges.empty()) {
        return false;
      }
      for (const Halfedge h : edges) {
        made_of_.layout.pairs.push_back(half.middle(h));
        ++added_;
      }
    } else {
      return false;
    }
    sites_ = std::make_unique<MirrorSites>(mass_, made_of_.layout);
    return true;
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
      const BoundarySite& site = made_of_.line[sites[i].index()];
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
  OpenDouble double_;
  const Uniformized& t_;
  std::vector<double> factor_, size_;
  SurfaceMass mass_;
  OpenSites made_of_;  ///< what `sites_` was last made of
  std::unique_ptr<MirrorSites> sites_;
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
