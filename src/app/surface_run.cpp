#include "app/surface_run.h"

#include <fmt/format.h>

#include "app/outputs.h"
#include "app/progress.h"
#include "app/signals.h"
#include "ucvt/check.h"

namespace ucvt {
namespace {

/// The options of the library, with the sites of --init in them.
RemeshOptions options_of(const RemeshArguments& arguments) {
  RemeshOptions options = arguments.options;
  if (arguments.init_file.empty()) {
    return options;
  }
  const std::string name = input_name(arguments.init_file);
  SavedSites saved = about_file(name, [&] { return read_sites(arguments.init_file); });
  const int asked = options.sites;
  start_from(options, std::move(saved));
  if (arguments.sites_given && asked != options.sites) {
    throw Failure(ExitStatus::Usage,
                  fmt::format("{}: there are {} sites, but -n asks for {}; leave -n out", name,
                              options.sites, asked));
  }
  return options;
}

}  // namespace

SurfaceRun run_on_surface(const RemeshArguments& arguments, Supervisor& supervisor,
                          CheckpointFile& checkpoint) {
  RemeshOptions options = options_of(arguments);
  ClosedInput input = read_closed_input(arguments.shared);
  begin_computation();
  ProgressLine progress(arguments.shared, supervisor);
  options.monitor = progress.monitor();
  options.checkpoint = checkpoint.writer();
  RemeshResult result = about_file(input_name(arguments.shared.input), [&] {
    return supervisor.watch([&] {
      RemeshResult made = remesh(input.surface, options);
      if (arguments.check) {
        check(made);
      }
      return made;
    });
  });
  return {std::move(input), std::move(result)};
}

void write_run(const RemeshArguments& arguments, const RemeshResult& result) {
  write_output(arguments.surface, [&] { result.surface.write(arguments.surface); });
  write_output(arguments.sites, [&] { write_sites(arguments.sites, result); });
}

Json run_report(const RemeshArguments& arguments, const SurfaceRun& run,
                std::chrono::steady_clock::time_point start) {
  Json report;
  report["input"] = input_report(arguments.shared.input, run.input.counts);
  report["uniformization"] = uniformization_report(run.result.surface.report());
  add_remesh_report(report, run.result);
  add_run_report(report, start);
  report["seed"] = arguments.options.seed;
  report["threads"] = threads_used(arguments.options.threads);
  return report;
}

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

}  // namespace ucvt
