// `ucvt partition`: the input cut along the cells of a centroidal Voronoi tessellation.
#pragma once

#include "app/failure.h"
#include "app/options.h"

namespace ucvt {

/// Reads, computes, writes all outputs, prints the summary. Throws Failure.
ExitStatus run_partition(const PartitionArguments& arguments);

}  // namespace ucvt
