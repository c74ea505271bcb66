// Whether D and the sites' places on T still say the same.
//
// Both are carried along by the moves, each by its own arithmetic: the offsets of D by flips and changes
// of frames, the places by walks over T. Going from one place to the next by D's offset must lead to
// the next site; by how far it does not is the drift of the two.
#pragma once

#include <vector>

#include "triangulation/delaunay.h"
#include "triangulation/uniform_surface.h"

namespace ucvt {

struct Consistency {
  double angle_sum_rad = 0;  ///< largest difference of D's angles round a site from 2 pi
  double circle = 0;         ///< largest relative depth of a site inside a circle of D
  double place = 0;  ///< largest miss of a place reached by an offset, relative to the offset
};

/// Measures all sites and edges. Site i's frame in D and in places[i] is one and the same.
Consistency measure_consistency(const UniformSurface& t, const DelaunayTriangulation& d,
                                const std::vector<Place>& places);

}  // namespace ucvt
