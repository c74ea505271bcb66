#include "triangulation/delaunay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Flips happen only past this fraction of the determinant's terms, so that rounding cannot flip
/// cocircular points back and forth; DESIGN's Delaunay tolerance.
constexpr double flip_tolerance = 1e-12;

/// Least sine of an angle that a triangle may keep after a move or a flip made for removal.
constexpr double flat_sine = 1e-10;

/// A place this far beyond an edge, relative to it, is on the edge.
constexpr double edge_tolerance = 1e-14;

/// Moves that cannot be made are halved down to this part of an edge before they are given up.
constexpr double least_move = 1e-3;

/// Tries to remove a vertex that is to go, each from another place in its star.
constexpr int max_nudges = 8;

/// With no more vertices than this on a sphere, those that are left when one is away may lie in one
/// hemisphere, which geodesic triangles cannot cover.
constexpr std::size_t least_on_sphere = 12;

/// Offsets shorter than this are made longer where their fourth power counts, which would be below the
/// range of doubles; the range is that of log scales that span 340.
constexpr double tiny_radius = 1e-70, tiny_h = tiny_radius * tiny_radius / 2;

double radius(const Offset& p) {
  return std::sqrt(p.x * p.x + p.y * p.y);
}

/// Sine of the angle from p to q at the origin.
double sine_between(const Offset& p, const Offset& q) {
  return cross(p, q) / (radius(p) * radius(q));
}

}  // namespace

bool DelaunayTriangulation::is_delaunay(Halfedge h) const {
  Offset a = offset(h), b = offset(connectivity_.rotate(h)),
         d = offset(connectivity_.twin(h).next());
  if (a.h < tiny_h) {
    for (Offset* p : {&a, &b, &d}) {
      *p = {p->x / tiny_radius, p->y / tiny_radius, p->h / tiny_radius / tiny_radius};
    }
  }
  const double det = in_circle(a, b, d);
  if (det >= 0) {
    return true;
  }
  const double ra = radius(a), rb = radius(b), rd = radius(d);
  const double scale = ra * rb * d.h + rb * rd * a.h + rd * ra * b.h;
  return det >= -flip_tolerance * scale;
}

bool DelaunayTriangulation::is_convex(Halfedge h) const {
  const Halfedge t = connectivity_.twin(h);
  if (t.face() == h.face()) {
    return false;
  }
  const Offset &j = offset(h), &k = offset(connectivity_.rotate(h)), &m = offset(t.next());
  return cross(m, k) > 0 && orientation(space_, m, j, k) > 0;
}

void DelaunayTriangulation::flip(Halfedge h) {
  const Halfedge t = connectivity_.twin(h);
  const Halfedge hn = h.next(), hp = h.prev(), tn = t.next(), tp = t.prev();
  const auto at = [&](Halfedge x) -> const Offset& { return offset(x); };
  const auto back = [&](Halfedge x) -> const Offset& { return offset(connectivity_.twin(x)); };
  // Both ends of the new diagonal are found through the nearer end of the old one.
  const bool by_origin = back(hp).h + at(tn).h <= at(hn).h + back(tp).h;
  const Offset from_i_to_k = by_origin ? back(hp) : at(hn),
               from_k_to_i = by_origin ? at(hp) : back(hn);
  const Offset from_i_to_m = by_origin ? at(tn) : back(tp),
               from_m_to_i = by_origin ? back(tn) : at(tp);
  const Offset mk = between_frames(from_m_to_i, from_i_to_m).apply(space_, from_i_to_k);
  const Offset km = between_frames(from_k_to_i, from_i_to_k).apply(space_, from_i_to_m);
  const Offset jk = at(hn), ki = at(hp), im = at(tn), mj = at(tp);
  connectivity_.flip(h);
  offset_[hn.index()] = ki, offset_[hp.index()] = im;
  offset_[tn.index()] = mj, offset_[tp.index()] = jk;
  offset_[h.index()] = on_quadric(space_, mk), offset_[t.index()] = on_quadric(space_, km);
}

std::int64_t DelaunayTriangulation::flip_to_delaunay(std::vector<Halfedge> stack) {
  std::int64_t flips = 0;
  while (!stack.empty()) {
    const Halfedge h = stack.back();
    stack.pop_back();
    if (is_delaunay(h) || !is_convex(h)) {
      continue;
    }
    const Halfedge t = connectivity_.twin(h);
    flip(h);
    ++flips;
    stack.insert(stack.end(), {h.next(), h.prev(), t.next(), t.prev()});
  }
  return flips;
}

double DelaunayTriangulation::spacing(Vertex v) const {
  double sum = 0;
  int n = 0;
  connectivity_.for_outgoing(v, [&](Halfedge h) {
    sum += std::sqrt(2 * offset(h).h);
    ++n;
  });
  return sum / n;
}

