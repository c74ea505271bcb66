#include "ucvt/spaces.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "cvt/domain.h"
#include "cvt/formula.h"
#include "cvt/space_sites.h"
#include "cvt/uniformity.h"
#include "space/polygon_moments.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Draws of random initial sites before giving up: few of them on a sphere may lie in one hemisphere.
constexpr int max_draws = 200;
constexpr std::size_t most_redrawn = 50;

/// Of a formula, at most: smooth ones take some hundreds, and one that jumps has no end.
constexpr std::int64_t evaluations_per_cell = 100'000;

/// Spacing of a hexagonal lattice over the circumradius of its cells.
constexpr double spacing_per_radius = 1.7320508075688772;

/// Integrals of the density over a cell.
class CellMeasure {
 public:
  CellMeasure(const Domain& domain, const SpaceOptions& options) : domain_(domain) {
    cubature_.relative_tolerance = options.quadrature;
    cubature_.max_evaluations = evaluations_per_cell;
    if (!options.density.empty()) {
      formula_.emplace(options.density, domain.kappa);
      if (formula_->is_constant()) {
        constant_ = (*formula_)({0, 0, 1});
        formula_.reset();
      }
    }
  }

  [[nodiscard]] Moments operator()(const Frame& frame, const SiteCell& cell, double& error) const {
    const Space s{domain_.kappa};
    if (!formula_) {
      Moments out = uniform_moments(s, cell.corner);
      out.m *= constant_, out.x *= constant_, out.y *= constant_, out.h *= constant_;
      return out;
    }
    const auto density = [&](const Offset& x) {
      return (*formula_)(into_polygon(domain_, model_point(frame, x)));
    };
    const Cubature out = density_moments(s, cell.corner, density, cubature_);
    error = std::max(error, out.error);
    return out.moments;
  }

 private:
  const Domain& domain_;
  std::optional<DensityFormula> formula_;
  double constant_ = 1;
  CubatureOptions cubature_;
};

/// What one iteration asks of a cell.
struct Step {
  Offset target;
  double energy = 0, mass = 0, move = 0, error = 0;
};

double reach(Space s, const SiteCell& cell) {
  double h = 0;
  for (const Offset& c : cell.corner) {
    h = std::max(h, c.h);
  }
  return length_of_chord(s, std::sqrt(2 * h));
}

class SpaceCvt {
 public:
  SpaceCvt(const Domain& domain, const SpaceOptions& options)
      : domain_(domain), options_(options), space_{domain.kappa}, measure_(domain, options) {
    place_sites();
  }

  SpaceResult run() {
    SpaceResult out;
    out.domain = domain_;
    out.initial_uniformity = uniformity();
    if (options_.keep_cells) {
      out.initial_sites = sites_->points();
      out.initial_cells = cells();
    }
    iterate(out);
    out.sites = sites_->points();
    out.uniformity = uniformity();
    if (options_.keep_cells) {
      out.cells = cells();
      out.triangles = sites_->triangles();
    }
    return out;
  }

 private:
  void place_sites() {
    const auto n = options_.initial_sites.empty()
                       ? static_cast<std::size_t>(std::max(options_.sites, 0))
                       : options_.initial_sites.size();
    const int given = options_.initial_sites.empty() ? options_.sites : static_cast<int>(n);
    const std::size_t least = domain_.kind == DomainKind::Sphere ? 2 : 1;
    if (n < least) {
      throw InvalidInput(fmt::format(
          "{} sites are too few: {}; ask for at least {}", given,
          n == 1 ? "the whole sphere has no centroid" : "there is nothing to place", least));
    }
    for (std::size_t i = 0; i < options_.initial_sites.size(); ++i) {
      if (!contains(domain_, options_.initial_sites[i])) {
        const ModelPoint& p = options_.initial_sites[i];
        throw InvalidInput(
            fmt::format("initial site {} at ({:g}, {:g}, {:g}) does not lie in the domain; give "
                        "points of the model inside it",
                        i, p[0], p[1], p[2]));
      }
    }
    if (!options_.initial_sites.empty()) {
      sites_ = make_sites(domain_, options_.initial_sites);
      return;
    }
    std::uint64_t seed = options_.seed;
    // Only few random sites on a sphere lie in one hemisphere, and only then other ones do better.
    const bool redraw = domain_.kind == DomainKind::Sphere && n <= most_redrawn;
    for (int tries = redraw ? max_draws : 1;; --tries) {
      try {
        std::vector<ModelPoint> points = random_points(domain_, n, seed);
        sort_along_curve(points);
        sites_ = make_sites(domain_, points);
        return;
      } catch (const NumericalError&) {
        if (tries <= 1) {
          throw;
        }
        seed = seed * 6364136223846793005u + 1442695040888963407u;
      }
    }
  }

