#include "cvt/surface_cells.h"

#include <algorithm>
#include <optional>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "cvt/cell_walk.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// A neighbour is nearer only when it is by more than this part of its own height: ties stay where
/// they are, and handing a vertex on ends.
constexpr double least_gain = 1e-14;

/// Two points of a frame are the ends of an edge when their squared chord is its own within this part.
constexpr double same_chord2 = 1e-3;

/// Faces of one task. Fixed, so that sums do not depend on the number of threads.
constexpr std::size_t chunk_size = 2048;

/// h at half the distance of a point at height h.
double half_way(Space s, double h) {
  return h / 2 / (1 + std::sqrt(1 - s.kappa * h / 2));
}

/// Cells looked at for one face, at most; far more than a face that resolves its density meets.
constexpr std::size_t most_visits = 5000;

using Triangle = std::array<Offset, 3>;

struct Share {
  Vertex site;
  Moments moments;
};

}  // namespace

Stars::Stars(const DelaunayTriangulation& d) {
  const Connectivity& c = d.connectivity();
  first_.reserve(c.vertex_count() + 1);
  offset_.reserve(c.halfedge_count());
  neighbour_.reserve(c.halfedge_count());
  for (std::size_t i = 0; i < c.vertex_count(); ++i) {
    first_.push_back(offset_.size());
    double least = HUGE_VAL, most = 0;
    c.for_outgoing({static_cast<std::int32_t>(i)}, [&](Halfedge h) {
      offset_.push_back(d.offset(h));
      neighbour_.push_back({d.frame_change(h), c.head(h)});
      least = std::min(least, d.offset(h).h);
      most = std::max(most, d.offset(h).h);
    });
    reach_.push_back(std::sqrt(2 * most));
    inner_h_.push_back(half_way(d.space(), least));
  }
  first_.push_back(offset_.size());
}

void SurfaceCells::settle(Lift& lift) const {
  const Space s = t_->space();
  for (std::size_t step = 0; step <= lifts_.size() + stars_.site_count(); ++step) {
    if (lift.at.h < stars_.inner_h(lift.owner)) {
      return;
    }
    const auto offsets = stars_.offsets(lift.owner);
    std::size_t best = offsets.size();
    double most = 0;
    for (std::size_t j = 0; j < offsets.size(); ++j) {
      const double beyond = beyond_bisector(s, lift.at, offsets[j]);
      if (beyond > most && beyond > least_gain * offsets[j].h) {
        most = beyond, best = j;
      }
    }
    if (best == offsets.size()) {
      return;
    }
    const Stars::Neighbour& n = stars_.neighbours(lift.owner)[best];
    lift = {on_quadric(s, n.frame.apply_inverse(s, lift.at)), n.site};
  }
  throw NumericalError("the cell that holds a vertex of the surface was not found");
}

SurfaceCells::SurfaceCells(const UniformSurface& t, const DelaunayTriangulation& d,
                           const std::vector<Place>& places)
    : t_(&t), stars_(d), lifts_(t.connectivity().vertex_count()) {
  CellWalk walk(t);
  std::vector<Offset> neighbours;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vertex site{static_cast<std::int32_t>(i)};
    const auto offsets = stars_.offsets(site);
    neighbours.assign(offsets.begin(), offsets.end());
    for (const auto& face : walk.faces(places[i], neighbours)) {
      for (std::size_t k = 0; k < 3; ++k) {
        Lift& lift = lifts_[t.connectivity().origin(halfedges(face.place.face)[k]).index()];
        if (face.outside[k] == 0 || lift.owner.id < 0) {
          lift = {face.place.corner[k], site};
        }
      }
    }
  }
  if (std::any_of(lifts_.begin(), lifts_.end(),
                  [](const Lift& lift) { return lift.owner.id < 0; })) {
    throw NumericalError("a vertex of the surface lies in no cell");
  }
  follow(d, std::vector<Offset>(places.size()));
}

void SurfaceCells::follow(const DelaunayTriangulation& d, std::span<const Offset> reached) {
  stars_ = Stars(d);
  const Space s = t_->space();
  tbb::parallel_for(std::size_t{0}, lifts_.size(), [&](std::size_t v) {
    Lift& lift = lifts_[v];
    lift.at = on_quadric(s, transvect_back(s, reached[lift.owner.index()], lift.at));
    settle(lift);
  });
}

/// One thread's pass over faces; gathers what they add to the cells they meet.
class SurfaceCells::Sweep {
 public:
  Sweep(const SurfaceCells& cells, const SurfaceMass& mass, const std::vector<Place>& places)
      : cells_(cells),
        t_(*cells.t_),
        space_(cells.t_->space()),
        mass_(mass),
        places_(places),
        slot_(places.size(), -1) {}

