// The Delaunay triangulation of sites in a polygon of the plane or the hyperbolic plane, and their
// Voronoi cells clipped by the polygon.
//
// The bisector of two sites is linear in central coordinates, so the diagram is that of the lower
// hull of the sites' offsets (x, y, h) in one frame: the paraboloid, or the hyperboloid itself. The
// hull comes from Qhull and says who may be whose neighbour; cells are then clipped in the frame of
// their own site, where nothing cancels. Aurenhammer 1987; section 5 of the paper.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "triangulation/frame.h"
#include "ucvt/spaces.h"

namespace ucvt {

/// Who may be whose neighbour, and the triangles whose circumcentre lies in the polygon.
struct PolygonDelaunay {
  std::vector<std::size_t> start;       ///< site i has neighbour[start[i]] to neighbour[start[i+1]]
  std::vector<std::int32_t> neighbour;  ///< ascending for each site; symmetric
  /// Three sites each, counterclockwise, the smallest number first, in lexicographic order.
  std::vector<std::array<std::int32_t, 3>> triangles;

  [[nodiscard]] std::span<const std::int32_t> neighbours(std::size_t site) const {
    return std::span(neighbour).subspan(start[site], start[site + 1] - start[site]);
  }
};

/// The Delaunay triangulation of sites in a polygon.
///
/// The neighbours include every site whose bisector bounds the cell within the polygon, and some
/// whose does not. Requires a polygon domain that contains the sites. Throws InvalidInput when two
/// sites coincide or the domain is no polygon.
PolygonDelaunay delaunay_in_polygon(const Domain& domain, const std::vector<ModelPoint>& sites);

/// A site's cell in its own frame, with what lies across its sides.
struct PolygonCell {
  std::vector<Offset> corner;        ///< counterclockwise
  std::vector<std::int32_t> across;  ///< side i, corner i to i + 1: the site there, or -1: none
};

/// The polygon clipped to what is nearer to the origin of `frame` than to each of the neighbours.
/// Requires the origin to lie in the polygon; corners are those of model_corners(domain).
PolygonCell clipped_cell(const std::vector<ModelPoint>& corners, const Frame& frame,
                         const std::vector<ModelPoint>& sites,
                         std::span<const std::int32_t> neighbours);

}  // namespace ucvt
