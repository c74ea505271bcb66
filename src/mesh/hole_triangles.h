// Triangles that close a hole: of all triangulations of its loop the one of least area.
//
// Source: G. Barequet, M. Sharir, "Filling gaps in the boundary of a polyhedron", Computer Aided
// Geometric Design 12(2), 1995, without their matching of borders.
#pragma once

#include <functional>
#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

/// Triangles on the numbers 0 to n - 1 of the loop's corners, in its direction; none when every
/// triangulation has a forbidden diagonal, or when the best folds over itself: its faces' area
/// vectors add up to less than half its area. Takes time in O(n^3). Requires n >= 3.
std::vector<Corners> hole_triangles(
    const std::vector<Position>& loop,
    const std::function<bool(std::size_t, std::size_t)>& is_forbidden);

}  // namespace ucvt
