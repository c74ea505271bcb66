// The boundaries of the Voronoi cells as curves on T.
#pragma once

#include <vector>

#include "conformal/overlay.h"
#include "conformal/uniformize.h"
#include "triangulation/delaunay.h"

namespace ucvt {

/// Traces every boundary between two cells over T, from Voronoi vertex to Voronoi vertex: curve n
/// belongs to the n-th canonical halfedge of D, and its sides bear the sites' numbers; node f is the
/// Voronoi vertex of D's face f. Site i's frame in D and in places[i] is one and the same.
///
/// Voronoi vertices are kept `margin` off T's edges, in barycentric terms, and those nearer to each
/// other than 100 times that are taken for one place: a tracer then never has to tell by rounding
/// where it ends. Throws NumericalError when a tracer misses its end all the same.
CurveNetwork cell_curves(const Uniformized& t, const DelaunayTriangulation& d,
                         const std::vector<Place>& places, double margin);

}  // namespace ucvt
