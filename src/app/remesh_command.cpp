#include "app/remesh_command.h"

#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "app/outputs.h"
#include "app/report.h"
#include "app/surface_run.h"

namespace ucvt {
namespace {

using Clock = std::chrono::steady_clock;

std::string summary(const SurfaceRun& run, Clock::time_point start) {
  const RemeshReport& remesh = run.joined.remesh;
  const MeshQuality& q = remesh.quality;
  const CvtReport& cvt = run.joined.cvt;
  const auto count = [](std::int64_t n) { return fmt::format("{}", n); };
  return aligned(
      {{"vertices", count(remesh.vertices)},
       {"faces", count(remesh.faces)},
       {"genus", count(remesh.genus)},
       {"boundary",
        fmt::format("{} loop{}", remesh.boundary_loops, remesh.boundary_loops == 1 ? "" : "s")},
       {"geometry", geometry_text(run)},
       {"iterations", fmt::format("{} ({}converged)", cvt.iterations, cvt.converged ? "" : "not ")},
       {"energy",
        fmt::format("{:.4f} of small regular hexagons", energy_over_hexagonal(run.results))},
       {"angles",
        fmt::format("smallest {:.2f}, smallest on average {:.2f} degrees, {:.2f} % of the "
                    "triangles below 30",
                    q.angle_min_deg, q.angle_min_avg_deg, 100 * q.below_30)},
       {"Q", fmt::format("smallest {:.4f}, on average {:.4f}", q.q_min, q.q_avg)},
       {"regular", fmt::format("{:.2f} % of the vertices", 100 * q.regular)},
       {"cv", fmt::format("{:.4f} of the cell areas on the input", run.joined.cell_area_3d.cv)}},
      start);
}

}  // namespace

ExitStatus run_remesh(const RemeshArguments& arguments) {
  const auto start = Clock::now();
  const std::vector<std::string> outputs = outputs_of(arguments);
  check_writable(outputs);
  CheckpointFile checkpoint(arguments.checkpoint);
  Supervisor supervisor(arguments.shared.limits, &checkpoint);
  const SurfaceRun run = run_on_surface(arguments, Surfaces::ClosedAndOpen, supervisor, checkpoint);
  const TriangleMesh mesh = joined_mesh(run.results);
  const MadeFigures figures = about_file(input_name(arguments.shared.input), [&] {
    const SurfaceFigureArguments& asked = arguments.figures;
    const bool cells = !asked.figure.empty() && asked.show == SurfaceShow::Cells;
    const std::optional<Partition> cut =
        cells ? std::optional(partition(run.results.front())) : std::nullopt;
    return make_figures(asked, run.results.front(), mesh, cut ? &*cut : nullptr);
  });
  const std::string& report = arguments.shared.report;
  supervisor.begin_outputs();
  write_output(arguments.output, [&] { write_mesh(arguments.output, mesh); });
  write_run(arguments, run);
  write_figures(figures);
  write_output(report, [&] { write_text(report, report_text(run_report(arguments, run, start))); });
  const ExitStatus status = judge(arguments, run.joined);
  if (!arguments.shared.quiet && !takes_stdout(outputs)) {
    print_results(summary(run, start));
  }
  return status;
}

}  // namespace ucvt
