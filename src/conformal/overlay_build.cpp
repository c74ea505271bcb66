// Laying a network of curves over T.
#include <algorithm>
#include <compare>

#include "conformal/overlay.h"

namespace ucvt {

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

}  // namespace ucvt
