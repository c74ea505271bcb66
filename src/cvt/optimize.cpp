#include "cvt/optimize.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>

#include "space/polygon_moments.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

constexpr std::size_t memory = 7;

/// Armijo's constant, halvings before Lloyd's step takes over, and the longest step of a site
/// relative to its spacing.
constexpr double sufficient_decrease = 1e-4;
constexpr int max_halvings = 4;
constexpr double longest_step = 0.5;

/// On the sphere a cell's Hessian is this part of its gradient at least: it vanishes where the mass lies
/// a quarter turn from the site.
constexpr double flattest = 0.5;

/// Of a step in the hyperbolic plane, in central coordinates: a distance of 7.
constexpr double farthest = 1 - 1e-6;

/// Steps for which the sites' stiffness is used, and the largest move to a centroid from which on.
constexpr int stiffness_steps = 20;
constexpr double stiffness_move = 0.25;

/// Steps over which the energy has to fall.
constexpr std::size_t stagnation_steps = 10;

/// Relative rounding of an energy: smaller differences tell nothing.
constexpr double energy_rounding = 1e-14;

using Vectors = std::vector<Vector2>;

double dot(const Vectors& a, const Vectors& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i].x * b[i].x + a[i].y * b[i].y;
  }
  return sum;
}

void add(Vectors& a, double factor, const Vectors& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i].x += factor * b[i].x, a[i].y += factor * b[i].y;
  }
}

/// Steps are central coordinates, which end at 1 in the hyperbolic plane: no step goes so far.
Offset at(Space s, const Vector2& step) {
  const double length = std::hypot(step.x, step.y);
  const double scale = s.kappa < 0 && length > farthest ? farthest / length : 1;
  return from_central(s, scale * step.x, scale * step.y);
}

/// False without mass, and where it pulls evenly to all sides.
bool has_centroid(Space s, const Moments& m) {
  return m.m > 0 && (m.x != 0 || m.y != 0 || m.m - s.kappa * m.h > 0);
}

/// Energy, gradient and centroids, all in the sites' frames.
struct Evaluation {
  double energy = 0, max_move = 0;
  Vectors gradient;
  std::vector<Offset> centroid;
  std::vector<double> inverse_hessian, spacing;
};

class Optimizer {
 public:
  Optimizer(SiteSystem& sites, const OptimizeOptions& options, const Monitor& monitor)
      : sites_(sites), options_(options), monitor_(monitor), space_(sites.space()) {}

  OptimizeResult run() {
    Evaluation now = evaluate();
    out_.evaluations = 0;
    while (true) {
      out_.energy.push_back(now.energy);
      out_.max_move.push_back(now.max_move);
      out_.converged = now.max_move <= options_.tolerance || stagnates();
      if (out_.converged || out_.evaluations >= options_.evaluations) {
        break;
      }
      now = options_.method == Method::Lloyd ? lloyd_step(now) : lbfgs_step(std::move(now));
      if (stuck_) {
        break;
      }
      out_.cancelled =
          monitor_ && !monitor_({"optimize", static_cast<int>(out_.energy.size()), now.max_move});
      if (out_.cancelled) {
        break;
      }
    }
    return std::move(out_);
  }

 private:
  struct Pair {
    Vectors step, change;
    double curvature = 0;  ///< step . change
  };

  /// True when the energy has hardly fallen over the last steps.
  [[nodiscard]] bool stagnates() const {
    const std::vector<double>& e = out_.energy;
    return options_.least_decrease > 0 && e.size() > stagnation_steps &&
           e[e.size() - 1 - stagnation_steps] - e.back() < options_.least_decrease * e.back();
  }

