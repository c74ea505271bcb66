#include "conformal/overlay.h"

#include <algorithm>
#include <tuple>

#include "ucvt/error.h"

namespace ucvt {
namespace {

[[noreturn]] void refuse_inside() {
  throw NumericalError("all boundaries of cells lie inside one face; ask for more sites");
}

}  // namespace

Overlay::Overlay(const Connectivity& t, const CurveNetwork& network) : anchor_(t.halfedge_count()) {
  nodes_.resize(t.vertex_count(), {Kind::Vertex, false, {}, {}});
  for (const HomogeneousPoint& p : network.nodes) {
    nodes_.push_back({Kind::Inner, false, p.weight, {}});
  }
  for (std::size_t i = 0; i < t.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (t.is_canonical(h)) {
      const Dart d = map_.add_edge({t.origin(h).id}, {t.head(h).id});
      anchor_[h.index()] = d, anchor_[t.twin(h).index()] = d.twin();
    }
  }
  for (std::size_t i = 0; i < t.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    map_.link(anchor_[i], anchor_[h.next().index()]);
  }
  put_crossings(t, network);
  label_.resize(map_.dart_count(), -1);
  put_curves(t.vertex_count(), network);
  joints_ = {};
  grow();
}

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

/// Nodes on T's edges, where curves cross them, in their order along each edge.
void Overlay::put_crossings(const Connectivity& t, const CurveNetwork& network) {
  struct Place {
    Halfedge edge;
    double along;
    std::size_t curve, crossing;
    auto operator<=>(const Place&) const = default;
  };
  std::vector<Place> places;
  joints_.resize(network.curves.size());
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    const auto& crossings = network.curves[c].crossings;
    joints_[c].resize(crossings.size());
    for (std::size_t k = 0; k < crossings.size(); ++k) {
      const CurveCrossing& x = crossings[k];
      const bool ahead = t.is_canonical(x.side);
      const double sum = x.at_origin + x.at_head;
      places.push_back(
          {ahead ? x.side : t.twin(x.side), (ahead ? x.at_head : x.at_origin) / sum, c, k});
    }
  }
  std::sort(places.begin(), places.end());
  Halfedge edge;
  Dart piece;
  for (const Place& p : places) {
    if (p.edge != edge) {
      edge = p.edge, piece = anchor_[edge.index()];
    }
    const CurveCrossing& x = network.curves[p.curve].crossings[p.crossing];
    const bool ahead = x.side == edge;
    const double sum = x.at_origin + x.at_head, a = x.at_origin / sum, b = x.at_head / sum;
    const Node n = add_node({Kind::Edge, true, {ahead ? a : b, ahead ? b : a, 0}, {}});
    const Dart on = map_.split(piece, n);
    at(n).forward = on;
    anchor_[t.twin(edge).index()] = on.twin();
    joints_[p.curve][p.crossing] = ahead ? Joint{piece, on} : Joint{on.twin(), piece.twin()};
    piece = on;
  }
}

/// The curves, piece by piece, each linked at its ends as T's edges and the network's order say.
void Overlay::put_curves(std::size_t first_node, const CurveNetwork& network) {
  std::vector<Dart> end(2 * network.curves.size());
  std::vector<Node> node(end.size());
  for (std::size_t n = 0; n < network.ends.size(); ++n) {
    for (const std::int32_t e : network.ends[n]) {
      node[static_cast<std::size_t>(e)] = {static_cast<std::int32_t>(first_node + n)};
    }
  }
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    Node from = node[2 * c];
    Dart before;
    for (std::size_t k = 0; k <= joints_[c].size(); ++k) {
      const bool last = k == joints_[c].size();
      const Node to = last ? node[2 * c + 1] : map_.head(joints_[c][k].arriving);
      const Dart d = map_.add_edge(from, to);
      label_.resize(map_.dart_count(), -1);
      label_[d.index()] = network.curves[c].left;
      label_[d.twin().index()] = network.curves[c].right;
      if (k == 0) {
        end[2 * c] = d;
      } else {
        const auto [arriving, leaving] = joints_[c][k - 1];
        map_.link(arriving, before.twin()), map_.link(before, leaving);
        map_.link(leaving.twin(), d), map_.link(d.twin(), arriving.twin());
      }
      before = d, from = to;
    }
    end[2 * c + 1] = before.twin();
  }
  for (const CurveNetwork::Ends& e : network.ends) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Dart d = end[static_cast<std::size_t>(e[i])];
      map_.link(d.twin(), end[static_cast<std::size_t>(e[(i + 2) % 3])]);
    }
  }
}

bool Overlay::is_embedded(std::int64_t euler_number) const {
  bool crossed = false;
  std::int64_t nodes = 0, edges = 0, regions = 0;
  std::vector<bool> seen(map_.dart_count()), met(nodes_.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    Dart d{static_cast<std::int32_t>(i)};
    const Node n = map_.origin(d);
    if (n.id < 0) {
      continue;
    }
    crossed = crossed || nodes_[n.index()].kind == Kind::Edge;
    nodes += met[n.index()] ? 0 : 1;
    met[n.index()] = true;
    edges += i % 2 == 0 ? 1 : 0;
    regions += seen[i] ? 0 : 1;
    for (; !seen[d.index()]; d = map_.next(d)) {
      seen[d.index()] = true;
    }
  }
  return crossed && nodes - edges + regions == euler_number;
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
  const auto a = halfedges(c.added), b = halfedges({c.added.id + 1});
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
    c.added.id < 0 ? undo_flip(c) : undo_split(c);
  }
}

}  // namespace ucvt
