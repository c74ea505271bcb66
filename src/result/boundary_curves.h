// The boundary of a surface as curves between corners, and where sites start on it and inside.
#pragma once

#include <cstdint>
#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

/// The boundary cut at its corners. An arc runs along vertices of the mesh with the surface on its
/// left, from corner to corner; round a loop without corners it comes back to its first vertex.
struct BoundaryCurves {
  std::vector<std::vector<std::int32_t>> arcs;
  std::vector<std::vector<std::size_t>> loops;  ///< numbers of the arcs of each loop, in order
  std::vector<bool> is_corner;                  ///< by vertex of the mesh
};

/// Corners are the boundary's vertices where it turns by more than 30 degrees, and still does when
/// it is looked at over half the spacing either way: a jagged boundary has no corner at every tooth.
/// Of several so close to each other the sharpest one is a corner.
BoundaryCurves boundary_curves(const TriangleMesh& mesh, double spacing);

/// A site on the boundary: at a vertex of the mesh to begin with.
struct BoundarySite {
  std::int32_t vertex = 0;
  std::size_t arc = 0;  ///< that it lies in or begins
  bool fixed = false;   ///< a corner
};

/// Sites at all corners and between them at about the spacing, three at least on every loop; loop by
/// loop, in order along it.
std::vector<std::vector<BoundarySite>> boundary_sites(const TriangleMesh& mesh,
                                                      const BoundaryCurves& curves, double spacing);

/// n vertices off the boundary, each as far as possible from the boundary's sites and those before it
/// by shortest paths along edges; fewer when the mesh has no more.
std::vector<std::int32_t> inner_sites(const TriangleMesh& mesh, const BoundaryCurves& curves,
                                      const std::vector<std::vector<BoundarySite>>& boundary,
                                      std::size_t n);

/// The point of the arc that is nearest to p.
Position nearest_on_arc(const TriangleMesh& mesh, const std::vector<std::int32_t>& arc,
                        const Position& p);

}  // namespace ucvt
