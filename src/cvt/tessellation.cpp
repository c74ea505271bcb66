#include "cvt/tessellation.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <tbb/parallel_for.h>

#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Sites closer than this to an edge of their face, in barycentric terms, are moved off it, so that
/// they can be told from T's vertices while those are still there.
constexpr double least_bary = 1e-6;

SurfacePoint off_the_edges(SurfacePoint p) {
  double sum = 0;
  for (double& b : p.bary) {
    sum += b = std::max(b, least_bary);
  }
  for (double& b : p.bary) {
    b /= sum;
  }
  return p;
}

void check_distinct(const std::vector<SurfacePoint>& sites) {
  std::vector<std::pair<std::int32_t, std::array<double, 3>>> sorted;
  for (const SurfacePoint& p : sites) {
    sorted.emplace_back(p.face.id, p.bary);
  }
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    throw InvalidInput("two sites lie at one place of face " + std::to_string(twice->first) +
                       "; give sites that differ");
  }
}

/// The site's face seen from the site, in the frame carried parallel from where `seen` is.
Place place_from(const UniformSurface& t, Face face, const CornerView& seen) {
  Place out{face, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    out.corner[i] = on_quadric(t.space(), transvect_back(t.space(), seen.at, seen.corner[i]));
  }
  return out;
}

/// Inserts the sites into T's own triangulation and removes T's vertices.
DelaunayTriangulation triangulate(const UniformSurface& t, const std::vector<SurfacePoint>& sites,
                                  const ThinnedSurface* base, std::vector<Place>& places) {
  check_distinct(sites);
  const std::vector<Offset> own_frames = base ? std::vector<Offset>{} : t.vertex_frames();
  const std::vector<Offset>& frames = base ? base->frames_of_t() : own_frames;
  DelaunayTriangulation d =
      base ? base->delaunay() : DelaunayTriangulation(t.space(), t.connectivity(), frames);
  std::vector<Vertex> before(d.vertex_count());
  for (std::size_t v = 0; v < before.size(); ++v) {
    before[v] = {static_cast<std::int32_t>(v)};
  }
  places.clear();
  for (const SurfacePoint& site : sites) {
    const SurfacePoint p = off_the_edges(site);
    const CornerView seen = seen_from_corner(t, frames, p);
    places.push_back(place_from(t, p.face, seen));
    if (!base) {
      d.insert(seen.from, {seen.at, {}});
      continue;
    }
    // The site and the corner of its face that tells its frame's direction best, from farther off.
    const auto far =
        static_cast<std::size_t>(std::min_element(p.bary.begin(), p.bary.end()) - p.bary.begin());
    std::array<Offset, 2> points{seen.at, seen.corner[far]};
    const Vertex v = base->anchor(seen.from, points);
    d.insert(v, placing(t.space(), places.back().corner[far], points[0], points[1]));
  }
  d.remove_all(before);
  return d;
}

}  // namespace

Tessellation::Tessellation(const SurfaceMass& mass, const std::vector<SurfacePoint>& sites,
                           const ThinnedSurface* base)
    : mass_(mass),
      d_(triangulate(mass.surface(), sites, base, places_)),
      cells_(mass.surface(), d_, places_) {}

std::vector<SurfacePoint> Tessellation::sites() const {
  std::vector<SurfacePoint> out;
  for (const Place& p : places_) {
    out.push_back(point_of(p));
  }
  return out;
}

void Tessellation::move(const std::vector<Offset>& target) {
  std::vector<Offset> reached(target.size());
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (target[i].h > 0) {
      reached[i] = d_.move({static_cast<std::int32_t>(i)}, target[i]);
    }
  }
  d_.make_delaunay();
  tbb::parallel_for(std::size_t{0}, places_.size(), [&](std::size_t i) {
    if (reached[i].h > 0) {
      move_place(mass_.surface(), places_[i], reached[i]);
    }
  });
  cells_.follow(d_, reached);
}

void Tessellation::measure(std::vector<CellState>& out) const {
  const std::vector<Moments> moments = cell_moments();
  out.resize(moments.size());
  for (std::size_t i = 0; i < moments.size(); ++i) {
    out[i] = {moments[i], d_.spacing({static_cast<std::int32_t>(i)})};
  }
}

void Tessellation::measure(const std::vector<Vertex>& sites, const std::vector<bool>& near,
                           std::vector<CellState>& out) const {
  const std::vector<Moments> moments = cells_.moments(mass_, places_, &near);
  out.clear();
  for (const Vertex v : sites) {
    out.push_back({moments[v.index()], d_.spacing(v)});
  }
}

std::vector<Spring> Tessellation::springs() const {
  const Connectivity& c = d_.connectivity();
  std::vector<Halfedge> edges;
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (c.is_canonical(h) && c.origin(h) != c.head(h)) {
      edges.push_back(h);
    }
  }
  std::vector<Spring> out(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(),
                    [&](std::size_t i) { out[i] = spring(edges[i]); });
  return out;
}

Spring Tessellation::spring(Halfedge h) const {
  const Connectivity& c = d_.connectivity();
  const Halfedge twin = c.twin(h);
  const auto cotangent_opposite = [&](Halfedge side) {
    const Offset &a = d_.offset(side), &b = d_.offset(c.rotate(side));
    return (2 * b.h + chord2(d_.space(), a, b) - 2 * a.h) / (2 * std::abs(cross(a, b)));
  };
  const double dual = std::max(0.0, cotangent_opposite(h) + cotangent_opposite(twin)) / 2;
  const SurfacePoint at = point_of(middle(h).place);
  double density = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex v = mass_.surface().connectivity().origin(halfedges(at.face)[k]);
    density += at.bary[k] * mass_.density()[v.index()];
  }
  const auto direction = [](const Offset& p) {
    const double r = std::sqrt(p.x * p.x + p.y * p.y);
    return Vector2{p.x / r, p.y / r};
  };
  return {c.origin(h).id, c.head(h).id, direction(d_.offset(h)), direction(d_.offset(twin)),
          density * dual * d_.offset(h).h};
}

void Tessellation::save() {
  if (!saved_) {
    saved_.emplace(Saved{places_, d_, cells_});
    return;
  }
  saved_->places = places_;
  saved_->d = d_;
  saved_->cells = cells_;
}

void Tessellation::restore() {
  places_ = saved_->places;
  d_ = saved_->d;
  cells_ = saved_->cells;
}

Tessellation::Middle Tessellation::middle(Halfedge h) const {
  const Vertex from = d_.connectivity().origin(h);
  Middle out{from, half_way(d_.space(), d_.offset(h)), place(from)};
  move_place(mass_.surface(), out.place, out.offset);
  return out;
}

void Tessellation::split_edges(const std::vector<Halfedge>& edges) {
  std::vector<Middle> middles;
  for (const Halfedge h : edges) {
    middles.push_back(middle(h));
  }
  for (const Middle& m : middles) {
    places_.push_back(m.place);
    d_.insert(m.from, {m.offset, {}});
  }
  cells_.follow(d_, std::vector<Offset>(places_.size()));
}

std::vector<Vertex> Tessellation::remove_sites(const std::vector<Vertex>& sites) {
  std::vector<bool> removed(places_.size());
  for (const Vertex v : sites) {
    removed[v.index()] = true;
    d_.remove(v);
  }
  std::vector<Vertex> number = d_.compact();
  std::vector<Place> left;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (!removed[i]) {
      left.push_back(places_[i]);
    }
  }
  places_ = std::move(left);
  cells_.follow_removal(d_, removed, number);
  return number;
}

}  // namespace ucvt
