// The options of the commands sphere, plane, torus and hyperbolic.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "app/option_parts.h"
#include "app/options.h"

namespace ucvt {

/// Adds the four commands to the app, which must outlive this object.
class SpaceCommands {
 public:
  explicit SpaceCommands(CLI::App& app);
  SpaceCommands(const SpaceCommands&) = delete;
  SpaceCommands& operator=(const SpaceCommands&) = delete;
  ~SpaceCommands() = default;

  /// The command that was given. Requires that one was. Throws Failure when its options do not fit.
  SpaceArguments parsed();

 private:
  struct Command {
    CLI::App* app = nullptr;
    CLI::Option* sites = nullptr;
    CLI::Option* figure = nullptr;
    StopFlags stop;
    std::pair<Fill, Measure> colour{Fill::DegreeClasses, Measure::Degree};
    SpaceArguments arguments;
  };
  Command& add(CLI::App& app, const std::string& name, const std::string& description);

  std::deque<Command> commands_;  // options point into the elements
};

/// Reads the value of --lattice: square, hexagonal or two vectors "a,b:c,d". Throws InvalidInput.
Domain parse_lattice(const std::string& text);

/// Reads the value of --domain in the plane (kappa 0) or the hyperbolic plane (kappa -1); none when
/// it names a file. Throws InvalidInput.
std::optional<Domain> parse_domain(double kappa, const std::string& text);

}  // namespace ucvt
