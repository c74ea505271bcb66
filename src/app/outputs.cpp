#include "app/outputs.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/failure.h"
#include "mesh/output_file.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

[[noreturn]] void fail_to_write(int error) {
  throw IoError(fmt::format("cannot write: {}; check the path and its permissions",
                            std::generic_category().message(error)));
}

void check_writable(const std::string& path) {
  struct stat status = {};
  if (path == "-") {
    const int mode = ::fcntl(STDOUT_FILENO, F_GETFL);
    if (mode < 0 || (static_cast<unsigned>(mode) & O_ACCMODE) == O_RDONLY) {
      fail_to_write(EBADF);
    }
  } else if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) &&
             !S_ISDIR(status.st_mode)) {
    // A pipe must not be opened twice: its reader would see the end.
    if (::access(path.c_str(), W_OK) != 0) {
      fail_to_write(errno);
    }
  } else {
    const OutputFile probe(path);
  }
}

}  // namespace

void reserve_standard_streams() {
  const int refusing[] = {O_WRONLY, O_RDONLY, O_WRONLY};
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (::fcntl(stream, F_GETFD) < 0) {
      // The lowest free number is this stream's, since those below are open by now.
      [[maybe_unused]] const int taken = ::open("/dev/null", refusing[stream]);
    }
  }
}

void check_writable(const std::vector<std::string>& outputs) {
  for (const std::string& path : outputs) {
    about_file(output_name(path), [&] { check_writable(path); });
  }
}

void print_results(const std::string& text) {
  write_text("-", text);
}

void write_text(const std::string& path, const std::string& text) {
  about_file(output_name(path), [&] {
    OutputFile file(path);
    file.write(text);
    file.commit();
  });
}

}  // namespace ucvt
