#include "ucvt/remesh.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "cvt/initial_sites.h"
#include "cvt/local_sites.h"
#include "cvt/surface_start.h"
#include "cvt/tessellation.h"
#include "cvt/uniformity.h"
#include "result/cell_complex.h"
#include "result/density.h"
#include "result/dual_mesh.h"
#include "result/even_sizes.h"
#include "result/site_points.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// T's edges on the input surface, in units of the hexagonal spacing of the sites: cells then hold
/// some ten of T's faces, which resolves the density across them.
constexpr double edge_per_spacing = 0.7;

/// Rounds of making room for a simplicial dual mesh. After each the sites settle that it left farther from their
/// centroids than this part of their spacing, and the rings around.
constexpr int max_rounds = 40, settling_rings = 2;
constexpr double disturbed = 0.1;
const OptimizeOptions settling{.evaluations = 20, .tolerance = 1e-2, .springs = false};

/// Part of the sites that may be taken away elsewhere to keep their number; more are added.
constexpr double most_moved = 0.25;

/// Edges of the shortest loop in a simplicial complex; cells shrink by at least `least_shrink` a
/// round where there is no room for it, and grow back by at most `growth` per unit of distance.
constexpr double shortest_loop = 3, least_shrink = 0.8, growth = 0.7;

/// Evaluations from one restart point to the next: there D, cells, frames and the optimiser's memory
/// are made anew from the sites alone, whether anyone asks for a checkpoint or not.
constexpr int leg_evaluations = 100;

/// Log scales that span more make a surface steep. A multilevel start would leave limbs without sites
/// there, the few cells of a coarse level being ruled by their far dense ends: sites start far apart, and
/// sizes are evened so many times, after so many evaluations each and to so much of the spacing.
constexpr double steep_span = 10;
constexpr int evenings = 8, evening_evaluations = 40;
constexpr double evening_tolerance = 3e-3;

/// Distance between neighbours in a hexagonal lattice of so many sites on the mesh.
double hexagonal_spacing(const TriangleMesh& mesh, int sites) {
  return std::sqrt(2 * surface_area(mesh) / (sites * std::numbers::sqrt3));
}

void check_count(const ClosedSurface& surface, int sites) {
  const int least = surface.genus == 0 ? 4 : 1;
  if (sites < least) {
    throw InvalidInput(fmt::format("{} sites are too few for genus {}; ask for at least {}", sites,
                                   surface.genus, least));
  }
}

std::vector<double> initial_size(const RemeshOptions& options, std::size_t vertices) {
  if (options.initial_size.empty()) {
    return std::vector<double>(vertices, 1.0);
  }
  if (options.initial_size.size() != vertices) {
    throw InvalidInput(
        fmt::format("{} cell sizes do not fit the surface, which has {} vertices; "
                    "give sites made for the same mesh and count",
                    options.initial_size.size(), vertices));
  }
  return options.initial_size;
}

/// Of T's edges on the input, by halfedge.
std::vector<double> lengths(const Uniformized& t) {
  std::vector<double> out;
  out.reserve(t.intrinsic.log_length.size());
  for (const double l : t.intrinsic.log_length) {
    out.push_back(std::exp(l));
  }
  return out;
}

class Remesher {
 public:
  Remesher(const ClosedSurface& surface, const RemeshOptions& options)
      : options_(options),
        surface_(uniformize(surface,
                            {edge_per_spacing * hexagonal_spacing(surface.mesh, options.refine_for),
                             options.monitor})),
        t_(surface_.value()),
        factor_(conformal_factor(t_)),
        spacing_3d_(hexagonal_spacing(surface.mesh, options.refine_for)),
        size_(initial_size(options, factor_.size())),
        thinned_(thin_out(t_.surface, lengths(t_), thinned_counts(t_.surface, options.sites))),
        mass_(std::make_unique<SurfaceMass>(t_.surface, sizing_density(factor_, size_))) {}

  RemeshResult run() {
    if (options_.progress) {
      go_on();
    } else {
      place_initial_sites();
    }
    while (leg()) {
    }
    const auto added =
        static_cast<std::int64_t>(sites_->site_count()) - static_cast<std::int64_t>(options_.sites);
    cvt_.method = options_.method == Method::Lloyd ? "lloyd" : "lbfgs";
    cvt_.sites = static_cast<std::int64_t>(sites_->site_count());
    return collect(added);
  }

 private:
  [[nodiscard]] bool is_steep() const {
    const UniformizationReport& u = surface_.report();
    return u.log_scale_max - u.log_scale_min > steep_span;
  }

