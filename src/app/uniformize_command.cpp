#include "app/uniformize_command.h"

#include <chrono>
#include <optional>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "app/closed_input.h"
#include "app/outputs.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/signals.h"
#include "ucvt/cover.h"

namespace ucvt {
namespace {

using Clock = std::chrono::steady_clock;

std::string summary(const UniformizationReport& report, Clock::time_point start) {
  const auto count = [](std::int64_t n) { return fmt::format("{}", n); };
  return aligned(
      {
          {"vertices", count(report.vertices)},
          {"faces", count(report.faces)},
          {"genus", count(report.genus)},
          {"geometry", report.geometry},
          {"iterations", count(report.newton_iterations)},
          {"flips",
           fmt::format("{} Euclidean, {} Ptolemy", report.euclidean_flips, report.ptolemy_flips)},
          {"angle error", fmt::format("{:.1e} rad", report.max_angle_error)},
          {"log scale",
           fmt::format("{:.4g} to {:.4g}", report.log_scale_min, report.log_scale_max)},
      },
      start);
}

/// An open surface is doubled.
int genus_of_t(const ClosedInput& input) {
  return input.open ? 2 * input.open->genus + input.open->boundary_loops - 1
                    : input.components.front().surface.genus;
}

bool needs_cover(const UniformizeArguments& arguments) {
  return !arguments.group.empty() || !arguments.loops.empty() || !arguments.uv.empty() ||
         needs_cover(arguments.figures);
}

void write_outputs(const UniformizeArguments& arguments, const ClosedInput& input,
                   const UniformizedSurface& surface, Clock::time_point start,
                   Supervisor& supervisor) {
  std::optional<Cover> cover;
  const MadeFigures figures = about_file(input_name(arguments.shared.input), [&] {
    if (needs_cover(arguments)) {
      cover.emplace(surface);
    }
    return make_figures(arguments.figures, surface, cover ? &*cover : nullptr);
  });
  supervisor.begin_outputs();
  write_output(arguments.output, [&] { surface.write(arguments.output); });
  write_output(arguments.group, [&] { cover->write_group(arguments.group); });
  write_output(arguments.loops, [&] { cover->write_loops(arguments.loops); });
  write_output(arguments.uv,
               [&] { cover->write_uv(arguments.uv, arguments.figures.cover_picture.coordinates); });
  write_figures(figures);
  write_output(arguments.shared.report, [&] {
    Json report;
    report["input"] = input_report(arguments.shared.input, input.counts);
    if (input.repair) {
      report["repair"] = repair_report(*input.repair);
    }
    report["uniformization"] = uniformization_report(surface.report());
    if (cover) {
      report["group"] = group_report(cover->group());
    }
    add_run_report(report, start);
    report["threads"] = threads_used(arguments.threads);
    write_text(arguments.shared.report, report_text(report));
  });
}

}  // namespace

ExitStatus run_uniformize(const UniformizeArguments& arguments) {
  const auto start = Clock::now();
  const std::vector<std::string> outputs = outputs_of(arguments);
  check_writable(outputs);
  Supervisor supervisor(arguments.shared.limits);
  const ClosedInput input = read_input(arguments.shared, Surfaces::ClosedAndOpen);
  require_one_component(arguments.shared, input, "uniformize");
  if (needs_cover(arguments)) {
    about_file(input_name(arguments.shared.input), [&] {
      require_coordinates(genus_of_t(input), arguments.figures.cover_picture.coordinates);
    });
  }
  begin_computation();
  std::optional<tbb::global_control> limit;
  if (arguments.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(arguments.threads));
  }
  ProgressLine progress(arguments.shared, supervisor);
  UniformizeOptions options;
  options.monitor = progress.monitor();
  const UniformizedSurface surface = about_file(input_name(arguments.shared.input), [&] {
    return supervisor.watch([&] {
      return input.open ? uniformize(*input.open, options)
                        : uniformize(input.components.front().surface, options);
    });
  });
  progress.clear();
  write_outputs(arguments, input, surface, start, supervisor);
  if (!arguments.shared.quiet && !takes_stdout(outputs)) {
    print_results(summary(surface.report(), start));
  }
  return ExitStatus::Done;
}

}  // namespace ucvt
