// Canonical generators as polylines on the input surface, an OBJ file (docs/group.md).
#pragma once

#include <string>
#include <vector>

#include "conformal/uniformize.h"
#include "cover/generators.h"

namespace ucvt {

/// The closed loops of the words as polylines on the input. The loops run along edges of T; those
/// are curves over the input's faces where T was flipped, followed to within a few hundredths of
/// their length. A loop's last point is its first.
std::vector<std::vector<Position>> loops_on_input(const Uniformized& t, const DeckSystem& system);

/// The OBJ text: `v` lines, and for every generator `o NAME` with one `l` line.
std::string loops_obj(const Uniformized& t, const DeckSystem& system, const DeckGroup& group);

}  // namespace ucvt
