// `ucvt remesh`: the dual mesh of a centroidal Voronoi tessellation.
#pragma once

#include "app/failure.h"
#include "app/options.h"

namespace ucvt {

/// Reads, computes, writes all outputs, prints the summary. Throws Failure.
ExitStatus run_remesh(const RemeshArguments& arguments);

}  // namespace ucvt
