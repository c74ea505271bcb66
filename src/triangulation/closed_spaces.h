// The closed spaces themselves as small triangulations, for sites to be inserted into.
//
// Sphere: the octahedron. Flat torus: one vertex, two triangles. Surface of a regular 4g-gon: the
// polygon's centre and its corners, which are one vertex. DESIGN, section 2 (D).
#pragma once

#include <vector>

#include "triangulation/delaunay.h"
#include "triangulation/frame.h"

namespace ucvt {

/// A Delaunay triangulation with the model frame of each vertex: the head of a halfedge lies at the
/// halfedge's offset in its origin's frame, up to a deck transformation.
struct SpaceTriangulation {
  DelaunayTriangulation triangulation;
  std::vector<Frame> frame;
};

/// Triangulates a closed domain: sphere, torus or surface, as the makers in spaces.h give it.
///
/// The first vertex stands at the model's origin. Throws InvalidInput for a polygon.
SpaceTriangulation triangulate_closed(const Domain& domain);

/// The side that side i is glued to. Requires a torus or a surface.
std::size_t glued_side(const Domain& domain, std::size_t i);

}  // namespace ucvt
