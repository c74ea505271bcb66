// Layouts of T in the model space, for files and pictures.
#pragma once

#include <array>
#include <vector>

#include "cover/generators.h"
#include "triangulation/uniform_surface.h"

namespace ucvt {

/// The corners of every face in one frame: a fundamental domain, developed face by face over a
/// breadth-first spanning tree of the dual from `root`.
///
/// For looking at only: doubles cannot hold a wide span of scales in one layout, and hyperbolic
/// offsets grow like exp(distance).
std::vector<std::array<Offset, 3>> fundamental_domain(const UniformSurface& t, Face root);

/// T cut open along the greedy loops and laid out about the base: by halfedge, the frame at its
/// face's corner at its origin. A face's three corners agree with each other; across a cut lies the
/// image under `across_cut`.
std::vector<DeckMap> laid_out(const UniformSurface& t, const DeckSystem& system);

/// The deck transformation that brings the laid out face of h's twin next to the face of h: the
/// identity where the layout is not cut.
DeckMap across_cut(const UniformSurface& t, const DeckSystem& system, Halfedge h);

/// The image of the origin in two coordinates, from the map's numbers without loss.
/// Requires coordinates of the curvature (`require_coordinates`).
std::array<double, 2> coordinates_of(double kappa, const DeckMap& m, CoverCoordinates coordinates);

}  // namespace ucvt
