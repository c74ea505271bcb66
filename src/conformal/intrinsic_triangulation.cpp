#include "conformal/intrinsic_triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>

#include "space/moments.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Euclidean flips happen only past this cotangent sum.
constexpr double delaunay_tolerance = 1e-10;

/// Triangles with less room than this in the triangle inequality, relative to their longest side,
/// are degenerate to rounding and get the room of `mollified_room` mean edge lengths.
constexpr double least_room = 1e-14, mollified_room = 1e-5;

double length(const IntrinsicTriangulation& t, Halfedge h) {
  return std::exp(t.log_length[h.index()]);
}

void set_length(IntrinsicTriangulation& t, Halfedge h, double log_length) {
  t.log_length[h.index()] = t.log_length[t.connectivity.twin(h).index()] = log_length;
}

/// A triangle laid out with the side of h on the x axis, from the origin to (base, 0).
struct Laid {
  double base = 0, x = 0, y = 0;  ///< apex at (x, y), y >= 0
};

Laid lay_out(double base, double from_origin, double from_head) {
  const double det = triangle_determinant({0}, {base, from_origin, from_head});
  // (a - b)(a + b) keeps the digits of near-isosceles needles.
  const double x = (base + (from_origin - from_head) * ((from_origin + from_head) / base)) / 2;
  return {base, x, det / base};
}

Laid lay_out(const IntrinsicTriangulation& t, Halfedge h) {
  return lay_out(length(t, h), length(t, h.prev()), length(t, h.next()));
}

/// Cotangents of the angles opposite to h and its twin, summed.
double cotangent_sum(const IntrinsicTriangulation& t, Halfedge h) {
  const auto cotangent = [&](Halfedge g) {
    const Laid p = lay_out(t, g);
    return p.y > 0 ? (p.y - (p.base - p.x) * (p.x / p.y)) / p.base
                   : (p.x < 0 || p.x > p.base ? HUGE_VAL : -HUGE_VAL);
  };
  return cotangent(h) + cotangent(t.connectivity.twin(h));
}

void euclidean_flip(IntrinsicTriangulation& t, Halfedge h) {
  const Halfedge twin = t.connectivity.twin(h);
  const Laid k = lay_out(t, h), m = lay_out(t, twin);
  const double base = k.base, mx = base - m.x;
  // The diagonals' intersection, affinely: (i v_i + j v_j) = (k v_k + m v_m), both sums 1.
  const double wk = m.y / (k.y + m.y), wm = 1 - wk;
  const double wj = (wk * k.x + wm * mx) / base;
  const double diagonal = std::hypot(k.x - mx, k.y + m.y);
  t.log.add_flip(h, twin, 1 - wj, wj, wk, wm);
  const Halfedge hn = h.next(), hp = h.prev(), tn = twin.next(), tp = twin.prev();
  const auto& l = t.log_length;
  const double jk = l[hn.index()], ki = l[hp.index()], im = l[tn.index()], mj = l[tp.index()];
  t.connectivity.flip(h);
  t.log_length[hn.index()] = ki, t.log_length[hp.index()] = im;
  t.log_length[tn.index()] = mj, t.log_length[tp.index()] = jk;
  set_length(t, h, std::log(diagonal));
  ++t.euclidean_flips;
}

/// True when the quadrilateral round h is strictly convex, so that its other diagonal exists.
bool is_convex(const IntrinsicTriangulation& t, Halfedge h) {
  const Halfedge twin = t.connectivity.twin(h);
  if (twin.face() == h.face()) {
    return false;
  }
  const Laid k = lay_out(t, h), m = lay_out(t, twin);
  const double height = k.y + m.y;
  if (!(height > 0)) {
    return false;
  }
  const double crossing = (k.x * m.y + (k.base - m.x) * k.y) / height;
  return crossing > 0 && crossing < k.base;
}

void flip_to_delaunay(IntrinsicTriangulation& t, std::vector<Halfedge> stack) {
  while (!stack.empty()) {
    const Halfedge h = stack.back();
    stack.pop_back();
    if (cotangent_sum(t, h) >= -delaunay_tolerance || !is_convex(t, h)) {
      continue;
    }
    euclidean_flip(t, h);
    const Halfedge twin = t.connectivity.twin(h);
    stack.insert(stack.end(), {h.next(), h.prev(), twin.next(), twin.prev()});
  }
}

