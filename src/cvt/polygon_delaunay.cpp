#include "cvt/polygon_delaunay.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "cvt/convex_hull.h"
#include "cvt/domain.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

using Triangle = std::array<std::int32_t, 3>;
using Edge = std::array<std::int32_t, 2>;

/// With no more sites than this, each may be every other's neighbour.
constexpr std::size_t few = 8;

/// Height of the point above a hull whose height is 1.
constexpr double top_height = 1.1;

/// A value of a bisector below this part of its terms is none: the corner lies on it.
constexpr double on_bisector = 1e-13;

void check_sites(const std::vector<ModelPoint>& sites) {
  std::vector<std::size_t> order(sites.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return std::tuple(sites[i][0], sites[i][1], i); };
  std::ranges::sort(order, {}, key);
  for (std::size_t k = 1; k < order.size(); ++k) {
    const ModelPoint &p = sites[order[k - 1]], &q = sites[order[k]];
    if (p[0] == q[0] && p[1] == q[1]) {
      throw InvalidInput(
          fmt::format("sites {} and {} coincide at ({:g}, {:g}, {:g}); drop one of them",
                      order[k - 1], order[k], p[0], p[1], p[2]));
    }
  }
}

/// Two sides of a triangle from its first corner on, with what h changes along them.
std::pair<Offset, Offset> sides(const std::vector<Offset>& x, const Triangle& t) {
  const Offset& p = x[static_cast<std::size_t>(t[0])];
  const auto to = [&](std::int32_t i) {
    const Offset& q = x[static_cast<std::size_t>(i)];
    return Offset{q.x - p.x, q.y - p.y, q.h - p.h};
  };
  return {to(t[1]), to(t[2])};
}

/// The triangles of the lower hull, counterclockwise; none when the sites lie on a line.
std::vector<Triangle> lower_hull(const std::vector<Offset>& x) {
  // To the unit cube, so that Qhull's tolerances fit, with a point above the middle, so that
  // cocircular sites have a hull as well.
  double r = 0, h = 0;
  for (const Offset& p : x) {
    r = std::max({r, std::abs(p.x), std::abs(p.y)}), h = std::max(h, p.h);
  }
  std::vector<std::array<double, 3>> points;
  double mean_x = 0, mean_y = 0;
  for (const Offset& p : x) {
    points.push_back({p.x / r, p.y / r, p.h / h});
    mean_x += p.x / r / static_cast<double>(x.size());
    mean_y += p.y / r / static_cast<double>(x.size());
  }
  points.push_back({mean_x, mean_y, top_height});
  std::vector<Triangle> out;
  const auto top = static_cast<std::int32_t>(x.size());
  for (auto [t, normal] : convex_hull(std::move(points))) {
    if (normal[2] < 0 && std::ranges::find(t, top) == t.end()) {
      const auto [u, v] = sides(x, t);
      if (cross(u, v) < 0) {
        std::swap(t[1], t[2]);
      }
      out.push_back(t);
    }
  }
  return out;
}

/// Drops the triangles whose circumcentre lies outside the polygon and sorts the others.
void keep_inside(std::vector<Triangle>& triangles, const std::vector<Offset>& x,
                 const std::vector<CentralPoint>& polygon) {
  std::erase_if(triangles, [&](const Triangle& t) {
    // The plane of the lifted sites is h = k.q + constant, k the circumcentre.
    const auto [u, v] = sides(x, t);
    const Central k = circumcentre(u, v);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const CentralPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      if (!((b[0] - a[0]) * (k.y - a[1]) - (b[1] - a[1]) * (k.x - a[0]) >= 0)) {
        return true;
      }
    }
    return false;
  });
  for (Triangle& t : triangles) {
    std::ranges::rotate(t, std::ranges::min_element(t));
  }
  std::ranges::sort(triangles);
}

/// Each with the next along the line that the sites lie on.
void join_along_line(const std::vector<Offset>& x, std::vector<Edge>& edges) {
  const auto farthest = [&](std::size_t from) {
    return *std::ranges::max_element(
        std::views::iota(std::size_t{0}, x.size()), {},
        [&](std::size_t i) { return std::hypot(x[i].x - x[from].x, x[i].y - x[from].y); });
  };
  const std::size_t a = farthest(0), b = farthest(a);
  const double dx = x[b].x - x[a].x, dy = x[b].y - x[a].y;
  std::vector<std::int32_t> order(x.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::int32_t i) {
    const Offset& p = x[static_cast<std::size_t>(i)];
    return std::pair(dx * p.x + dy * p.y, i);
  });
  for (std::size_t k = 1; k < order.size(); ++k) {
    edges.push_back({order[k - 1], order[k]});
  }
}

void join_all(std::size_t n, std::vector<Edge>& edges) {
  for (std::int32_t j = 0; j < static_cast<std::int32_t>(n); ++j) {
    for (std::int32_t i = 0; i < j; ++i) {
      edges.push_back({i, j});
    }
  }
}

