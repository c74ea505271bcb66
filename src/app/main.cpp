// The ucvt command: reads the command line, runs the command, turns failures into exit statuses.
#include <exception>
#include <new>
#include <string>
#include <variant>

#include "app/failure.h"
#include "app/info_command.h"
#include "app/options.h"
#include "app/outputs.h"
#include "app/partition_command.h"
#include "app/remesh_command.h"
#include "app/signals.h"
#include "app/space_command.h"
#include "app/uniformize_command.h"

namespace ucvt {
namespace {

struct CommandRunner {
  ExitStatus operator()(const TextRequest& request) const {
    catch_signals();
    print_results(request.text);
    return ExitStatus::Done;
  }
  ExitStatus operator()(const RemeshArguments& arguments) const { return run_remesh(arguments); }
  ExitStatus operator()(const PartitionArguments& arguments) const {
    return run_partition(arguments);
  }
  ExitStatus operator()(const UniformizeArguments& arguments) const {
    return run_uniformize(arguments);
  }
  ExitStatus operator()(const InfoArguments& arguments) const { return run_info(arguments); }
  ExitStatus operator()(const SpaceArguments& arguments) const { return run_space(arguments); }
};

ExitStatus run(int argc, const char* const* argv) {
  try {
    reserve_standard_streams();
    return std::visit(CommandRunner(), parse_arguments(argc, argv));
  } catch (const Failure& failure) {
    print_line_to_stderr(failure.what());
    return failure.status();
  } catch (const std::bad_alloc&) {
    print_line_to_stderr("not enough memory; give a smaller mesh or ask for fewer sites");
  } catch (const std::exception& error) {
    print_line_to_stderr(std::string("unexpected failure (") + error.what() +
                         "); please report it");
  }
  return ExitStatus::NotFinished;
}

}  // namespace
}  // namespace ucvt

int main(int argc, char** argv) {
  try {
    return static_cast<int>(ucvt::run(argc, argv));
  } catch (...) {
    return static_cast<int>(ucvt::ExitStatus::NotFinished);
  }
}
