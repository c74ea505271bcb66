#include "cvt/consistency.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <set>

namespace ucvt {
namespace {

/// Faces round the one that was reached in which the site is looked for.
constexpr std::size_t most_faces = 1000;

double angle_between(const Offset& p, const Offset& q) {
  return std::atan2(cross(p, q), p.x * q.x + p.y * q.y);
}

double angle_error(const DelaunayTriangulation& d, Vertex site) {
  double sum = 0;
  d.connectivity().for_outgoing(site, [&](Halfedge h) {
    const double angle = angle_between(d.offset(h), d.offset(d.connectivity().rotate(h)));
    sum += angle > 0 ? angle : angle + 2 * std::numbers::pi;
  });
  return std::abs(sum - 2 * std::numbers::pi);
}

/// How deep the vertex opposite to h lies in the circle on the other side, relative to the terms.
double depth_in_circle(const DelaunayTriangulation& d, Halfedge h) {
  const Connectivity& c = d.connectivity();
  const Offset &a = d.offset(h), &b = d.offset(c.rotate(h)), &o = d.offset(c.twin(h).next());
  const auto r = [](const Offset& p) { return std::hypot(p.x, p.y); };
  const double scale = r(a) * r(b) * o.h + r(b) * r(o) * a.h + r(o) * r(a) * b.h;
  return std::max(0.0, -in_circle(a, b, o) / scale);
}

Place across(const UniformSurface& t, const Place& from, std::size_t side) {
  const Halfedge h = halfedges(from.face)[side], twin = t.connectivity().twin(h);
  const Offset u = from.corner[side], v = from.corner[(side + 1) % 3];
  const auto j = static_cast<std::size_t>(twin.id % 3);
  Place to{twin.face(), {}};
  to.corner[j] = v, to.corner[(j + 1) % 3] = u;
  to.corner[(j + 2) % 3] = t.develop(h, u, v);
  return to;
}

/// A face and how far its nearest corner is from the origin of the frame, by chord.
struct Seen {
  double distance;
  Place place;

  Seen(const Place& p, double d) : distance(d), place(p) {}
  bool operator<(const Seen& other) const { return distance > other.distance; }
};

double nearest_corner(const Place& place) {
  const auto& [a, b, c] = place.corner;
  return std::sqrt(2 * std::min({a.h, b.h, c.h}));
}

/// Chord from the origin of the place's frame to a point of T near it, faces being looked at from near to
/// far; where it is in none of them, how far they reach.
double distance_to(const UniformSurface& t, const Place& from, const SurfacePoint& p) {
  std::priority_queue<Seen> front;
  std::set<std::int32_t> seen{from.face.id};
  front.emplace(from, 0.0);
  double reached = 0;
  for (std::size_t looked_at = 0; !front.empty() && looked_at < most_faces; ++looked_at) {
    const Seen next = front.top();
    front.pop();
    if (next.place.face == p.face) {
      return std::sqrt(2 * point_in_frame(t, p, next.place.corner).h);
    }
    reached = std::max(reached, next.distance);
    for (std::size_t side = 0; side < 3; ++side) {
      const Place beyond = across(t, next.place, side);
      if (seen.insert(beyond.face.id).second) {
        front.emplace(beyond, nearest_corner(beyond));
      }
    }
  }
  return reached;
}

double smallest_chord(const UniformSurface& t, Face f) {
  const auto side = halfedges(f);
  return std::min({t.chord(side[0]), t.chord(side[1]), t.chord(side[2])});
}

/// From the end where T's faces are smaller: an error relative to the offset then stays small in terms
/// of the faces where it ends.
double miss(const UniformSurface& t, const DelaunayTriangulation& d,
            const std::vector<Place>& places, Halfedge h) {
  const Connectivity& c = d.connectivity();
  const auto size_at = [&](Halfedge g) {
    return smallest_chord(t, places[c.origin(g).index()].face);
  };
  const Halfedge along = size_at(h) <= size_at(c.twin(h)) ? h : c.twin(h);
  Place place = places[c.origin(along).index()];
  move_place(t, place, d.offset(along));
  const SurfacePoint target = point_of(places[c.head(along).index()]);
  return distance_to(t, place, target) / std::sqrt(2 * d.offset(along).h);
}

/// Difference of the lengths that an edge's two ends see.
double disagreement(const DelaunayTriangulation& d, Halfedge h) {
  const double here = std::sqrt(2 * d.offset(h).h);
  return std::abs(here - std::sqrt(2 * d.offset(d.connectivity().twin(h)).h)) / here;
}

}  // namespace

Consistency measure_consistency(const UniformSurface& t, const DelaunayTriangulation& d,
                                const std::vector<Place>& places) {
  Consistency out;
  for (std::size_t i = 0; i < places.size(); ++i) {
    out.angle_sum_rad = std::max(out.angle_sum_rad, angle_error(d, {static_cast<std::int32_t>(i)}));
  }
  for (std::size_t i = 0; i < d.connectivity().halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (d.connectivity().is_canonical(h)) {
      out.circle = std::max(out.circle, depth_in_circle(d, h));
      out.place = std::max({out.place, miss(t, d, places, h), disagreement(d, h)});
    }
  }
  return out;
}

}  // namespace ucvt
