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

void add_repair(CLI::App& app, SharedArguments& shared) {
  CLI::Option* const repair =
      app.add_flag("--repair", shared.repair,
                   "weld, split, orient and close small holes where the surface is not closed");
  add_number(
      app, "--weld", shared.repair_options.weld, [](double e) { return e >= 0 && e <= 1; },
      "a number from 0 to 1",
      fmt::format("repair: weld open vertices up to EPS of the bounding box' diagonal (default {})",
                  shared.repair_options.weld))
      ->type_name("EPS")
      ->needs(repair);
  add_number(
      app, "--holes", shared.repair_options.hole_edges, [](int k) { return k >= 0; },
      "a whole number from 0 up",
      fmt::format("repair: close holes of at most K edges (default {}), and very small ones",
                  shared.repair_options.hole_edges))
      ->type_name("K")
      ->needs(repair);
}

void add_component(CLI::App& app, SharedArguments& shared) {
  add_number(
      app, "--component", shared.component, [](int k) { return k >= 0; },
      "a whole number from 0 up", "take this component only, counted from 0 (default: all)")
      ->type_name("K");
}

struct RemeshFlags {
  CLI::Option* sites = nullptr;
  StopFlags stop;
};

void add_ply_output(CLI::App& app, std::string& output) {
  app.add_option("-o", output, "PLY to write; - writes standard output")
      ->required()
      ->type_name("OUT.ply");
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
  app.add_option_function<std::string>("--init", init,
                                       "where the sites start (default multilevel, on steep "
                                       "surfaces far apart); FILE: as --sites wrote it")
      ->type_name("multilevel|random|farthest|FILE");
  add_seed(app, arguments.options.seed);
}

void take(const RemeshFlags& flags, RemeshArguments& arguments) {
  arguments.sites_given = flags.sites->count() > 0;
  arguments.convergence_asked = flags.stop.ask_for_convergence();
}

/// What remesh and partition have in common, but the output.
RemeshFlags add_tessellation(CLI::App& app, RemeshArguments& arguments,
                             const std::vector<SurfaceShow>& shows) {
  RemeshFlags flags;
  add_input(app, arguments.shared);
  add_repair(app, arguments.shared);
  add_component(app, arguments.shared);
  flags.sites = add_sites(app, arguments.options.sites);
  app.add_option("--surface", arguments.surface, "write the uniformized surface as it was used")
      ->type_name("FILE.ply");
  app.add_option("--sites", arguments.sites, "write the sites on that surface")
      ->type_name("FILE.json");
  add_start(app, arguments);
  app.add_option("--checkpoint", arguments.checkpoint.path,
                 "write the state of the run now and then; --init FILE goes on from it")
      ->type_name("FILE.json");
  add_seconds(app, "--checkpoint-every", arguments.checkpoint.every_seconds,
              "least time from one checkpoint to the next (default 30)");
  flags.stop = add_stop(app, arguments.options.iterations, arguments.options.tolerance);
  add_method(app, arguments.options.method);
  app.add_flag("--ensure-simplicial,!--no-ensure-simplicial", arguments.options.ensure_simplicial,
               "add the few sites that a simplicial mesh needs (default: on)");
  app.add_flag("--check", arguments.check,
               "check the result once more, by other ways, before it is written");
  add_threads(app, arguments.options.threads);
  add_surface_figure(app, arguments.figures, shows, false);
  add_cover_coordinates(app, arguments.figures.cover_picture.coordinates);
  return flags;
}

RemeshFlags add_remesh(CLI::App& app, RemeshArguments& arguments) {
  app.add_option("-o", arguments.output, "mesh to write; - writes OFF to standard output")
      ->required()
      ->type_name("OUT.{obj,off,ply,stl}");
  return add_tessellation(app, arguments,
                          {SurfaceShow::Mesh, SurfaceShow::Wireframe, SurfaceShow::Cells});
}

RemeshFlags add_partition(CLI::App& app, PartitionArguments& arguments) {
  add_ply_output(app, arguments.remesh.output);
  app.add_option("--labels", arguments.labels, "write the cell of each input vertex and face")
      ->type_name("FILE.csv");
  app.add_option("--cells", arguments.cells, "write one line of measures for every cell")
      ->type_name("FILE.csv");
  return add_tessellation(app, arguments.remesh,
                          {SurfaceShow::Cells, SurfaceShow::Mesh, SurfaceShow::Wireframe});
}

