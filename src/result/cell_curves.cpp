#include "result/cell_curves.h"

#include <algorithm>
#include <cmath>

#include "mesh/disjoint_sets.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Two lifts of one point are the same when their squared chord is below this part of a face's.
constexpr double same_lift2 = 1e-3;

/// Faces looked at round the place where a Voronoi vertex was expected.
constexpr std::size_t search_limit = 200;

constexpr double coincidence_per_margin = 100;

/// A face of T laid out in some frame.
struct LaidFace {
  Face face;
  std::array<Offset, 3> corner;
};

LaidFace across(const UniformSurface& t, const LaidFace& from, std::size_t side) {
  const Halfedge h = halfedges(from.face)[side], twin = t.connectivity().twin(h);
  const auto j = static_cast<std::size_t>(twin.id % 3);
  LaidFace out{twin.face(), {}};
  out.corner[j] = from.corner[(side + 1) % 3];
  out.corner[(j + 1) % 3] = from.corner[side];
  out.corner[(j + 2) % 3] = t.develop(h, from.corner[side], from.corner[(side + 1) % 3]);
  return out;
}

/// The side that comes from a line's right and goes to its left, given how far left of it the corners
/// lie; a line that misses the face by rounding takes the corner it comes nearest to with it.
std::size_t exit_side(std::array<double, 3> left) {
  const auto nearest = static_cast<std::size_t>(
      std::min_element(left.begin(), left.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      left.begin());
  const bool all_left = left[0] > 0 && left[1] > 0 && left[2] > 0;
  const bool all_right = left[0] <= 0 && left[1] <= 0 && left[2] <= 0;
  if (all_left || all_right) {
    left[nearest] = all_left ? -1 : 1;
  }
  std::size_t side = 0;
  while (side < 2 && !(left[side] <= 0 && left[side + 1] > 0)) {
    ++side;
  }
  return side;
}

double least_chord2(const UniformSurface& t, Face f) {
  const auto side = halfedges(f);
  const double c = std::min({t.chord(side[0]), t.chord(side[1]), t.chord(side[2])});
  return c * c;
}

class Tracer {
 public:
  Tracer(const Uniformized& t, const DelaunayTriangulation& d, const std::vector<Place>& places,
         double margin)
      : u_(t), t_(t.surface), space_(t_.space()), d_(d), places_(places), margin_(margin) {}

  CurveNetwork run() {
    find_nodes();
    CurveNetwork out;
    const Connectivity& c = d_.connectivity();
    out.ends.resize(c.face_count());
    for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)};
      if (!c.is_canonical(h)) {
        continue;
      }
      const auto n = static_cast<std::int32_t>(out.curves.size());
      const Halfedge twin = c.twin(h);
      out.ends[h.face().index()][i % 3] = 2 * n;
      out.ends[twin.face().index()][static_cast<std::size_t>(twin.id % 3)] = 2 * n + 1;
      out.curves.push_back({c.head(h).id, c.origin(h).id, trace(h)});
    }
    for (const SurfacePoint& p : nodes_) {
      out.nodes.push_back({p.face, in_light_cone(p)});
    }
    return out;
  }

 private:
  /// The Voronoi vertex of h's face in the frame of h's origin.
  [[nodiscard]] Offset voronoi_vertex(Halfedge h) const {
    const Central k = circumcentre(d_.offset(h), d_.offset(d_.connectivity().rotate(h)));
    return from_central(space_, k.x, k.y);
  }

  /// Where the Voronoi vertices lie on T.
  void find_nodes() {
    const Connectivity& c = d_.connectivity();
    for (std::size_t f = 0; f < c.face_count(); ++f) {
      const Halfedge h{3 * static_cast<std::int32_t>(f)};
      const Offset at = voronoi_vertex(h);
      const LaidFace face = seen_from(walk(face_at(c.origin(h)), at), at);
      SurfacePoint p = point_of({face.face, face.corner});
      double sum = 0;
      for (double& b : p.bary) {
        sum += b = std::max(b, margin_);
      }
      for (double& b : p.bary) {
        b /= sum;
      }
      nodes_.push_back(p);
    }
    DisjointSets groups(c.face_count());
    const double near = coincidence_per_margin * margin_;
    for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)}, twin = c.twin(h);
      const double distance2 = chord2(space_, voronoi_vertex(h), voronoi_vertex(twin.next()));
      if (distance2 < near * near * least_chord2(t_, nodes_[h.face().index()].face)) {
        groups.join(h.face().id, twin.face().id);
      }
    }
    for (std::size_t f = 0; f < nodes_.size(); ++f) {
      nodes_[f] = nodes_[static_cast<std::size_t>(groups.find(static_cast<std::int32_t>(f)))];
    }
  }

  /// The node's face laid out where the node is nearest to the origin, found by going round a face
  /// there.
  [[nodiscard]] LaidFace lay_out(const SurfacePoint& node, const LaidFace& there) const {
    std::vector<LaidFace> near{there};
    std::size_t best = search_limit + 3;
    double least = HUGE_VAL;
    for (std::size_t n = 0; n < near.size(); ++n) {
      if (near[n].face == node.face) {
        const double h = point_in_frame(t_, node, near[n].corner).h;
        if (h < least) {
          least = h, best = n;
        }
        if (2 * h < same_lift2 * least_chord2(t_, node.face)) {
          break;
        }
      }
      for (std::size_t side = 0; side < 3 && near.size() < search_limit; ++side) {
        const LaidFace next = across(t_, near[n], side);
        const bool known = std::any_of(near.begin(), near.end(), [&](const LaidFace& old) {
          return old.face == next.face && chord2(space_, old.corner[0], next.corner[0]) <
                                              same_lift2 * least_chord2(t_, next.face);
        });
        if (!known) {
          near.push_back(next);
        }
      }
    }
    if (best >= near.size()) {
      throw NumericalError("a corner of a cell was not found again on the surface");
    }
    return near[best];
  }

  void check_steps(std::size_t steps) const {
    if (steps > 100 + 3 * t_.connectivity().face_count()) {
      throw NumericalError("the boundary of a cell was lost on the surface");
    }
  }

  /// Crosses a side; returns the number of the corner beyond it, whose value in `left` is to be set.
  std::size_t step(LaidFace& face, std::array<double, 3>& left, std::size_t side) const {
    const Halfedge twin = t_.connectivity().twin(halfedges(face.face)[side]);
    const auto j = static_cast<std::size_t>(twin.id % 3);
    const double right = left[side], other = left[(side + 1) % 3];
    face = across(t_, face, side);
    left[j] = other, left[(j + 1) % 3] = right;
    return (j + 2) % 3;
  }

  /// From a face round the origin straight to the face round another point. All in the frame of the
  /// origin: faces there may be smaller than what doubles tell apart in the other point's frame.
  [[nodiscard]] LaidFace walk(LaidFace face, const Offset& to) const {
    std::array<double, 3> left{};
    for (std::size_t i = 0; i < 3; ++i) {
      left[i] = cross(to, face.corner[i]);
    }
    for (std::size_t steps = 0;; ++steps) {
      const std::size_t side = exit_side(left), next = (side + 1) % 3;
      if (orientation(space_, face.corner[side], face.corner[next], to) >= 0) {
        return face;
      }
      check_steps(steps);
      const std::size_t apex = step(face, left, side);
      left[apex] = cross(to, face.corner[apex]);
    }
  }

  /// The same face in the frame carried parallel to a point.
  [[nodiscard]] LaidFace seen_from(LaidFace face, const Offset& at) const {
    for (Offset& c : face.corner) {
      c = on_quadric(space_, transvect_back(space_, at, c));
    }
    return face;
  }

  [[nodiscard]] LaidFace face_at(Vertex site) const {
    const Place& p = places_[site.index()];
    return {p.face, p.corner};
  }

  /// The curve across h's edge, from the Voronoi vertex on its left to the one on its right.
  [[nodiscard]] std::vector<CurveCrossing> trace(Halfedge h) const {
    const Halfedge twin = d_.connectivity().twin(h);
    const SurfacePoint &start = nodes_[h.face().index()], &end = nodes_[twin.face().index()];
    const Offset a = voronoi_vertex(h), b = voronoi_vertex(twin.next());
    const LaidFace there = seen_from(walk(face_at(d_.connectivity().origin(h)), a), a);
    LaidFace face = lay_out(start, there);
    const Offset ab = on_quadric(space_, transvect_back(space_, a, b));
    const Offset from = point_in_frame(t_, start, face.corner);
    const LaidFace last = lay_out(end, seen_from(walk(there, ab), ab));
    const Offset to = transvect(space_, ab, point_in_frame(t_, end, last.corner));
    std::vector<CurveCrossing> out;
    std::array<double, 3> left{};
    for (std::size_t i = 0; i < 3; ++i) {
      left[i] = orientation(space_, from, to, face.corner[i]);
    }
    while (!is_at(face, end, to)) {
      const std::size_t side = exit_side(left), next = (side + 1) % 3;
      check_steps(out.size());
      out.push_back(crossing(halfedges(face.face)[side], left[side], left[next]));
      const std::size_t apex = step(face, left, side);
      left[apex] = orientation(space_, from, to, face.corner[apex]);
    }
    return out;
  }

  [[nodiscard]] bool is_at(const LaidFace& face, const SurfacePoint& end, const Offset& to) const {
    return face.face == end.face && chord2(space_, point_in_frame(t_, end, face.corner), to) <
                                        same_lift2 * least_chord2(t_, face.face);
  }

  [[nodiscard]] double scale(Halfedge h) const {
    return u_.log_scale[t_.connectivity().origin(h).index()];
  }

  /// Chord weights at a side's ends are the determinants with the other end; exp(u) makes them those
  /// of the light cone.
  [[nodiscard]] CurveCrossing crossing(Halfedge h, double at_origin, double at_head) const {
    const double u = scale(h), v = scale(h.next()), top = std::max(u, v);
    double a = std::abs(at_head), b = std::abs(at_origin);
    if (!(a + b > 0)) {
      a = b = 1;
    }
    const double sum = a + b;
    return {h, a / sum * std::exp(u - top), b / sum * std::exp(v - top)};
  }

  [[nodiscard]] std::array<double, 3> in_light_cone(const SurfacePoint& p) const {
    const auto side = halfedges(p.face);
    const double top = std::max({scale(side[0]), scale(side[1]), scale(side[2])});
    std::array<double, 3> w{};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += w[i] = p.bary[i] * std::exp(scale(side[i]) - top);
    }
    return {w[0] / sum, w[1] / sum, w[2] / sum};
  }

  const Uniformized& u_;
  const UniformSurface& t_;
  Space space_;
  const DelaunayTriangulation& d_;
  const std::vector<Place>& places_;
  double margin_;
  std::vector<SurfacePoint> nodes_;  // by face of D
};

}  // namespace

CurveNetwork cell_curves(const Uniformized& t, const DelaunayTriangulation& d,
                         const std::vector<Place>& places, double margin) {
  return Tracer(t, d, places, margin).run();
}

}  // namespace ucvt
