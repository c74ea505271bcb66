#include "cvt/thinned_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Points none of which is nearer to another than r, taken as they come until there is room for no more,
/// number about this many for an area of r^2.
constexpr double packing = 0.7;

/// Times that a vertex is met on the way of shortest paths.
constexpr std::uint8_t most_meetings = 30;

std::vector<double> chords(const DelaunayTriangulation& d) {
  std::vector<double> out;
  for (std::size_t i = 0; i < d.connectivity().halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    out.push_back(std::sqrt(2 * d.offset(std::min(h, d.connectivity().twin(h))).h));
  }
  return out;
}

/// By vertex the first edge of the way to the vertex that stays near it; id -1: it stays itself.
///
/// Of the candidates those stay that are farther than the radius from all taken before, by paths of edges.
std::vector<Halfedge> spread_out(const Connectivity& c, const std::vector<double>& length,
                                 const std::vector<Vertex>& candidates, double radius) {
  std::vector<Halfedge> towards(c.vertex_count());
  std::vector<double> distance(c.vertex_count(), HUGE_VAL);
  // Shortest paths, corrected in the order in which vertices are met: over a few rings of vertices that
  // is sooner done than by a heap. Where lengths differ by powers, corrections would go on and on, and
  // paths are good enough without.
  std::vector<Vertex> front;
  std::vector<bool> waits(c.vertex_count(), false);
  std::vector<std::uint8_t> meetings(c.vertex_count());
  const auto meet = [&](Vertex v) {
    if (!waits[v.index()] && meetings[v.index()] < most_meetings) {
      waits[v.index()] = true;
      ++meetings[v.index()];
      front.push_back(v);
    }
  };
  const auto reach = [&](double limit) {
    for (std::size_t k = 0; k < front.size(); ++k) {
      const Vertex v = front[k];
      waits[v.index()] = false;
      const double d = distance[v.index()];
      c.for_outgoing(v, [&](Halfedge h) {
        const Vertex w = c.head(h);
        const double through = d + length[h.index()];
        if (through < distance[w.index()] && through <= limit) {
          distance[w.index()] = through, towards[w.index()] = c.twin(h);
          meet(w);
        }
      });
    }
    front.clear();
  };
  for (const Vertex v : candidates) {
    if (distance[v.index()] == HUGE_VAL) {
      distance[v.index()] = 0;
      meet(v);
      reach(radius);
    }
  }
  std::fill(meetings.begin(), meetings.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (distance[i] < HUGE_VAL) {
      meet({static_cast<std::int32_t>(i)});
    }
  }
  reach(HUGE_VAL);
  return towards;
}

double total_area(const std::vector<double>& length) {
  double sum = 0;
  for (std::size_t i = 0; i < length.size(); i += 3) {
    sum += triangle_determinant({0}, {length[i], length[i + 1], length[i + 2]}) / 2;
  }
  return sum;
}

std::vector<double> vertex_areas(const UniformSurface& t) {
  std::vector<double> out(t.connectivity().vertex_count());
  for (std::size_t f = 0; f < t.connectivity().face_count(); ++f) {
    const Face face{static_cast<std::int32_t>(f)};
    const double share = t.area(face) / 3;
    for (const Halfedge h : halfedges(face)) {
      out[t.connectivity().origin(h).index()] += share;
    }
  }
  return out;
}

/// The point at an offset in the frame of a vertex.
SurfacePoint point_near(const UniformSurface& t, const std::vector<Offset>& frames, Vertex v,
                        const Offset& at) {
  const Halfedge h = t.connectivity().outgoing(v);
  const auto slot = static_cast<std::size_t>(h.id % 3);
  Place place{h.face(), {}};
  place.corner[(slot + 1) % 3] = frames[h.index()];
  place.corner[(slot + 2) % 3] = frames[t.connectivity().rotate(h).index()];
  move_place(t, place, at);
  return point_of(place);
}

}  // namespace

