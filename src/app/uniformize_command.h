// `ucvt uniformize`: the conformal surface of constant curvature as PLY.
#pragma once

#include "app/failure.h"
#include "app/options.h"

namespace ucvt {

/// Reads, computes, writes all outputs, prints the summary. Throws Failure.
ExitStatus run_uniformize(const UniformizeArguments& arguments);

}  // namespace ucvt
