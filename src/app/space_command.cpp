#include "app/space_command.h"

#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "app/outputs.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/signals.h"

namespace ucvt {
namespace {

using Clock = std::chrono::steady_clock;

/// What a message is about: the domain, by its file where it has one.
std::string subject(const SpaceArguments& arguments) {
  return arguments.domain ? arguments.command : input_name(arguments.domain_text);
}

Domain domain_of(const SpaceArguments& arguments) {
  if (arguments.domain) {
    return *arguments.domain;
  }
  return about_file(subject(arguments), [&] {
    const double kappa = arguments.command == "hyperbolic" ? -1 : 0;
    return polygon_domain(kappa, read_polygon(arguments.domain_text));
  });
}

bool needs_cells(const SpaceArguments& arguments) {
  return !arguments.output.empty() || !arguments.cells.empty() || !arguments.csv.empty() ||
         !arguments.figure.empty() || !arguments.plot_uniformity.empty();
}

/// The options of the library, with the sites of --init in them.
SpaceOptions options_of(const SpaceArguments& arguments, const Domain& domain) {
  SpaceOptions options = arguments.options;
  options.keep_cells = needs_cells(arguments);
  if (arguments.init_file.empty()) {
    return options;
  }
  const std::string name = input_name(arguments.init_file);
  options.initial_sites =
      about_file(name, [&] { return read_space_sites(arguments.init_file, domain); });
  const std::size_t found = options.initial_sites.size();
  if (arguments.sites_given && found != static_cast<std::size_t>(options.sites)) {
    throw Failure(ExitStatus::Usage,
                  fmt::format("{}: there are {} sites, but -n asks for {}; leave -n out", name,
                              found, options.sites));
  }
  return options;
}

std::string summary(const SpaceArguments& arguments, const SpaceResult& result,
                    Clock::time_point start) {
  const CvtReport& cvt = result.cvt;
  const UniformityReport& u = result.uniformity;
  const auto cv = [](const UniformityReport& r) {
    return fmt::format("radius {:.4f}, nearest {:.4f}, area {:.4f}", r.radius.cv, r.nearest.cv,
                       r.area.cv);
  };
  const std::string energy = fmt::format("{:.6g}", cvt.energy.back());
  return aligned(
      {
          {"space", arguments.domain_text == arguments.command
                        ? arguments.command
                        : fmt::format("{} {}", arguments.command, arguments.domain_text)},
          {"area", fmt::format("{:.6g}", result.domain.area)},
          {"sites", fmt::format("{}", cvt.sites)},
          {"iterations",
           fmt::format("{} ({}converged)", cvt.iterations, cvt.converged ? "" : "not ")},
          {"energy", arguments.options.density.empty()
                         ? fmt::format("{} ({:.4f} of regular hexagons)", energy,
                                       energy_over_hexagonal(result))
                         : energy},
          {"hexagons", fmt::format("{:.2f} % of the cells", 100 * u.hexagons)},
          {"cv", cv(u)},
          {"cv at start", cv(result.initial_uniformity)},
      },
      start);
}

Json report_of(const SpaceArguments& arguments, const SpaceResult& result,
               Clock::time_point start) {
  Json report;
  add_space_report(report, arguments.domain_text, result, arguments.options.density.empty());
  add_run_report(report, start);
  report["seed"] = arguments.options.seed;
  report["threads"] = threads_used(arguments.options.threads);
  return report;
}

void write_outputs(const SpaceArguments& arguments, const SpaceResult& result,
                   Clock::time_point start, Supervisor& supervisor) {
  // What can be refused is made before the first file is written.
  std::optional<TriangleMesh> mesh;
  std::string figure;
  about_file(subject(arguments), [&] {
    if (!arguments.output.empty()) {
      mesh = delaunay_mesh(result, arguments.coordinates);
    }
    if (!arguments.figure.empty()) {
      figure = space_picture(result, arguments.picture);
    }
  });
  supervisor.begin_outputs();
  write_output(arguments.output, [&] { write_mesh(arguments.output, *mesh); });
  write_output(arguments.cells,
               [&] { write_cells(arguments.cells, result, arguments.coordinates); });
  write_output(arguments.csv, [&] { write_cell_table(arguments.csv, result); });
  write_output(arguments.sites, [&] { write_space_sites(arguments.sites, result); });
  write_output(arguments.figure, [&] { write_figure(arguments.figure, figure); });
  write_output(arguments.plot_energy,
               [&] { write_figure(arguments.plot_energy, line_plot(energy_plot(result))); });
  write_output(arguments.plot_uniformity, [&] {
    write_figure(arguments.plot_uniformity, line_plot(uniformity_plot(result)));
  });
  const std::string& report = arguments.shared.report;
  write_output(report,
               [&] { write_text(report, report_text(report_of(arguments, result, start))); });
}

/// What the result is not, said on stderr; whether the run counts as finished.
ExitStatus judge(const SpaceArguments& arguments, const SpaceResult& result) {
  const std::string name = subject(arguments);
  if (result.quadrature_error > arguments.options.quadrature && !arguments.shared.quiet) {
    print_line_to_stderr(
        fmt::format("{}: integrals of the density have relative errors up to {:.2g}; a density "
                    "without jumps, or --quadrature, avoids that",
                    name, result.quadrature_error));
  }
  const bool failed = !result.cvt.converged && arguments.convergence_asked;
  if (!result.cvt.converged && (failed || !arguments.shared.quiet)) {
    print_line_to_stderr(name + ": " + not_converged(result.cvt, arguments.options.tolerance));
  }
  return failed ? ExitStatus::NotFinished : ExitStatus::Done;
}

}  // namespace

ExitStatus run_space(const SpaceArguments& arguments) {
  const auto start = Clock::now();
  const std::vector<std::string> outputs = outputs_of(arguments);
  check_writable(outputs);
  Supervisor supervisor(arguments.shared.limits);
  const Domain domain = domain_of(arguments);
  SpaceOptions options = options_of(arguments, domain);
  begin_computation();
  ProgressLine progress(arguments.shared, supervisor);
  options.monitor = progress.monitor();
  const SpaceResult result = about_file(subject(arguments), [&] {
    return supervisor.watch([&] { return tessellate(domain, options); });
  });
  progress.clear();
  write_outputs(arguments, result, start, supervisor);
  const ExitStatus status = judge(arguments, result);
  if (!arguments.shared.quiet && !takes_stdout(outputs)) {
    print_results(summary(arguments, result, start));
  }
  return status;
}

}  // namespace ucvt