/// Writes the edges, both ways and each once, as lists of neighbours.
void store(PolygonDelaunay& d, std::size_t n, std::vector<Edge> edges) {
  for (std::size_t k = edges.size(); k-- > 0;) {
    edges.push_back({edges[k][1], edges[k][0]});
  }
  std::ranges::sort(edges);
  edges.erase(std::ranges::unique(edges).begin(), edges.end());
  d.start.assign(n + 1, 0);
  d.neighbour.clear();
  for (const Edge& e : edges) {
    d.neighbour.push_back(e[1]);
    d.start[static_cast<std::size_t>(e[0]) + 1] = d.neighbour.size();
  }
  std::partial_sum(d.start.begin(), d.start.end(), d.start.begin(),
                   [](std::size_t a, std::size_t b) { return std::max(a, b); });
}

/// Edges to the true neighbours of the sites that the hull has lost to rounding.
void join_lost(const Domain& domain, const std::vector<ModelPoint>& sites,
               std::vector<Edge>& edges) {
  std::vector<char> known(sites.size(), 0);
  for (const Edge& e : edges) {
    known[static_cast<std::size_t>(e[0])] = known[static_cast<std::size_t>(e[1])] = 1;
  }
  const auto corners = model_corners(domain);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (known[i] != 0) {
      continue;
    }
    std::vector<std::int32_t> others(sites.size());
    std::iota(others.begin(), others.end(), 0);
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Frame frame = frame_at(domain.kappa, sites[i]);
    for (const std::int32_t j : clipped_cell(corners, frame, sites, others).across) {
      if (j >= 0) {
        edges.push_back({static_cast<std::int32_t>(i), j});
      }
    }
  }
}

/// The point of a geodesic at t of its chord, seen from the model's centre.
Offset on_chord(Space s, const Offset& p, const Offset& q, double t) {
  const double z = std::sqrt(1 - s.kappa * t * (1 - t) * chord2(s, p, q));
  return on_quadric(s, {((1 - t) * p.x + t * q.x) / z, ((1 - t) * p.y + t * q.y) / z, 0});
}

/// Cuts the cell by the bisector of its site and the one at a.
void clip(Space s, PolygonCell& cell, const Offset& a, std::int32_t site, PolygonCell& scratch) {
  const std::size_t n = cell.corner.size();
  // Positive beyond the bisector; corners on it get 0, so that no cut makes a side of no length.
  const auto beyond = [&](const Offset& p) {
    const double height = a.h * model_z(s, p);
    const double value = a.x * p.x + a.y * p.y - height;
    return std::abs(value) <= on_bisector * height ? 0 : value;
  };
  scratch.corner.clear(), scratch.across.clear();
  const auto add = [&](const Offset& p, std::int32_t across) {
    scratch.corner.push_back(p), scratch.across.push_back(across);
  };
  bool cut = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Offset &p = cell.corner[i], &q = cell.corner[(i + 1) % n];
    const double at_p = beyond(p), at_q = beyond(q);
    cut = cut || at_p > 0;
    if (at_p <= 0) {
      add(p, at_p == 0 && at_q > 0 ? site : cell.across[i]);
    }
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
      add(on_chord(s, p, q, at_p / (at_p - at_q)), at_p < 0 ? site : cell.across[i]);
    }
  }
  if (cut) {
    std::swap(cell, scratch);
  }
}

}  // namespace

PolygonCell clipped_cell(const std::vector<ModelPoint>& corners, const Frame& frame,
                         const std::vector<ModelPoint>& sites,
                         std::span<const std::int32_t> neighbours) {
  const Space s{frame.kappa};
  PolygonCell cell, scratch;
  for (const ModelPoint& p : corners) {
    cell.corner.push_back(offset_in(frame, p));
    cell.across.push_back(-1);
  }
  std::vector<std::pair<Offset, std::int32_t>> near;
  for (const std::int32_t j : neighbours) {
    near.emplace_back(offset_in(frame, sites[static_cast<std::size_t>(j)]), j);
  }
  // The nearest first: the cell is soon small, and what is left of long sides with it.
  std::ranges::sort(near, {}, [](const auto& n) { return std::pair(n.first.h, n.second); });
  for (const auto& [offset, site] : near) {
    clip(s, cell, offset, site, scratch);
  }
  return cell;
}

PolygonDelaunay delaunay_in_polygon(const Domain& domain, const std::vector<ModelPoint>& sites) {
  if (domain.kind != DomainKind::PlanePolygon && domain.kind != DomainKind::HyperbolicPolygon) {
    throw InvalidInput("the domain is not a polygon; triangulate a closed one by itself");
  }
  check_sites(sites);
  const std::size_t n = sites.size();
  const Frame frame = central_frame(domain);
  std::vector<Offset> x;
  for (const ModelPoint& p : sites) {
    x.push_back(offset_in(frame, p));
  }
  PolygonDelaunay out;
  if (n >= 3) {
    out.triangles = lower_hull(x);
  }
  std::vector<Edge> edges;
  for (const Triangle& t : out.triangles) {
    edges.insert(edges.end(), {{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}});
  }
  if (n <= few) {
    join_all(n, edges);
  } else if (edges.empty()) {
    join_along_line(x, edges);
  } else {
    join_lost(domain, sites, edges);
  }
  store(out, n, std::move(edges));
  std::vector<CentralPoint> polygon;
  for (const ModelPoint& p : model_corners(domain)) {
    const Offset c = offset_in(frame, p);
    const double z = model_z({domain.kappa}, c);
    polygon.push_back({c.x / z, c.y / z});
  }
  keep_inside(out.triangles, x, polygon);
  return out;
}

}  // namespace ucvt
