#include "restricted_voronoi/restricted_voronoi.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "mesh/disjoint_sets.h"
#include "restricted_voronoi/site_grid.h"

namespace ucvt::restricted {
namespace {

/// A corner of a part of a triangle, and what lies across the side that begins there: a site, or side k
/// of the triangle as -1 - k.
struct PartCorner {
  Position at;
  std::int32_t across;
};
using Part = std::vector<PartCorner>;

Position between(const Position& p, const Position& q, double t) {
  return {std::lerp(p[0], q[0], t), std::lerp(p[1], q[1], t), std::lerp(p[2], q[2], t)};
}

double farthest(const Part& part, const Position& from) {
  double out = 0;
  for (const PartCorner& c : part) {
    out = std::max(out, distance2(c.at, from));
  }
  return std::sqrt(out);
}

/// Cuts off what is nearer to the other site.
void clip(Part& part, const Position& site, const Position& other, std::int32_t number,
          Part& scratch) {
  const auto beyond = [&](const Position& p) { return distance2(p, site) - distance2(p, other); };
  scratch.clear();
  for (std::size_t i = 0; i < part.size(); ++i) {
    const PartCorner &p = part[i], &q = part[(i + 1) % part.size()];
    const double at_p = beyond(p.at), at_q = beyond(q.at);
    if (at_p <= 0) {
      scratch.push_back(p);
    }
    if ((at_p <= 0) != (at_q <= 0)) {
      scratch.push_back({between(p.at, q.at, at_p / (at_p - at_q)), at_p <= 0 ? number : p.across});
    }
  }
  part.swap(scratch);
}

/// The area of a flat polygon and its centroid.
std::pair<double, Position> area_and_centroid(const Part& part) {
  double area = 0;
  Position sum{};
  for (std::size_t i = 1; i + 1 < part.size(); ++i) {
    const Position &a = part[0].at, &b = part[i].at, &c = part[i + 1].at;
    const double aa = distance2(b, c), bb = distance2(c, a), cc = distance2(a, b);
    const double square = 2 * (aa * bb + bb * cc + cc * aa) - aa * aa - bb * bb - cc * cc;
    const double piece = std::sqrt(std::max(0.0, square)) / 4;
    area += piece;
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += piece * (a[k] + b[k] + c[k]) / 3;
    }
  }
  return {area, sum};
}

class Builder {
 public:
  Builder(const TriangleMesh& mesh, const std::vector<Position>& sites)
      : mesh_(mesh),
        sites_(sites),
        grid_(sites, std::sqrt(survey(mesh).area / static_cast<double>(sites.size()))),
        visited_(sites.size(), -1) {
    out_.cells.resize(sites.size());
  }

  Diagram run() && {
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      share_out(f);
    }
    for (Cell& c : out_.cells) {
      for (double& x : c.centroid) {
        x /= c.area > 0 ? c.area : 1;
      }
    }
    count_parts();
    return std::move(out_);
  }

 private:
  /// A part of a cell reaches a side of its triangle; there it meets the same cell's part beyond.
  using EdgeOfCell = std::pair<std::pair<std::int32_t, std::int32_t>, std::int32_t>;

  [[nodiscard]] Part whole(std::size_t f) const {
    Part out;
    for (std::size_t k = 0; k < 3; ++k) {
      out.push_back({mesh_.positions[static_cast<std::size_t>(mesh_.faces[f][k])],
                     -1 - static_cast<std::int32_t>(k)});
    }
    return out;
  }

  void share_out(std::size_t f) {
    queue_.clear();
    for (const PartCorner& c : whole(f)) {
      visit(grid_.nearest(c.at), f);
    }
    for (std::size_t n = 0; n < queue_.size(); ++n) {
      const std::int32_t site = queue_[n];
      const Part part = part_of(site, f);
      if (part.size() < 3) {
        continue;
      }
      for (const PartCorner& c : part) {
        if (c.across >= 0) {
          visit(c.across, f);
        }
      }
      add(site, f, part);
    }
  }

  void visit(std::int32_t site, std::size_t f) {
    auto& last = visited_[static_cast<std::size_t>(site)];
    if (last != static_cast<std::int64_t>(f)) {
      last = static_cast<std::int64_t>(f);
      queue_.push_back(site);
    }
  }

  Part part_of(std::int32_t site, std::size_t f) {
    const Position& at = sites_[static_cast<std::size_t>(site)];
    Part part = whole(f);
    double reach = 2 * farthest(part, at);
    const auto* others = &grid_.around(site, 0);
    for (std::size_t k = 0; part.size() >= 3; ++k) {
      if (k == others->size()) {
        others = &grid_.around(site, reach);
      }
      if (k == others->size() || (*others)[k].first > reach) {
        break;
      }
      const std::int32_t other = (*others)[k].second;
      clip(part, at, sites_[static_cast<std::size_t>(other)], other, scratch_);
      reach = 2 * farthest(part, at);
    }
    return part;
  }

  void add(std::int32_t site, std::size_t f, const Part& part) {
    Cell& cell = out_.cells[static_cast<std::size_t>(site)];
    const auto [area, moment] = area_and_centroid(part);
    cell.area += area;
    for (std::size_t k = 0; k < 3; ++k) {
      cell.centroid[k] += moment[k];
    }
    const auto number = static_cast<std::int32_t>(part_site_.size());
    part_site_.push_back(site);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::int32_t before = part[(i + part.size() - 1) % part.size()].across;
      const std::int32_t after = part[i].across;
      if (before >= 0 && after >= 0) {
        add_dual({site, before, after});
      }
      if (after < 0) {
        const auto k = static_cast<std::size_t>(-1 - after);
        const std::int32_t u = mesh_.faces[f][k], v = mesh_.faces[f][(k + 1) % 3];
        at_edge_.emplace_back(EdgeOfCell{std::minmax(u, v), site}, number);
      }
    }
  }

  void add_dual(const Corners& t) {
    Corners sorted = t;
    std::ranges::sort(sorted);
    if (known_dual_.insert(sorted).second) {
      out_.dual.push_back(t);
    }
  }

  void count_parts() {
    std::ranges::sort(at_edge_);
    DisjointSets sets(part_site_.size());
    for (std::size_t i = 1; i < at_edge_.size(); ++i) {
      if (at_edge_[i - 1].first == at_edge_[i].first) {
        sets.join(at_edge_[i - 1].second, at_edge_[i].second);
      }
    }
    for (std::size_t i = 0; i < part_site_.size(); ++i) {
      if (sets.find(static_cast<std::int32_t>(i)) == static_cast<std::int32_t>(i)) {
        ++out_.cells[static_cast<std::size_t>(part_site_[i])].parts;
      }
    }
  }

  const TriangleMesh& mesh_;
  const std::vector<Position>& sites_;
  SiteGrid grid_;
  std::vector<std::int64_t> visited_;  // by site: the last face that it was visited for
  std::vector<std::int32_t> queue_;
  Part scratch_;
  std::vector<std::int32_t> part_site_;  // by part
  std::vector<std::pair<EdgeOfCell, std::int32_t>> at_edge_;
  std::set<Corners> known_dual_;
  Diagram out_;
};

}  // namespace

Diagram restricted_voronoi(const TriangleMesh& mesh, const std::vector<Position>& sites) {
  return Builder(mesh, sites).run();
}

}  // namespace ucvt::restricted
