// The dual of a tessellation: a triangle mesh with the sites as vertices.
#pragma once

#include <vector>

#include "conformal/uniformize.h"
#include "triangulation/delaunay.h"

namespace ucvt {

/// D's faces over the sites' positions on the input surface: closed, oriented, of the input's genus.
TriangleMesh dual_mesh(const Uniformized& t, const DelaunayTriangulation& d,
                       const std::vector<SurfacePoint>& sites);

/// An edge of D that keeps it from being a simplicial complex: a loop, or any but the shortest of
/// several edges between the same two sites, which makes a loop with that one.
struct NonSimplicialEdge {
  Halfedge halfedge;
  double loop_length;  ///< in the uniform metric, by chords
};
std::vector<NonSimplicialEdge> edges_not_simplicial(const DelaunayTriangulation& d);

}  // namespace ucvt