  void place_initial_sites() {
    const auto n = static_cast<std::size_t>(options_.sites);
    if (!options_.initial_sites.empty()) {
      place(as_points(options_.initial_sites, t_.surface.connectivity().face_count()));
      return;
    }
    const bool multilevel = options_.init == InitialSites::Multilevel;
    at_.evenings_left = is_steep() ? evenings : 0;
    if (multilevel && !is_steep()) {
      const std::vector<SurfacePoint> points = level_by_level();
      if (!points.empty()) {
        place(points);
        if (!options_.ensure_simplicial || !make_room()) {
          offer_checkpoint(points);
        }
        return;
      }
    }
    if (options_.init == InitialSites::Farthest ||
        (multilevel && is_steep() && n <= t_.surface.connectivity().vertex_count())) {
      place(far_apart_sites());
    } else {
      sites_ =
          random_tessellation(*mass_, t_.vertex_area_3d, options_.sites, options_.seed, base());
    }
  }

  /// What D is built from; null: from T.
  [[nodiscard]] const ThinnedSurface* base() const {
    const ThinnedSurface* out = nullptr;
    for (const ThinnedSurface& t : thinned_) {
      if (!out || t.delaunay().vertex_count() >= 2 * static_cast<std::size_t>(options_.sites)) {
        out = &t;
      }
    }
    return out;
  }

  [[nodiscard]] std::vector<SurfacePoint> level_by_level() const {
    return multilevel_start({*mass_, t_.vertex_area_3d, thinned_}, options_.sites, options_.seed,
                            options_.method, options_.monitor);
  }

  void place(const std::vector<SurfacePoint>& sites) {
    sites_ = std::make_unique<Tessellation>(*mass_, sites, base());
    if (!covers_surface(*sites_)) {
      throw NumericalError("the initial sites lie in one hemisphere");
    }
  }

  [[nodiscard]] std::vector<SurfacePoint> far_apart_sites() const {
    const auto n = static_cast<std::size_t>(options_.sites);
    if (n > t_.surface.connectivity().vertex_count()) {
      throw InvalidInput(
          fmt::format("farthest-point sites are vertices of the refined surface, "
                      "which has {}; start from random sites",
                      t_.surface.connectivity().vertex_count()));
    }
    return farthest_sites(t_.surface, lengths(t_), n, options_.seed);
  }

  /// Sizes that make up for uneven cells. Where doubles do not suffice to build D anew they stay.
  void even_out() {
    const std::vector<SurfacePoint> points = sites_->sites();
    std::vector<double> size = size_;
    even_sizes(*sites_, SurfaceMass(t_.surface, factor_), size);
    auto mass = std::make_unique<SurfaceMass>(t_.surface, sizing_density(factor_, size));
    if (auto anew = built_anew(*mass, points)) {
      sites_ = std::move(anew), mass_ = std::move(mass), size_ = std::move(size);
      offer_checkpoint(points);
    }
  }

  /// The state that a checkpoint holds.
  void go_on() {
    at_ = *options_.progress;
    const auto n = options_.initial_sites.size();
    const auto most = static_cast<std::int64_t>(most_moved * options_.sites);
    if ((at_.evenings_left > 0 && n > static_cast<std::size_t>(options_.sites)) || at_.moved < 0 ||
        at_.moved > most || at_.evenings_left < 0 || at_.round < 0 || at_.evaluations < 0) {
      throw InvalidInput("the progress of the run does not fit its sites; give an unchanged file");
    }
    cvt_.iterations = at_.iterations;
    cvt_.energy = std::move(at_.energy), cvt_.max_move = std::move(at_.max_move);
    place(as_points(options_.initial_sites, t_.surface.connectivity().face_count()));
    if (at_.round > 0 && at_.evaluations == 0) {
      make_room();
    }
  }

  /// Limits of the current optimisation.
  [[nodiscard]] OptimizeOptions limits() const {
    OptimizeOptions out = until_converged(options_);
    if (is_steep()) {
      out.springs = false;
      out.least_decrease = 0;  // the sum of the energies is ruled by a few cells
    }
    if (at_.evenings_left > 0) {
      out.evaluations = evening_evaluations;
      out.tolerance = evening_tolerance;
    }
    return out;
  }

  /// From one restart point to the next; false when the run is at its end.
  bool leg() {
    OptimizeOptions now = limits();
    const bool ends = now.evaluations - at_.evaluations <= leg_evaluations;
    now.evaluations = std::min(now.evaluations - at_.evaluations, leg_evaluations);
    if (!optimize(now) && !ends) {
      restart();
      return true;
    }
    at_.evaluations = 0;
    return next_optimisation();
  }

  /// Sets out for what follows on an optimisation; false when nothing does.
  bool next_optimisation() {
    if (at_.evenings_left > 0) {
      --at_.evenings_left;
      even_out();
      return true;
    }
    return options_.ensure_simplicial && make_room();
  }

