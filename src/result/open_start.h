// Where the sites of a surface with boundary start.
#pragma once

#include <vector>

#include "result/half_mesh.h"
#include "result/open_double.h"
#include "ucvt/remesh.h"

namespace ucvt {

/// Sites of the double, with what those on the boundary belong to.
struct OpenSites {
  MirrorLayout layout;
  std::vector<BoundarySite> line;               ///< by number of the sites on the line
  std::vector<std::vector<std::size_t>> loops;  ///< their numbers, in order along each loop
};

/// As many sites as the options ask for: those of the boundary at about the spacing, three on a loop and
/// one at a corner at least; inside level by level from fewer sites, or as far apart as possible where
/// the options say so, the surface is steep or the sites are few. Throws InvalidInput when there are
/// fewer sites than the boundary needs, Cancelled.
OpenSites open_start(const OpenDouble& made, const SurfaceMass& mass, double spacing,
                     const RemeshOptions& options);

/// Replaces the sites of each gap's pair by one on the boundary, where their edge crosses it.
void close_gaps(const std::vector<HalfView::Gap>& gaps, OpenSites& sites);

}  // namespace ucvt
