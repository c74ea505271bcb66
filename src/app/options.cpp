#include "app/options.h"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/option_parts.h"
#include "app/space_options.h"

namespace ucvt {
namespace {

void add_input(CLI::App& app, SharedArguments& shared) {
  app.add_option("IN", shared.input, "mesh to read: OFF, OBJ, PLY or STL; - reads standard input")
      ->required();
  add_shared(app, shared);
}

struct RemeshFlags {
  CLI::Option* sites = nullptr;
  StopFlags stop;
};

void add_method(CLI::App& app, Method& method) {
  const auto set = [&method](const std::string& name) {
    if (name != "lbfgs" && name != "lloyd") {
      throw CLI::ValidationError("--method",
                                 fmt::format("'{}' is no method; give lbfgs or lloyd", name));
    }
    method = name == "lloyd" ? Method::Lloyd : Method::Lbfgs;
  };
  app.add_option_function<std::string>("--method", set, "how sites are moved (default lbfgs)")
      ->type_name("lbfgs|lloyd");
}

void add_start(CLI::App& app, RemeshArguments& arguments) {
  const auto init = [&arguments](const std::string& text) {
    arguments.init_file.clear();
    if (text == "multilevel") {
      arguments.options.init = InitialSites::Multilevel;
    } else if (text == "random") {
      arguments.options.init = InitialSites::Random;
    } else if (text == "farthest") {
      arguments.options.init = InitialSites::Farthest;
    } else {
      arguments.init_file = text;
    }
  };
  app.add_option_function<std::string>(
         "--init", init, "where the sites start (default multilevel); FILE: as --sites wrote it")
      ->type_name("multilevel|random|farthest|FILE");
  add_seed(app, arguments.options.seed);
}

RemeshFlags add_remesh(CLI::App& app, RemeshArguments& arguments) {
  RemeshFlags flags;
  add_input(app, arguments.shared);
  flags.sites = add_sites(app, arguments.options.sites);
  app.add_option("-o", arguments.output, "mesh to write; - writes OFF to standard output")
      ->required()
      ->type_name("OUT.{obj,off,ply,stl}");
  app.add_option("--surface", arguments.surface, "write the uniformized surface as it was used")
      ->type_name("FILE.ply");
  app.add_option("--sites", arguments.sites, "write the sites on that surface")
      ->type_name("FILE.json");
  add_start(app, arguments);
  flags.stop = add_stop(app, arguments.options.iterations, arguments.options.tolerance);
  add_method(app, arguments.options.method);
  app.add_flag("--ensure-simplicial,!--no-ensure-simplicial", arguments.options.ensure_simplicial,
               "add the few sites that a simplicial mesh needs (default: on)");
  add_threads(app, arguments.options.threads);
  add_surface_figure(app, arguments.figures,
                     {SurfaceShow::Mesh, SurfaceShow::Wireframe, SurfaceShow::Cells}, false);
  add_cover_coordinates(app, arguments.figures.cover_picture.coordinates);
  return flags;
}

void add_uniformize(CLI::App& app, UniformizeArguments& arguments) {
  add_input(app, arguments.shared);
  app.add_option("-o", arguments.output, "PLY to write; - writes standard output")
      ->required()
      ->type_name("OUT.ply");
  add_threads(app, arguments.threads);
  add_surface_figure(
      app, arguments.figures,
      {SurfaceShow::Plain, SurfaceShow::Loops, SurfaceShow::Area, SurfaceShow::Angle}, true);
  add_cover_coordinates(app, arguments.figures.cover_picture.coordinates);
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
  check_surface_figure(arguments.figures, command);
  check_outputs(outputs_of(arguments), command);
}

void check(const UniformizeArguments& arguments) {
  check_extension("-o", arguments.output, {".ply"}, "uniformize");
  check_surface_figure(arguments.figures, "uniformize");
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
  return asked_for({arguments.output, arguments.surface, arguments.sites, arguments.figures.figure,
                    arguments.figures.cover, arguments.shared.report});
}

std::vector<std::string> outputs_of(const UniformizeArguments& arguments) {
  return asked_for({arguments.output, arguments.figures.figure, arguments.figures.cover,
                    arguments.shared.report});
}

std::vector<std::string> outputs_of(const InfoArguments& arguments) {
  return asked_for({arguments.shared.report});
}

Arguments parse_arguments(int argc, const char* const* argv) {
  CLI::App app(
      "Centroidal Voronoi tessellations of the sphere, the plane and the hyperbolic plane, and of "
      "closed surfaces in their universal cover.",
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
  add_input(*info_app, info.shared);
  SpaceCommands spaces(app);

  check_command_name(argc, argv, app);
  if (std::string text = parse(app, argc, argv); !text.empty()) {
    return TextRequest{std::move(text)};
  }
  check_not_empty(*app.get_subcommands().front());
  if (remesh_app->parsed()) {
    remesh.sites_given = flags.sites->count() > 0;
    remesh.convergence_asked = flags.stop.ask_for_convergence();
    check(remesh);
    return remesh;
  }
  if (uniformize_app->parsed()) {
    check(uniformize);
    return uniformize;
  }
  if (info_app->parsed()) {
    return info;
  }
  return spaces.parsed();
}

}  // namespace ucvt
