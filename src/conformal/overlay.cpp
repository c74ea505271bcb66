#include "conformal/overlay.h"

#include <algorithm>

#include "ucvt/error.h"

namespace ucvt {
namespace {

[[noreturn]] void refuse_inside() {
  throw NumericalError("all boundaries of cells lie inside one face; ask for more sites");
}

}  // namespace

void Overlay::grow() {
  label_.resize(map_.dart_count(), -1);
  point_of_.resize(map_.dart_count(), 0);
  stamp_.resize(nodes_.size(), 0);
}

Node Overlay::add_node(const NodeData& data) {
  if (free_nodes_.empty()) {
    nodes_.push_back(data);
    return {static_cast<std::int32_t>(nodes_.size() - 1)};
  }
  const Node n = free_nodes_.back();
  free_nodes_.pop_back();
  at(n) = data;
  return n;
}

void Overlay::set_point(Dart d, const QuadPoint& p) {
  point_of_[d.index()] = static_cast<std::uint32_t>(points_.size());
  points_.push_back(p);
}

/// Finds where the origins of all darts of a face lie in the quadrilateral (i, j, k, m), given what
/// the face's corners and sides are there; of sides on neither side of ij, coordinates decide.
void Overlay::gather(const Sides& sides, const FaceCorners& corners,
                     const std::array<int, 3>& side_of, const Change& c) {
  const auto make = [&](const std::array<double, 3>& w, std::size_t first, int side) {
    QuadPoint p;
    for (std::size_t n = 0; n < 3; ++n) {
      for (std::size_t q = 0; q < 4; ++q) {
        p.weight[q] += w[n] * corners[(first + n) % 3][q];
      }
    }
    p.beyond = p.weight[2] * c.m - p.weight[3] * c.k;
    p.side = side != 0 ? side : p.beyond >= 0 ? 1 : -1;
    return p;
  };
  for (std::size_t s = 0; s < 3; ++s) {
    for_side(sides[s], [&](Dart arriving, Dart leaving) {
      const NodeData& n = at(map_.origin(leaving));
      const bool ahead = n.forward == leaving;
      const double a = n.weight[ahead ? 0 : 1], b = n.weight[ahead ? 1 : 0];
      set_point(map_.next(arriving), make({a, b, 0}, s, side_of[s]));
      point_of_[leaving.index()] = point_of_[map_.next(arriving).index()];
    });
  }
  for_inner(sides, [&](Dart leaving) {
    const auto& w = at(map_.origin(leaving)).weight;
    const auto first = static_cast<std::size_t>(sides[0].id % 3);
    set_point(leaving, make({w[first], w[(first + 1) % 3], w[(first + 2) % 3]}, 0, 0));
    for (Dart d = map_.next(leaving.twin()); d != leaving; d = map_.next(d.twin())) {
      point_of_[d.index()] = point_of_[leaving.index()];
    }
  });
}

/// Gives the inner nodes of the two restored faces their weights there.
void Overlay::settle(const Change& c) {
  const auto put = [&](Halfedge h, std::size_t a, std::size_t b, std::size_t apex, double rate,
                       std::size_t other, double other_rate) {
    for_inner({h, h.next(), h.prev()}, [&](Dart leaving) {
      // Trade the corner opposite to the face for i and j, as ChangeLog::undo does.
      const auto& w = point(leaving).weight;
      const double traded = other_rate > 0 ? w[other] / other_rate : 0;
      const std::array<double, 2> gain{traded * c.i, traded * c.j};
      const double wa = w[a] + gain[a], wb = w[b] + gain[b];
      const double wc = std::max(0.0, w[apex] - traded * rate), sum = wa + wb + wc;
      auto& out = at(map_.origin(leaving)).weight;
      out[static_cast<std::size_t>(h.id % 3)] = wa / sum;
      out[static_cast<std::size_t>(h.next().id % 3)] = wb / sum;
      out[static_cast<std::size_t>(h.prev().id % 3)] = wc / sum;
    });
  };
  put(c.h, 0, 1, 2, c.k, 3, c.m);
  put(c.t, 1, 0, 3, c.m, 2, c.k);
}

/// Removes an edge of the triangulation; curves run on through its nodes.
void Overlay::remove_side(Halfedge side) {
  darts_.assign(1, anchor_[side.index()]);
  for_side(side, [&](Dart arriving, Dart leaving) {
    darts_.push_back(leaving);
    at(map_.origin(leaving)).forward = map_.next(arriving);
  });
  std::vector<Node> nodes;
  for (std::size_t n = 1; n < darts_.size(); ++n) {
    nodes.push_back(map_.origin(darts_[n]));
  }
  for (const Dart d : darts_) {
    map_.remove(d);
  }
  for (const Node n : nodes) {
    // Within one geometry the curve is straight, and the node tells nothing.
    at(n).bend ? static_cast<void>(at(n).kind = Kind::Inner) : dissolve(n);
  }
}

/// Joins the two edges at a node of degree 2.
void Overlay::dissolve(Node n) {
  const Dart leaving = at(n).forward, back = map_.next(leaving.twin());
  const Node far = map_.head(leaving);
  if (at(far).forward == leaving.twin()) {
    at(far).forward = back;
  }
  point_of_[back.index()] = point_of_[leaving.twin().index()];
  map_.dissolve_head(back.twin());
  free_nodes_.push_back(n);
}

void Overlay::undo_flip(const Change& c) {
  const Halfedge hn = c.h.next(), hp = c.h.prev(), tn = c.t.next(), tp = c.t.prev();
  if (is_crossed(c.h) && !is_crossed(hn) && !is_crossed(hp) && !is_crossed(tn) && !is_crossed(tp)) {
    refuse_inside();
  }
  points_.clear();
  gather({c.h, hn, hp}, {{{0, 0, 0, 1}, {0, 0, 1, 0}, {1, 0, 0, 0}}}, {0, 1, -1}, c);
  gather({c.t, tn, tp}, {{{0, 0, 1, 0}, {0, 0, 0, 1}, {0, 1, 0, 0}}}, {0, -1, 1}, c);
  remove_side(c.h);
  const Dart ki = anchor_[hn.index()], im = anchor_[hp.index()];
  const Dart mj = anchor_[tn.index()], jk = anchor_[tp.index()];
  anchor_[hn.index()] = jk, anchor_[hp.index()] = ki;
  anchor_[tn.index()] = im, anchor_[tp.index()] = mj;
  draw_diagonal(c, im, jk);
  settle(c);
}

void Overlay::undo_split(const Change& c) {
  const Halfedge hn = c.h.next(), hp = c.h.prev(), tn = c.t.next(), tp = c.t.prev();
  const auto a = halfedges(c.added[0]), b = halfedges(c.added[1]);
  const bool crossed = is_crossed(c.h) || is_crossed(a[0]);
  if ((is_crossed(hn) && !crossed && !is_crossed(hp) && !is_crossed(a[1])) ||
      (is_crossed(tp) && !crossed && !is_crossed(tn) && !is_crossed(b[2]))) {
    refuse_inside();
  }
  const std::array<double, 4> i{1, 0, 0, 0}, j{0, 1, 0, 0}, k{0, 0, 1, 0}, m{0, 0, 0, 1};
  const std::array<double, 4> n{0.5, 0.5, 0, 0};
  points_.clear();
  gather({c.h, hn, hp}, {{i, n, k}}, {}, c);
  gather({c.t, tn, tp}, {{n, i, m}}, {}, c);
  gather({a[0], a[1], a[2]}, {{n, j, k}}, {}, c);
  gather({b[0], b[1], b[2]}, {{j, n, m}}, {}, c);
  for (const Halfedge half : {c.h, a[0]}) {
    for_side(half, [&](Dart, Dart leaving) {
      const auto& w = point(leaving).weight;
      NodeData& data = at(map_.origin(leaving));
      const bool ahead = data.forward == leaving;
      data.weight = {w[ahead ? 0 : 1], w[ahead ? 1 : 0], 0};
    });
  }
  remove_side(hn);
  remove_side(tp);
  // The added vertex has two edges left, along ij; the one towards j goes.
  const Dart nj = anchor_[a[0].index()], jn = anchor_[b[0].index()];
  const Node added = map_.origin(nj);
  at(added).forward = nj;
  anchor_[c.t.index()] = jn == nj.twin() ? map_.next(nj.twin()) : jn;
  dissolve(added);
  anchor_[hn.index()] = anchor_[a[1].index()];
  anchor_[tp.index()] = anchor_[b[2].index()];
  settle(c);
}

void Overlay::undo(const ChangeLog& log, std::size_t euclidean) {
  for (std::size_t n = log.size(); n-- > 0;) {
    if (n + 1 == euclidean) {
      // From here on lines are straight in another geometry.
      for (NodeData& data : nodes_) {
        data.bend = true;
      }
    }
    const Change& c = log.changes()[n];
    c.added[0].id < 0 ? undo_flip(c) : undo_split(c);
  }
  const std::vector<Dart> renumbered = anchor_;
  for (std::size_t i = 0; i < anchor_.size(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const Face f = log.first_name(h.face());
    anchor_[3 * f.index() + i % 3] = renumbered[i];
  }
}

}  // namespace ucvt