  void run(std::size_t first, std::size_t last, std::vector<Share>& out) {
    for (std::size_t f = first; f < last; ++f) {
      add({static_cast<std::int32_t>(f)}, out);
    }
    for (const Share& s : out) {
      slot_[s.site.index()] = -1;
    }
  }

 private:
  /// A cell that may meet the face at hand, with the face's corners in its site's frame.
  struct Visit {
    Vertex site;
    Triangle corner;
    std::size_t first = 0, size = 0;  ///< of its part of the face, in points_
  };

  Moments& of(Vertex site, std::vector<Share>& out) {
    std::int32_t& slot = slot_[site.index()];
    if (slot < 0) {
      slot = static_cast<std::int32_t>(out.size());
      out.push_back({site, {}});
    }
    return out[static_cast<std::size_t>(slot)].moments;
  }

  [[nodiscard]] const Lift& lift(Face f, std::size_t i) const {
    return cells_.lifts_[t_.connectivity().origin(halfedges(f)[i]).index()];
  }

  /// True when p and q, in the frame of the site, can be the ends of h: lifts of another edge are
  /// farther apart.
  [[nodiscard]] bool joins(Halfedge h, Vertex site, const Offset& p, const Offset& q) const {
    if (space_.kappa > 0) {
      return true;
    }
    const double chord = t_.chord(h), gap = std::abs(chord2(space_, p, q) - chord * chord);
    if (gap < same_chord2 * chord * chord) {
      return true;
    }
    const double rounding = lift_rounding(space_, p, cells_.stars_.reach(site));
    return gap < rounding * (2 * chord + rounding);
  }

  /// Bound on the squared chord between two lifts of corner 0 of the face that are one.
  [[nodiscard]] double near2(Face f, Vertex site, const Offset& p) const {
    const double chord = t_.chord(halfedges(f)[0]);
    return same_lift2(chord * chord, lift_rounding(space_, p, cells_.stars_.reach(site)));
  }

  void add(Face f, std::vector<Share>& out) {
    const Lift &a = lift(f, 0), &b = lift(f, 1), &c = lift(f, 2);
    if (a.owner == b.owner && b.owner == c.owner) {
      const auto side = halfedges(f);
      if (joins(side[0], a.owner, a.at, b.at) && joins(side[1], a.owner, b.at, c.at) &&
          joins(side[2], a.owner, c.at, a.at)) {
        of(a.owner, out) += moments_of(mass_.weights(f), {a.at, b.at, c.at});
        return;
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (lift(f, (i + 1) % 3).owner == lift(f, (i + 2) % 3).owner && add_cut_corner(f, i, out)) {
        return;
      }
    }
    visit_cells(f);
    share_out(f, out);
  }

  /// The usual face that straddles cells: corner i alone lies in one cell, its part is a triangle, and
  /// the other corners' cell has the rest. False when it is not so.
  ///
  /// The cut runs between points where both sites are nearest, so that all corners of the rest lie in
  /// the other cell, which is convex.
  bool add_cut_corner(Face f, std::size_t i, std::vector<Share>& out) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Lift &at = lift(f, i), &next = lift(f, j), &last = lift(f, k);
    const auto side = halfedges(f);
    const auto neighbours = cells_.stars_.neighbours(at.owner);
    const auto offsets = cells_.stars_.offsets(at.owner);
    if (at.owner == next.owner || !joins(side[j], next.owner, next.at, last.at)) {
      return false;
    }
    Triangle corner;
    corner[i] = at.at;
    std::size_t across = 0;
    for (; across < neighbours.size(); ++across) {
      if (neighbours[across].site == next.owner) {
        corner[j] = neighbours[across].frame.apply(space_, next.at);
        corner[k] = neighbours[across].frame.apply(space_, last.at);
        if (joins(side[i], at.owner, at.at, corner[j]) &&
            joins(side[k], at.owner, corner[k], at.at)) {
          break;
        }
      }
    }
    if (across == neighbours.size()) {
      return false;
    }
    const auto value = [&](std::size_t n, std::size_t v) {
      return beyond_bisector(space_, corner[v], offsets[n]);
    };
    const double here = value(across, i), there = value(across, j), beyond = value(across, k);
    if (!(here < 0 && there > 0 && beyond > 0)) {
      return false;
    }
    const double p = here / (here - there), q = here / (here - beyond);
    for (std::size_t n = 0; n < offsets.size(); ++n) {
      const double v = value(n, i);
      if (n != across && (v + p * (value(n, j) - v) > 0 || v + q * (value(n, k) - v) > 0)) {
        return false;
      }
    }
    std::array<Barycentric, 3> b{{{0, 0}, {1, 0}, {0, 1}}};
    const auto between = [&](std::size_t v, double s) {
      return Barycentric{b[i].b1 + s * (b[v].b1 - b[i].b1), b[i].b2 + s * (b[v].b2 - b[i].b2)};
    };
    const Weights piece = integrate_piece(space_, t_.triangle(f), mass_.corner_densities(f), b[i],
                                          between(j, p), between(k, q));
    of(at.owner, out) += moments_of(piece, corner);
    Weights rest = mass_.weights(f);
    rest -= piece;
    corner[i] = neighbours[across].frame.apply_inverse(space_, at.at);
    corner[j] = next.at;
    corner[k] = last.at;
    of(next.owner, out) += moments_of(rest, corner);
    return true;
  }