/// The mean of the sizes at the ends of h.
double wanted_length(const IntrinsicTriangulation& t, const std::vector<double>& size, Halfedge h) {
  return (size[t.connectivity.origin(h).index()] + size[t.connectivity.head(h).index()]) / 2;
}

/// Faces in an order in which neighbours stay near each other while faces are added.
class FaceOrder {
 public:
  explicit FaceOrder(std::size_t faces) : next_(faces) {
    for (std::size_t f = 0; f < faces; ++f) {
      next_[f] = static_cast<std::int32_t>(f + 1 < faces ? f + 1 : 0);
    }
  }
  /// Requires the added face to have the next number.
  void put_after(Face f, Face added) {
    next_.push_back(next_[f.index()]);
    next_[f.index()] = added.id;
  }
  /// The places of all faces, from face 0 on.
  [[nodiscard]] std::vector<Face> numbers() const {
    std::vector<Face> out(next_.size());
    std::int32_t place = 0, f = 0;
    do {
      out[static_cast<std::size_t>(f)] = {place++};
      f = next_[static_cast<std::size_t>(f)];
    } while (f != 0);
    return out;
  }

 private:
  std::vector<std::int32_t> next_;
};

/// Face f gets the number to[f].
void renumber_faces(IntrinsicTriangulation& t, const std::vector<Face>& to) {
  t.connectivity.renumber_faces(to);
  const std::vector<double> old = t.log_length;
  for (std::size_t i = 0; i < old.size(); ++i) {
    t.log_length[3 * to[i / 3].index() + i % 3] = old[i];
  }
  t.log.renumber(to);
}

void mollify(std::vector<double>& length) {
  double mean = 0, missing = 0;
  std::size_t degenerate = 0;
  for (const double l : length) {
    mean += l / static_cast<double>(length.size());
  }
  for (std::size_t f = 0; f < length.size(); f += 3) {
    bool flat = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const double c = length[f + i], a = length[f + (i + 1) % 3], b = length[f + (i + 2) % 3];
      const double room = (a - c) + b;
      flat = flat || room <= least_room * std::max({a, b, c});
      missing = std::max(missing, mollified_room * mean - room);
    }
    degenerate += flat ? 1 : 0;
  }
  if (degenerate == 0) {
    return;
  }
  if (3 * degenerate == length.size()) {
    throw InvalidInput("no face has an area; check the units and the export");
  }
  for (double& l : length) {
    l += missing;
  }
}

}  // namespace

IntrinsicTriangulation intrinsic_triangulation(const TriangleMesh& mesh) {
  IntrinsicTriangulation t;
  t.connectivity = Connectivity(mesh.positions.size(), mesh.faces);
  // In units of the largest coordinate difference, so that no square over- or underflows.
  double unit = 0;
  const Position& first = mesh.positions.front();
  for (const Position& p : mesh.positions) {
    for (std::size_t i = 0; i < 3; ++i) {
      unit = std::max(unit, std::abs(p[i] / 2 - first[i] / 2));
    }
  }
  if (!(unit > 0)) {
    throw InvalidInput("all vertices lie at one point; check the units and the export");
  }
  std::vector<double> length;
  length.reserve(3 * mesh.faces.size());
  for (const Corners& f : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Position& p = mesh.positions[static_cast<std::size_t>(f[i])];
      const Position& q = mesh.positions[static_cast<std::size_t>(f[(i + 1) % 3])];
      const auto d = [&](std::size_t c) { return (q[c] / 2 - p[c] / 2) / unit; };
      length.push_back(2 * std::hypot(d(0), d(1), d(2)));
    }
  }
  mollify(length);
  t.log_length.reserve(length.size());
  for (const double l : length) {
    t.log_length.push_back(std::log(l) + std::log(unit));
  }
  return t;
}

void make_euclidean_delaunay(IntrinsicTriangulation& t) {
  std::vector<Halfedge> all;
  for (std::size_t i = t.connectivity.halfedge_count(); i-- > 0;) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (t.connectivity.is_canonical(h)) {
      all.push_back(h);
    }
  }
  flip_to_delaunay(t, std::move(all));
}

