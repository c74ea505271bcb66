// The command line as data.
//
// `parse_arguments` settles everything that can be settled without touching a file: which command,
// the values of its options, that at most one output goes to standard output, that extensions name
// formats. The commands take these structs.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "ucvt/remesh.h"

namespace ucvt {

struct SharedArguments {
  std::string input;   ///< "-": standard input
  std::string report;  ///< empty: none
  bool quiet = false;
  bool verbose = false;
};

struct RemeshArguments {
  SharedArguments shared;
  std::string output;
  std::string surface;    ///< empty: not written
  std::string sites;      ///< empty: not written
  std::string init_file;  ///< empty: options.init holds
  RemeshOptions options;
  bool sites_given = false;
  bool convergence_asked = false;  ///< a tolerance was given and no number of iterations
};

struct UniformizeArguments {
  SharedArguments shared;
  std::string output;
  int threads = 0;  ///< 0: all cores
};

struct InfoArguments {
  SharedArguments shared;
};

/// What --help and --version ask for.
struct TextRequest {
  std::string text;
};

using Arguments = std::variant<TextRequest, RemeshArguments, UniformizeArguments, InfoArguments>;

/// The outputs that are asked for, in the order in which they are written.
std::vector<std::string> outputs_of(const RemeshArguments& arguments);
std::vector<std::string> outputs_of(const UniformizeArguments& arguments);
std::vector<std::string> outputs_of(const InfoArguments& arguments);

/// Reads the command line. Throws Failure (ExitStatus::Usage) with a line that names the option and
/// ends in the hint at --help.
Arguments parse_arguments(int argc, const char* const* argv);

}  // namespace ucvt