  /// Where the end of h other than `from` lies in the frame of the cell that `from` is given in: by
  /// its own lift there, or in the cell of a neighbour.
  [[nodiscard]] std::optional<Offset> other_end(Halfedge h, const Lift& from,
                                                const Lift& other) const {
    if (other.owner == from.owner && joins(h, from.owner, from.at, other.at)) {
      return other.at;
    }
    for (const Stars::Neighbour& n : cells_.stars_.neighbours(from.owner)) {
      if (n.site == other.owner) {
        const Offset p = n.frame.apply(space_, other.at);
        if (joins(h, from.owner, from.at, p)) {
          return p;
        }
      }
    }
    return std::nullopt;
  }

  /// The face's corners in the frame of corner i's owner, when T or D shows them nearby.
  [[nodiscard]] std::optional<Triangle> corners_about(Face f, std::size_t i) const {
    const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
    const auto side = halfedges(f);
    const Lift& at = lift(f, i);
    Triangle out;
    out[i] = at.at;
    const auto p = other_end(side[i], at, lift(f, next));
    const auto q = other_end(side[last], at, lift(f, last));
    if (!p && !q) {
      return std::nullopt;
    }
    out[next] = p ? *p : t_.develop(t_.connectivity().twin(side[last]), at.at, *q);
    out[last] = q && (!p || joins(side[next], at.owner, *p, *q))
                    ? *q
                    : t_.develop(t_.connectivity().twin(side[i]), *p, at.at);
    return out;
  }

  /// The same by developing T over the whole cell of corner 0's owner: for faces larger than cells.
  [[nodiscard]] Triangle corners_by_walk(Face f) {
    const Lift& at = lift(f, 0);
    if (!walk_) {
      walk_.emplace(t_);
    }
    const auto offsets = cells_.stars_.offsets(at.owner);
    neighbours_.assign(offsets.begin(), offsets.end());
    // The nearest lift: others are farther than rounding has carried this one.
    const CellWalk::Developed* best = nullptr;
    double least = HUGE_VAL;
    for (const auto& d : walk_->faces(places_[at.owner.index()], neighbours_)) {
      const double gap = d.place.face == f ? chord2(space_, d.place.corner[0], at.at) : HUGE_VAL;
      if (gap < least) {
        least = gap, best = &d;
      }
    }
    if (best == nullptr) {
      throw NumericalError("a face of the surface was not met by the cell of its corner");
    }
    return best->place.corner;
  }

