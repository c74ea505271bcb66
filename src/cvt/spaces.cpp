#include "ucvt/spaces.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include <tbb/global_control.h>

#include "cvt/cell_measure.h"
#include "cvt/optimize.h"
#include "cvt/space_start.h"
#include "cvt/space_system.h"
#include "cvt/uniformity.h"
#include "space/polygon_moments.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

class SpaceCvt {
 public:
  SpaceCvt(const Domain& domain, const SpaceOptions& options)
      : domain_(domain),
        options_(options),
        space_{domain.kappa},
        measure_(domain, options),
        sites_(start_sites(domain, options, measure_)) {}

  SpaceResult run() {
    SpaceResult out;
    out.domain = domain_;
    out.initial_uniformity = uniformity();
    if (options_.keep_cells) {
      out.initial_sites = sites_->points();
      out.initial_cells = cells();
    }
    out.cvt = move_sites();
    out.sites = sites_->points();
    add_energies(out);
    out.uniformity = uniformity();
    if (options_.keep_cells) {
      out.cells = cells();
      out.triangles = sites_->triangles();
    }
    return out;
  }

 private:
  CvtReport move_sites() {
    const auto start = std::chrono::steady_clock::now();
    SpaceSystem system(space_, *sites_, measure_);
    OptimizeResult done = optimize(
        system, {options_.method, options_.iterations, options_.tolerance}, options_.monitor);
    if (done.cancelled) {
      throw Cancelled("interrupted; no output was written");
    }
    CvtReport out;
    out.method = options_.method == Method::Lloyd ? "lloyd" : "lbfgs";
    out.sites = static_cast<std::int64_t>(sites_->count());
    out.iterations = done.evaluations;
    out.converged = done.converged;
    out.energy = std::move(done.energy), out.max_move = std::move(done.max_move);
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return out;
  }

  /// The paper's energies, which differ from ours by the domain's mass; and the error of the integrals.
  void add_energies(SpaceResult& out) const {
    std::vector<double> mass(sites_->count()), error(sites_->count());
    for_cells(*sites_, [&](std::size_t i, const SiteCell& cell) {
      mass[i] = measure_(sites_->frame(i), cell, error[i]).m;
    });
    out.quadrature_error = *std::max_element(error.begin(), error.end());
    const double total = std::accumulate(mass.begin(), mass.end(), 0.0);
    // 1 - cos d and cosh d - 1 are half of chord^2; in the plane the paper has d^2 itself.
    const double kappa = space_.kappa;
    for (const double e : out.cvt.energy) {
      out.paper_energy.push_back(e / (1 + kappa * kappa) - kappa * total);
    }
  }

  [[nodiscard]] UniformityReport uniformity() const {
    const std::size_t n = sites_->count();
    std::vector<double> radius(n), nearest(n), area(n);
    std::vector<int> degree(n);
    for_cells(*sites_, [&](std::size_t i, const SiteCell& cell) {
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
    for_cells(*sites_, [&](std::size_t i, const SiteCell& cell) {
      const Frame& frame = sites_->frame(i);
      SpaceCell& c = out[i];
      for (const Offset& corner : cell.corner) {
        c.corners.push_back(model_point(frame, corner));
      }
      double error = 0;
      const Moments m = measure_(frame, cell, error);
      c.centroid = model_point(frame, centroid_or_site(space_, m));
      c.degree = cell.degree;
      c.area = uniform_moments(space_, cell.corner).m;
      c.mass = m.m, c.energy = 2 * m.h;
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
