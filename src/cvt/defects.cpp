#include "cvt/defects.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "cvt/local_sites.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Rings round a defect whose sites move to tell what a change there is worth.
constexpr int moving_rings = 2;

const OptimizeOptions around{.evaluations = 10, .tolerance = 1e-3, .springs = false};
const OptimizeOptions everywhere{.evaluations = 15, .tolerance = 1e-3};

/// What a change may be worth less than nothing, in cells: the sites farther away give way later.
constexpr double most_loss = 0.1;

/// Fewer sites have no room for a defect and what is around it.
constexpr std::size_t least_sites = 100;

/// The end of a row of sites, and the sites around.
struct Region {
  Halfedge edge;       ///< from a site with less than six neighbours to one with more
  Neighbourhood part;  ///< of its ends
};

/// A number without pattern (splitmix64), to take defects in an order that differs from time to time.
std::uint64_t scrambled(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

/// Regions that have no site in common.
std::vector<Region> disjoint_regions(const Connectivity& d, std::uint64_t seed) {
  std::vector<std::pair<std::uint64_t, Halfedge>> ends_of_rows;
  for (std::size_t i = 0; i < d.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (d.degree(d.origin(h)) < 6 && d.degree(d.head(h)) > 6) {
      ends_of_rows.emplace_back(scrambled(seed * d.halfedge_count() + i), h);
    }
  }
  std::sort(ends_of_rows.begin(), ends_of_rows.end());
  std::vector<bool> taken(d.vertex_count());
  const auto is_taken = [&](Vertex v) { return taken[v.index()]; };
  std::vector<Region> out;
  for (const auto& [key, edge] : ends_of_rows) {
    Neighbourhood part = neighbourhood(d, {d.origin(edge), d.head(edge)}, moving_rings);
    if (std::ranges::any_of(part.moving, is_taken) || std::ranges::any_of(part.rim, is_taken)) {
      continue;
    }
    for (const auto* sites : {&part.moving, &part.rim}) {
      for (const Vertex v : *sites) {
        taken[v.index()] = true;
      }
    }
    out.push_back({edge, std::move(part)});
  }
  return out;
}

/// The halfedge to v's farthest neighbour.
Halfedge longest_edge(const DelaunayTriangulation& d, Vertex v) {
  Halfedge out = d.connectivity().outgoing(v);
  d.connectivity().for_outgoing(v, [&](Halfedge h) {
    if (d.offset(h).h > d.offset(out).h) {
      out = h;
    }
  });
  return out;
}

double energy_of(const std::vector<CellState>& cells) {
  double sum = 0;
  for (const CellState& c : cells) {
    sum += 2 * c.moments.h;
  }
  return sum;
}

enum class Change : char { Remove, Add };

class Mender {
 public:
  Mender(std::unique_ptr<Tessellation> sites, const Monitor& monitor)
      : monitor_(monitor), now_(std::move(sites)), best_(std::make_unique<Tessellation>(*now_)) {
    now_->measure(cells_);
    best_energy_ = energy_of(cells_);
  }

  /// Not better in the end: goes back.
  void exchange(Change first, std::uint64_t seed) {
    const std::size_t n = change(first, now_->site_count(), seed);
    if (n == 0) {
      return;
    }
    change(first == Change::Remove ? Change::Add : Change::Remove, n, seed);
    const double energy = energy_of(cells_);
    if (now_->site_count() == best_->site_count() && energy < best_energy_) {
      best_ = std::make_unique<Tessellation>(*now_);
      best_energy_ = energy;
    } else {
      now_ = std::make_unique<Tessellation>(*best_);
      now_->measure(cells_);
    }
  }

  std::unique_ptr<Tessellation> take() { return std::move(best_); }

 private:
  /// Changes the best places, at most so many; all that are worth it when there are as many sites as at
  /// first, otherwise whatever it costs. Returns their number.
  std::size_t change(Change what, std::size_t most, std::uint64_t seed) {
    const double mean = energy_of(cells_) / static_cast<double>(cells_.size());
    std::vector<Region> regions = disjoint_regions(now_->delaunay().connectivity(), seed);
    const std::vector<double> rise = rises(what, regions);
    // A site less raises the energy of all by that of one, and the other way round.
    const bool balanced = now_->site_count() == best_->site_count();
    const double worth_it = (what == Change::Remove ? mean : -mean) + most_loss * mean;
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < regions.size(); ++k) {
      if (!balanced || rise[k] < worth_it) {
        order.emplace_back(rise[k], k);
      }
    }
    std::sort(order.begin(), order.end());
    order.resize(std::min(order.size(), most));
    std::vector<Region> chosen;
    for (const auto& [r, k] : order) {
      chosen.push_back(std::move(regions[k]));
    }
    if (!chosen.empty()) {
      apply(what, chosen, *now_);
      settle(*now_, everywhere);
      now_->measure(cells_);
    }
    return chosen.size();
  }

  /// Returns the numbers of the sites that were, by their old ones; id -1 for those taken away.
  static std::vector<Vertex> apply(Change what, const std::vector<Region>& regions,
                                   Tessellation& sites) {
    const DelaunayTriangulation& d = sites.delaunay();
    if (what == Change::Remove) {
      std::vector<Vertex> ends;
      for (const Region& r : regions) {
        ends.push_back(d.connectivity().origin(r.edge));
      }
      return sites.remove_sites(ends);
    }
    std::vector<Vertex> number;
    for (std::size_t v = 0; v < d.vertex_count(); ++v) {
      number.push_back({static_cast<std::int32_t>(v)});
    }
    std::vector<Halfedge> edges;
    for (const Region& r : regions) {
      edges.push_back(longest_edge(d, d.connectivity().head(r.edge)));
    }
    sites.split_edges(edges);
    return number;
  }

  /// By how much the energy rises when the change is made, for every region by itself.
  [[nodiscard]] std::vector<double> rises(Change what, const std::vector<Region>& regions) const {
    Tessellation trial(*now_);
    const std::vector<Vertex> number = apply(what, regions, trial);
    std::vector<double> out(regions.size());
    Neighbourhood all;
    std::vector<std::size_t> region_of_moving, region_of_rim;
    for (std::size_t k = 0; k < regions.size(); ++k) {
      const auto take = [&](Vertex v, std::vector<Vertex>& into, std::vector<std::size_t>& region) {
        out[k] -= 2 * cells_[v.index()].moments.h;
        if (number[v.index()].id >= 0) {
          into.push_back(number[v.index()]), region.push_back(k);
        }
      };
      for (const Vertex v : regions[k].part.moving) {
        take(v, all.moving, region_of_moving);
      }
      for (const Vertex v : regions[k].part.rim) {
        take(v, all.rim, region_of_rim);
      }
      if (what == Change::Add) {
        all.moving.push_back({static_cast<std::int32_t>(number.size() + k)});
        region_of_moving.push_back(k);
      }
    }
    LocalSites local(trial, all);
    settle(local, around);
    std::vector<CellState> after;
    local.measure(after);
    region_of_moving.insert(region_of_moving.end(), region_of_rim.begin(), region_of_rim.end());
    for (std::size_t i = 0; i < after.size(); ++i) {
      out[region_of_moving[i]] += 2 * after[i].moments.h;
    }
    return out;
  }

  void settle(SiteSystem& sites, const OptimizeOptions& options) const {
    if (optimize(sites, options, monitor_).cancelled) {
      throw Cancelled("interrupted; no output was written");
    }
  }

  const Monitor& monitor_;
  std::unique_ptr<Tessellation> now_, best_;
  double best_energy_;
  std::vector<CellState> cells_;  ///< of the sites now
};

}  // namespace

std::unique_ptr<Tessellation> mend_defects(std::unique_ptr<Tessellation> sites, int exchanges,
                                           const Monitor& monitor) {
  if (sites->site_count() < least_sites) {
    return sites;
  }
  Mender mender(std::move(sites), monitor);
  for (int i = 0; i < exchanges; ++i) {
    mender.exchange(i % 2 == 0 ? Change::Remove : Change::Add, static_cast<std::uint64_t>(i));
  }
  return mender.take();
}

}  // namespace ucvt
