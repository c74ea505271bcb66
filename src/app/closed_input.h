// The input of the computing commands: a mesh file that is one surface, closed or with boundary.
#pragma once

#include <variant>

#include "app/options.h"
#include "ucvt/mesh.h"

namespace ucvt {

struct ClosedInput {
  MeshSurvey counts;  ///< of the mesh as it was read
  ClosedSurface surface;
};

/// What remesh takes.
struct SurfaceInput {
  MeshSurvey counts;  ///< of the mesh as it was read
  std::variant<ClosedSurface, OpenSurface> surface;
};

/// Reads the mesh and tells on stderr when faces had to be turned round. Throws Failure.
ClosedInput read_closed_input(const SharedArguments& shared);
SurfaceInput read_surface_input(const SharedArguments& shared);

}  // namespace ucvt
