#include "app/figure_options.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/failure.h"
#include "app/option_parts.h"
#include "mesh/file_extension.h"
#include "ucvt/figure.h"

namespace ucvt {
namespace {

constexpr std::array<const char*, 7> show_names{"plain", "loops", "area",     "angle",
                                                "cells", "mesh",  "wireframe"};

std::string name_of(SurfaceShow show) {
  return show_names[static_cast<std::size_t>(show)];
}

void add_show(CLI::App& app, SurfaceShow& show, const std::vector<SurfaceShow>& choices,
              CLI::Option* figure) {
  std::vector<std::pair<std::string, SurfaceShow>> named;
  for (const SurfaceShow s : choices) {
    named.emplace_back(name_of(s), s);
  }
  show = choices.front();
  add_choice(app, "--show", show, named,
             fmt::format("what the figure shows (default {})", named.front().first))
      ->needs(figure);
}

/// Reads LON,LAT[,ROLL].
Camera parse_camera(const std::string& text) {
  Camera camera;
  const std::array<double*, 3> parts{&camera.lon_deg, &camera.lat_deg, &camera.roll_deg};
  std::string_view rest = text;
  std::size_t read = 0;
  for (bool more = true; more; ++read) {
    const std::size_t comma = rest.find(',');
    more = comma != std::string_view::npos;
    if (read == parts.size() || !parse_decimal(rest.substr(0, comma), *parts[read]) ||
        !std::isfinite(*parts[read])) {
      read = 0;
      break;
    }
    rest.remove_prefix(more ? comma + 1 : rest.size());
  }
  if (read < 2 || std::abs(camera.lat_deg) > 90) {
    throw CLI::ValidationError(
        "--camera",
        fmt::format("'{}' is no longitude, latitude and roll in degrees such as -60,25 or -90,90,0",
                    text));
  }
  return camera;
}

}  // namespace

void add_surface_figure(CLI::App& app, SurfaceFigureArguments& arguments,
                        const std::vector<SurfaceShow>& choices, bool mesh_edges) {
  CLI::Option* const figure =
      app.add_option("--figure", arguments.figure, "draw the surface")->type_name("FILE.{svg,png}");
  add_show(app, arguments.show, choices, figure);
  app.add_option_function<std::string>(
         "--camera",
         [&arguments](const std::string& t) { arguments.picture.camera = parse_camera(t); },
         "direction the surface is seen from, z up, in degrees (default -60,25)")
      ->type_name("LON,LAT[,ROLL]")
      ->needs(figure);
  CLI::Option* const cover = app.add_option("--cover", arguments.cover, "draw the universal cover")
                                 ->type_name("FILE.{svg,png}");
  add_number(
      app, "--width", arguments.picture.width, [](int w) { return w >= 100 && w <= 4000; },
      "a whole number from 100 to 4000",
      fmt::format("width of figures in pixels (default {})", arguments.picture.width))
      ->type_name("PX");
  if (mesh_edges) {
    app.add_flag("--mesh-edges", arguments.cover_picture.mesh_edges,
                 "draw the edges of the uniformized surface in the cover")
        ->needs(cover);
  }
}

void add_cover_coordinates(CLI::App& app, CoverCoordinates& coordinates) {
  add_choice<CoverCoordinates>(app, "--coordinates", coordinates,
                               {{"klein", CoverCoordinates::Klein},
                                {"poincare", CoverCoordinates::Poincare},
                                {"half-plane", CoverCoordinates::HalfPlane},
                                {"plane", CoverCoordinates::Plane}},
                               "of the cover (default klein; a torus has plane ones only)");
}

void check_figure_path(const std::string& option, const std::string& path,
                       const std::string& command) {
  check_extension(option, path, {".svg", ".png"}, command);
  if (file_extension(path) == ".png" && !can_write_png()) {
    fail_usage(fmt::format("{}: {}: this program was built without librsvg, which PNG files need; "
                           "write .svg",
                           option, path),
               command);
  }
}

void check_surface_figure(const SurfaceFigureArguments& arguments, const std::string& command) {
  check_figure_path("--figure", arguments.figure, command);
  check_figure_path("--cover", arguments.cover, command);
}

bool needs_cover(const SurfaceFigureArguments& a) {
  return !a.cover.empty() || (!a.figure.empty() && a.show == SurfaceShow::Loops);
}

MadeFigures make_figures(const SurfaceFigureArguments& a, const UniformizedSurface& surface,
                         const Cover* cover) {
  MadeFigures out;
  if (!a.figure.empty()) {
    const SurfaceValue value = a.show == SurfaceShow::Area    ? SurfaceValue::Area
                               : a.show == SurfaceShow::Angle ? SurfaceValue::Angle
                                                              : SurfaceValue::None;
    out.figures.emplace_back(a.figure, a.show == SurfaceShow::Loops
                                           ? loops_picture(*cover, a.picture)
                                           : surface_picture(surface, value, a.picture));
  }
  if (!a.cover.empty()) {
    CoverPictureOptions options = a.cover_picture;
    options.width = a.picture.width;
    out.figures.emplace_back(a.cover, cover_picture(*cover, options));
  }
  return out;
}

MadeFigures make_figures(const SurfaceFigureArguments& a, const RemeshResult& result,
                         const TriangleMesh& mesh, const Partition* cells) {
  MadeFigures out;
  if (!a.figure.empty()) {
    const MeshStyle style =
        a.show == SurfaceShow::Wireframe ? MeshStyle::Wireframe : MeshStyle::HiddenLines;
    out.figures.emplace_back(a.figure, a.show == SurfaceShow::Cells
                                           ? cells_picture(result, *cells, a.picture)
                                           : mesh_picture(mesh, style, a.picture));
  }
  if (!a.cover.empty()) {
    CoverPictureOptions options = a.cover_picture;
    options.width = a.picture.width;
    out.figures.emplace_back(a.cover, cell_cover_picture(result, options));
  }
  return out;
}

void write_figures(const MadeFigures& made) {
  for (const auto& [path, svg] : made.figures) {
    about_file(output_name(path), [&path = path, &svg = svg] { write_figure(path, svg); });
  }
}

}  // namespace ucvt
