#include "app/partition_command.h"

#include <chrono>

#include <fmt/format.h>

#include "app/outputs.h"
#include "app/report.h"
#include "app/surface_run.h"
#include "ucvt/partition.h"

namespace ucvt {
namespace {

using Clock = std::chrono::steady_clock;

std::string summary(const RemeshResult& result, const Partition& p, Clock::time_point start) {
  const CvtReport& cvt = result.cvt;
  const Spread& area = result.cell_area_3d;
  return aligned(
      {{"cells", fmt::format("{}", p.cells.size())},
       {"genus", fmt::format("{}", result.report.genus)},
       {"geometry", result.surface.report().geometry},
       {"iterations", fmt::format("{} ({}converged)", cvt.iterations, cvt.converged ? "" : "not ")},
       {"hexagons", fmt::format("{:.2f} % of the cells", 100 * result.uniformity.hexagons)},
       {"cv", fmt::format("{:.4f} of the cell areas on the input, which go from {:.4f} to {:.4f} "
                          "of their mean",
                          area.cv, area.min / area.mean, area.max / area.mean)},
       {"colours", fmt::format("{}", p.colours)},
       {"vertices", fmt::format("{}", p.mesh.positions.size())},
       {"faces", fmt::format("{}", p.mesh.faces.size())}},
      start);
}

}  // namespace

ExitStatus run_partition(const PartitionArguments& arguments) {
  const auto start = Clock::now();
  const RemeshArguments& asked = arguments.remesh;
  const std::vector<std::string> outputs = outputs_of(arguments);
  check_writable(outputs);
  CheckpointFile checkpoint(asked.checkpoint);
  Supervisor supervisor(asked.shared.limits, &checkpoint);
  const SurfaceRun run = run_on_surface(asked, supervisor, checkpoint);
  const auto [p, figures] = about_file(input_name(asked.shared.input), [&] {
    Partition cut = partition(run.result);
    MadeFigures made = make_figures(asked.figures, run.result, &cut);
    return std::pair(std::move(cut), std::move(made));
  });
  const std::string& report = asked.shared.report;
  supervisor.begin_outputs();
  write_output(asked.output, [&] { write_partition(asked.output, p); });
  write_output(arguments.labels,
               [&] { write_labels(arguments.labels, p, run.input.surface.input_vertex); });
  write_output(arguments.cells, [&] { write_cells(arguments.cells, p); });
  write_run(asked, run.result);
  write_figures(figures);
  write_output(report, [&] {
    Json json = run_report(asked, run, start);
    json["partition"] = {{"cells", p.cells.size()},
                         {"colours", p.colours},
                         {"vertices", p.mesh.positions.size()},
                         {"faces", p.mesh.faces.size()}};
    write_text(report, report_text(json));
  });
  const ExitStatus status = judge(asked, run.result);
  if (!asked.shared.quiet && !takes_stdout(outputs)) {
    print_results(summary(run.result, p, start));
  }
  return status;
}

}  // namespace ucvt
