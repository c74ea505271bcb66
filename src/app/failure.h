// How a command ends when it does not end well: an exit status and one line for stderr.
//
// The library's exceptions know neither the program nor the file; this is where the file's name is
// put before their message and where their kind becomes an exit status. Serves all commands.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace ucvt {

enum class ExitStatus : std::uint8_t { Done = 0, NotFinished = 1, Usage = 2, BadInput = 3 };

/// Ends the command; `what()` is the line without the program's name.
class Failure : public std::runtime_error {
 public:
  Failure(ExitStatus status, const std::string& line) : std::runtime_error(line), status_(status) {}
  [[nodiscard]] ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

/// "-" as people call it.
std::string input_name(const std::string& path);
std::string output_name(const std::string& path);

/// Turns the exception that is being handled into a Failure that names the file. Throws Failure.
[[noreturn]] void fail_about(const std::string& file);

/// Runs work that concerns a file; what it throws becomes a Failure that names the file.
template <typename Work>
auto about_file(const std::string& file, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (...) {
    fail_about(file);
  }
}

/// What is said when memory ends.
extern const char* const not_enough_memory;

/// Prints "ucvt: " and the text to stderr as exactly one line.
void print_line_to_stderr(const std::string& text);

}  // namespace ucvt
