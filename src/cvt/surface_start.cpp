#include "cvt/surface_start.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "cvt/defects.h"
#include "cvt/initial_sites.h"
#include "cvt/multilevel.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Vertices of T under a site of the start's levels.
constexpr int vertices_per_site = 16;
/// A thinned T with more than this part of T's vertices is not worth it.
constexpr double most_left = 0.5;

/// Sites resolve the density where its logarithm changes by less than this from one to the next. A level
/// finds no rest where such a share of its sites does not.
constexpr double most_change = 4, most_unresolved = 0.25;

/// The coarsest level comes to rest: what defects it has all levels have. The others end where ten steps
/// lower the energy by little.
const OptimizeOptions at_rest{.evaluations = 200, .tolerance = 1e-4, .least_decrease = 1e-5};
const OptimizeOptions settled{.evaluations = 100, .tolerance = 1e-3, .least_decrease = 1e-4};

/// Random starts compete, with seeds so far apart, until so many evaluations after the coarsest levels:
/// there energies tell which will be best in the end, on the first level they do not.
constexpr int starts = 2, most_competing = 1000, trial_evaluations = 20;
constexpr std::uint64_t stride = 0x9E3779B97F4A7C15u;

/// Exchanges that mend defects on levels of so many sites at most, the larger ones only where T itself is
/// their ground: where T is fine they take long for little. Still larger ones have few defects.
constexpr int small_level = 1000, small_exchanges = 3, large_level = 4000, large_exchanges = 2;
const OptimizeOptions before_mending{.evaluations = 25, .tolerance = 1e-3, .least_decrease = 1e-4};

/// Draws of random sites before giving up.
constexpr int max_draws = 200;

/// The thinnest T that has enough vertices for so many sites, or T itself, with its density.
class Ground {
 public:
  Ground(const StartSurface& on_t, int sites) : mass_of_t_(&on_t.mass) {
    for (const ThinnedSurface& t : on_t.thinned) {
      if (2 * t.delaunay().vertex_count() >
          static_cast<std::size_t>(sites) * static_cast<std::size_t>(vertices_per_site)) {
        thinned_ = &t;
      }
    }
    if (thinned_) {
      own_mass_ = std::make_unique<SurfaceMass>(thinned_->surface(),
                                                thinned_->averaged(on_t.mass.density()));
    }
    weight_ = thinned_ ? thinned_->summed(on_t.weight) : on_t.weight;
  }

  [[nodiscard]] bool is_thinned() const { return thinned_ != nullptr; }
  [[nodiscard]] const SurfaceMass& mass() const { return own_mass_ ? *own_mass_ : *mass_of_t_; }
  [[nodiscard]] const std::vector<double>& weight() const { return weight_; }

  [[nodiscard]] std::vector<SurfacePoint> from_t(std::vector<SurfacePoint> points) const {
    if (thinned_) {
      for (SurfacePoint& p : points) {
        p = thinned_->from_t(p);
      }
    }
    return points;
  }
  [[nodiscard]] std::vector<SurfacePoint> to_t(std::vector<SurfacePoint> points) const {
    if (thinned_) {
      for (SurfacePoint& p : points) {
        p = thinned_->to_t(p);
      }
    }
    return points;
  }

 private:
  const SurfaceMass* mass_of_t_;
  const ThinnedSurface* thinned_ = nullptr;
  std::unique_ptr<SurfaceMass> own_mass_;
  std::vector<double> weight_;
};

class MultilevelStart {
 public:
  MultilevelStart(const StartSurface& surface, int sites, Method method, const Monitor& monitor)
      : sites_(sites),
        euler_number_(surface.mass.surface().connectivity().euler_number()),
        plan_(plan_levels(sites, euler_number_)),
        method_(method),
        monitor_(monitor) {
    grounds_.reserve(static_cast<std::size_t>(plan_.levels) + 1);
    for (int left = 0; left <= plan_.levels; ++left) {
      grounds_.emplace_back(surface, sites_on(left));
    }
  }

