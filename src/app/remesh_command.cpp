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

std::string summary(const RemeshResult& result, Clock::time_point start) {
  const RemeshReport& remesh = result.report;
  const MeshQuality& q = remesh.quality;
  const CvtReport& cvt = result.cvt;
  const auto count = [](std::int64_t n) { return fmt::format("{}", n); };
  return aligned(
      {{"vertices", count(remesh.vertices)},
       {"faces", count(remesh.faces)},
       {"genus", count(remesh.genus)},
       {"geometry", result.surface.report().geometry},
       {"iterations", fmt::format("{} ({}converged)", cvt.iterations, cvt.converged ? "" : "not ")},
       {"angles",
        fmt::format("smallest {:.2f}, smallest on average {:.2f} degrees, {:.2f} % of the "
                    "triangles below 30",
                    q.angle_min_deg, q.angle_min_avg_deg, 100 * q.below_30)},
       {"Q", fmt::format("smallest {:.4f}, on average {:.4f}", q.q_min, q.q_avg)},
       {"regular", fmt::format("{:.2f} % of the vertices", 100 * q.regular)},
       {"cv", fmt::format("{:.4f} of the cell areas on the input", result.cell_area_3d.cv)}},
      start);
}

}  // namespace

ExitStatus run_remesh(const RemeshArguments& arguments) {
  const auto start = Clock::now();
  const std::vector<std::string> outputs = outputs_of(arguments);
  check_writable(outputs);
  CheckpointFile checkpoint(arguments.checkpoint);
  Supervisor supervisor(arguments.shared.limits, &checkpoint);
  const SurfaceRun run = run_on_surface(arguments, supervisor, checkpoint);
  const RemeshResult& result = run.result;
  const MadeFigures figures = about_file(input_name(arguments.shared.input), [&] {
    const SurfaceFigureArguments& asked = arguments.figures;
    const bool cells = !asked.figure.empty() && asked.show == SurfaceShow::Cells;
    const std::optional<Partition> cut = cells ? std::optional(partition(result)) : std::nullopt;
    return make_figures(asked, result, cut ? &*cut : nullptr);
  });
  const std::string& report = arguments.shared.report;
  supervisor.begin_outputs();
  write_output(arguments.output, [&] { write_mesh(arguments.output, result.mesh); });
  write_run(arguments, result);
  write_figures(figures);
  write_output(report, [&] { write_text(report, report_text(run_report(arguments, run, start))); });
  const ExitStatus status = judge(arguments, result);
  if (!arguments.shared.quiet && !takes_stdout(outputs)) {
    print_results(summary(result, start));
  }
  return status;
}

}  // namespace ucvt