void add_uniformize(CLI::App& app, UniformizeArguments& arguments) {
  add_input(app, arguments.shared);
  add_repair(app, arguments.shared);
  add_component(app, arguments.shared);
  add_ply_output(app, arguments.output);
  app.add_option("--group", arguments.group,
                 "write canonical generators of the deck group, the polygon and its pairings")
      ->type_name("FILE.json");
  app.add_option("--loops", arguments.loops, "write the generators as lines on the input")
      ->type_name("FILE.obj");
  app.add_option("--uv", arguments.uv, "write the surface with texture coordinates")
      ->type_name("FILE.obj");
  add_threads(app, arguments.threads);
  add_surface_figure(
      app, arguments.figures,
      {SurfaceShow::Plain, SurfaceShow::Loops, SurfaceShow::Area, SurfaceShow::Angle}, true);
  add_cover_coordinates(app, arguments.figures.cover_picture.coordinates);
}

void check(const RemeshArguments& arguments, const std::string& command) {
  if (!arguments.sites_given && arguments.init_file.empty()) {
    fail_usage("-n N, the number of sites, is missing", command);
  }
  if (arguments.shared.input == "-" && arguments.init_file == "-") {
    fail_usage("both the mesh and --init read standard input", command);
  }
  if (arguments.checkpoint.path == "-") {
    fail_usage("--checkpoint needs a file, not standard output", command);
  }
  check_extension("--surface", arguments.surface, {".ply"}, command);
  check_surface_figure(arguments.figures, command);
}

void check(const RemeshArguments& arguments) {
  check(arguments, "remesh");
  check_extension("-o", arguments.output, {".obj", ".off", ".ply", ".stl"}, "remesh");
  check_outputs(outputs_of(arguments), "remesh");
}

void check(const PartitionArguments& arguments) {
  check(arguments.remesh, "partition");
  check_extension("-o", arguments.remesh.output, {".ply"}, "partition");
  check_outputs(outputs_of(arguments), "partition");
}

void check(const UniformizeArguments& arguments) {
  check_extension("-o", arguments.output, {".ply"}, "uniformize");
  check_extension("--loops", arguments.loops, {".obj"}, "uniformize");
  check_extension("--uv", arguments.uv, {".obj"}, "uniformize");
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
                    arguments.figures.cover, arguments.shared.report, arguments.checkpoint.path});
}

std::vector<std::string> outputs_of(const PartitionArguments& arguments) {
  const RemeshArguments& remesh = arguments.remesh;
  return asked_for({remesh.output, arguments.labels, arguments.cells, remesh.surface, remesh.sites,
                    remesh.figures.figure, remesh.figures.cover, remesh.shared.report,
                    remesh.checkpoint.path});
}

std::vector<std::string> outputs_of(const UniformizeArguments& arguments) {
  return asked_for({arguments.output, arguments.group, arguments.loops, arguments.uv,
                    arguments.figures.figure, arguments.figures.cover, arguments.shared.report});
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
  PartitionArguments partition;
  UniformizeArguments uniformize;
  InfoArguments info;
  CLI::App* const remesh_app =
      app.add_subcommand("remesh", "write the dual mesh of a tessellation with N sites");
  const RemeshFlags remesh_flags = add_remesh(*remesh_app, remesh);
  CLI::App* const partition_app =
      app.add_subcommand("partition", "write the input cut along the cells of a tessellation");
  const RemeshFlags partition_flags = add_partition(*partition_app, partition);
  CLI::App* const uniformize_app =
      app.add_subcommand("uniformize", "write the conformal surface of constant curvature");
  add_uniformize(*uniformize_app, uniformize);
  CLI::App* const info_app = app.add_subcommand("info", "print topology, faults and quality");
  add_input(*info_app, info.shared);
  add_repair(*info_app, info.shared);
  SpaceCommands spaces(app);

  check_command_name(argc, argv, app);
  if (std::string text = parse(app, argc, argv); !text.empty()) {
    return TextRequest{std::move(text)};
  }
  check_not_empty(*app.get_subcommands().front());
  if (remesh_app->parsed()) {
    take(remesh_flags, remesh);
    check(remesh);
    return remesh;
  }
  if (partition_app->parsed()) {
    take(partition_flags, partition.remesh);
    check(partition);
    return partition;
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
