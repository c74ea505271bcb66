#include "app/partition_command.h"

#include <algorithm>
#include <chrono>
#include <variant>

#include <fmt/format.h>

#include "app/outputs.h"
#include "app/report.h"
#include "app/surface_run.h"
#include "ucvt/partition.h"

namespace ucvt {
namespace {

using Clock = std::chrono::steady_clock;

double hexagons(const Partition& p) {
  const auto six = std::count_if(p.cells.begin(), p.cells.end(),
                                 [](const PartitionCell& c) { return c.degree == 6; });
  return static_cast<double>(six) / static_cast<double>(p.cells.size());
}

std::string summary(const SurfaceRun& run, const Partition& p, Clock::time_point start) {
  const CvtReport& cvt = run.joined.cvt;
  const Spread& area = run.joined.cell_area_3d;
  return aligned(
      {{"cells", fmt::format("{}", p.cells.size())},
       {"genus", fmt::format("{}", run.joined.remesh.genus)},
       {"geometry", geometry_text(run)},
       {"iterations", fmt::format("{} ({}converged)", cvt.iterations, cvt.converged ? "" : "not ")},
       {"energy",
        fmt::format("{:.4f} of small regular hexagons", energy_over_hexagonal(run.results))},
       {"hexagons", fmt::format("{:.2f} % of the cells", 100 * hexagons(p))},
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
  const SurfaceRun run = run_on_surface(asked, Surfaces::ClosedAndOpen, supervisor, checkpoint);
  const auto [joined, figures] = about_file(input_name(asked.shared.input), [&] {
    JoinedPartition cut = run.input.open ? partition(*run.input.open, run.results.front())
                                         : partition(run.input.components, run.results);
    MadeFigures made =
        make_figures(asked.figures, run.results.front(), joined_mesh(run.results), &cut.partition);
    return std::pair(std::move(cut), std::move(made));
  });
  const Partition& p = joined.partition;
  const std::string& report = asked.shared.report;
  supervisor.begin_outputs();
  write_output(asked.output, [&] { write_partition(asked.output, p); });
  write_output(arguments.labels, [&] {
    write_labels(arguments.labels, p, run.input.vertices_in_file(joined.input_vertex),
                 run.input.faces_in_file(joined.input_face));
  });
  write_output(arguments.cells, [&] { write_cells(arguments.cells, p); });
  write_run(asked, run);
  write_figures(figures);
  write_output(report, [&] {
    Json json = run_report(asked, run, start);
    json["partition"] = {{"cells", p.cells.size()},
                         {"colours", p.colours},
                         {"vertices", p.mesh.positions.size()},
                         {"faces", p.mesh.faces.size()}};
    write_text(report, report_text(json));
  });
  const ExitStatus status = judge(asked, run.joined);
  if (!asked.shared.quiet && !takes_stdout(outputs)) {
    print_results(summary(run, p, start));
  }
  return status;
}

}  // namespace ucvt
