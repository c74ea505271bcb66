// T cut open, as an OBJ file with texture coordinates (docs/group.md).
#pragma once

#include <string>

#include "conformal/uniformize.h"
#include "cover/layout.h"

namespace ucvt {

/// The OBJ text: `v` T's vertices at their places on the input, `vt` every lift of a vertex in the
/// layout once, `f` T's faces as v/vt, counterclockwise in both. T's faces are the input's where no
/// edge was flipped. Requires coordinates of the geometry (`require_coordinates`).
std::string uv_obj(const Uniformized& t, const DeckSystem& system, CoverCoordinates coordinates);

}  // namespace ucvt
