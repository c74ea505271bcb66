// A tessellation of a surface as remesh and partition make it, up to what they do with it.
#pragma once

#include <chrono>

#include "app/closed_input.h"
#include "app/failure.h"
#include "app/options.h"
#include "app/report.h"
#include "app/supervisor.h"

namespace ucvt {

struct SurfaceRun {
  ClosedInput input;
  std::vector<RemeshResult> results;  ///< one for each component
  JoinedReport joined;
};

/// Reads the mesh and the sites to start from, and computes. Throws Failure, also when it was asked
/// to stop.
SurfaceRun run_on_surface(const RemeshArguments& arguments, Surfaces surfaces,
                          Supervisor& supervisor, CheckpointFile& checkpoint);

/// Writes --surface and --sites, of one component, where they are asked for. Throws Failure.
void write_run(const RemeshArguments& arguments, const SurfaceRun& run);

Json run_report(const RemeshArguments& arguments, const SurfaceRun& run,
                std::chrono::steady_clock::time_point start);

/// What the result is not, said on stderr; whether the run counts as finished.
ExitStatus judge(const RemeshArguments& arguments, const JoinedReport& joined);

/// "hyperbolic"; "spherical, euclidean (3 components)".
std::string geometry_text(const SurfaceRun& run);

}  // namespace ucvt