  /// Null where doubles do not suffice.
  [[nodiscard]] std::unique_ptr<Tessellation> built_anew(
      const SurfaceMass& mass, const std::vector<SurfacePoint>& points) const {
    try {
      auto anew = std::make_unique<Tessellation>(mass, points, base());
      return covers_surface(*anew) ? std::move(anew) : nullptr;
    } catch (const InvalidInput&) {
      return nullptr;
    } catch (const NumericalError&) {
      return nullptr;
    }
  }

  /// Makes D, cells and frames anew from the sites alone. Where doubles do not suffice for that the
  /// run goes on as it is.
  void restart() {
    const std::vector<SurfacePoint> points = sites_->sites();
    if (auto anew = built_anew(*mass_, points)) {
      sites_ = std::move(anew);
      offer_checkpoint(points);
    }
  }

  void offer_checkpoint(const std::vector<SurfacePoint>& points) {
    if (!options_.checkpoint) {
      return;
    }
    SavedSites saved{as_sites(points), options_.refine_for, size_, at_};
    saved.progress->sites = options_.sites;
    saved.progress->iterations = cvt_.iterations;
    saved.progress->energy = cvt_.energy, saved.progress->max_move = cvt_.max_move;
    options_.checkpoint(saved);
  }

  /// True when it converged. The steps of a multilevel start are not counted.
  bool optimize(const OptimizeOptions& limits) {
    const auto start = std::chrono::steady_clock::now();
    const int before = at_.evaluations;
    const Monitor monitor = [&](const Progress& p) {
      return !options_.monitor || options_.monitor({p.stage, before + p.iteration, p.residual});
    };
    const OptimizeResult result = ucvt::optimize(*sites_, limits, monitor);
    if (result.cancelled) {
      throw Cancelled("interrupted; no output was written");
    }
    at_.evaluations += result.evaluations;
    if (at_.evenings_left == 0) {
      record(result, before > 0);
      cvt_.seconds +=
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    return result.converged;
  }

  /// `continued`: it starts where the one before ended, which is recorded.
  void record(const OptimizeResult& result, bool continued) {
    const std::ptrdiff_t first = continued ? 1 : 0;
    cvt_.iterations += result.evaluations;
    cvt_.energy.insert(cvt_.energy.end(), result.energy.begin() + first, result.energy.end());
    cvt_.max_move.insert(cvt_.max_move.end(), result.max_move.begin() + first,
                         result.max_move.end());
    cvt_.converged = result.converged;
  }

  /// The sites whose cells hold least, no neighbours among them and none at an edge that is in the way:
  /// at most as many as there are such edges, and as may still be moved.
  std::vector<Vertex> spare_sites(const std::vector<NonSimplicialEdge>& in_the_way) {
    const DelaunayTriangulation& d = sites_->delaunay();
    const std::size_t n = sites_->site_count();
    const auto allowed =
        static_cast<std::size_t>(most_moved * options_.sites) - static_cast<std::size_t>(at_.moved);
    std::vector<CellState> cells(n);
    sites_->measure(cells);
    std::vector<std::pair<double, Vertex>> by_energy;
    for (std::size_t i = 0; i < n; ++i) {
      const double r = cells[i].spacing;
      by_energy.emplace_back(cells[i].moments.m * r * r, Vertex{static_cast<std::int32_t>(i)});
    }
    std::sort(by_energy.begin(), by_energy.end());
    std::vector<bool> taken(n);
    for (const NonSimplicialEdge& e : in_the_way) {
      taken[d.connectivity().origin(e.halfedge).index()] = true;
      taken[d.connectivity().head(e.halfedge).index()] = true;
    }
    std::vector<Vertex> out;
    for (const auto& [energy, site] : by_energy) {
      if (out.size() >= std::min(in_the_way.size(), allowed)) {
        break;
      }
      if (!taken[site.index()]) {
        out.push_back(site);
        taken[site.index()] = true;
        d.connectivity().for_outgoing(
            site, [&](Halfedge h) { taken[d.connectivity().head(h).index()] = true; });
      }
    }
    at_.moved += static_cast<std::int64_t>(out.size());
    return out;
  }

  /// Rounds of it, until nothing is in the way. False when nothing was.
  bool make_room() {
    bool any = false;
    while (at_.round < max_rounds && shrink_cells()) {
      any = true;
      ++at_.round;
      settle_disturbed();
      restart();
    }
    return any;
  }

  void settle_disturbed() {
    std::vector<CellState> cells;
    sites_->measure(cells);
    std::vector<Vertex> centres;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double h = centroid_or_site(sites_->space(), cells[i].moments).h;
      if (std::sqrt(2 * h) > disturbed * cells[i].spacing) {
        centres.push_back({static_cast<std::int32_t>(i)});
      }
    }
    const Connectivity& d = sites_->delaunay().connectivity();
    LocalSites local(*sites_, neighbourhood(d, std::move(centres), settling_rings));
    if (ucvt::optimize(local, settling, options_.monitor).cancelled) {
      throw Cancelled("interrupted; no output was written");
    }
  }

