#include "app/remesh_command.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "app/closed_input.h"
#include "app/outputs.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/signals.h"

namespace ucvt {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double bytes_per_megabyte = 1e6;

/// The options of the library, with the sites of --init in them.
RemeshOptions options_of(const RemeshArguments& arguments) {
  RemeshOptions options = arguments.options;
  if (arguments.init_file.empty()) {
    return options;
  }
  const std::string name = input_name(arguments.init_file);
  SavedSites saved = about_file(name, [&] { return read_sites(arguments.init_file); });
  options.initial_sites = std::move(saved.sites);
  options.refine_for = saved.refine_for;
  options.initial_size = std::move(saved.size);
  const std::size_t found = options.initial_sites.size();
  if (arguments.sites_given && found != static_cast<std::size_t>(options.sites)) {
    throw Failure(ExitStatus::Usage,
                  fmt::format("{}: there are {} sites, but -n asks for {}; leave -n out", name,
                              found, options.sites));
  }
  options.sites = static_cast<int>(found);
  return options;
}

std::string summary(const RemeshResult& result, Clock::time_point start) {
  const RemeshReport& remesh = result.report;
  const MeshQuality& q = remesh.quality;
  const CvtReport& cvt = result.cvt;
  const auto count = [](std::int64_t n) { return fmt::format("{}", n); };
  return aligned_lines({
      {"vertices", count(remesh.vertices)},
      {"faces", count(remesh.faces)},
      {"genus", count(remesh.genus)},
      {"geometry", result.surface.report().geometry},
      {"iterations", fmt::format("{} ({}converged)", cvt.iterations, cvt.converged ? "" : "not ")},
      {"angles", fmt::format("smallest {:.2f}, smallest on average {:.2f} degrees, {:.2f} % of the "
                             "triangles below 30",
                             q.angle_min_deg, q.angle_min_avg_deg, 100 * q.below_30)},
      {"Q", fmt::format("smallest {:.4f}, on average {:.4f}", q.q_min, q.q_avg)},
      {"regular", fmt::format("{:.2f} % of the vertices", 100 * q.regular)},
      {"cv", fmt::format("{:.4f} of the cell areas on the input", result.cell_area_3d.cv)},
      {"time", fmt::format("{:.2f} s", seconds_since(start))},
      {"peak memory",
       fmt::format("{:.0f} MB", static_cast<double>(peak_memory_bytes()) / bytes_per_megabyte)},
  });
}

Json report_of(const RemeshArguments& arguments, const ClosedInput& input,
               const RemeshResult& result, Clock::time_point start) {
  Json report;
  report["input"] = input_report(arguments.shared.input, input.counts);
  report["uniformization"] = uniformization_report(result.surface.report());
  add_remesh_report(report, result);
  add_run_report(report, start);
  report["seed"] = arguments.options.seed;
  report["threads"] = threads_used(arguments.options.threads);
  return report;
}

void write_outputs(const RemeshArguments& arguments, const ClosedInput& input,
                   const RemeshResult& result, Clock::time_point start) {
  const auto write = [](const std::string& path, const auto& work) {
    if (!path.empty()) {
      about_file(output_name(path), work);
    }
  };
  const MadeFigures figures = about_file(input_name(arguments.shared.input), [&] {
    const bool cells =
        !arguments.figures.figure.empty() && arguments.figures.show == SurfaceShow::Cells;
    const std::optional<Partition> cut = cells ? std::optional(partition(result)) : std::nullopt;
    return make_figures(arguments.figures, result, cut ? &*cut : nullptr);
  });
  write(arguments.output, [&] { write_mesh(arguments.output, result.mesh); });
  write(arguments.surface, [&] { result.surface.write(arguments.surface); });
  write(arguments.sites, [&] { write_sites(arguments.sites, result); });
  write_figures(figures);
  const std::string& report = arguments.shared.report;
  write(report,
        [&] { write_text(report, report_text(report_of(arguments, input, result, start))); });
}

/// What the mesh is not, said on stderr; whether the run counts as finished.
ExitStatus judge(const RemeshArguments& arguments, const RemeshResult& result) {
  const std::string name = input_name(arguments.shared.input);
  const bool quiet = arguments.shared.quiet;
  ExitStatus status = ExitStatus::Done;
  const auto say = [&](const std::string& text, bool failed) {
    if (failed) {
      status = ExitStatus::NotFinished;
    }
    if (failed || !quiet) {
      print_line_to_stderr(name + ": " + text);
    }
  };
  if (const std::int64_t added = result.report.sites_added; added > 0) {
    say(fmt::format("added {} site{} so that the mesh is simplicial", added, added == 1 ? "" : "s"),
        false);
  }
  if (!result.report.simplicial) {
    say("the mesh is not simplicial (loops or double edges); ask for more sites",
        arguments.options.ensure_simplicial);
  }
  if (!result.cvt.converged) {
    say(not_converged(result.cvt, arguments.options.tolerance), arguments.convergence_asked);
  }
  return status;
}

}  // namespace

ExitStatus run_remesh(const RemeshArguments& arguments) {
  const auto start = Clock::now();
  const std::vector<std::string> outputs = outputs_of(arguments);
  check_writable(outputs);
  catch_signals();
  RemeshOptions options = options_of(arguments);
  const ClosedInput input = read_closed_input(arguments.shared);
  begin_computation();
  ProgressLine progress(arguments.shared);
  options.monitor = progress.monitor();
  const RemeshResult result = about_file(input_name(arguments.shared.input),
                                         [&] { return remesh(input.surface, options); });
  progress.clear();
  if (interrupted()) {
    throw interruption();
  }
  write_outputs(arguments, input, result, start);
  const ExitStatus status = judge(arguments, result);
  const bool stdout_taken = std::find(outputs.begin(), outputs.end(), "-") != outputs.end();
  if (!arguments.shared.quiet && !stdout_taken) {
    print_results(summary(result, start));
  }
  return status;
}

}  // namespace ucvt
