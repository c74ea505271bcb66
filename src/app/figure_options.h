// The options of pictures of surfaces and covers, and the pictures of a result.
//
// A command has --figure with what it can show, --cover where there is a cover, and the options of
// both. Pictures are made before the first file is written, and written one after the other.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "ucvt/partition.h"
#include "ucvt/remesh.h"
#include "ucvt/surface_figure.h"

namespace ucvt {

/// What --show names.
enum class SurfaceShow : char { Plain, Loops, Area, Angle, Cells, Mesh, Wireframe };

struct SurfaceFigureArguments {
  std::string figure;  ///< empty: none
  std::string cover;   ///< empty: none
  SurfaceShow show = SurfaceShow::Plain;
  SurfacePictureOptions picture;
  CoverPictureOptions cover_picture;
};

/// Adds --figure, --show with these choices, the first of which is the default, --camera, --width,
/// --cover and, if asked for, --mesh-edges.
void add_surface_figure(CLI::App& app, SurfaceFigureArguments& arguments,
                        const std::vector<SurfaceShow>& choices, bool mesh_edges);

/// Adds --coordinates: those of a cover's picture and files.
void add_cover_coordinates(CLI::App& app, CoverCoordinates& coordinates);

/// Checks the extensions. Throws Failure.
void check_surface_figure(const SurfaceFigureArguments& arguments, const std::string& command);

/// A figure path is .svg or .png, and .png can be written. Throws Failure.
void check_figure_path(const std::string& option, const std::string& path,
                       const std::string& command);

/// Pictures not yet written: paths and SVG texts.
struct MadeFigures {
  std::vector<std::pair<std::string, std::string>> figures;
};

/// Whether pictures of a uniformized surface take its cover.
bool needs_cover(const SurfaceFigureArguments& arguments);

MadeFigures make_figures(const SurfaceFigureArguments& arguments, const UniformizedSurface& surface,
                         const Cover* cover);
/// Takes the partition only where cells are shown, and the result only for cells and the cover.
MadeFigures make_figures(const SurfaceFigureArguments& arguments, const RemeshResult& result,
                         const TriangleMesh& mesh, const Partition* cells);

/// Throws Failure that names the file.
void write_figures(const MadeFigures& made);

}  // namespace ucvt
