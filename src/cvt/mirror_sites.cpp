#include "cvt/mirror_sites.h"

#include <cmath>

#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Offsets closer than this part of their length are the same neighbour, up to how symmetric T is.
constexpr double same_neighbour = 1e-3;

/// Sine of the angle within which an edge of D runs along the mirror line.
constexpr double along_line = 1e-4;

std::vector<SurfacePoint> all_points(const MirrorLayout& layout) {
  std::vector<SurfacePoint> out = layout.on_line;
  for (const auto& [one, other] : layout.pairs) {
    out.push_back(one), out.push_back(other);
  }
  return out;
}

/// The reflection that takes the direction of `from` to that of `to`.
Reflection reflection_of(double cosine, double sine) {
  const double norm = std::hypot(cosine, sine);
  return {cosine / norm, sine / norm};
}

bool same_place(const Offset& p, const Offset& q) {
  const double reach = same_neighbour * std::hypot(p.x, p.y);
  return std::hypot(p.x - q.x, p.y - q.y) < reach && std::abs(p.h - q.h) < reach;
}

}  // namespace

std::array<double, 2> Reflection::axis() const {
  const double half = std::atan2(sine, cosine) / 2;
  return {std::cos(half), std::sin(half)};
}

MirrorSites::MirrorSites(const SurfaceMass& mass, const MirrorLayout& layout)
    : line_count_(layout.on_line.size()),
      fixed_(layout.fixed),
      sites_(mass, all_points(layout)),
      t_(mass.surface()) {
  put_exactly(t_, all_points(layout));
  for (std::size_t i = 0; i < sites_.site_count(); ++i) {
    const Vertex site{static_cast<std::int32_t>(i)}, image = partner(site);
    reflection_.push_back(image < site ? reflection_[image.index()] : find_reflection(site));
  }
}

void MirrorSites::put_exactly(const UniformSurface& t, const std::vector<SurfacePoint>& points) {
  std::vector<Offset> target;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Place& place = sites_.place({static_cast<std::int32_t>(i)});
    target.push_back(point_in_frame(t, points[i], place.corner));
  }
  sites_.move(target);
}

Vertex MirrorSites::partner(Vertex site) const {
  if (on_line(site)) {
    return site;
  }
  const auto line = static_cast<std::int32_t>(line_count_);
  return {line + ((site.id - line) ^ 1)};
}

Vertex MirrorSites::shown(std::size_t i) const {
  return {static_cast<std::int32_t>(i < line_count_ ? i : 2 * i - line_count_)};
}

/// The nearest neighbour's edge is in D on both halves whatever ties there are; its image is told from
/// other edges between the same two sites by the images of all other edges.
Reflection MirrorSites::find_reflection(Vertex site) const {
  const DelaunayTriangulation& d = sites_.delaunay();
  const Connectivity& c = d.connectivity();
  const Vertex image = partner(site);
  Halfedge nearest = c.outgoing(site);
  c.for_outgoing(site, [&](Halfedge h) {
    if (d.offset(h).h < d.offset(nearest).h) {
      nearest = h;
    }
  });
  struct Sum {
    double cosine = 0, sine = 0;
    int matches = 0;
  } best;
  c.for_outgoing(image, [&](Halfedge candidate) {
    const Offset &p = d.offset(nearest), &q = d.offset(candidate);
    const Reflection r = reflection_of(p.x * q.x - p.y * q.y, p.x * q.y + p.y * q.x);
    if (c.head(candidate) != partner(c.head(nearest)) || !same_place(r(p), q)) {
      return;
    }
    Sum sum;
    c.for_outgoing(site, [&](Halfedge h) {
      const Offset& from = d.offset(h);
      c.for_outgoing(image, [&](Halfedge g) {
        const Offset& to = d.offset(g);
        if (c.head(g) == partner(c.head(h)) && same_place(r(from), to)) {
          sum.cosine += from.x * to.x - from.y * to.y;
          sum.sine += from.x * to.y + from.y * to.x;
          ++sum.matches;
        }
      });
    });
    if (sum.matches > best.matches) {
      best = sum;
    }
  });
  if (best.matches == 0) {
    throw NumericalError("the doubled surface is not symmetric round a site");
  }
  return reflection_of(best.cosine, best.sine);
}

MirrorLayout MirrorSites::layout() const {
  const std::vector<SurfacePoint> points = sites_.sites();
  MirrorLayout out;
  out.fixed = fixed_;
  out.on_line.assign(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(line_count_));
  for (std::size_t i = line_count_; i < points.size(); i += 2) {
    out.pairs.push_back({points[i], points[i + 1]});
  }
  return out;
}

SurfacePoint MirrorSites::point_at(Vertex site, const Offset& at) const {
  Place place = sites_.place(site);
  move_place(t_, place, at);
  return point_of(place);
}

MirrorSites::Ahead MirrorSites::look_ahead(Vertex p, int direction) const {
  const DelaunayTriangulation& d = sites_.delaunay();
  const Connectivity& c = d.connectivity();
  auto [x, y] = reflection_[p.index()].axis();
  x *= direction, y *= direction;
  Ahead out;
  c.for_outgoing(p, [&](Halfedge h) {
    const Offset &a = d.offset(h), &b = d.offset(c.rotate(h));
    const double beside = (x * a.y - y * a.x) / std::hypot(a.x, a.y);
    if (std::abs(beside) < along_line && x * a.x + y * a.y > 0 && on_line(c.head(h))) {
      out = {h, true};
    } else if (!out.on_line && a.x * y - a.y * x >= 0 && x * b.y - y * b.x > 0) {
      out.halfedge = h;
    }
  });
  return out;
}

void MirrorSites::measure(std::vector<CellState>& out) const {
  const std::vector<Moments> moments = sites_.cell_moments();
  out.resize(site_count());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Vertex site = shown(i);
    const Moments &a = moments[site.index()], &b = moments[partner(site).index()];
    const Offset seen = reflection_[site.index()]({b.x, b.y, b.h});
    Moments mean{(a.m + b.m) / 2, (a.x + seen.x) / 2, (a.y + seen.y) / 2, (a.h + b.h) / 2};
    if (on_line(site)) {
      mean = {mean.m / 2, mean.x / 2, mean.y / 2, mean.h / 2};
      if (fixed_[site.index()]) {
        mean.x = mean.y = 0;
      }
    }
    out[i] = {mean, sites_.delaunay().spacing(site)};
  }
}

void MirrorSites::move(const std::vector<Offset>& target) {
  std::vector<Offset> all(sites_.site_count());
  for (std::size_t i = 0; i < target.size(); ++i) {
    const Vertex site = shown(i);
    if (!on_line(site)) {
      all[site.index()] = target[i];
      all[partner(site).index()] = reflection_[site.index()](target[i]);
    } else if (!fixed_[site.index()]) {
      const auto [x, y] = reflection_[site.index()].axis();
      const double along = x * target[i].x + y * target[i].y;
      all[site.index()] = on_quadric(space(), {along * x, along * y, target[i].h});
    }
  }
  sites_.move(all);
}

}  // namespace ucvt
