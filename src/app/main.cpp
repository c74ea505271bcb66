// The ucvt command: reads the command line, runs the command, turns failures into exit statuses.
#include <exception>
#include <new>
#include <string>
#include <variant>

#include <unistd.h>

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
    print_line_to_stderr(not_enough_memory);
  } catch (const std::exception& error) {
    print_line_to_stderr(std::string("unexpected failure (") + error.what() +
                         "); please report it");
  }
  return ExitStatus::NotFinished;
}

/// Memory may end where no exception can pass, which is no reason to abort.
[[noreturn]] void end_in_order() {
  try {
    if (const std::exception_ptr current = std::current_exception()) {
      std::rethrow_exception(current);
    }
    print_line_to_stderr("unexpected failure; please report it");
  } catch (const std::bad_alloc&) {
    print_line_to_stderr(not_enough_memory);
  } catch (...) {
    print_line_to_stderr("unexpected failure; please report it");
  }
  ::_exit(static_cast<int>(ExitStatus::NotFinished));
}

}  // namespace
}  // namespace ucvt

int main(int argc, char** argv) {
  std::set_terminate(ucvt::end_in_order);
  try {
    return static_cast<int>(ucvt::run(argc, argv));
  } catch (...) {
    return static_cast<int>(ucvt::ExitStatus::NotFinished);
  }
}
