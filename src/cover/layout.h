// Layouts of T in the model space, for files and pictures.
#pragma once

#include <array>
#include <vector>

#include "triangulation/uniform_surface.h"

namespace ucvt {

/// The corners of every face in one frame: a fundamental domain, developed face by face over a
/// breadth-first spanning tree of the dual from `root`.
///
/// For looking at only: doubles cannot hold a wide span of scales in one layout, and hyperbolic
/// offsets grow like exp(distance).
std::vector<std::array<Offset, 3>> fundamental_domain(const UniformSurface& t, Face root);

}  // namespace ucvt
