// `ucvt info`: topology, faults and quality of a mesh, fit for remeshing or not.
#pragma once

#include "app/failure.h"
#include "app/options.h"

namespace ucvt {

/// Prints what the mesh is. A mesh that remesh would refuse is no failure. Throws Failure when the
/// file cannot be read as a mesh.
ExitStatus run_info(const InfoArguments& arguments);

}  // namespace ucvt
