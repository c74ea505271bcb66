#include "app/uniformize_command.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "app/closed_input.h"
#include "app/outputs.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/signals.h"

namespace ucvt {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double bytes_per_megabyte = 1e6;

std::string summary(const ClosedInput& input, const UniformizationReport& report,
                    Clock::time_point start) {
  const auto count = [](std::int64_t n) { return fmt::format("{}", n); };
  return aligned_lines({
      {"vertices", count(input.counts.vertices + report.refined_vertices)},
      {"faces", count(input.counts.faces + 2 * report.refined_vertices)},
      {"genus", count(input.surface.genus)},
      {"geometry", report.geometry},
      {"iterations", count(report.newton_iterations)},
      {"flips",
       fmt::format("{} Euclidean, {} Ptolemy", report.euclidean_flips, report.ptolemy_flips)},
      {"angle error", fmt::format("{:.1e} rad", report.max_angle_error)},
      {"log scale", fmt::format("{:.4g} to {:.4g}", report.log_scale_min, report.log_scale_max)},
      {"time", fmt::format("{:.2f} s", seconds_since(start))},
      {"peak memory",
       fmt::format("{:.0f} MB", static_cast<double>(peak_memory_bytes()) / bytes_per_megabyte)},
  });
}

void write_outputs(const UniformizeArguments& arguments, const ClosedInput& input,
                   const UniformizedSurface& surface, Clock::time_point start) {
  const MadeFigures figures = about_file(input_name(arguments.shared.input),
                                         [&] { return make_figures(arguments.figures, surface); });
  about_file(output_name(arguments.output), [&] { surface.write(arguments.output); });
  write_figures(figures);
  if (arguments.shared.report.empty()) {
    return;
  }
  Json report;
  report["input"] = input_report(arguments.shared.input, input.counts);
  report["uniformization"] = uniformization_report(surface.report());
  add_run_report(report, start);
  report["threads"] = threads_used(arguments.threads);
  write_text(arguments.shared.report, report_text(report));
}

}  // namespace

ExitStatus run_uniformize(const UniformizeArguments& arguments) {
  const auto start = Clock::now();
  const std::vector<std::string> outputs = outputs_of(arguments);
  check_writable(outputs);
  catch_signals();
  const ClosedInput input = read_closed_input(arguments.shared);
  begin_computation();
  std::optional<tbb::global_control> limit;
  if (arguments.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(arguments.threads));
  }
  ProgressLine progress(arguments.shared);
  UniformizeOptions options;
  options.monitor = progress.monitor();
  const UniformizedSurface surface = about_file(input_name(arguments.shared.input),
                                                [&] { return uniformize(input.surface, options); });
  progress.clear();
  if (interrupted()) {
    throw interruption();
  }
  write_outputs(arguments, input, surface, start);
  const bool stdout_taken = std::find(outputs.begin(), outputs.end(), "-") != outputs.end();
  if (!arguments.shared.quiet && !stdout_taken) {
    print_results(summary(input, surface.report(), start));
  }
  return ExitStatus::Done;
}

}  // namespace ucvt