  Evaluation evaluate() {
    ++out_.evaluations;
    sites_.measure(cells_);
    const std::size_t n = cells_.size();
    Evaluation e;
    e.gradient.resize(n), e.centroid.resize(n), e.inverse_hessian.resize(n), e.spacing.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Moments& m = cells_[i].moments;
      e.energy += 2 * m.h;
      e.gradient[i] = {-2 * m.x, -2 * m.y};
      e.spacing[i] = cells_[i].spacing;
      if (!has_centroid(space_, m)) {
        continue;
      }
      const double along = m.m - space_.kappa * m.h;
      e.inverse_hessian[i] =
          1 / (2 * std::max(along, flattest * space_.kappa * std::hypot(m.x, m.y)));
      e.centroid[i] = centroid_or_site(space_, m);
      const double chord = std::sqrt(2 * e.centroid[i].h);
      e.max_move = std::max(e.max_move, chord / e.spacing[i]);
    }
    return e;
  }

  void move(const Vectors& step, double factor) {
    target_.resize(step.size());
    for (std::size_t i = 0; i < step.size(); ++i) {
      target_[i] = at(space_, {factor * step[i].x, factor * step[i].y});
    }
    sites_.move(target_);
  }

  Evaluation lloyd_step(const Evaluation& now) {
    pairs_.clear();
    sites_.move(now.centroid);
    return evaluate();
  }

  /// Far from a minimum springs are not what the Hessian is.
  void update_stiffness(const Evaluation& now) {
    if (!options_.springs || now.max_move > stiffness_move ||
        (stiffness_ && ++stiffness_age_ < stiffness_steps)) {
      return;
    }
    stiffness_age_ = 0;
    stiffness_.reset();
    const std::vector<Spring> springs = sites_.springs();
    if (springs.empty()) {
      return;
    }
    std::vector<double> diagonal;
    for (const double inverse : now.inverse_hessian) {
      diagonal.push_back(inverse > 0 ? 1 / inverse : 1);
    }
    stiffness_ = std::make_unique<Stiffness>(springs, diagonal);
    if (!stiffness_->is_usable()) {
      stiffness_.reset();
    }
  }

  /// Applies the initial inverse Hessian.
  void solve(const Evaluation& now, Vectors& v) const {
    if (stiffness_) {
      stiffness_->solve(v);
      return;
    }
    for (std::size_t i = 0; i < v.size(); ++i) {
      v[i].x *= now.inverse_hessian[i], v[i].y *= now.inverse_hessian[i];
    }
  }

  /// The L-BFGS direction (two-loop recursion); no site goes farther than a part of its spacing.
  [[nodiscard]] Vectors direction(const Evaluation& now) const {
    Vectors d = now.gradient;
    std::vector<double> along(pairs_.size());
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      along[k] = dot(pairs_[k].step, d) / pairs_[k].curvature;
      add(d, -along[k], pairs_[k].change);
    }
    for (Vector2& v : d) {
      v = {-v.x, -v.y};
    }
    solve(now, d);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const double back = dot(pairs_[k].change, d) / pairs_[k].curvature;
      add(d, -along[k] - back, pairs_[k].step);
    }
    for (std::size_t i = 0; i < d.size(); ++i) {
      const double length = std::hypot(d[i].x, d[i].y), most = longest_step * now.spacing[i];
      if (length > most) {
        d[i].x *= most / length, d[i].y *= most / length;
      }
    }
    return d;
  }

  void remember(const Vectors& step, double factor, const Evaluation& from, const Evaluation& to) {
    Pair pair{step, to.gradient, 0};
    for (Vector2& s : pair.step) {
      s.x *= factor, s.y *= factor;
    }
    add(pair.change, -1, from.gradient);
    pair.curvature = dot(pair.step, pair.change);
    if (pair.curvature > 0) {
      pairs_.push_back(std::move(pair));
      if (pairs_.size() > memory) {
        pairs_.pop_front();
      }
    }
  }

  Evaluation lbfgs_step(Evaluation now) {
    update_stiffness(now);
    const Vectors d = direction(now);
    const double slope = dot(d, now.gradient);
    sites_.save();
    if (slope < 0) {
      double factor = 1;
      for (int k = 0; k <= max_halvings && out_.evaluations < options_.evaluations; ++k) {
        try {
          move(d, factor);
          Evaluation next = evaluate();
          const double rounding = energy_rounding * std::abs(now.energy);
          if (next.energy <= now.energy + sufficient_decrease * factor * slope + rounding) {
            remember(d, factor, now, next);
            return next;
          }
        } catch (const NumericalError&) {
          // Too far for the triangulation to follow; a shorter step may do.
        }
        sites_.restore();
        factor /= 2;
      }
    }
    if (out_.evaluations >= options_.evaluations) {
      return now;
    }
    try {
      return lloyd_step(now);
    } catch (const NumericalError&) {
      if (out_.energy.size() < 2) {
        throw;
      }
      sites_.restore();
      stuck_ = true;
      return now;
    }
  }

  SiteSystem& sites_;
  const OptimizeOptions& options_;
  const Monitor& monitor_;
  Space space_;
  std::vector<CellState> cells_;
  std::vector<Offset> target_;
  std::deque<Pair> pairs_;
  std::unique_ptr<Stiffness> stiffness_;
  int stiffness_age_ = 0;
  OptimizeResult out_;
  bool stuck_ = false;  ///< the triangulation can follow no step
};

}  // namespace

Offset centroid_or_site(Space s, const Moments& m) {
  if (!has_centroid(s, m)) {
    return {};
  }
  const double along = m.m - s.kappa * m.h;
  return s.kappa < 0 ? at(s, {m.x / along, m.y / along}) : centroid_anywhere(s, m);
}

OptimizeOptions until_converged(const RemeshOptions& options) {
  OptimizeOptions out{options.method, options.iterations, options.tolerance};
  if (options.tolerance <= 0) {
    out.tolerance = 1e-3;
    out.least_decrease = options.method == Method::Lbfgs ? 1e-4 : 0;
  }
  return out;
}

OptimizeResult optimize(SiteSystem& sites, const OptimizeOptions& options, const Monitor& monitor) {
  return Optimizer(sites, options, monitor).run();
}

}  // namespace ucvt
