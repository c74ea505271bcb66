#include "cvt/space_start.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cvt/domain.h"
#include "cvt/multilevel.h"
#include "cvt/space_system.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Draws of random initial sites before giving up: few of them on a sphere may lie in one hemisphere.
constexpr int max_draws = 200;
constexpr std::size_t most_redrawn = 50;

/// Evaluations and tolerance of each level of a multilevel start.
constexpr int level_evaluations = 80;
constexpr double level_tolerance = 1e-3;

/// Random starts of the first level, and what their seeds differ by.
constexpr int coarse_starts = 8;
constexpr std::uint64_t stride = 0x9E3779B97F4A7C15u;

void check_options(const Domain& domain, const SpaceOptions& options) {
  const std::vector<ModelPoint>& given = options.initial_sites;
  const int n = given.empty() ? options.sites : static_cast<int>(given.size());
  const int least = domain.kind == DomainKind::Sphere ? 2 : 1;
  if (n < least) {
    throw InvalidInput(fmt::format(
        "{} sites are too few: {}; ask for at least {}", n,
        n == 1 ? "the whole sphere has no centroid" : "there is nothing to place", least));
  }
  if (options.init == InitialSites::Farthest) {
    throw InvalidInput(
        "farthest-point sites are vertices of a mesh, which a bare space has not; start from "
        "random "
        "sites");
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!contains(domain, given[i])) {
      const ModelPoint& p = given[i];
      throw InvalidInput(
          fmt::format("initial site {} at ({:g}, {:g}, {:g}) does not lie in the domain; give "
                      "points of the model inside it",
                      i, p[0], p[1], p[2]));
    }
  }
}

std::unique_ptr<SpaceSites> random_sites(const Domain& domain, std::size_t n, std::uint64_t seed) {
  // Only few random sites on a sphere lie in one hemisphere, and only then other ones do better.
  const bool redraw = domain.kind == DomainKind::Sphere && n <= most_redrawn;
  for (int tries = redraw ? max_draws : 1;; --tries) {
    try {
      std::vector<ModelPoint> points = random_points(domain, n, seed);
      sort_along_curve(points);
      return make_sites(domain, points);
    } catch (const NumericalError&) {
      if (tries <= 1) {
        throw;
      }
      seed = seed * 6364136223846793005u + 1442695040888963407u;
    }
  }
}

class MultilevelStart {
 public:
  MultilevelStart(const Domain& domain, const SpaceOptions& options, const CellMeasure& measure)
      : domain_(domain), options_(options), measure_(measure) {}

  std::unique_ptr<SpaceSites> sites() {
    const std::int64_t euler_number = 2 - 2 * domain_.genus;
    const LevelPlan plan = plan_levels(options_.sites, euler_number);
    if (plan.levels == 0) {
      return random_sites(domain_, static_cast<std::size_t>(options_.sites), options_.seed);
    }
    auto sites = coarsest(static_cast<std::size_t>(plan.coarsest));
    for (int left = plan.levels; left > 0; --left) {
      if (left < plan.levels) {
        settle(*sites);
      }
      sites = finer(*sites, sites_on_level(options_.sites, euler_number, left - 1));
    }
    return sites;
  }

 private:
  /// The best of some random starts.
  std::unique_ptr<SpaceSites> coarsest(std::size_t n) {
    std::unique_ptr<SpaceSites> best;
    double least = 0;
    for (int k = 0; k < coarse_starts; ++k) {
      auto sites = random_sites(domain_, n, options_.seed + static_cast<std::uint64_t>(k) * stride);
      const double energy = settle(*sites);
      if (!best || energy < least) {
        best = std::move(sites), least = energy;
      }
    }
    return best;
  }

  /// Moves the sites to a rough CVT and returns its energy.
  double settle(SpaceSites& sites) {
    SpaceSystem system({domain_.kappa}, sites, measure_);
    const OptimizeResult done =
        optimize(system, {options_.method, level_evaluations, level_tolerance}, options_.monitor);
    if (done.cancelled) {
      throw Cancelled("interrupted; no output was written");
    }
    return done.energy.back();
  }

  /// With so many sites as are wanted, the new ones at the middles of Delaunay edges.
  [[nodiscard]] std::unique_ptr<SpaceSites> finer(const SpaceSites& sites, int wanted) const {
    std::vector<ModelPoint> points = sites.points();
    const std::vector<ModelPoint> middles =
        sites.middles(static_cast<std::size_t>(wanted) - points.size());
    points.insert(points.end(), middles.begin(), middles.end());
    sort_along_curve(points);
    return make_sites(domain_, points);
  }

  const Domain& domain_;
  const SpaceOptions& options_;
  const CellMeasure& measure_;
};

}  // namespace

std::unique_ptr<SpaceSites> start_sites(const Domain& domain, const SpaceOptions& options,
                                        const CellMeasure& measure) {
  check_options(domain, options);
  if (!options.initial_sites.empty()) {
    return make_sites(domain, options.initial_sites);
  }
  if (options.init == InitialSites::Multilevel && is_closed(domain)) {
    try {
      return MultilevelStart(domain, options, measure).sites();
    } catch (const NumericalError&) {
      // A density can draw the few sites of a coarse level into one hemisphere.
    }
  }
  return random_sites(domain, static_cast<std::size_t>(options.sites), options.seed);
}

}  // namespace ucvt