  /// Asks for cells so small, near every edge that keeps the dual mesh from being simplicial, that a
  /// loop of three edges fits round the handle there, and makes the edge's middle a site, in place of
  /// one that is not needed where it is. False when there is no such edge.
  bool shrink_cells() {
    const DelaunayTriangulation& d = sites_->delaunay();
    const auto in_the_way = edges_not_simplicial(d);
    if (in_the_way.empty()) {
      return false;
    }
    std::vector<SurfacePoint> sites = sites_->sites();
    std::vector<double> size = size_;
    for (const NonSimplicialEdge& e : in_the_way) {
      const Vertex a = d.connectivity().origin(e.halfedge);
      const double room = e.loop_length / (shortest_loop * d.spacing(a));
      const SurfacePoint middle = point_of(sites_->middle(e.halfedge).place);
      for (const Face f : {middle.face, sites_->place(a).face}) {
        for (const Halfedge h : halfedges(f)) {
          const std::size_t v = t_.surface.connectivity().origin(h).index();
          size[v] = std::min(size[v], size_[v] * std::min(room, least_shrink));
        }
      }
      sites.push_back(middle);
    }
    std::vector<Vertex> spare = spare_sites(in_the_way);
    std::sort(spare.begin(), spare.end(), [](Vertex a, Vertex b) { return b.index() < a.index(); });
    for (const Vertex v : spare) {
      sites.erase(sites.begin() + v.id);
    }
    limit_growth(t_, growth / spacing_3d_, size);
    size_ = std::move(size);
    sites_.reset();
    mass_ = std::make_unique<SurfaceMass>(t_.surface, sizing_density(factor_, size_));
    sites_ = std::make_unique<Tessellation>(*mass_, sites, base());
    return true;
  }

  [[nodiscard]] RemeshResult collect(std::int64_t added) const {
    const DelaunayTriangulation& d = sites_->delaunay();
    const std::vector<SurfacePoint> points = sites_->sites();
    RemeshResult out{dual_mesh(t_, d, points),
                     surface_,
                     {},
                     options_.refine_for,
                     mass_->density(),
                     size_,
                     cvt_,
                     hexagonal_energy(t_.surface, mass_->density(), points.size()),
                     {},
                     {},
                     {}};
    out.sites = as_sites(points);
    out.uniformity = measure_uniformity(d);
    const SurfaceMass area_on_input(t_.surface, factor_);
    std::vector<double> areas;
    for (const Moments& m : sites_->cell_moments(area_on_input)) {
      areas.push_back(m.m);
    }
    out.cell_area_3d = spread_of(areas);
    RemeshReport& r = out.report;
    r.vertices = static_cast<std::int64_t>(out.mesh.positions.size());
    r.faces = static_cast<std::int64_t>(out.mesh.faces.size());
    r.genus = static_cast<int>(1 - d.connectivity().euler_number() / 2);
    r.simplicial = edges_not_simplicial(d).empty();
    r.sites_added = added;
    r.quality = measure_quality(out.mesh);
    out.cells = cell_complex(*sites_);
    return out;
  }

  const RemeshOptions& options_;
  UniformizedSurface surface_;
  const Uniformized& t_;
  std::vector<double> factor_;
  double spacing_3d_;         ///< hexagonal spacing of the sites on the input
  std::vector<double> size_;  ///< wanted at T's vertices, relative to that spacing
  std::vector<ThinnedSurface> thinned_;
  std::unique_ptr<SurfaceMass> mass_;
  std::unique_ptr<Tessellation> sites_;
  RunProgress at_;  ///< but for what the CVT report holds
  CvtReport cvt_;
};

}  // namespace

void start_from(RemeshOptions& options, SavedSites saved) {
  options.sites = saved.progress ? saved.progress->sites : static_cast<int>(saved.sites.size());
  options.initial_sites = std::move(saved.sites);
  options.refine_for = saved.refine_for;
  options.initial_size = std::move(saved.size);
  options.progress = std::move(saved.progress);
}

RemeshResult remesh(const ClosedSurface& surface, const RemeshOptions& options) {
  RemeshOptions used = options;
  if (used.progress) {
    used.sites = used.progress->sites;
  } else if (!used.initial_sites.empty()) {
    used.sites = static_cast<int>(used.initial_sites.size());
  }
  check_count(surface, used.sites);
  if (used.progress) {
    check_count(surface, static_cast<int>(used.initial_sites.size()));
  }
  if (used.refine_for <= 0) {
    used.refine_for = used.sites;
  }
  std::optional<tbb::global_control> limit;
  if (used.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(used.threads));
  }
  return Remesher(surface, used).run();
}

}  // namespace ucvt