  [[nodiscard]] std::vector<SurfacePoint> sites(std::uint64_t seed) {
    if (plan_.levels == 0) {
      return {};
    }
    const int planned = plan_.levels;
    while (plan_.levels > 1 && unresolved(plan_.levels) > most_unresolved) {
      --plan_.levels;
    }
    Level best = start(seed);
    if (!best.rested && plan_.levels > 1) {
      // So few do not resolve the density: the level that they would be split into comes first.
      --plan_.levels;
      best = start(seed);
    }
    for (int k = 1; k < starts && best.rested && plan_.levels == planned; ++k) {
      Level other = start(seed += stride);
      if (other.energy < best.energy) {
        best = std::move(other);
      }
    }
    while (best.left > 0) {
      best = finer(mended(best), best.left == plan_.levels ? at_rest : settled);
    }
    if (exchanges(best) > 0) {
      best = mended(best);
    } else if (ground(best).is_thinned()) {
      best = optimised(best, settled);
    }
    return best.points;
  }

 private:
  /// Sites with so many splittings to come.
  struct Level {
    int left = 0;
    std::vector<SurfacePoint> points;  ///< of T
    double energy = 0;
    bool rested = false;  ///< converged on the coarsest level
  };

  [[nodiscard]] int sites_on(int left) const { return sites_on_level(sites_, euler_number_, left); }

  /// The share of so many sites that do not resolve the density.
  [[nodiscard]] double unresolved(int left) const {
    const SurfaceMass& mass = grounds_.front().mass();
    const UniformSurface& t = mass.surface();
    const Connectivity& c = t.connectivity();
    // The root of the density is as dense as sites are.
    struct Part {
      double sites, change;
    };
    std::vector<Part> parts;
    double whole = 0;
    for (std::size_t f = 0; f < c.face_count(); ++f) {
      const Face face{static_cast<std::int32_t>(f)};
      double root = 0, change = 0;
      for (const Halfedge h : halfedges(face)) {
        const double from = mass.density()[c.origin(h).index()];
        const double to = mass.density()[c.head(h).index()];
        root += std::sqrt(from) / 3;
        change = std::max(change, std::abs(std::log(to / from)) / t.chord(h));
      }
      parts.push_back({root * t.area(face), change / std::sqrt(root)});
      whole += parts.back().sites;
    }
    const double spacing = std::sqrt(2 * whole / (std::numbers::sqrt3 * sites_on(left)));
    double sum = 0;
    for (const Part& p : parts) {
      sum += p.change * spacing > most_change ? p.sites : 0;
    }
    return sum / whole;
  }

  /// From random sites to the last level on which starts compete, roughly optimised there.
  [[nodiscard]] Level start(std::uint64_t seed) const {
    int left = plan_.levels;
    while (left > 1 && sites_on(left - 1) <= most_competing) {
      --left;
    }
    Level level{plan_.levels, {}, 0, true};
    const Ground& coarsest = ground(level);
    level.points = coarsest.to_t(
        random_tessellation(coarsest.mass(), coarsest.weight(), sites_on(level.left), seed)
            ->sites());
    OptimizeOptions options = at_rest;
    while (level.left > left) {
      level = finer(level, options);
      options = settled;
    }
    options.evaluations = std::min(options.evaluations, trial_evaluations);
    return optimised(level, options);
  }

  [[nodiscard]] Level optimised(const Level& level, const OptimizeOptions& options) const {
    const Ground& at = ground(level);
    Tessellation sites(at.mass(), at.from_t(level.points));
    Level out = optimise(sites, level, options);
    out.points = at.to_t(sites.sites());
    return out;
  }

