#include "app/failure.h"

#include <cstdio>
#include <new>

#include <fmt/format.h>

#include "ucvt/error.h"

namespace ucvt {

std::string input_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

std::string output_name(const std::string& path) {
  return path == "-" ? "standard output" : path;
}

const char* const not_enough_memory =
    "not enough memory; give a smaller mesh or ask for fewer sites";

void fail_about(const std::string& file) {
  const auto fail = [&](ExitStatus status, const std::string& message) {
    return Failure(status, fmt::format("{}: {}", file, message));
  };
  try {
    throw;
  } catch (const Failure&) {
    throw;
  } catch (const Cancelled&) {
    throw Failure(ExitStatus::NotFinished, "interrupted; no output was written");
  } catch (const InvalidInput& error) {
    throw fail(ExitStatus::BadInput, error.what());
  } catch (const IoError& error) {
    throw fail(ExitStatus::NotFinished, error.what());
  } catch (const NumericalError& error) {
    const std::string message = error.what();
    const bool has_remedy = message.find("; ") != std::string::npos;
    throw fail(ExitStatus::NotFinished,
               has_remedy ? message : message + "; please report this mesh");
  } catch (const std::bad_alloc&) {
    throw fail(ExitStatus::NotFinished, not_enough_memory);
  } catch (const std::exception& error) {
    throw fail(ExitStatus::NotFinished,
               fmt::format("unexpected failure ({}); please report it", error.what()));
  }
}

void print_line_to_stderr(const std::string& text) {
  std::string line = "ucvt: " + text;
  for (char& c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' || byte == 0x7f) {
      c = '?';
    }
  }
  line += '\n';
  // Nothing can be said about a stderr that does not take it.
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace ucvt
