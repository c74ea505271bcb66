// D: a Delaunay triangulation of sites on a closed surface of constant curvature, without copies.
//
// A Delta-complex in which every halfedge i -> j stores the offset of j in i's tangent frame.
// A halfedge and its twin determine the isometry between the two frames, so every change is local
// and no group table, layout or global coordinate exists. Insertion walks, removal flips the star
// down to three faces, moves carry the star along; Lawson flips restore the Delaunay condition.
#pragma once

#include <array>
#include <vector>

#include "space/offset.h"
#include "triangulation/connectivity.h"

namespace ucvt {

class DelaunayTriangulation {
 public:
  /// Takes a geodesic triangulation: the offset of every halfedge's head in its origin's frame.
  /// Requires every face to be positively oriented in all three of its corners' frames.
  DelaunayTriangulation(Space space, Connectivity connectivity, std::vector<Offset> offset)
      : space_(space), connectivity_(std::move(connectivity)), offset_(std::move(offset)) {}

  [[nodiscard]] Space space() const { return space_; }
  [[nodiscard]] const Connectivity& connectivity() const { return connectivity_; }
  [[nodiscard]] std::size_t vertex_count() const { return connectivity_.vertex_count(); }
  /// The head of h in the frame of its origin.
  [[nodiscard]] const Offset& offset(Halfedge h) const { return offset_[h.index()]; }
  [[nodiscard]] const std::vector<Offset>& offsets() const { return offset_; }

  /// Mean chord from v to its neighbours.
  [[nodiscard]] double spacing(Vertex v) const;

  /// The change of coordinates from the frame at h's head to the frame at its origin.
  [[nodiscard]] Isometry frame_change(Halfedge h) const {
    return between_frames(offset(h), offset(connectivity_.twin(h)));
  }

  /// False when the edge's circle strictly contains the opposite vertex (beyond a relative 1e-12).
  [[nodiscard]] bool is_delaunay(Halfedge h) const;

  /// Adds a vertex whose frame lies at `frame` in the frame of v, and restores Delaunay around it.
  ///
  /// The vertex takes the number `reuse` when that names a removed one. Requires the place not to
  /// coincide with a vertex. Throws NumericalError when the walk to it does not end.
  Vertex insert(Vertex v, const Isometry& frame, Vertex reuse = {});

  /// Removes v and restores Delaunay around the hole. Requires another vertex to remain; throws
  /// NumericalError when the star cannot be flipped down to three faces.
  void remove(Vertex v);

  /// Removes many vertices, as `remove`, restores Delaunay and compacts. Those of the smallest scale go
  /// first: a vertex goes while its star is of its own scale still, and no star ever spans more scales
  /// than doubles can compare.
  void remove_all(const std::vector<Vertex>& vertices);

  /// Moves v to offset `to` in its own frame, carrying the frame parallel; does not restore
  /// Delaunay. Returns false, having changed nothing, when some face would turn over.
  bool move_in_star(Vertex v, const Offset& to);

  /// Moves v anywhere: within its star when that holds, otherwise by removal and insertion.
  /// Returns where it went: `to`, or less far along the same geodesic when v can only move within its
  /// star (the only vertex of the surface; a star that spans too many scales).
  Offset move(Vertex v, const Offset& to);

  /// Lawson flips over the whole triangulation. Returns their number.
  std::int64_t make_delaunay();

  /// Drops removed vertices and faces; returns new vertex numbers by old ones.
  std::vector<Vertex> compact();

  /// Replaces the offset of a halfedge by a better value of the same: rounding grows from flip to flip,
  /// so who knows where the vertices are says so now and then. For all halfedges, or none.
  void correct(Halfedge h, const Offset& offset) { offset_[h.index()] = offset; }

  /// Gives vertex v the number to[v], a permutation.
  void renumber(const std::vector<Vertex>& to) { connectivity_.renumber(to); }

  /// Sum of the faces' areas by the angles at their corners, each in its own frame: 2 pi |chi| on
  /// the sphere and the hyperbolic plane whatever happened to the triangulation.
  [[nodiscard]] double area() const;

 private:
  void flip(Halfedge h);
  /// Leaves a valid triangulation with v in it when v cannot be removed.
  bool try_remove(Vertex v);
  [[nodiscard]] bool is_convex(Halfedge h) const;
  std::int64_t flip_to_delaunay(std::vector<Halfedge> stack);
  /// From the face of h, whose corners from h's origin on stand at x in some frame, to the face that
  /// contains that frame's origin.
  void walk(Halfedge& h, std::array<Offset, 3>& x) const;

  Space space_;
  Connectivity connectivity_;
  std::vector<Offset> offset_;
};

}  // namespace ucvt
