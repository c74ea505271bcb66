#include "app/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>
#include <type_traits>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/failure.h"
#include "mesh/file_extension.h"
#include "ucvt/version.h"

namespace ucvt {
namespace {

constexpr int most_threads = 1024;
const char* const version_line = "ucvt " UCVT_VERSION;

/// A number written in decimal; CLI11 would read 010 as eight.
template <typename Number>
bool parse_decimal(const std::string& text, Number& value) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

/// Adds an option that takes a number for which `accepts` holds.
template <typename Number, typename Accepts>
CLI::Option* add_number(CLI::App& app, const std::string& name, Number& target,
                        const Accepts& accepts, const std::string& wanted,
                        const std::string& description) {
  const auto read = [name, &target, accepts, wanted](const CLI::results_t& values) {
    const std::string& text = values.at(0);
    Number value = 0;
    if (!parse_decimal(text, value) || !accepts(value)) {
      throw CLI::ValidationError(name, fmt::format("'{}' is not {}", text, wanted));
    }
    target = value;
    return true;
  };
  return app.add_option(name, read, description);
}

void add_shared(CLI::App& app, SharedArguments& shared) {
  app.add_option("IN", shared.input, "mesh to read: OFF, OBJ, PLY or STL; - reads standard input")
      ->required();
  app.add_option("--report", shared.report, "write a report as JSON")->type_name("FILE.json");
  CLI::Option* const quiet = app.add_flag("--quiet", shared.quiet, "print errors only");
  app.add_flag("--verbose", shared.verbose, "print one line for every iteration")->excludes(quiet);
  app.set_version_flag("--version", version_line, "print the version");
}

void add_threads(CLI::App& app, int& threads) {
  add_number(
      app, "--threads", threads, [](int t) { return t >= 1 && t <= most_threads; },
      fmt::format("a whole number from 1 to {}", most_threads),
      "threads to use (default: all cores); results do not depend on it")
      ->type_name("T");
}

struct RemeshFlags {
  CLI::Option* sites = nullptr;
  CLI::Option* iterations = nullptr;
  CLI::Option* tolerance = nullptr;
};

void add_lloyd(CLI::App& app, RemeshOptions& options, RemeshFlags& flags) {
  flags.iterations = add_number(
      app, "--iterations", options.iterations, [](int k) { return k >= 0; },
      "a whole number from 0 up",
      fmt::format("stop after K iterations (default {})", options.iterations));
  flags.iterations->type_name("K");
  flags.tolerance = add_number(
      app, "--tolerance", options.tolerance, [](double e) { return e > 0 && std::isfinite(e); },
      "a number above 0",
      fmt::format("stop when no site moves by more than EPS of its spacing (default {})",
                  options.tolerance));
  flags.tolerance->type_name("EPS");
  const auto method = [](const std::string& name) {
    if (name != "lloyd") {
      throw CLI::ValidationError("--method", fmt::format("'{}' is no method; give lloyd", name));
    }
  };
  app.add_option_function<std::string>("--method", method, "how sites are moved (default lloyd)")
      ->type_name("lloyd");
}

void add_start(CLI::App& app, RemeshArguments& arguments) {
  const auto init = [&arguments](const std::string& text) {
    arguments.init_file.clear();
    if (text == "random") {
      arguments.options.init = InitialSites::Random;
    } else if (text == "farthest") {
      arguments.options.init = InitialSites::Farthest;
    } else {
      arguments.init_file = text;
    }
  };
  app.add_option_function<std::string>(
         "--init", init, "where the sites start (default random); FILE: as --sites wrote it")
      ->type_name("random|farthest|FILE");
  add_number(
      app, "--seed", arguments.options.seed, [](std::uint64_t) { return true; },
      "a whole number from 0 up", "start of the random numbers (default 1)")
      ->type_name("S");
}

RemeshFlags add_remesh(CLI::App& app, RemeshArguments& arguments) {
  RemeshFlags flags;
  add_shared(app, arguments.shared);
  flags.sites = add_number(
      app, "-n", arguments.options.sites, [](int n) { return n >= 1; }, "a whole number from 1 up",
      "number of sites; may be left out when --init names a file");
  flags.sites->type_name("N");
  app.add_option("-o", arguments.output, "mesh to write; - writes OFF to standard output")
      ->required()
      ->type_name("OUT.{obj,off,ply,stl}");
  app.add_option("--surface", arguments.surface, "write the uniformized surface as it was used")
      ->type_name("FILE.ply");
  app.add_option("--sites", arguments.sites, "write the sites on that surface")
      ->type_name("FILE.json");
  add_start(app, arguments);
  add_lloyd(app, arguments.options, flags);
  app.add_flag("--ensure-simplicial,!--no-ensure-simplicial", arguments.options.ensure_simplicial,
               "add the few sites that a simplicial mesh needs (default: on)");
  add_threads(app, arguments.options.threads);
  return flags;
}

void add_uniformize(CLI::App& app, UniformizeArguments& arguments) {
  add_shared(app, arguments.shared);
  app.add_option("-o", arguments.output, "PLY to write; - writes standard output")
      ->required()
      ->type_name("OUT.ply");
  add_threads(app, arguments.threads);
}

[[noreturn]] void fail_usage(const std::string& message, const std::string& command) {
  throw Failure(ExitStatus::Usage, fmt::format("{}; try 'ucvt{} --help'", message,
                                               command.empty() ? "" : ' ' + command));
}

std::vector<std::string> asked_for(std::vector<std::string> paths) {
  std::erase(paths, "");
  return paths;
}

/// Paths that name one file compare equal, as far as the file system knows.
std::string canonical(const std::string& path) {
  std::error_code error;
  const std::filesystem::path found =
      std::filesystem::weakly_canonical(std::filesystem::absolute(path), error);
  return error ? path : found.lexically_normal().string();
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

void check(const RemeshArguments& arguments) {
  const std::string command = "remesh";
  if (!arguments.sites_given && arguments.init_file.empty()) {
    fail_usage("-n N, the number of sites, is missing", command);
  }
  if (arguments.shared.input == "-" && arguments.init_file == "-") {
    fail_usage("both the mesh and --init read standard input", command);
  }
  check_extension("-o", arguments.output, {".obj", ".off", ".ply", ".stl"}, command);
  check_extension("--surface", arguments.surface, {".ply"}, command);
  check_outputs(outputs_of(arguments), command);
}

void check(const UniformizeArguments& arguments) {
  check_extension("-o", arguments.output, {".ply"}, "uniformize");
  check_outputs(outputs_of(arguments), "uniformize");
}

void check_not_empty(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const auto& values = option->results();
    if (option->get_items_expected_max() > 0 &&
        std::find(values.begin(), values.end(), "") != values.end()) {
      fail_usage(fmt::format("{} is empty", option->get_name()), command.get_name());
    }
  }
}

void check_command_name(int argc, const char* const* argv, const CLI::App& app) {
  if (argc < 2) {
    fail_usage("no command is given", "");
  }
  const std::string first = argv[1];
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  if (!first.starts_with("-") &&
      std::none_of(commands.begin(), commands.end(),
                   [&](const CLI::App* command) { return command->get_name() == first; })) {
    fail_usage(fmt::format("there is no command '{}'", first), "");
  }
}

/// Runs CLI11; gives the text that --help or --version ask for, else an empty one.
std::string parse(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion&) {
    return std::string(version_line) + "\n";
  } catch (const CLI::Success&) {
    return app.help();
  } catch (const CLI::ParseError& error) {
    const auto commands = app.get_subcommands();
    if (commands.empty()) {
      fail_usage(fmt::format("'{}' is no option and no command", argv[1]), "");
    }
    fail_usage(error.what(), commands.front()->get_name());
  }
  return "";
}

}  // namespace