  [[nodiscard]] Visit first_visit(Face f) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (const auto corners = corners_about(f, i)) {
        return {lift(f, i).owner, *corners};
      }
    }
    return {lift(f, 0).owner, corners_by_walk(f)};
  }

  /// Cuts the face by all cells that meet it, from neighbour to neighbour; their parts go to points_.
  void visit_cells(Face f) {
    visits_.clear();
    points_.clear();
    visits_.push_back(first_visit(f));
    bool any_part = false;
    for (std::size_t n = 0; n < visits_.size(); ++n) {
      if (n == most_visits) {
        throw NumericalError("the cells that meet a face of the surface do not end");
      }
      clip(visits_[n]);
      visits_[n].first = points_.size();
      visits_[n].size = polygon_.size() < 3 ? 0 : polygon_.size();
      points_.insert(points_.end(), polygon_.begin(),
                     polygon_.begin() + static_cast<std::ptrdiff_t>(visits_[n].size));
      // The cells that meet a face hang together: one that does not leads nowhere.
      any_part = any_part || visits_[n].size > 0;
      if (any_part && visits_[n].size == 0) {
        continue;
      }
      const auto neighbours = cells_.stars_.neighbours(visits_[n].site);
      for (const std::size_t j : cutting_) {
        const Stars::Neighbour& next = neighbours[j];
        const Triangle& corner = visits_[n].corner;
        const Offset first = next.frame.apply_inverse(space_, corner[0]);
        if (!was_visited(f, next.site, first)) {
          visits_.push_back({next.site,
                             {first, next.frame.apply_inverse(space_, corner[1]),
                              next.frame.apply_inverse(space_, corner[2])}});
        }
      }
    }
  }

  /// Whether the cell of the site, where it knows corner 0 at `first`, was visited.
  [[nodiscard]] bool was_visited(Face f, Vertex site, const Offset& first) const {
    const double near = near2(f, site, first);
    return std::any_of(visits_.begin(), visits_.end(), [&](const Visit& old) {
      return old.site == site && (space_.kappa > 0 || chord2(space_, old.corner[0], first) < near);
    });
  }

  /// Leaves the part of the face in the cell in polygon_, and the neighbours that cut it in cutting_.
  void clip(const Visit& visit) {
    polygon_ = {{0, 0}, {1, 0}, {0, 1}};
    cutting_.clear();
    const auto offsets = cells_.stars_.offsets(visit.site);
    for (std::size_t j = 0; j < offsets.size() && !polygon_.empty(); ++j) {
      const Triangle& x = visit.corner;
      const double at[3] = {beyond_bisector(space_, x[0], offsets[j]),
                            beyond_bisector(space_, x[1], offsets[j]),
                            beyond_bisector(space_, x[2], offsets[j])};
      if (at[0] <= 0 && at[1] <= 0 && at[2] <= 0) {
        continue;
      }
      if (cut(at)) {
        cutting_.push_back(j);
      }
    }
  }

  /// Cuts polygon_ where a function linear over the face, given at its corners, is positive.
  bool cut(const double (&at)[3]) {
    const auto value = [&](const Barycentric& b) {
      return (1 - b.b1 - b.b2) * at[0] + b.b1 * at[1] + b.b2 * at[2];
    };
    bool any = false;
    clipped_.clear();
    Barycentric p = polygon_.back();
    double p_value = value(p);
    for (const Barycentric& q : polygon_) {
      const double q_value = value(q);
      if ((p_value > 0) != (q_value > 0)) {
        const double s = p_value / (p_value - q_value);
        clipped_.push_back({p.b1 + s * (q.b1 - p.b1), p.b2 + s * (q.b2 - p.b2)});
      }
      if (q_value <= 0) {
        clipped_.push_back(q);
      } else {
        any = true;
      }
      p = q, p_value = q_value;
    }
    polygon_.swap(clipped_);
    return any;
  }

  /// Integrates the parts of the face; the one with the most corners gets what the others leave.
  void share_out(Face f, std::vector<Share>& out) {
    std::size_t rest = 0;
    for (std::size_t n = 1; n < visits_.size(); ++n) {
      if (visits_[n].size > visits_[rest].size) {
        rest = n;
      }
    }
    const ChordTriangle triangle = t_.triangle(f);
    const auto rho = mass_.corner_densities(f);
    Weights left = mass_.weights(f);
    for (std::size_t n = 0; n < visits_.size(); ++n) {
      const Visit& v = visits_[n];
      if (n == rest || v.size == 0) {
        continue;
      }
      Weights piece;
      const Barycentric* p = points_.data() + v.first;
      for (std::size_t i = 1; i + 1 < v.size; ++i) {
        piece += integrate_piece(space_, triangle, rho, p[0], p[i], p[i + 1]);
      }
      of(v.site, out) += moments_of(piece, v.corner);
      left -= piece;
    }
    of(visits_[rest].site, out) += moments_of(left, visits_[rest].corner);
  }

  const SurfaceCells& cells_;
  const UniformSurface& t_;
  const Space space_;
  const SurfaceMass& mass_;
  const std::vector<Place>& places_;
  std::vector<std::int32_t> slot_;  // by site: its share in the chunk at hand, or -1
  std::vector<Visit> visits_;
  std::vector<Barycentric> points_, polygon_, clipped_;
  std::vector<std::size_t> cutting_;
  std::optional<CellWalk> walk_;
  std::vector<Offset> neighbours_;
};

std::vector<Moments> SurfaceCells::moments(const SurfaceMass& mass,
                                           const std::vector<Place>& places) const {
  const std::size_t faces = t_->connectivity().face_count();
  const std::size_t chunks = (faces + chunk_size - 1) / chunk_size;
  std::vector<std::vector<Share>> shares(chunks);
  tbb::enumerable_thread_specific<Sweep> sweeps([&] { return Sweep(*this, mass, places); });
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t k) {
    sweeps.local().run(k * chunk_size, std::min(faces, (k + 1) * chunk_size), shares[k]);
  });
  std::vector<Moments> out(places.size());
  for (const auto& chunk : shares) {
    for (const Share& s : chunk) {
      out[s.site.index()] += s.moments;
    }
  }
  return out;
}

}  // namespace ucvt
