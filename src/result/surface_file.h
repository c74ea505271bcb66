// T as a PLY file (docs/formats.md).
#pragma once

#include <string>

#include "conformal/uniformize.h"

namespace ucvt {

/// Writes T: input positions and log scales at the vertices, corners, chords, gluing and layout of
/// the faces. Throws IoError; the file appears whole or not at all. "-" writes standard output.
void write_surface(const std::string& path, const Uniformized& t);

}  // namespace ucvt