  /// Optimised, and with as many middles of edges as the next level has more sites.
  [[nodiscard]] Level finer(const Level& level, const OptimizeOptions& options) const {
    const Ground& at = ground(level);
    Tessellation sites(at.mass(), at.from_t(level.points));
    Level out = optimise(sites, level, options);
    out.left = level.left - 1;
    const auto room = static_cast<std::size_t>(sites_on(out.left)) - sites.site_count();
    sites.split_edges(longest_edges(sites.delaunay(), room));
    out.points = at.to_t(sites.sites());
    return out;
  }

  /// That are worth their time on this level.
  [[nodiscard]] int exchanges(const Level& level) const {
    const int n = sites_on(level.left);
    if (n <= small_level) {
      return small_exchanges;
    }
    return n <= large_level && !ground(level).is_thinned() ? large_exchanges : 0;
  }

  /// Settled and with fewer defects; the level itself where no exchange is worth its time.
  [[nodiscard]] Level mended(const Level& level) const {
    if (exchanges(level) == 0) {
      return level;
    }
    const Ground& at = ground(level);
    auto sites = std::make_unique<Tessellation>(at.mass(), at.from_t(level.points));
    Level out = optimise(*sites, level, before_mending);
    sites = mend_defects(std::move(sites), exchanges(level), monitor_);
    out.points = at.to_t(sites->sites());
    return out;
  }

  /// The level but for its points.
  Level optimise(Tessellation& sites, const Level& level, OptimizeOptions options) const {
    options.method = method_;
    const OptimizeResult result = optimize(sites, options, monitor_);
    if (result.cancelled) {
      throw Cancelled("interrupted; no output was written");
    }
    const bool coarsest = level.left == plan_.levels;
    return {level.left, {}, result.energy.back(), coarsest ? result.converged : level.rested};
  }

  [[nodiscard]] const Ground& ground(const Level& level) const {
    return grounds_[static_cast<std::size_t>(level.left)];
  }

  int sites_;
  std::int64_t euler_number_;
  LevelPlan plan_;
  Method method_;
  const Monitor& monitor_;
  std::vector<Ground> grounds_;  ///< by the splittings to come
};

}  // namespace

std::vector<std::size_t> thinned_counts(const UniformSurface& t, int sites) {
  const std::int64_t euler_number = t.connectivity().euler_number();
  const int levels = plan_levels(sites, euler_number).levels;
  std::vector<std::size_t> out;
  for (int left = 0; left <= levels; ++left) {
    const auto n = static_cast<std::size_t>(sites_on_level(sites, euler_number, left)) *
                   static_cast<std::size_t>(vertices_per_site);
    if (static_cast<double>(n) < most_left * static_cast<double>(t.connectivity().vertex_count())) {
      out.push_back(n);
    }
  }
  return out;
}

bool covers_surface(const Tessellation& sites) {
  constexpr double sphere = 4 * std::numbers::pi;
  return sites.space().kappa <= 0 || std::abs(sites.delaunay().area() - sphere) < 1e-6 * sphere;
}

std::unique_ptr<Tessellation> random_tessellation(const SurfaceMass& mass,
                                                  const std::vector<double>& weight, int n,
                                                  std::uint64_t seed, const ThinnedSurface* base) {
  for (int tries = max_draws;; --tries) {
    try {
      auto out = std::make_unique<Tessellation>(
          mass, random_sites(mass.surface(), weight, static_cast<std::size_t>(n), seed), base);
      if (!covers_surface(*out)) {
        throw NumericalError("the initial sites lie in one hemisphere");
      }
      return out;
    } catch (const NumericalError&) {
      if (tries <= 1) {
        throw;
      }
      seed = seed * 6364136223846793005u + 1442695040888963407u;
    }
  }
}

std::vector<SurfacePoint> multilevel_start(const StartSurface& surface, int sites,
                                           std::uint64_t seed, Method method,
                                           const Monitor& monitor) {
  return MultilevelStart(surface, sites, method, monitor).sites(seed);
}

}  // namespace ucvt
