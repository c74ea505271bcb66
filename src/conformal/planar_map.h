// How the pieces of curves drawn on a closed surface hang together: nodes, edges and regions.
//
// Every edge is a pair of darts, one for each direction; a dart has a region on its left, and the next
// dart runs on round that region. Regions need not be stored: they are the rounds. All changes are
// local and keep the map one of the same surface, whatever the nodes' coordinates are.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

namespace ucvt {

struct Node {
  std::int32_t id = -1;
  auto operator<=>(const Node&) const = default;
  [[nodiscard]] std::size_t index() const { return static_cast<std::size_t>(id); }
};

struct Dart {
  std::int32_t id = -1;
  auto operator<=>(const Dart&) const = default;
  [[nodiscard]] std::size_t index() const { return static_cast<std::size_t>(id); }
  /// The same edge in the other direction.
  [[nodiscard]] Dart twin() const { return {id ^ 1}; }
};

class PlanarMap {
 public:
  /// Darts ever made; removed ones are used again.
  [[nodiscard]] std::size_t dart_count() const { return origin_.size(); }
  /// Id -1: the dart was removed.
  [[nodiscard]] Node origin(Dart d) const { return origin_[d.index()]; }
  [[nodiscard]] Node head(Dart d) const { return origin_[d.twin().index()]; }
  [[nodiscard]] Dart next(Dart d) const { return next_[d.index()]; }
  [[nodiscard]] Dart prev(Dart d) const { return prev_[d.index()]; }

  /// An edge that is not linked to anything yet; returns its dart from a to b.
  Dart add_edge(Node a, Node b);

  /// Makes b the next dart after a.
  void link(Dart a, Dart b) {
    next_[a.index()] = b;
    prev_[b.index()] = a;
  }

  /// Puts a node on the edge of d, which then ends there; returns the dart that goes on from it.
  Dart split(Dart d, Node n);

  /// Cuts the region that a and b go round by an edge between their origins; returns its dart from a's
  /// to b's, which has b's part of the region on its left.
  Dart connect(Dart a, Dart b);

  /// Removes the edge of d; the regions on its two sides become one.
  void remove(Dart d);

  /// Lets d run on over its next dart, from whose origin no other edge starts; that one is removed.
  void dissolve_head(Dart d);

 private:
  void release(Dart d);

  std::vector<Node> origin_;
  std::vector<Dart> next_, prev_;
  std::vector<Dart> free_;
};

}  // namespace ucvt
