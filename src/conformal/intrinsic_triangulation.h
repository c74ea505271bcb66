// The input surface by its edge lengths alone, with recorded changes of its triangulation.
//
// Lengths are stored as logarithms: log scales span 50 and more on ordinary models. Until the
// surface is uniformized the lengths are Euclidean; after `uniformize` began they are Penner
// coordinates (lambda lengths), which Ptolemy flips keep consistent for every scale factor u.
#pragma once

#include <vector>

#include "conformal/change_log.h"
#include "triangulation/connectivity.h"
#include "ucvt/mesh.h"

namespace ucvt {

struct IntrinsicTriangulation {
  Connectivity connectivity;
  std::vector<double> log_length;  ///< by halfedge; twins agree
  ChangeLog log;
  std::int64_t euclidean_flips = 0, ptolemy_flips = 0, splits = 0;
};

/// The intrinsic triangulation of a closed surface in space.
///
/// Where a triangle is degenerate to rounding (zero-length edges, collinear corners) all lengths
/// grow by the least constant that gives every triangle room of 1e-5 mean edge lengths (Sharp and
/// Crane 2020); otherwise they are exact. Throws InvalidInput when all triangles are degenerate.
IntrinsicTriangulation intrinsic_triangulation(const TriangleMesh& mesh);

/// Flips to intrinsic Delaunay with Euclidean flips (Bobenko and Springborn 2007).
void make_euclidean_delaunay(IntrinsicTriangulation& t);

/// Splits edges in their middle, longest first, until none is longer than the mean of the sizes
/// wanted at its ends, keeping the triangulation Delaunay. `size` (positive, by vertex) and `log_scale` grow
/// with it: a new vertex gets the mean of the ends it lies between. Faces are renumbered, each new one next to
/// that which it was cut from: memory keeps the order of space. Requires a Delaunay triangulation.
void refine(IntrinsicTriangulation& t, std::vector<double>& size, std::vector<double>& log_scale);

/// A third of the Euclidean area of each vertex' star.
std::vector<double> euclidean_vertex_areas(const IntrinsicTriangulation& t);

/// Replaces the edge of h by the other diagonal: the length by Ptolemy's relation, which holds for
/// all vertex scalings at once (Penner 1987; Springborn 2019). Requires two distinct faces.
void ptolemy_flip(IntrinsicTriangulation& t, Halfedge h);

}  // namespace ucvt
