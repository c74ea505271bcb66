// Curves on T, and the way they lie on the input: the exact overlay of both.
//
// The curves and the edges of the triangulation make one planar map (planar_map.h). Undoing the record
// of changes replaces an edge by the other diagonal of its quadrilateral in that map, which is a matter
// of combinatorics: nodes' coordinates say which way the restored diagonal takes through the regions,
// and whatever way they say, the map stays one of the same surface. docs/mapping-back.md.
#pragma once

#include <array>
#include <vector>

#include "conformal/change_log.h"
#include "conformal/planar_map.h"

namespace ucvt {

/// Where a curve leaves a face of T: the side it crosses, and the weights of the side's two ends.
struct CurveCrossing {
  Halfedge side;
  double at_origin = 0, at_head = 0;
};

/// A curve between two nodes of a network, straight in every face of T.
struct Curve {
  std::int32_t left = 0, right = 0;  ///< what the curve separates, by any numbers >= 0
  std::vector<CurveCrossing> crossings;
};

/// Curves that meet in nodes of degree 3 and nowhere else. Weights are those of the log's changes.
struct CurveNetwork {
  /// The ends at a node, counterclockwise: 2 c where curve c starts, 2 c + 1 where it ends.
  using Ends = std::array<std::int32_t, 3>;
  std::vector<HomogeneousPoint> nodes;
  std::vector<Ends> ends;
  std::vector<Curve> curves;
};

class Overlay {
 public:
  /// Lays the network over T.
  Overlay(const Connectivity& t, const CurveNetwork& network);

  /// True when the map is one of a surface of this Euler number, T's: curves then meet in their nodes
  /// only, and leave those in the network's order. `undo` keeps it so.
  [[nodiscard]] bool is_embedded(std::int64_t euler_number) const;

  /// Carries the network from after the last change to before the first one. The first `euclidean`
  /// changes are Euclidean flips and splits, the others Ptolemy flips. Throws NumericalError when the
  /// whole network lies inside one face.
  void undo(const ChangeLog& log, std::size_t euclidean);

  struct Corner {
    Node node;
    std::array<double, 3> bary{};  ///< in the face, sum 1
  };
  /// A part of a face that no curve crosses; corners counterclockwise.
  struct Region {
    std::int32_t label = -1;  ///< as the curves round it say; -1: none passes through the face
    std::vector<Corner> corners;
  };
  /// The regions of a face. Vertex v of the triangulation is node v.
  void regions_of(Face f, std::vector<Region>& out);

  [[nodiscard]] std::size_t node_count() const { return nodes_.size(); }

 private:
  enum class Kind : char { Vertex, Edge, Inner };
  struct NodeData {
    Kind kind = Kind::Inner;
    bool bend = false;  ///< of an edge's node: the curve is not straight there
    /// Inner: by the face's round. Edge: of the edge's ends behind and ahead of `forward`.
    std::array<double, 3> weight{};
    Dart forward;
  };
  /// A dart's origin in the quadrilateral of a change.
  struct QuadPoint {
    std::array<double, 4> weight{};  ///< of i, j, k, m
    double beyond = 0;               ///< positive on k's side of the line ij, negative on m's
    int side = 0;                    ///< 1: on k's side, -1: on m's, 0: on the line
  };
  using Sides = std::array<Halfedge, 3>;
  using FaceCorners = std::array<std::array<double, 4>, 3>;

  [[nodiscard]] NodeData& at(Node n) { return nodes_[n.index()]; }
  [[nodiscard]] bool is_curve(Dart d) const { return label_[d.index()] >= 0; }
  [[nodiscard]] QuadPoint& point(Dart d) { return points_[point_of_[d.index()]]; }
  void set_point(Dart d, const QuadPoint& p);
  Node add_node(const NodeData& data);
  void grow();

  void put_crossings(const Connectivity& t, const CurveNetwork& network);
  void put_curves(std::size_t first_node, const CurveNetwork& network);

  /// Calls visit(arriving, leaving) for every node on a side, with the side's darts there.
  template <class Visit>
  void for_side(Halfedge side, Visit visit) {
    Dart arriving = anchor_[side.index()];
    while (at(map_.head(arriving)).kind == Kind::Edge) {
      const Dart leaving = map_.next(map_.next(arriving).twin());
      visit(arriving, leaving);
      arriving = leaving;
    }
  }
  /// Calls visit(leaving) for every inner node of a face, with a dart that starts there.
  template <class Visit>
  void for_inner(const Sides& sides, Visit visit);
  [[nodiscard]] bool is_crossed(Halfedge side) {
    return at(map_.head(anchor_[side.index()])).kind == Kind::Edge;
  }

  void gather(const Sides& sides, const FaceCorners& corners, const std::array<int, 3>& side_of,
              const Change& c);
  void settle(const Change& c);
  void undo_flip(const Change& c);
  void undo_split(const Change& c);
  void remove_side(Halfedge side);
  void dissolve(Node n);
  void draw_diagonal(const Change& c, Dart from, Dart to);
  [[nodiscard]] std::array<double, 2> crossing(Dart g, const Change& c);
  Dart cross(Dart tip, Dart g, const Change& c);
  void extend(Dart tip, Dart to, const Change& c);
  [[nodiscard]] std::vector<Dart> way_round(Dart tip, Dart to) const;

  PlanarMap map_;
  std::vector<NodeData> nodes_;
  std::vector<Node> free_nodes_;
  std::vector<std::int32_t> label_;  ///< by dart: on its left; -1: of an edge of the triangulation
  std::vector<Dart> anchor_;         ///< by halfedge of the triangulation: its first dart

  // Scratch of one change or one face.
  std::vector<QuadPoint> points_;
  std::vector<std::uint32_t> point_of_;  ///< by dart
  std::vector<std::uint32_t> stamp_;     ///< by node
  std::vector<std::int32_t> taken_;      ///< by dart: the face it was last listed for
  std::uint32_t visit_ = 0;
  std::vector<Dart> stack_, darts_;

  // Only while being built: by curve and crossing, the edge's darts that arrive and leave there.
  struct Joint {
    Dart arriving, leaving;
  };
  std::vector<std::vector<Joint>> joints_;
};

template <class Visit>
void Overlay::for_inner(const Sides& sides, Visit visit) {
  ++visit_;
  stack_.clear();
  for (const Halfedge side : sides) {
    for_side(side, [&](Dart arriving, Dart) { stack_.push_back(map_.next(arriving)); });
  }
  while (!stack_.empty()) {
    const Dart back = stack_.back().twin();
    stack_.pop_back();
    const Node n = map_.origin(back);
    if (at(n).kind != Kind::Inner || stamp_[n.index()] == visit_) {
      continue;
    }
    stamp_[n.index()] = visit_;
    visit(back);
    for (Dart d = map_.next(back.twin()); d != back; d = map_.next(d.twin())) {
      stack_.push_back(d);
    }
  }
}

}  // namespace ucvt