void refine(IntrinsicTriangulation& t, std::vector<double>& size, std::vector<double>& log_scale) {
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry> queue;
  const auto push = [&](Halfedge h) {
    const double l = t.log_length[h.index()];
    if (l > std::log(wanted_length(t, size, h))) {
      queue.push({l, h.id});
    }
  };
  for (std::size_t i = 0; i < t.connectivity.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (t.connectivity.is_canonical(h)) {
      push(h);
    }
  }
  FaceOrder order(t.connectivity.face_count());
  while (!queue.empty()) {
    const auto [l, id] = queue.top();
    queue.pop();
    const Halfedge h{id};
    if (t.log_length[h.index()] != l) {
      continue;
    }
    const Halfedge twin = t.connectivity.twin(h);
    const Laid k = lay_out(t, h), m = lay_out(t, twin);
    const double half = l - std::numbers::ln2;
    const double to_k = std::log(std::hypot(k.x - k.base / 2, k.y));
    const double to_m = std::log(std::hypot(m.x - m.base / 2, m.y));
    const double jk = t.log_length[h.next().index()], mj = t.log_length[twin.prev().index()];
    const auto faces = static_cast<std::int32_t>(t.connectivity.face_count());
    const std::array<Face, 2> added{Face{faces}, Face{faces + 1}};
    size.push_back(wanted_length(t, size, h));
    log_scale.push_back(
        (log_scale[t.connectivity.origin(h).index()] + log_scale[t.connectivity.head(h).index()]) /
        2);
    t.connectivity.split_edge(h);
    t.log.add_split(h, twin, added);
    ++t.splits;
    t.log_length.resize(t.connectivity.halfedge_count());
    order.put_after(h.face(), added[0]);
    order.put_after(twin.face(), added[1]);
    const auto a = halfedges(added[0]), b = halfedges(added[1]);
    set_length(t, h, half), set_length(t, a[0], half);
    set_length(t, h.next(), to_k), set_length(t, twin.prev(), to_m);
    t.log_length[a[1].index()] = jk, t.log_length[b[2].index()] = mj;
    const std::size_t flips_before = t.log.size();
    const std::vector<Halfedge> rim{h.prev(), a[1], twin.next(), b[2]};
    flip_to_delaunay(t, rim);
    // Edges that moved to another number, by the split or by a flip, lost their entries.
    for (std::size_t c = flips_before; c < t.log.size(); ++c) {
      const Halfedge f = t.log.changes()[c].h, g = t.log.changes()[c].t;
      for (const Halfedge e : {f, f.next(), f.prev(), g.next(), g.prev()}) {
        push(e);
      }
    }
    for (const Halfedge g : {h, h.next(), a[0], a[1], b[2], twin.prev()}) {
      push(g);
    }
  }
  renumber_faces(t, order.numbers());
}

std::vector<double> euclidean_vertex_areas(const IntrinsicTriangulation& t) {
  std::vector<double> out(t.connectivity.vertex_count());
  for (std::size_t f = 0; f < t.connectivity.face_count(); ++f) {
    const auto side = halfedges({static_cast<std::int32_t>(f)});
    const double area =
        triangle_determinant({0}, {length(t, side[0]), length(t, side[1]), length(t, side[2])}) / 2;
    for (const Halfedge h : side) {
      out[t.connectivity.origin(h).index()] += area / 3;
    }
  }
  return out;
}

void ptolemy_flip(IntrinsicTriangulation& t, Halfedge h) {
  const Halfedge twin = t.connectivity.twin(h);
  const Halfedge hn = h.next(), hp = h.prev(), tn = twin.next(), tp = twin.prev();
  const auto& l = t.log_length;
  const double ij = l[h.index()];
  const double jk = l[hn.index()], ki = l[hp.index()], im = l[tn.index()], mj = l[tp.index()];
  const double p = ki + mj, q = jk + im, top = std::max(p, q);
  const double km = top + std::log1p(std::exp(std::min(p, q) - top)) - ij;
  // Light-cone vectors: l_jk l_jm v_i + l_ik l_im v_j = l_ij/l_km (l_im l_jm v_k + l_ik l_jk v_m).
  const std::array<double, 4> c{jk + mj, ki + im, ij - km + im + mj, ij - km + ki + jk};
  const double scale = *std::max_element(c.begin(), c.end());
  t.log.add_flip(h, twin, std::exp(c[0] - scale), std::exp(c[1] - scale), std::exp(c[2] - scale),
                 std::exp(c[3] - scale));
  t.connectivity.flip(h);
  t.log_length[hn.index()] = ki, t.log_length[hp.index()] = im;
  t.log_length[tn.index()] = mj, t.log_length[tp.index()] = jk;
  set_length(t, h, km);
  ++t.ptolemy_flips;
}

}  // namespace ucvt
