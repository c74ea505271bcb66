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
    const std::int64_t coarsest = sites_on_level(sites, euler_number, levels);
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

int sites_on_level(int sites, std::int64_t euler_number, int levels_left) {
  const std::int64_t factor = std::int64_t{1} << (2 * levels_left);
  return static_cast<int>((sites - euler_number + factor - 1) / factor + euler_number);
}

std::vector<Halfedge> longest_edges(const DelaunayTriangulation& d, std::size_t most) {
  std::vector<std::pair<double, Halfedge>> edges;
  for (std::size_t i = 0; i < d.connectivity().halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (d.connectivity().is_canonical(h)) {
      const double around =
          d.spacing(d.connectivity().origin(h)) + d.spacing(d.connectivity().head(h));
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
