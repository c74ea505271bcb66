#include "app/space_options.h"

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/failure.h"
#include "app/figure_options.h"
#include "cvt/formula.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// A value that the library refuses is wrong usage here.
template <typename Work>
void as_usage(const std::string& option, const Work& work) {
  try {
    work();
  } catch (const InvalidInput& error) {
    throw CLI::ValidationError(option, error.what());
  }
}

void add_computation(CLI::App& app, SpaceArguments& arguments) {
  SpaceOptions& options = arguments.options;
  const auto init = [&arguments](const std::string& text) {
    arguments.init_file.clear();
    if (text == "multilevel") {
      arguments.options.init = InitialSites::Multilevel;
    } else if (text == "random") {
      arguments.options.init = InitialSites::Random;
    } else {
      arguments.init_file = text;
    }
  };
  app.add_option_function<std::string>("--init", init,
                                       "where the sites start (default multilevel, in polygons "
                                       "random); FILE: as --sites wrote it")
      ->type_name("multilevel|random|FILE");
  add_seed(app, options.seed);
  add_method(app, options.method);
  app.add_option("--density", options.density, "density of the sites' mass, as in docs/spaces.md")
      ->type_name("FORMULA");
  add_number(
      app, "--quadrature", options.quadrature, [](double e) { return e > 0 && e < 1; },
      "a number between 0 and 1",
      fmt::format("relative error of the integrals of a formula (default {})", options.quadrature))
      ->type_name("EPS");
  add_threads(app, options.threads);
}

void add_outputs(CLI::App& app, SpaceArguments& arguments) {
  app.add_option("-o,--output", arguments.output,
                 "write the Delaunay mesh; - writes OFF to standard output")
      ->type_name("OUT.{obj,off,ply,stl}");
  app.add_option("--cells", arguments.cells, "write the cells as VTK polygons")
      ->type_name("FILE.vtu");
  app.add_option("--csv", arguments.csv, "write one line of measures for every cell")
      ->type_name("FILE.csv");
  app.add_option("--sites", arguments.sites, "write the sites")->type_name("FILE.json");
  app.add_option("--plot-energy", arguments.plot_energy, "plot the energy by iterations")
      ->type_name("FILE.{svg,png}");
  app.add_option("--plot-uniformity", arguments.plot_uniformity,
                 "plot radius, distance and area of the cells in ascending order")
      ->type_name("FILE.{svg,png}");
}

/// The colour of a cell: how, and by which measure.
using CellColour = std::pair<Fill, Measure>;

const std::vector<std::pair<std::string, CellColour>>& cell_colours() {
  static const std::vector<std::pair<std::string, CellColour>> colours = {
      {"degree", {Fill::DegreeClasses, Measure::Degree}},
      {"grey", {Fill::DegreeGreys, Measure::Degree}},
      {"area", {Fill::Measure, Measure::Area}},
      {"mass", {Fill::Measure, Measure::Mass}},
      {"energy", {Fill::Measure, Measure::Energy}},
      {"radius", {Fill::Measure, Measure::Radius}},
      {"nearest", {Fill::Measure, Measure::Nearest}},
      {"none", {Fill::None, Measure::Degree}}};
  return colours;
}

/// Options of the picture that every domain has. Returns --figure, which the others need.
CLI::Option* add_figure(CLI::App& app, SpaceArguments& arguments, CellColour& colour) {
  PictureOptions& picture = arguments.picture;
  CLI::Option* const figure =
      app.add_option("--figure", arguments.figure, "draw the cells")->type_name("FILE.{svg,png}");
  add_choice(app, "--figure-cells", colour, cell_colours(),
             "what the colour of a cell shows (default degree)")
      ->needs(figure);
  app.add_flag("--centroids", picture.centroids, "draw the centroids of the cells too")
      ->needs(figure);
  app.add_flag("--initial", picture.initial, "draw the initial cells instead of the final ones")
      ->needs(figure);
  return figure;
}

void add_sphere(CLI::App& app, SpaceArguments& arguments, CLI::Option* figure) {
  PictureOptions& picture = arguments.picture;
  add_choice<Projection>(
      app, "--projection", picture.projection,
      {{"orthographic", Projection::Orthographic}, {"both", Projection::BothHalves}},
      "draw the half that faces the viewer (default) or both")
      ->needs(figure);
  const auto view = [&picture](const std::string& text) {
    const std::size_t comma = text.find(',');
    const std::string_view all = text;
    if (comma == std::string::npos || !parse_decimal(all.substr(0, comma), picture.view_lon_deg) ||
        !parse_decimal(all.substr(comma + 1), picture.view_lat_deg) ||
        !std::isfinite(picture.view_lon_deg) || !(std::abs(picture.view_lat_deg) <= 90)) {
      throw CLI::ValidationError(
          "--view",
          fmt::format("'{}' is no longitude and latitude in degrees such as -90,30", text));
    }
  };
  app.add_option_function<std::string>("--view", view,
                                       "point below the viewer, in degrees (default 0,0)")
      ->type_name("LON,LAT")
      ->needs(figure);
  arguments.domain_text = "sphere";
  arguments.domain = sphere_domain();
}

