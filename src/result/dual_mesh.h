// The dual of a tessellation: a triangle mesh with the sites as vertices.
#pragma once

#include <vector>

#include "conformal/uniformize.h"
#include "triangulation/delaunay.h"

namespace ucvt {

/// D's faces over the sites' positions on the input surface: closed, oriented, of the input's genus.
TriangleMesh dual_mesh(const Uniformized& t, const DelaunayTriangulation& d,
                       const std::vector<SurfacePoint>& sites);

/// Halfedges of D that keep it from being a simplicial complex: loops, and all but the shortest of
/// several edges between the same two sites. One halfedge for each such edge.
std::vector<Halfedge> edges_not_simplicial(const DelaunayTriangulation& d);

}  // namespace ucvt
