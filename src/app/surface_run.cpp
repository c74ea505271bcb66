#include "app/surface_run.h"

#include <algorithm>

#include <fmt/ranges.h>

#include "app/outputs.h"
#include "app/progress.h"
#include "app/signals.h"
#include "ucvt/check.h"

namespace ucvt {
namespace {

#ifdef NDEBUG
constexpr bool always_checked = false;
#else
constexpr bool always_checked = true;
#endif

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

/// Files of sites and of the uniform surface, cells in pictures and the cover are of one component.
void check_components(const RemeshArguments& a, const ClosedInput& input) {
  const auto check = [&](bool asked, const std::string& what) {
    if (asked) {
      require_one_component(a.shared, input, what);
    }
  };
  check(!a.init_file.empty(), "--init FILE");
  check(!a.checkpoint.path.empty(), "--checkpoint");
  check(!a.surface.empty(), "--surface");
  check(!a.sites.empty(), "--sites");
  check(!a.figures.cover.empty(), "--cover");
  check(!a.figures.figure.empty() && a.figures.show == SurfaceShow::Cells, "--show cells");
}

void refuse_what_open_surfaces_lack(const RemeshArguments& a, const ClosedInput& input) {
  if (!input.open) {
    return;
  }
  const auto check = [&](bool asked, const char* what) {
    if (asked) {
      throw Failure(ExitStatus::BadInput,
                    fmt::format("{}: the surface is open, where there is no {}; leave it out",
                                input_name(a.shared.input), what));
    }
  };
  check(!a.checkpoint.path.empty(), "--checkpoint");
  check(!a.init_file.empty(), "--init");
  check(a.options.init == InitialSites::Random, "--init random");
  check(!a.figures.cover.empty(), "--cover");
}

std::vector<RemeshResult> computed(const RemeshArguments& arguments, const ClosedInput& input,
                                   const RemeshOptions& options) {
  std::vector<RemeshResult> results;
  if (input.open) {
    results.push_back(remesh(*input.open, options));
  } else {
    results = remesh(input.components, options);
  }
  if (arguments.check || always_checked) {
    for (const RemeshResult& result : results) {
      check(result);
    }
  }
  return results;
}

}  // namespace

SurfaceRun run_on_surface(const RemeshArguments& arguments, Surfaces surfaces,
                          Supervisor& supervisor, CheckpointFile& checkpoint) {
  RemeshOptions options = options_of(arguments);
  ClosedInput input = read_input(arguments.shared, surfaces);
  check_components(arguments, input);
  refuse_what_open_surfaces_lack(arguments, input);
  begin_computation();
  ProgressLine progress(arguments.shared, supervisor);
  options.monitor = progress.monitor();
  options.checkpoint = checkpoint.writer();
  std::vector<RemeshResult> results = about_file(input_name(arguments.shared.input), [&] {
    return supervisor.watch([&] { return computed(arguments, input, options); });
  });
  JoinedReport joined = joined_report(results);
  return {std::move(input), std::move(results), std::move(joined)};
}

void write_run(const RemeshArguments& arguments, const SurfaceRun& run) {
  const RemeshResult& result = run.results.front();
  write_output(arguments.surface, [&] { result.surface.write(arguments.surface); });
  write_output(arguments.sites, [&] { write_sites(arguments.sites, result); });
}

Json run_report(const RemeshArguments& arguments, const SurfaceRun& run,
                std::chrono::steady_clock::time_point start) {
  Json report;
  report["input"] = input_report(arguments.shared.input, run.input.counts);
  if (run.input.repair) {
    report["repair"] = repair_report(*run.input.repair);
  }
  if (run.results.size() == 1) {
    report["uniformization"] = uniformization_report(run.results.front().surface.report());
    add_remesh_report(report, run.results.front());
  } else {
    add_joined_report(report, run.input.components, run.results, run.joined);
  }
  add_run_report(report, start);
  report["seed"] = arguments.options.seed;
  report["threads"] = threads_used(arguments.options.threads);
  return report;
}

std::string geometry_text(const SurfaceRun& run) {
  std::vector<std::string> kinds;
  for (const RemeshResult& r : run.results) {
    const std::string& geometry = r.surface.report().geometry;
    if (std::find(kinds.begin(), kinds.end(), geometry) == kinds.end()) {
      kinds.push_back(geometry);
    }
  }
  std::string text = fmt::format("{}", fmt::join(kinds, ", "));
  if (run.results.size() > 1) {
    text += fmt::format(" ({} components)", run.results.size());
  }
  return text;
}

ExitStatus judge(const RemeshArguments& arguments, const JoinedReport& joined) {
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
  if (const std::int64_t added = joined.remesh.sites_added; added > 0) {
    say(fmt::format("added {} site{} so that the mesh is simplicial", added, added == 1 ? "" : "s"),
        false);
  }
  if (!joined.remesh.simplicial) {
    say("the mesh is not simplicial (loops or double edges); ask for more sites",
        arguments.options.ensure_simplicial);
  }
  if (!joined.cvt.converged) {
    say(not_converged(joined.cvt, arguments.options.tolerance), arguments.convergence_asked);
  }
  return status;
}

}  // namespace ucvt
