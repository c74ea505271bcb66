#include "result/even_sizes.h"

#include <algorithm>
#include <cmath>

namespace ucvt {
namespace {

/// Change of the log scale from a site to its farthest neighbour from which on a cell counts in full.
constexpr double steep_cell = 1.5;

/// Part of what is amiss that is made up for at once, and the most of it, as a logarithm.
constexpr double gain = 0.5, most_amiss = 0.7;

/// The log scale under every site, but for its sign: half the logarithm of the conformal factor.
std::vector<double> log_scales(const Tessellation& sites, const SurfaceMass& area) {
  const Connectivity& t = area.surface().connectivity();
  std::vector<double> out;
  for (const SurfacePoint& p : sites.sites()) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += p.bary[i] * std::log(area.density()[t.origin(halfedges(p.face)[i]).index()]);
    }
    out.push_back(sum / 2);
  }
  return out;
}

/// log(area on the input over the mean) of every cell.
std::vector<double> log_excess(const Tessellation& sites, const SurfaceMass& area) {
  const std::vector<Moments> cells = sites.cell_moments(area);
  double total = 0;
  for (const Moments& m : cells) {
    total += m.m;
  }
  std::vector<double> out;
  for (const Moments& m : cells) {
    out.push_back(std::log(m.m * static_cast<double>(cells.size()) / total));
  }
  return out;
}

}  // namespace

void even_sizes(const Tessellation& sites, const SurfaceMass& area, std::vector<double>& size) {
  const Connectivity& d = sites.delaunay().connectivity();
  const std::vector<double> scale = log_scales(sites, area), excess = log_excess(sites, area);
  std::vector<double> factor(sites.site_count());
  for (std::size_t i = 0; i < factor.size(); ++i) {
    double around = 0, steepness = 0;
    int degree = 0;
    d.for_outgoing({static_cast<std::int32_t>(i)}, [&](Halfedge h) {
      const std::size_t j = d.head(h).index();
      around += excess[j];
      steepness = std::max(steepness, std::abs(scale[j] - scale[i]));
      ++degree;
    });
    const double amiss = std::min(1.0, steepness / steep_cell) * (excess[i] + around / degree) / 2;
    // Areas go with the square of the size.
    factor[i] = std::exp(-gain / 2 * std::clamp(amiss, -most_amiss, most_amiss));
  }
  for (std::size_t v = 0; v < size.size(); ++v) {
    size[v] *= factor[sites.owner({static_cast<std::int32_t>(v)}).index()];
  }
}

}  // namespace ucvt
