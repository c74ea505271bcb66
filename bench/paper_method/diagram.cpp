#include "paper_method/diagram.h"

#include <algorithm>
#include <utility>

#include "cvt/convex_hull.h"

namespace ucvt::paper {
namespace {

using Point = std::array<double, 3>;

/// What the hull is taken of; the head of diagram.h has the reason.
Point lifted(double kappa, const ModelPoint& p) {
  if (kappa > 0) {
    return p;
  }
  const double x = p[0] / (1 + p[2]), y = p[1] / (1 + p[2]);
  return {x, y, x * x + y * y};
}

/// det[b - a, c - a, up], where `up` is outward at a.
double turn(const Point& a, const Point& b, const Point& c, const Point& up) {
  const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return up[0] * (u[1] * v[2] - u[2] * v[1]) + up[1] * (u[2] * v[0] - u[0] * v[2]) +
         up[2] * (u[0] * v[1] - u[1] * v[0]);
}

std::vector<Corners> delaunay(double kappa, const std::vector<ModelPoint>& points) {
  std::vector<Point> lift;
  for (const ModelPoint& p : points) {
    lift.push_back(lifted(kappa, p));
  }
  std::vector<Corners> out;
  for (auto [t, normal] : convex_hull(lift)) {
    if (kappa <= 0 && normal[2] >= 0) {
      continue;
    }
    const auto at = [&](std::size_t i) { return lift[static_cast<std::size_t>(t[i])]; };
    if (turn(at(0), at(1), at(2), kappa > 0 ? at(0) : Point{0, 0, 1}) < 0) {
      std::swap(t[1], t[2]);
    }
    out.push_back(t);
  }
  return out;
}

/// A fan's spokes in order, from pairs of consecutive ones; empty when it is not one fan.
std::vector<std::int32_t> chained(std::vector<std::pair<std::int32_t, std::int32_t>> pairs) {
  std::ranges::sort(pairs);
  const auto from = [&](std::int32_t spoke) {
    return std::ranges::lower_bound(pairs, spoke, {},
                                    &std::pair<std::int32_t, std::int32_t>::first);
  };
  // An open fan starts with the spoke that ends no pair.
  auto start = std::ranges::find_if(pairs, [&](const auto& p) {
    return std::ranges::none_of(pairs, [&](const auto& q) { return q.second == p.first; });
  });
  if (pairs.empty()) {
    return {};
  }
  std::vector<std::int32_t> out{(start == pairs.end() ? pairs.begin() : start)->first};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto next = from(out.back());
    if (next == pairs.end() || next->first != out.back()) {
      return {};
    }
    out.push_back(next->second);
  }
  return out;
}

Corners starting_at(const Corners& t, std::size_t i) {
  return {t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
}

/// Where to start so that the triangle's order comes first.
std::size_t first_of(const Corners& t) {
  std::size_t out = 0;
  for (const std::size_t i : {1U, 2U}) {
    out = starting_at(t, i) < starting_at(t, out) ? i : out;
  }
  return out;
}

}  // namespace

Diagram diagram(const FundamentalDomain& domain, const std::vector<PlacedSite>& sites) {
  Diagram out;
  out.sites = sites.size();
  out.points.reserve(sites.size() * (domain.neighbour.size() + 1));
  for (const PlacedSite& s : sites) {
    out.points.push_back(s.frame.P);
  }
  for (const ModelMatrix& m : domain.neighbour) {
    for (const PlacedSite& s : sites) {
      out.points.push_back(on_model(domain.kappa, transformed(m, s.frame.P)));
    }
  }
  out.triangles = delaunay(domain.kappa, out.points);
  return out;
}

std::vector<std::vector<std::int32_t>> neighbours(const Diagram& d) {
  std::vector<std::vector<std::pair<std::int32_t, std::int32_t>>> pairs(d.sites);
  for (const Corners& t : d.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (const auto at = static_cast<std::size_t>(t[i]); at < d.sites) {
        pairs[at].emplace_back(t[(i + 1) % 3], t[(i + 2) % 3]);
      }
    }
  }
  std::vector<std::vector<std::int32_t>> out;
  for (auto& p : pairs) {
    out.push_back(chained(std::move(p)));
  }
  return out;
}

std::vector<Corners> quotient(const Diagram& d) {
  std::vector<Corners> out;
  for (const Corners& t : d.triangles) {
    const Corners sites{d.site(t[0]), d.site(t[1]), d.site(t[2])};
    const std::size_t first = first_of(sites);
    if (static_cast<std::size_t>(t[first]) < d.sites) {
      out.push_back(starting_at(sites, first));
    }
  }
  std::ranges::sort(out);
  return out;
}

std::vector<Corners> quotient(const DelaunayTriangulation& d) {
  const Connectivity& c = d.connectivity();
  std::vector<Corners> out;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    const auto side = halfedges({static_cast<std::int32_t>(f)});
    const Corners sites{c.origin(side[0]).id, c.origin(side[1]).id, c.origin(side[2]).id};
    out.push_back(starting_at(sites, first_of(sites)));
  }
  std::ranges::sort(out);
  return out;
}

}  // namespace ucvt::paper
