// The input of the computing commands: a mesh file that is one closed surface.
#pragma once

#include "app/options.h"
#include "ucvt/mesh.h"

namespace ucvt {

struct ClosedInput {
  MeshSurvey counts;  ///< of the mesh as it was read
  ClosedSurface surface;
};

/// Reads the mesh and tells on stderr when faces had to be turned round. Throws Failure.
ClosedInput read_closed_input(const SharedArguments& shared);

}  // namespace ucvt
