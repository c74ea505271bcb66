// The paper's fundamental domain and its neighbours (its sections 6.1 and 6.2).
//
// A canonical 4g-gon with geodesic sides, laid out with its middle at the centre of the Klein disk
// (torus: the plane), and the 16 g^2 - 8 g deck transformations to the domains that share a side or a
// corner with it. A sphere is its own universal cover: no sides, no neighbours.
#pragma once

#include <vector>

#include "triangulation/frame.h"
#include "triangulation/uniform_surface.h"

namespace ucvt::paper {

struct FundamentalDomain {
  double kappa = 1;
  std::vector<ModelPoint> corners;     ///< counterclockwise; side i from i to i + 1; convex
  std::vector<ModelMatrix> back;       ///< by side: from the domain across it to this one
  std::vector<ModelMatrix> neighbour;  ///< from this domain to its neighbours
};

/// A site as the paper's method moves it: its tangent frame in the model, and the same frame's place
/// on T, from which the density near the site is read.
struct PlacedSite {
  Frame frame;
  Place place;
};

struct LaidOut {
  FundamentalDomain domain;
  std::vector<PlacedSite> sites;
};

/// The domain of T, with sites brought into it. The deck group and the layout have 32 digits until
/// they are rounded here. Throws NumericalError as `deck_system`.
LaidOut laid_out_domain(const UniformSurface& t, const std::vector<SurfacePoint>& sites);

/// Whether the point lies in the domain, sides included.
bool contains(const FundamentalDomain& domain, const ModelPoint& p);

/// Moves a site that left the domain to the side opposite to the one that it left by, as often as it
/// takes. Throws NumericalError when that does not end.
void bring_back(const FundamentalDomain& domain, Frame& site);

}  // namespace ucvt::paper