ThinnedSurface::ThinnedSurface(std::shared_ptr<const Source> source, DelaunayTriangulation d,
                               std::vector<Vertex> kept, std::vector<Halfedge> towards)
    : source_(std::move(source)),
      delaunay_(std::move(d)),
      surface_(delaunay_.space(), delaunay_.connectivity(), chords(delaunay_)),
      kept_(std::move(kept)),
      towards_(std::move(towards)),
      near_(towards_.size()) {
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    near_[kept_[i].index()] = {static_cast<std::int32_t>(i)};
  }
  const Connectivity& c = source_->t.connectivity();
  std::vector<std::size_t> way;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    way.clear();
    std::size_t v = i;
    for (; near_[v].id < 0; v = c.head(towards_[v]).index()) {
      way.push_back(v);
    }
    for (const std::size_t w : way) {
      near_[w] = near_[v];
    }
  }
}

std::vector<double> ThinnedSurface::summed(const std::vector<double>& of_t) const {
  std::vector<double> sum(surface_.connectivity().vertex_count());
  for (std::size_t v = 0; v < of_t.size(); ++v) {
    sum[near_[v].index()] += of_t[v];
  }
  return sum;
}

std::vector<double> ThinnedSurface::averaged(const std::vector<double>& of_t) const {
  std::vector<double> weighted = of_t;
  for (std::size_t v = 0; v < of_t.size(); ++v) {
    weighted[v] *= source_->area[v];
  }
  std::vector<double> out = summed(weighted);
  const std::vector<double> area = summed(source_->area);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] /= area[i];
  }
  return out;
}

Vertex ThinnedSurface::anchor(Vertex of_t, std::span<Offset> points) const {
  const Space s = surface_.space();
  const Connectivity& c = source_->t.connectivity();
  while (towards_[of_t.index()].id >= 0) {
    const Halfedge h = towards_[of_t.index()];
    const Isometry back =
        between_frames(source_->frames[c.twin(h).index()], source_->frames[h.index()]);
    for (Offset& p : points) {
      p = on_quadric(s, back.apply(s, p));
    }
    of_t = c.head(h);
  }
  return near_[of_t.index()];
}

SurfacePoint ThinnedSurface::from_t(const SurfacePoint& p) const {
  CornerView seen = seen_from_corner(source_->t, source_->frames, p);
  const Vertex v = anchor(seen.from, {&seen.at, 1});
  return point_near(surface_, delaunay_.offsets(), v, seen.at);
}

SurfacePoint ThinnedSurface::to_t(const SurfacePoint& p) const {
  const CornerView seen = seen_from_corner(surface_, delaunay_.offsets(), p);
  return point_near(source_->t, source_->frames, kept_[seen.from.index()], seen.at);
}

std::vector<ThinnedSurface> thin_out(const UniformSurface& t, const std::vector<double>& length,
                                     const std::vector<std::size_t>& counts) {
  std::vector<ThinnedSurface> out;
  if (counts.empty()) {
    return out;
  }
  const auto source = std::make_shared<const ThinnedSurface::Source>(
      ThinnedSurface::Source{t, t.vertex_frames(), vertex_areas(t)});
  DelaunayTriangulation d(t.space(), t.connectivity(), source->frames);
  std::vector<Vertex> left;  // by vertex of d: that of T
  for (std::size_t v = 0; v < t.connectivity().vertex_count(); ++v) {
    left.push_back({static_cast<std::int32_t>(v)});
  }
  const double area = total_area(length);
  for (const std::size_t count : counts) {
    const double radius = std::sqrt(packing * area / static_cast<double>(count));
    std::vector<Halfedge> towards = spread_out(t.connectivity(), length, left, radius);
    std::vector<Vertex> stays, goes;
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (towards[left[i].index()].id < 0) {
        stays.push_back(left[i]);
      } else {
        goes.push_back({static_cast<std::int32_t>(i)});
      }
    }
    try {
      d.remove_all(goes);
      out.push_back(ThinnedSurface(source, d, stays, std::move(towards)));
    } catch (const NumericalError&) {
      break;
    }
    left = std::move(stays);
  }
  return out;
}

}  // namespace ucvt
