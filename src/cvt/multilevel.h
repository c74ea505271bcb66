// A multilevel start: a small CVT first, then from level to level sites at the middles of D's edges.
#pragma once

#include <cstdint>
#include <vector>

#include "triangulation/delaunay.h"

namespace ucvt {

/// The levels of a multilevel start: splitting all edges takes n - chi sites, chi the Euler number,
/// to four times as many.
struct LevelPlan {
  int coarsest = 0;  ///< sites of the first level
  int levels = 0;    ///< splittings from there to the number asked for
};

/// The plan whose last splitting leaves out fewest edges, with a first level of 32 to 160 sites where
/// that can be.
LevelPlan plan_levels(int sites, std::int64_t euler_number);

/// Sites of the level after which `levels_left` splittings lead to the number asked for, or a few more:
/// what is too many is left out where that is fewest.
int sites_on_level(int sites, std::int64_t euler_number, int levels_left);

/// So many of D's edges, or all: those longest for their surroundings first.
std::vector<Halfedge> longest_edges(const DelaunayTriangulation& d, std::size_t most);

}  // namespace ucvt
