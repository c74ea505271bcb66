#include "cvt/straddling_faces.h"

#include <algorithm>

#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Cells looked at for one face, at most; far more than a face that resolves its density meets.
constexpr std::size_t most_visits = 5000;

Barycentric between(const Barycentric& p, const Barycentric& q, double s) {
  return {p.b1 + s * (q.b1 - p.b1), p.b2 + s * (q.b2 - p.b2)};
}

}  // namespace

void StraddlingFaces::add(Face f, CellShares& out) {
  const auto v = t_.vertex_order().corners(f);
  for (std::size_t i = 0; i < 3; ++i) {
    lift_[i] = {lifts_.at[v[i]], lifts_.owner[v[i]]};
  }
  visit_cells(f);
  share_out(f, out);
}

/// Where the end of h other than `from` lies in the frame of the cell that `from` is given in: by
/// its own lift there, or in the cell of a neighbour.
std::optional<Offset> StraddlingFaces::other_end(Halfedge h, const Lift& from,
                                                 const Lift& other) const {
  if (other.owner == from.owner && is_edge(h, from.owner, from.at, other.at)) {
    return other.at;
  }
  const auto sites = stars_.sites(from.owner);
  for (std::size_t n = 0; n < sites.size(); ++n) {
    if (sites[n] == other.owner) {
      const Offset p = stars_.frames(from.owner)[n].apply(space_, other.at);
      if (is_edge(h, from.owner, from.at, p)) {
        return p;
      }
    }
  }
  return std::nullopt;
}

/// The face's corners in the frame of corner i's owner, when T or D shows them nearby.
std::optional<StraddlingFaces::Triangle> StraddlingFaces::corners_about(Face f,
                                                                        std::size_t i) const {
  const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
  const auto side = halfedges(f);
  const Lift& at = lift_[i];
  Triangle out;
  out[i] = at.at;
  const auto p = other_end(side[i], at, lift_[next]);
  const auto q = other_end(side[last], at, lift_[last]);
  if (!p && !q) {
    return std::nullopt;
  }
  out[next] = p ? *p : t_.develop(t_.connectivity().twin(side[last]), at.at, *q);
  out[last] = q && (!p || is_edge(side[next], at.owner, *p, *q))
                  ? *q
                  : t_.develop(t_.connectivity().twin(side[i]), *p, at.at);
  return out;
}

/// The same by developing T over the owner's whole cell: for faces larger than cells. A face that
/// touches the cell in a corner only may not be met there.
std::optional<StraddlingFaces::Triangle> StraddlingFaces::corners_by_walk(Face f, std::size_t i) {
  const Lift& at = lift_[i];
  if (!walk_) {
    walk_.emplace(t_);
  }
  const auto offsets = stars_.offsets(at.owner);
  neighbours_.assign(offsets.begin(), offsets.end());
  // The nearest lift: others are farther than rounding has carried this one.
  const CellWalk::Developed* best = nullptr;
  double least = HUGE_VAL;
  for (const auto& d : walk_->faces(places_[at.owner.index()], neighbours_)) {
    const double gap = d.place.face == f ? chord2(space_, d.place.corner[i], at.at) : HUGE_VAL;
    if (gap < least) {
      least = gap, best = &d;
    }
  }
  return best == nullptr ? std::nullopt : std::optional(best->place.corner);
}

StraddlingFaces::Visit StraddlingFaces::first_visit(Face f) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (const auto corners = corners_about(f, i)) {
      return {lift_[i].owner, *corners};
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (const auto corners = corners_by_walk(f, i)) {
      return {lift_[i].owner, *corners};
    }
  }
  throw NumericalError("a face of the surface was not met by the cells of its corners");
}

/// Cuts the face by all cells that meet it, from neighbour to neighbour; their parts go to points_.
void StraddlingFaces::visit_cells(Face f) {
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
    const auto sites = stars_.sites(visits_[n].site);
    const auto frames = stars_.frames(visits_[n].site);
    for (const std::size_t j : cutting_) {
      const Triangle& corner = visits_[n].corner;
      const Offset first = frames[j].apply_inverse(space_, corner[0]);
      if (!was_visited(f, sites[j], first)) {
        visits_.push_back({sites[j],
                           {first, frames[j].apply_inverse(space_, corner[1]),
                            frames[j].apply_inverse(space_, corner[2])}});
      }
    }
  }
}

/// Whether the cell of the site, where it knows corner 0 at `first`, was visited.
bool StraddlingFaces::was_visited(Face f, Vertex site, const Offset& first) const {
  for (const Visit& old : visits_) {
    if (old.site != site) {
      continue;
    }
    const double chord = t_.chord(halfedges(f)[0]);
    const double rounding = lift_rounding(space_, first, stars_.reach(site));
    if (space_.kappa > 0 ||
        chord2(space_, old.corner[0], first) < same_lift2(chord * chord, rounding)) {
      return true;
    }
  }
  return false;
}

/// Leaves the part of the face in the cell in polygon_, and the neighbours that cut it in cutting_.
void StraddlingFaces::clip(const Visit& visit) {
  polygon_ = {{0, 0}, {1, 0}, {0, 1}};
  cutting_.clear();
  const auto offsets = stars_.offsets(visit.site);
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
bool StraddlingFaces::cut(const double (&at)[3]) {
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
      clipped_.push_back(between(p, q, s));
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

/// Integrates the parts of the face; the one with the most corners gets what the others leave. The
/// corners' shares are taken back.
void StraddlingFaces::share_out(Face f, CellShares& out) {
  std::size_t rest = 0;
  for (std::size_t n = 1; n < visits_.size(); ++n) {
    if (visits_[n].size > visits_[rest].size) {
      rest = n;
    }
  }
  const FacePieces& face = mass_.pieces(f);
  Weights left = face.weights;
  for (std::size_t n = 0; n < visits_.size(); ++n) {
    const Visit& v = visits_[n];
    if (n == rest || v.size == 0) {
      continue;
    }
    Weights piece;
    const Barycentric* p = points_.data() + v.first;
    for (std::size_t i = 1; i + 1 < v.size; ++i) {
      piece += integrate_piece(space_, face.triangle, face.density, p[0], p[i], p[i + 1]);
    }
    out.of(v.site) += moments_of(space_, piece, v.corner);
    left -= piece;
  }
  out.of(visits_[rest].site) += moments_of(space_, left, visits_[rest].corner);
  for (std::size_t i = 0; i < 3; ++i) {
    out.of(lift_[i].owner) -= face.share(i).moments(space_, lift_[i].at);
  }
}

}  // namespace ucvt