void add_torus(CLI::App& app, SpaceArguments& arguments) {
  const auto lattice = [&arguments](const std::string& text) {
    as_usage("--lattice", [&] { arguments.domain = parse_lattice(text); });
    arguments.domain_text = text;
  };
  lattice("square");
  app.add_option_function<std::string>("--lattice", lattice,
                                       "vectors that span the torus (default square: 1,0:0,1)")
      ->type_name("square|hexagonal|A,B:C,D");
}

void add_domain(CLI::App& app, SpaceArguments& arguments, double kappa, const std::string& usual,
                const std::string& values) {
  const auto domain = [&arguments, kappa](const std::string& text) {
    as_usage("--domain", [&] { arguments.domain = parse_domain(kappa, text); });
    arguments.domain_text = text;
  };
  domain(usual);
  app.add_option_function<std::string>(
         "--domain", domain,
         fmt::format("default {}; FILE: corners of a convex polygon, one 'x y' a line", usual))
      ->type_name(values);
}

void add_hyperbolic(CLI::App& app, SpaceArguments& arguments, CLI::Option* figure) {
  add_choice<Projection>(app, "--projection", arguments.picture.projection,
                         {{"klein", Projection::Klein}, {"poincare", Projection::Poincare}},
                         "disk to draw (default klein)")
      ->needs(figure);
  add_choice<Coordinates>(app, "--coordinates", arguments.coordinates,
                          {{"klein", Coordinates::Central},
                           {"poincare", Coordinates::Poincare},
                           {"model", Coordinates::Model}},
                          "coordinates in the files of -o and --cells (default klein)");
}

double kappa_of(const std::string& command) {
  return command == "sphere" ? 1 : command == "hyperbolic" ? -1 : 0;
}

void check(const SpaceArguments& arguments) {
  const std::string& command = arguments.command;
  if (!arguments.sites_given && arguments.init_file.empty()) {
    fail_usage("-n N, the number of sites, is missing", command);
  }
  if (!arguments.domain && arguments.domain_text == "-" && arguments.init_file == "-") {
    fail_usage("both --domain and --init read standard input", command);
  }
  check_extension("-o", arguments.output, {".obj", ".off", ".ply", ".stl"}, command);
  check_extension("--cells", arguments.cells, {".vtu"}, command);
  check_extension("--csv", arguments.csv, {".csv"}, command);
  check_figure_path("--figure", arguments.figure, command);
  check_figure_path("--plot-energy", arguments.plot_energy, command);
  check_figure_path("--plot-uniformity", arguments.plot_uniformity, command);
  check_outputs(outputs_of(arguments), command);
  if (!arguments.options.density.empty()) {
    try {
      const DensityFormula formula(arguments.options.density, kappa_of(command));
    } catch (const InvalidInput& error) {
      fail_usage(fmt::format("--{}", error.what()), command);
    }
  }
}

}  // namespace

SpaceCommands::SpaceCommands(CLI::App& app) {
  Command& sphere = add(app, "sphere", "tessellate the sphere");
  add_sphere(*sphere.app, sphere.arguments, sphere.figure);
  Command& plane = add(app, "plane", "tessellate a convex polygon in the plane");
  add_domain(*plane.app, plane.arguments, 0, "rectangle:1x1",
             "regular:K[:RADIUS]|rectangle:WxH|FILE");
  Command& torus = add(app, "torus", "tessellate a flat torus");
  add_torus(*torus.app, torus.arguments);
  Command& hyperbolic = add(app, "hyperbolic",
                            "tessellate a convex polygon in the hyperbolic plane, or a closed "
                            "hyperbolic surface");
  add_domain(*hyperbolic.app, hyperbolic.arguments, -1, "regular:6:0.8",
             "regular:K[:RADIUS]|surface:G[:canonical]|FILE");
  add_hyperbolic(*hyperbolic.app, hyperbolic.arguments, hyperbolic.figure);
}

SpaceCommands::Command& SpaceCommands::add(CLI::App& app, const std::string& name,
                                           const std::string& description) {
  Command& command = commands_.emplace_back();
  command.app = app.add_subcommand(name, description);
  SpaceArguments& arguments = command.arguments;
  arguments.command = name;
  command.sites = add_sites(*command.app, arguments.options.sites);
  add_computation(*command.app, arguments);
  command.stop = add_stop(*command.app, arguments.options.iterations, arguments.options.tolerance);
  add_outputs(*command.app, arguments);
  command.figure = add_figure(*command.app, arguments, command.colour);
  add_shared(*command.app, arguments.shared);
  return command;
}

SpaceArguments SpaceCommands::parsed() {
  for (Command& command : commands_) {
    if (!command.app->parsed()) {
      continue;
    }
    SpaceArguments& out = command.arguments;
    out.sites_given = command.sites->count() > 0;
    out.convergence_asked = command.stop.ask_for_convergence();
    out.picture.fill = command.colour.first;
    out.picture.measure = command.colour.second;
    check(out);
    return out;
  }
  throw std::logic_error("no command of a space was given");
}

std::vector<std::string> outputs_of(const SpaceArguments& arguments) {
  return asked_for({arguments.output, arguments.cells, arguments.csv, arguments.sites,
                    arguments.figure, arguments.plot_energy, arguments.plot_uniformity,
                    arguments.shared.report});
}

}  // namespace ucvt
