// `ucvt sphere`, `plane`, `torus` and `hyperbolic`: tessellations of the three spaces themselves.
#pragma once

#include "app/failure.h"
#include "app/options.h"

namespace ucvt {

/// Computes, writes all outputs, prints the summary. Throws Failure.
ExitStatus run_space(const SpaceArguments& arguments);

}  // namespace ucvt