  /// Calls work(i, cell) for every site, in parallel.
  template <class Work>
  void for_cells(Work work) const {
    tbb::enumerable_thread_specific<SiteCell> scratch;
    tbb::parallel_for(std::size_t{0}, sites_->count(), [&](std::size_t i) {
      SiteCell& cell = scratch.local();
      sites_->cell(i, cell);
      work(i, cell);
    });
  }

  [[nodiscard]] Step step(std::size_t i, const SiteCell& cell) const {
    Step out;
    const Moments m = measure_(sites_->frame(i), cell, out.error);
    out.mass = m.m, out.energy = 2 * m.h;
    // A cell without mass, or one whose mass pulls evenly, has nowhere to go.
    const double pull = std::hypot(m.x, m.y), along = m.m - space_.kappa * m.h;
    if (m.m > 0 && (pull > 0 || along > 0)) {
      out.target = centroid_anywhere(space_, m);
      out.move = length_of_chord(space_, std::sqrt(2 * out.target.h)) /
                 (spacing_per_radius * reach(space_, cell));
    }
    return out;
  }

  void iterate(SpaceResult& out) {
    const auto start = std::chrono::steady_clock::now();
    CvtReport& cvt = out.cvt;
    cvt.method = "lloyd";
    cvt.sites = static_cast<std::int64_t>(sites_->count());
    std::vector<Step> steps(sites_->count());
    std::vector<Offset> target(steps.size());
    while (true) {
      for_cells([&](std::size_t i, const SiteCell& cell) { steps[i] = step(i, cell); });
      double energy = 0, mass = 0, max_move = 0, error = 0;
      for (std::size_t i = 0; i < steps.size(); ++i) {
        energy += steps[i].energy, mass += steps[i].mass;
        max_move = std::max(max_move, steps[i].move);
        error = std::max(error, steps[i].error);
        target[i] = steps[i].target;
      }
      cvt.energy.push_back(energy);
      // 1 - cos d and cosh d - 1 are half of chord^2; in the plane the paper has d^2 itself.
      const double kappa = space_.kappa;
      out.paper_energy.push_back(energy / (1 + kappa * kappa) - kappa * mass);
      out.quadrature_error = error;
      cvt.converged = max_move <= options_.tolerance;
      if (cvt.converged || cvt.iterations >= options_.iterations) {
        break;
      }
      cvt.max_move.push_back(max_move);
      sites_->move(target);
      ++cvt.iterations;
      if (options_.monitor && !options_.monitor({"optimize", cvt.iterations, max_move})) {
        throw Cancelled("interrupted; no output was written");
      }
    }
    cvt.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  [[nodiscard]] UniformityReport uniformity() const {
    const std::size_t n = sites_->count();
    std::vector<double> radius(n), nearest(n), area(n);
    std::vector<int> degree(n);
    for_cells([&](std::size_t i, const SiteCell& cell) {
      radius[i] = reach(space_, cell), nearest[i] = cell.nearest;
      area[i] = uniform_moments(space_, cell.corner).m;
      degree[i] = cell.degree;
    });
    UniformityReport out{spread_of(radius), spread_of(nearest), spread_of(area), {}, 0};
    for (const int d : degree) {
      ++out.degree[d];
    }
    const auto six = out.degree.find(6);
    out.hexagons =
        six == out.degree.end() ? 0 : static_cast<double>(six->second) / static_cast<double>(n);
    return out;
  }

  [[nodiscard]] std::vector<SpaceCell> cells() const {
    std::vector<SpaceCell> out(sites_->count());
    for_cells([&](std::size_t i, const SiteCell& cell) {
      const Frame& frame = sites_->frame(i);
      SpaceCell& c = out[i];
      for (const Offset& corner : cell.corner) {
        c.corners.push_back(model_point(frame, corner));
      }
      const Step s = step(i, cell);
      c.centroid = model_point(frame, s.target);
      c.degree = cell.degree;
      c.area = uniform_moments(space_, cell.corner).m;
      c.mass = s.mass, c.energy = s.energy;
      c.radius = reach(space_, cell), c.nearest = cell.nearest;
    });
    return out;
  }

  const Domain& domain_;
  const SpaceOptions& options_;
  Space space_;
  CellMeasure measure_;
  std::unique_ptr<SpaceSites> sites_;
};

}  // namespace

SpaceResult tessellate(const Domain& domain, const SpaceOptions& options) {
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(options.threads));
  }
  return SpaceCvt(domain, options).run();
}

}  // namespace ucvt
