// The way of a restored diagonal through the regions of its quadrilateral, and the regions at the end.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "conformal/overlay.h"

namespace ucvt {
namespace {

double share_of_second(const std::array<double, 2>& w) {
  return w[1] / (w[0] + w[1]);
}

}  // namespace

/// Where the curve of g crosses the line ij, in weights of i and j.
std::array<double, 2> Overlay::crossing(Dart g, const Change& c) {
  const QuadPoint &p = point(g), &q = point(g.twin());
  // A point between p and q, from all terms positive, and then k and m traded for i and j.
  const double a = std::abs(q.beyond), b = std::abs(p.beyond), sum = a + b;
  const double of_p = sum > 0 ? a / sum : 0.5, of_q = sum > 0 ? b / sum : 0.5;
  std::array<double, 4> x{};
  for (std::size_t n = 0; n < 4; ++n) {
    x[n] = of_p * p.weight[n] + of_q * q.weight[n];
  }
  const double most = std::max(c.k, c.m);
  const double traded = most > 0 ? (c.k >= c.m ? x[2] : x[3]) / most : 0;
  const double i = x[0] + traded * c.i, j = x[1] + traded * c.j;
  return i + j > 0 ? std::array<double, 2>{i / (i + j), j / (i + j)}
                   : std::array<double, 2>{0.5, 0.5};
}

/// The next piece of the diagonal, between the origins of two darts of one region.
void Overlay::extend(Dart tip, Dart to, const Change& c) {
  const Dart e = map_.connect(tip, to);
  grow();
  label_[e.index()] = label_[e.twin().index()] = -1;
  NodeData& from = at(map_.origin(e));
  if (from.kind == Kind::Edge) {
    from.forward = e;
  } else {
    anchor_[c.h.index()] = e;
  }
  anchor_[c.t.index()] = e.twin();
}

/// Takes the diagonal from its tip over the curve of g; returns the tip beyond it.
Dart Overlay::cross(Dart tip, Dart g, const Change& c) {
  const std::array<double, 2> w = crossing(g, c);
  const Node n = add_node({Kind::Edge, false, {w[0], w[1], 0}, {}});
  const Dart on = map_.split(g, n);
  grow();
  label_[on.index()] = label_[g.index()];
  label_[on.twin().index()] = label_[g.twin().index()];
  point_of_[on.twin().index()] = point_of_[g.twin().index()];
  set_point(on, {{w[0], w[1], 0, 0}, 0, 0});
  point_of_[g.twin().index()] = point_of_[on.index()];
  extend(tip, on, c);
  return g.twin();
}

/// Draws ij, given the darts that follow the region's corners at i and at j.
void Overlay::draw_diagonal(const Change& c, Dart from, Dart to) {
  Dart tip = from;
  while (true) {
    // The line leaves the region over a curve that comes from m's side and goes to k's.
    Dart best;
    double least = HUGE_VAL;
    bool arrived = false;
    Dart g = tip;
    do {
      arrived = arrived || g == to;
      if (is_curve(g) && point(g).side < 0 && point(g.twin()).side > 0) {
        const double along = share_of_second(crossing(g, c));
        if (best.id < 0 || along < least) {
          best = g, least = along;
        }
      }
      g = map_.next(g);
    } while (g != tip);
    if (best.id < 0 && arrived) {
      break;
    }
    if (best.id >= 0) {
      tip = cross(tip, best, c);
      continue;
    }
    // Only rounding leads into a region without a way out.
    for (const Dart over : way_round(tip, to)) {
      tip = cross(tip, over, c);
    }
    break;
  }
  extend(tip, to, c);
}

/// The fewest curves to cross from the region of one dart to that of another.
std::vector<Dart> Overlay::way_round(Dart tip, Dart to) const {
  std::unordered_map<std::int32_t, Dart> entered;  // by dart: the one crossed into its region
  const auto enter = [&](Dart first, Dart over) {
    Dart d = first;
    do {
      entered[d.id] = over;
      d = map_.next(d);
    } while (d != first);
  };
  std::vector<Dart> queue{tip};
  enter(tip, {});
  for (std::size_t n = 0; n < queue.size() && !entered.contains(to.id); ++n) {
    Dart d = queue[n];
    do {
      if (is_curve(d) && !entered.contains(d.twin().id)) {
        enter(d.twin(), d);
        queue.push_back(d.twin());
      }
      d = map_.next(d);
    } while (d != queue[n]);
  }
  std::vector<Dart> out;
  for (Dart over = entered.at(to.id); over.id >= 0; over = entered.at(over.id)) {
    out.push_back(over);
  }
  std::reverse(out.begin(), out.end());
  return out;
}

void Overlay::regions_of(Face f, std::vector<Region>& out) {
  const Sides sides = halfedges(f);
  out.clear();
  points_.clear();
  darts_.clear();
  gather(sides, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}, {1, 1, 1}, {});
  for (std::size_t s = 0; s < 3; ++s) {
    QuadPoint corner;
    corner.weight[s] = 1;
    set_point(anchor_[sides[s].index()], corner);
    darts_.push_back(anchor_[sides[s].index()]);
    for_side(sides[s], [&](Dart arriving, Dart leaving) {
      darts_.push_back(map_.next(arriving));
      darts_.push_back(leaving);
    });
  }
  for_inner(sides, [&](Dart leaving) {
    Dart d = leaving;
    do {
      darts_.push_back(d);
      d = map_.next(d.twin());
    } while (d != leaving);
  });
  // A dart is taken when its mark is this face's.
  taken_.resize(map_.dart_count(), -1);
  for (const Dart first : darts_) {
    Region region;
    for (Dart d = first; taken_[d.index()] != f.id; d = map_.next(d)) {
      taken_[d.index()] = f.id;
      region.label = std::max(region.label, label_[d.index()]);
      const auto& w = point(d).weight;
      const double sum = w[0] + w[1] + w[2];
      region.corners.push_back({map_.origin(d), {w[0] / sum, w[1] / sum, w[2] / sum}});
    }
    if (!region.corners.empty()) {
      out.push_back(std::move(region));
    }
  }
}

}  // namespace ucvt