std::int64_t DelaunayTriangulation::make_delaunay() {
  std::vector<Halfedge> all;
  for (std::size_t i = 0; i < offset_.size(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (!connectivity_.is_removed(h.face()) && connectivity_.is_canonical(h)) {
      all.push_back(h);
    }
  }
  return flip_to_delaunay(std::move(all));
}

void DelaunayTriangulation::walk(Halfedge& h, std::array<Offset, 3>& x) const {
  const std::size_t limit = 100 + 3 * connectivity_.face_count();
  for (std::size_t step = 0; step < limit; ++step) {
    std::size_t exit = 3;
    double worst = -edge_tolerance;
    for (std::size_t i = 0; i < 3; ++i) {
      const Offset &u = x[i], &v = x[(i + 1) % 3];
      const double inside = cross(u, v) / chord2(space_, u, v);
      if (inside < worst) {
        worst = inside, exit = i;
      }
    }
    if (exit == 3) {
      return;
    }
    for (std::size_t i = 0; i < exit; ++i) {
      h = h.next();
    }
    const Offset u = x[exit], v = x[(exit + 1) % 3];
    const Isometry at_u = placing(space_, offset(h), u, v);
    h = connectivity_.twin(h);
    x = {v, u, on_quadric(space_, at_u.apply(space_, offset(h.next())))};
  }
  throw NumericalError("the walk to a new site did not end");
}

Vertex DelaunayTriangulation::insert(Vertex v, const Isometry& frame, Vertex reuse) {
  // Start in the face at v that the new place is seen through; corners in the new vertex' frame.
  Halfedge h = connectivity_.outgoing(v);
  connectivity_.for_outgoing(v, [&](Halfedge g) {
    if (cross(offset(g), frame.translation) >= 0 &&
        cross(frame.translation, offset(connectivity_.rotate(g))) > 0) {
      h = g;
    }
  });
  const auto seen = [&](const Offset& p) {
    return on_quadric(space_, frame.apply_inverse(space_, p));
  };
  std::array<Offset, 3> x{seen({}), seen(offset(h)), seen(offset(connectivity_.rotate(h)))};
  walk(h, x);
  // The same round as the face's own, from its number 0.
  const auto side = halfedges(h.face());
  std::rotate(x.begin(), x.begin() + (3 - h.id % 3) % 3, x.end());
  std::array<Offset, 3> back;
  for (std::size_t i = 0; i < 3; ++i) {
    const Isometry corner = placing(space_, offset(side[i]), x[i], x[(i + 1) % 3]);
    back[i] = corner.rotation.inverse()({-x[i].x, -x[i].y, x[i].h});
  }
  const std::array<Offset, 3> rim{offset(side[0]), offset(side[1]), offset(side[2])};
  const Vertex n = connectivity_.split_face(h.face(), reuse);
  offset_.resize(connectivity_.halfedge_count());
  std::vector<Halfedge> stack;
  Halfedge out = side[2];  // n -> corner 0, as split_face leaves it
  for (std::size_t i = 0; i < 3; ++i, out = connectivity_.rotate(out)) {
    offset_[out.index()] = x[i];
    offset_[connectivity_.twin(out).index()] = back[i];
    offset_[out.next().index()] = rim[i];
    stack.push_back(out.next());
  }
  flip_to_delaunay(std::move(stack));
  return n;
}

bool DelaunayTriangulation::try_remove(Vertex v) {
  // Flip away, of all edges at v whose quadrilateral is convex, the one that leaves the best
  // shaped triangle behind; some edge always can be while v has more than three.
  std::vector<Vertex> link;
  connectivity_.for_outgoing(v, [&](Halfedge h) { link.push_back(connectivity_.head(h)); });
  while (connectivity_.degree(v) > 3) {
    Halfedge best;
    double best_shape = 0;
    connectivity_.for_outgoing(v, [&](Halfedge h) {
      const Halfedge t = connectivity_.twin(h);
      // A loop counts twice at v; a diagonal that comes back to v gains nothing.
      const auto at_v = [&](Halfedge g) { return connectivity_.origin(g) == v ? 1 : 0; };
      const int gain = 1 + at_v(t) - at_v(h.prev()) - at_v(t.prev());
      if (gain <= 0 || !is_convex(h)) {
        return;
      }
      const Offset &j = offset(h), &k = offset(connectivity_.rotate(h)), &m = offset(t.next());
      const double outer = orientation(space_, m, j, k) /
                           (chord2(space_, m, j) + chord2(space_, j, k) + chord2(space_, k, m));
      const double shape = std::min(outer, sine_between(m, k));
      if (shape > best_shape) {
        best_shape = shape, best = h;
      }
    });
    if (best.id < 0) {
      return false;
    }
    flip(best);
  }
  const Halfedge a = connectivity_.outgoing(v);
  const Halfedge b = connectivity_.rotate(a), c = connectivity_.rotate(b);
  if (a.face() == b.face() || b.face() == c.face() || c.face() == a.face()) {
    return false;
  }
  const std::array<Offset, 3> rim{offset(a.next()), offset(b.next()), offset(c.next())};
  const Face face = connectivity_.remove_vertex_of_degree_3(v);
  for (std::size_t i = 0; i < 3; ++i) {
    offset_[halfedges(face)[i].index()] = rim[i];
  }
  std::vector<Halfedge> stack;
  for (const Vertex w : link) {
    if (w != v) {
      connectivity_.for_outgoing(w, [&](Halfedge h) { stack.push_back(h); });
    }
  }
  flip_to_delaunay(std::move(stack));
  return true;
}

void DelaunayTriangulation::remove(Vertex v) {
  // On the crossing of straight lines through its neighbours (regular grids) no quadrilateral at v is
  // strictly convex; off them one is. Where v lies no longer matters.
  for (int nudge = 0; nudge < max_nudges; ++nudge) {
    if (try_remove(v)) {
      return;
    }
    bool moved = false;
    connectivity_.for_outgoing(v, [&](Halfedge h) {
      const Offset a = offset(h), b = offset(connectivity_.rotate(h));
      moved = moved ||
              move_in_star(v, from_central(space_, (2 * a.x + b.x) / 12, (2 * a.y + b.y) / 12));
    });
    if (!moved) {
      break;
    }
  }
  throw NumericalError("a vertex of the triangulation could not be removed");
}

void DelaunayTriangulation::remove_all(const std::vector<Vertex>& vertices) {
  // By octave of the scale, otherwise as they come: neighbours in memory go together.
  std::vector<std::pair<int, Vertex>> order;
  for (const Vertex v : vertices) {
    double nearest = HUGE_VAL;
    connectivity_.for_outgoing(v, [&](Halfedge h) { nearest = std::min(nearest, offset(h).h); });
    order.emplace_back(std::ilogb(nearest) / 2, v);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [octave, v] : order) {
    remove(v);
  }
  compact();
  make_delaunay();
}

bool DelaunayTriangulation::move_in_star(Vertex v, const Offset& to) {
  struct Change {
    Halfedge h;
    Offset out, back;
  };
  thread_local std::vector<Change> changes;
  changes.clear();
  connectivity_.for_outgoing(v, [&](Halfedge h) {
    const bool loop = connectivity_.head(h) == v;
    const Isometry from_head = frame_change(h);
    const Offset target = loop ? from_head.apply(space_, to) : offset(h);
    const Offset back = frame_change(connectivity_.twin(h)).apply(space_, to);
    changes.push_back({h, on_quadric(space_, transvect_back(space_, to, target)),
                       loop ? Offset{} : on_quadric(space_, back)});
  });
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const Offset &p = changes[i].out, &q = changes[(i + 1) % changes.size()].out;
    if (!(sine_between(p, q) > flat_sine)) {
      return false;
    }
  }
  for (const Change& c : changes) {
    offset_[c.h.index()] = c.out;
    const Halfedge t = connectivity_.twin(c.h);
    if (connectivity_.head(c.h) != v) {
      offset_[t.index()] = c.back;
    }
  }
  return true;
}

