// The Voronoi diagram of the sites and their copies in the neighbour domains, the paper's way.
//
// Hyperbolic: a power diagram in the Klein disk. The site s becomes the point t = s/(2 sqrt(1 - s^2))
// with weight w^2 = s^2/(4 (1 - s^2)) - 1/sqrt(1 - s^2) (the paper's section 3.1), and the dual of the
// diagram is the lower hull of (t, t^2 - w^2) = (x/2, y/2, z), the site's Minkowski point. The paper
// gives that to CGAL, which decides exactly; Qhull works in doubles and z grows like exp(distance) to
// 1e11, so the hull is taken after a projective map that keeps it, (x, y, z) -> (x, y, z - 1)/(1 + z):
// Poincare coordinates w and w^2. Plane: Delaunay triangles, w and w^2 as well. Sphere: the hull of the
// sites themselves.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "paper_method/fundamental_domain.h"
#include "triangulation/delaunay.h"
#include "ucvt/mesh.h"

namespace ucvt::paper {

struct Diagram {
  std::size_t sites = 0;           ///< point i is a lift of site i % sites
  std::vector<ModelPoint> points;  ///< the sites, then their copies, neighbour by neighbour
  std::vector<Corners> triangles;  ///< Delaunay, counterclockwise, numbers of points

  [[nodiscard]] std::int32_t site(std::int32_t point) const {
    return point % static_cast<std::int32_t>(sites);
  }
};

Diagram diagram(const FundamentalDomain& domain, const std::vector<PlacedSite>& sites);

/// Neighbours of each site itself in the diagram, counterclockwise, the first one twice unless the
/// cell is open; empty when the site's triangles do not form one fan.
std::vector<std::vector<std::int32_t>> neighbours(const Diagram& d);

/// The triangles modulo the deck group, sorted, each as three sites in that of its three orders which
/// comes first: those of which the first site is not a copy.
///
/// A triangle of three times the same site is there up to three times, or not at all.
std::vector<Corners> quotient(const Diagram& d);

/// D's triangles, written likewise.
std::vector<Corners> quotient(const DelaunayTriangulation& d);

}  // namespace ucvt::paper
