// The command line as data.
//
// `parse_arguments` settles everything that can be settled without touching a file: which command,
// the values of its options, that at most one output goes to standard output, that extensions name
// formats. The commands take these structs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/figure_options.h"
#include "ucvt/figure.h"
#include "ucvt/remesh.h"
#include "ucvt/repair.h"
#include "ucvt/space_files.h"
#include "ucvt/spaces.h"

namespace ucvt {

struct LimitArguments {
  double seconds = 0;          ///< 0: none
  std::int64_t megabytes = 0;  ///< of memory that the program may take; 0: no limit
};

struct CheckpointArguments {
  std::string path;           ///< empty: none
  double every_seconds = 30;  ///< 0: at every restart point
};

struct SharedArguments {
  std::string input;   ///< "-": standard input; empty for the commands that read no mesh
  std::string report;  ///< empty: none
  bool quiet = false;
  bool verbose = false;
  bool repair = false;
  RepairOptions repair_options;
  int component = -1;  ///< -1: all
  LimitArguments limits;
};

/// Of remesh, and of what partition has in common with it.
struct RemeshArguments {
  SharedArguments shared;
  std::string output;
  std::string surface;    ///< empty: not written
  std::string sites;      ///< empty: not written
  std::string init_file;  ///< empty: options.init holds
  CheckpointArguments checkpoint;
  RemeshOptions options;
  SurfaceFigureArguments figures;
  bool check = false;
  bool sites_given = false;
  bool convergence_asked = false;  ///< a tolerance was given and no number of iterations
};

struct PartitionArguments {
  RemeshArguments remesh;
  std::string labels;  ///< empty: not written
  std::string cells;   ///< empty: not written
};

struct UniformizeArguments {
  SharedArguments shared;
  std::string output;
  // Outputs of the deck group; those that are empty are not written.
  std::string group;
  std::string loops;
  std::string uv;
  SurfaceFigureArguments figures;  ///< its coordinates are those of the UV output too
  int threads = 0;                 ///< 0: all cores
};

struct InfoArguments {
  SharedArguments shared;
};

/// Of the commands sphere, plane, torus and hyperbolic.
struct SpaceArguments {
  SharedArguments shared;
  std::string command;
  std::string domain_text;       ///< as it was given
  std::optional<Domain> domain;  ///< none: `domain_text` names a file that holds a polygon
  std::string init_file;         ///< empty: random sites
  SpaceOptions options;
  bool sites_given = false;
  bool convergence_asked = false;  ///< a tolerance was given and no number of iterations
  // Outputs; those that are empty are not written.
  std::string output;  ///< the Delaunay mesh
  std::string cells;
  std::string csv;
  std::string sites;
  std::string figure;
  std::string plot_energy;
  std::string plot_uniformity;
  Coordinates coordinates = Coordinates::Central;  ///< of the mesh and the cells
  PictureOptions picture{.fill = Fill::DegreeClasses};
};

/// What --help and --version ask for.
struct TextRequest {
  std::string text;
};

using Arguments = std::variant<TextRequest, RemeshArguments, PartitionArguments,
                               UniformizeArguments, InfoArguments, SpaceArguments>;

/// The outputs that are asked for, in the order in which they are written.
std::vector<std::string> outputs_of(const RemeshArguments& arguments);
std::vector<std::string> outputs_of(const PartitionArguments& arguments);
std::vector<std::string> outputs_of(const UniformizeArguments& arguments);
std::vector<std::string> outputs_of(const InfoArguments& arguments);
std::vector<std::string> outputs_of(const SpaceArguments& arguments);

/// Reads the command line. Throws Failure (ExitStatus::Usage) with a line that names the option and
/// ends in the hint at --help.
Arguments parse_arguments(int argc, const char* const* argv);

}  // namespace ucvt
