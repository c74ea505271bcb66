// The readers of the single formats, from bytes in memory.
//
// Each gives the mesh as the file has it or throws InvalidInput with the line or the byte of the
// fault. Step: the input of every command.
#pragma once

#include <string_view>

#include "ucvt/mesh.h"

namespace ucvt {

/// OFF and its variants (COFF, NOFF, STOFF and mixtures, `OFF BINARY` in big or little endian);
/// source: the Geomview manual, OFF files. Four-dimensional and n-dimensional files are refused.
TriangleMesh read_off(std::string_view bytes);

/// Whether the text begins like OFF: its first word is a magic word of the family.
bool looks_like_off(std::string_view bytes);

/// Wavefront OBJ: `v` and `f`; vertices are told apart by their position index alone.
TriangleMesh read_obj(std::string_view bytes);

/// PLY 1.0, ascii and both binary forms, with faces as polygons or triangle strips.
TriangleMesh read_ply(std::string_view bytes);

/// Ascii STL; corners are welded by exact position.
TriangleMesh read_stl_text(std::string_view bytes);

/// Binary STL; corners are welded by exact position.
TriangleMesh read_stl_binary(std::string_view bytes);

}  // namespace ucvt
