// Uniformization of surfaces with boundary, by their doubles (docs/boundaries.md).
#pragma once

#include "mesh/doubled_surface.h"
#include "ucvt/uniformize.h"

namespace ucvt {

/// As `uniformize` of its closed surface; T knows its mirror images.
UniformizedSurface uniformize(const DoubledSurface& doubled, const UniformizeOptions& options);

}  // namespace ucvt
