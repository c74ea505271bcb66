#include "app/option_parts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/ranges.h>

#include "app/failure.h"
#include "mesh/file_extension.h"
#include "ucvt/version.h"

namespace ucvt {
namespace {

constexpr int most_threads = 1024;
constexpr std::int64_t most_megabytes = 1'000'000'000;
constexpr double most_seconds = 1e9;

/// Paths that name one file compare equal, as far as the file system knows.
std::string canonical(const std::string& path) {
  std::error_code error;
  const std::filesystem::path found =
      std::filesystem::weakly_canonical(std::filesystem::absolute(path), error);
  return error ? path : found.lexically_normal().string();
}

}  // namespace

const char* const version_line = "ucvt " UCVT_VERSION;

namespace {

void add_limits(CLI::App& app, LimitArguments& limits) {
  add_seconds(app, "--time-limit", limits.seconds, "end the run, without outputs, after so long");
  add_number(
      app, "--memory-limit", limits.megabytes,
      [](std::int64_t mb) { return mb >= 1 && mb <= most_megabytes; },
      fmt::format("a whole number from 1 to {}", most_megabytes),
      "end the run, without outputs, when it needs more memory")
      ->type_name("MB");
}

}  // namespace

void add_seconds(CLI::App& app, const std::string& name, double& seconds,
                 const std::string& description) {
  add_number(
      app, name, seconds, [](double s) { return s >= 0 && s <= most_seconds; },
      fmt::format("a number from 0 to {:.0e}", most_seconds), description)
      ->type_name("SECONDS");
}

void add_shared(CLI::App& app, SharedArguments& shared) {
  app.add_option("--report", shared.report, "write a report as JSON")->type_name("FILE.json");
  CLI::Option* const quiet = app.add_flag("--quiet", shared.quiet, "print errors only");
  app.add_flag("--verbose", shared.verbose, "print one line for every iteration")->excludes(quiet);
  app.set_version_flag("--version", version_line, "print the version");
  add_limits(app, shared.limits);
}

void add_threads(CLI::App& app, int& threads) {
  add_number(
      app, "--threads", threads, [](int t) { return t >= 1 && t <= most_threads; },
      fmt::format("a whole number from 1 to {}", most_threads),
      "threads to use (default: all cores); results do not depend on it")
      ->type_name("T");
}

void add_seed(CLI::App& app, std::uint64_t& seed) {
  add_number(
      app, "--seed", seed, [](std::uint64_t) { return true; }, "a whole number from 0 up",
      "start of the random numbers (default 1)")
      ->type_name("S");
}

void add_method(CLI::App& app, Method& method) {
  add_choice<Method>(app, "--method", method, {{"lbfgs", Method::Lbfgs}, {"lloyd", Method::Lloyd}},
                     "how sites are moved (default lbfgs)");
}

CLI::Option* add_sites(CLI::App& app, int& sites) {
  return add_number(
             app, "-n", sites, [](int n) { return n >= 1; }, "a whole number from 1 up",
             "number of sites; may be left out when --init names a file")
      ->type_name("N");
}

bool StopFlags::ask_for_convergence() const {
  return tolerance->count() > 0 && iterations->count() == 0;
}

StopFlags add_stop(CLI::App& app, int& iterations, double& tolerance) {
  StopFlags flags;
  flags.iterations = add_number(
      app, "--iterations", iterations, [](int k) { return k >= 0; }, "a whole number from 0 up",
      fmt::format("stop after K iterations (default {})", iterations));
  flags.iterations->type_name("K");
  flags.tolerance = add_number(
      app, "--tolerance", tolerance, [](double e) { return e > 0 && std::isfinite(e); },
      "a number above 0",
      fmt::format("stop when no site moves by more than EPS of its spacing (default {})",
                  tolerance > 0 ? fmt::to_string(tolerance)
                                : "0.001, or when the energy hardly falls any more"));
  flags.tolerance->type_name("EPS");
  return flags;
}

void fail_usage(const std::string& message, const std::string& command) {
  throw Failure(ExitStatus::Usage, fmt::format("{}; try 'ucvt{} --help'", message,
                                               command.empty() ? "" : ' ' + command));
}

std::vector<std::string> asked_for(std::vector<std::string> paths) {
  std::erase(paths, "");
  return paths;
}

void check_outputs(const std::vector<std::string>& outputs, const std::string& command) {
  if (std::count(outputs.begin(), outputs.end(), "-") > 1) {
    fail_usage("more than one output goes to standard output", command);
  }
  std::vector<std::string> files;
  files.reserve(outputs.size());
  for (const std::string& path : outputs) {
    files.push_back(path == "-" ? path : canonical(path));
  }
  std::sort(files.begin(), files.end());
  const auto twice = std::adjacent_find(files.begin(), files.end());
  if (twice != files.end() && !twice->starts_with("/dev/")) {
    fail_usage(fmt::format("{}: more than one output goes to this file", *twice), command);
  }
}

void check_extension(const std::string& option, const std::string& path,
                     const std::vector<std::string>& known, const std::string& command) {
  if (path.empty() || path == "-") {
    return;
  }
  const std::string extension = file_extension(path);
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    fail_usage(fmt::format("{}: {}: the extension '{}' is none of {}", option, path, extension,
                           fmt::join(known, " ")),
               command);
  }
}

}  // namespace ucvt
