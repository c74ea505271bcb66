// The restricted Voronoi diagram that the paper's figure 19 compares with: the Voronoi diagram of sites
// in space, by Euclidean distance, cut with a surface.
//
// Every triangle is clipped to the cells that meet it by the bisectors of the sites near each, nearest
// first, until the next site is twice as far as any corner of what is left (the security radius: Levy,
// Bonneel 2013; the method: Yan, Levy, Liu, Sun, Wang 2009). Cells are met from neighbour to neighbour.
#pragma once

#include <vector>

#include "ucvt/mesh.h"

namespace ucvt::restricted {

struct Cell {
  double area = 0;
  Position centroid{};  ///< of its part of the surface; off the surface where that is curved
  int parts = 0;        ///< connected components
};

struct Diagram {
  std::vector<Cell> cells;  ///< one a site
  /// Three sites for every three cells that meet in a point of the surface; each three once, in the
  /// orientation of the first such point found.
  std::vector<Corners> dual;
};

/// Requires a closed surface (`closed_surface`) and sites that differ, in general position.
Diagram restricted_voronoi(const TriangleMesh& mesh, const std::vector<Position>& sites);

}  // namespace ucvt::restricted
