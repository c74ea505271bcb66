#include "conformal/change_log.h"

#include <algorithm>

namespace ucvt {
namespace {

std::size_t slot(Halfedge h) {
  return static_cast<std::size_t>(h.id % 3);
}

/// Puts the point into the face of the three halfedges, with their origins' weights.
void place(HomogeneousPoint& p, const std::array<Halfedge, 3>& at,
           const std::array<double, 3>& weight) {
  p.face = at[0].face();
  // Ratios count; keep them in range over many thousands of changes.
  const double sum = weight[0] + weight[1] + weight[2];
  for (std::size_t i = 0; i < 3; ++i) {
    p.weight[slot(at[i])] = weight[i] / sum;
  }
}

void undo_flip(const Change& c, HomogeneousPoint& p) {
  const Halfedge hn = c.h.next(), hp = c.h.prev(), tn = c.t.next(), tp = c.t.prev();
  double wi = 0, wj = 0, wk = 0, wm = 0;
  if (p.face == c.h.face()) {
    wm = p.weight[slot(c.h)], wk = p.weight[slot(hn)], wi = p.weight[slot(hp)];
  } else {
    wk = p.weight[slot(c.t)], wm = p.weight[slot(tn)], wj = p.weight[slot(tp)];
  }
  // Trade k and m for i and j until one of the two is used up.
  const bool use_up_m = wm * c.k <= wk * c.m;
  const double used = use_up_m ? wm : wk, rate = use_up_m ? c.m : c.k;
  const double traded = rate > 0 ? used / rate : 0;
  wi += traded * c.i, wj += traded * c.j;
  if (use_up_m) {
    place(p, {c.h, hn, hp}, {wi, wj, std::max(0.0, wk - traded * c.k)});
  } else {
    place(p, {c.t, tn, tp}, {wj, wi, std::max(0.0, wm - traded * c.m)});
  }
}

void undo_split(const Change& c, HomogeneousPoint& p) {
  const Halfedge hn = c.h.next(), hp = c.h.prev(), tn = c.t.next(), tp = c.t.prev();
  const auto w = p.weight;
  if (p.face == c.h.face()) {
    const double n = w[slot(hn)] / 2;
    place(p, {c.h, hn, hp}, {w[slot(c.h)] + n, n, w[slot(hp)]});
  } else if (p.face == c.t.face()) {
    const double n = w[slot(c.t)] / 2;
    place(p, {c.t, tn, tp}, {n, w[slot(tn)] + n, w[slot(tp)]});
  } else if (p.face == c.added[0]) {
    place(p, {c.h, hn, hp}, {w[0] / 2, w[1] + w[0] / 2, w[2]});
  } else {
    place(p, {c.t, tn, tp}, {w[0] + w[1] / 2, w[1] / 2, w[2]});
  }
}

}  // namespace

void ChangeLog::undo(std::vector<HomogeneousPoint>& points) const {
  std::int32_t faces = 0;
  for (const HomogeneousPoint& p : points) {
    faces = std::max(faces, p.face.id + 1);
  }
  for (const Change& c : changes_) {
    faces = std::max(
        {faces, c.h.face().id + 1, c.t.face().id + 1, c.added[0].id + 1, c.added[1].id + 1});
  }
  // Points by face, as chains: first[f] and next[point].
  std::vector<std::int32_t> first(static_cast<std::size_t>(faces), -1), next(points.size());
  const auto link = [&](std::size_t p) {
    next[p] = first[points[p].face.index()];
    first[points[p].face.index()] = static_cast<std::int32_t>(p);
  };
  for (std::size_t p = 0; p < points.size(); ++p) {
    link(p);
  }
  std::vector<std::size_t> here;
  for (auto c = changes_.rbegin(); c != changes_.rend(); ++c) {
    here.clear();
    const auto take = [&](Face f) {
      for (std::int32_t p = first[f.index()]; p >= 0; p = next[static_cast<std::size_t>(p)]) {
        here.push_back(static_cast<std::size_t>(p));
      }
      first[f.index()] = -1;
    };
    take(c->h.face());
    take(c->t.face());
    if (c->added[0].id >= 0) {
      take(c->added[0]);
      take(c->added[1]);
    }
    for (const std::size_t p : here) {
      c->added[0].id < 0 ? undo_flip(*c, points[p]) : undo_split(*c, points[p]);
      link(p);
    }
  }
  for (HomogeneousPoint& p : points) {
    p.face = first_name(p.face);
  }
}

void ChangeLog::renumber(const std::vector<Face>& to) {
  const auto renumbered = [&to](Halfedge h) {
    return Halfedge{3 * to[h.face().index()].id + h.id % 3};
  };
  for (Change& c : changes_) {
    c.h = renumbered(c.h), c.t = renumbered(c.t);
    for (Face& f : c.added) {
      f = f.id < 0 ? f : to[f.index()];
    }
  }
  std::vector<Face> names(to.size());
  for (std::size_t f = 0; f < to.size(); ++f) {
    names[to[f].index()] =
        f < first_name_.size() ? first_name_[f] : Face{static_cast<std::int32_t>(f)};
  }
  first_name_ = std::move(names);
}

}  // namespace ucvt