Offset DelaunayTriangulation::move(Vertex v, const Offset& to) {
  if (move_in_star(v, to)) {
    return to;
  }
  Halfedge link;
  connectivity_.for_outgoing(v, [&](Halfedge h) {
    if (connectivity_.head(h) != v && (link.id < 0 || offset(h).h < offset(link).h)) {
      link = h;
    }
  });
  const bool removable = space_.kappa <= 0 || vertex_count() > least_on_sphere;
  if (link.id >= 0 && removable) {
    // The nearest neighbour keeps the place while v is away: by way of a far one, what angles round
    // vertices miss 2 pi by would grow with every move.
    const Vertex anchor = connectivity_.head(link);
    const Offset anchor_seen = transvect_back(space_, to, offset(link));
    const Offset at = frame_change(connectivity_.twin(link)).apply(space_, to);
    const Isometry frame{at, rotation_between(anchor_seen, {-at.x, -at.y, at.h})};
    if (try_remove(v)) {
      insert(anchor, frame, v);
      return to;
    }
  }
  const double least = least_move * least_move * offset(connectivity_.outgoing(v)).h;
  return half_way(space_, to.h) > least ? move(v, half_way(space_, to)) : Offset{};
}

std::vector<Vertex> DelaunayTriangulation::compact() {
  const auto to = connectivity_.compact();
  for (std::size_t f = 0; f < to.face.size(); ++f) {
    if (to.face[f].id < 0) {
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      offset_[3 * to.face[f].index() + i] = offset_[3 * f + i];
    }
  }
  offset_.resize(connectivity_.halfedge_count());
  return to.vertex;
}

double DelaunayTriangulation::area() const {
  double sum = 0;
  for (std::size_t i = 0; i < offset_.size(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (connectivity_.is_removed(h.face())) {
      continue;
    }
    sum += central_triangle_area(space_, offset(h), offset(connectivity_.rotate(h))) / 3;
  }
  return sum;
}

}  // namespace ucvt
