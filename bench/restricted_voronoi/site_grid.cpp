#include "restricted_voronoi/site_grid.h"

#include <algorithm>
#include <cmath>

namespace ucvt::restricted {

SiteGrid::SiteGrid(const std::vector<Position>& sites, double spacing)
    : sites_(sites), spacing_(spacing), known_(sites.size()) {
  for (std::size_t i = 0; i < sites.size(); ++i) {
    boxes_[key(box(sites[i]))].push_back(static_cast<std::int32_t>(i));
  }
}

std::array<std::int64_t, 3> SiteGrid::box(const Position& p) const {
  std::array<std::int64_t, 3> out{};
  for (std::size_t k = 0; k < 3; ++k) {
    out[k] = static_cast<std::int64_t>(std::floor(p[k] / spacing_));
  }
  return out;
}

std::uint64_t SiteGrid::key(const std::array<std::int64_t, 3>& box) {
  // 21 bits an axis: boxes that share a key only cost time.
  std::uint64_t out = 0;
  for (const std::int64_t b : box) {
    out = out << 21U | (static_cast<std::uint64_t>(b) & 0x1fffffU);
  }
  return out;
}

template <class Visit>
void SiteGrid::for_near(const Position& p, double radius, Visit visit) const {
  const auto low = box({p[0] - radius, p[1] - radius, p[2] - radius});
  const auto high = box({p[0] + radius, p[1] + radius, p[2] + radius});
  std::array<std::int64_t, 3> at{};
  for (at[0] = low[0]; at[0] <= high[0]; ++at[0]) {
    for (at[1] = low[1]; at[1] <= high[1]; ++at[1]) {
      for (at[2] = low[2]; at[2] <= high[2]; ++at[2]) {
        if (const auto found = boxes_.find(key(at)); found != boxes_.end()) {
          std::ranges::for_each(found->second, visit);
        }
      }
    }
  }
}

std::int32_t SiteGrid::nearest(const Position& p) const {
  for (double radius = spacing_;; radius *= 2) {
    std::int32_t best = -1;
    double least = radius * radius;
    for_near(p, radius, [&](std::int32_t i) {
      const double d = distance2(p, sites_[static_cast<std::size_t>(i)]);
      if (d <= least) {
        least = d, best = i;
      }
    });
    if (best >= 0) {
      return best;
    }
  }
}

const std::vector<std::pair<double, std::int32_t>>& SiteGrid::around(std::int32_t site,
                                                                     double radius) {
  const auto index = static_cast<std::size_t>(site);
  Known& known = known_[index];
  if (radius > known.radius && known.others.size() + 1 < sites_.size()) {
    known.radius = std::max(1.5 * radius, 2 * spacing_);
    known.others.clear();
    for_near(sites_[index], known.radius, [&](std::int32_t i) {
      const double d = std::sqrt(distance2(sites_[index], sites_[static_cast<std::size_t>(i)]));
      if (i != site && d <= known.radius) {
        known.others.emplace_back(d, i);
      }
    });
    std::ranges::sort(known.others);
  }
  return known.others;
}

}  // namespace ucvt::restricted
