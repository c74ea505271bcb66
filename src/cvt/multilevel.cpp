#include "cvt/multilevel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ucvt {
namespace {

/// Sites of the first level.
constexpr std::int64_t least_coarse = 32, most_coarse = 160;

}  // namespace

LevelPlan plan_levels(int sites, std::int64_t euler_number) {
  LevelPlan best{sites, 0};
  std::int64_t least_excess = INT64_MAX;
  const std::int64_t wanted = sites - euler_number;
  std::int64_t factor = 4;
  for (int levels = 1; factor < wanted; ++levels, factor *= 4) {
    const std::int64_t coarsest = (wanted + factor - 1) / factor + euler_number;
    if (coarsest < least_coarse || (coarsest > most_coarse && levels > 1)) {
      continue;
    }
    const std::int64_t excess = factor * (coarsest - euler_number) - wanted;
    if (best.levels == 0 || best.coarsest > most_coarse || excess < least_excess) {
      best = {static_cast<int>(coarsest), levels}, least_excess = excess;
    }
  }
  return best;
}

std::vector<Halfedge> longest_edges(const Tessellation& sites, std::size_t most) {
  const DelaunayTriangulation& d = sites.delaunay();
  std::vector<std::pair<double, Halfedge>> edges;
  for (std::size_t i = 0; i < d.connectivity().halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (d.connectivity().is_canonical(h)) {
      const double around =
          sites.spacing(d.connectivity().origin(h)) + sites.spacing(d.connectivity().head(h));
      edges.emplace_back(-std::sqrt(2 * d.offset(h).h) / around, h);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Halfedge> out;
  for (std::size_t i = 0; i < std::min(most, edges.size()); ++i) {
    out.push_back(edges[i].second);
  }
  return out;
}

}  // namespace ucvt