std::vector<std::string> outputs_of(const RemeshArguments& arguments) {
  return asked_for({arguments.output, arguments.surface, arguments.sites, arguments.shared.report});
}

std::vector<std::string> outputs_of(const UniformizeArguments& arguments) {
  return asked_for({arguments.output, arguments.shared.report});
}

std::vector<std::string> outputs_of(const InfoArguments& arguments) {
  return asked_for({arguments.shared.report});
}

Arguments parse_arguments(int argc, const char* const* argv) {
  CLI::App app("Centroidal Voronoi tessellations in the universal cover of a closed surface.",
               "ucvt");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_line, "print the version");
  RemeshArguments remesh;
  UniformizeArguments uniformize;
  InfoArguments info;
  CLI::App* const remesh_app =
      app.add_subcommand("remesh", "write the dual mesh of a tessellation with N sites");
  const RemeshFlags flags = add_remesh(*remesh_app, remesh);
  CLI::App* const uniformize_app =
      app.add_subcommand("uniformize", "write the conformal surface of constant curvature");
  add_uniformize(*uniformize_app, uniformize);
  CLI::App* const info_app = app.add_subcommand("info", "print topology, faults and quality");
  add_shared(*info_app, info.shared);

  check_command_name(argc, argv, app);
  if (std::string text = parse(app, argc, argv); !text.empty()) {
    return TextRequest{std::move(text)};
  }
  check_not_empty(*app.get_subcommands().front());
  if (remesh_app->parsed()) {
    remesh.sites_given = flags.sites->count() > 0;
    remesh.convergence_asked = flags.tolerance->count() > 0 && flags.iterations->count() == 0;
    check(remesh);
    return remesh;
  }
  if (uniformize_app->parsed()) {
    check(uniformize);
    return uniformize;
  }
  return info;
}

}  // namespace ucvt
