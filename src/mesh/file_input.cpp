#include "mesh/file_input.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ucvt/error.h"

namespace ucvt {
namespace {

[[noreturn]] void fail(const char* what, int error) {
  throw IoError(fmt::format("cannot {}: {}; check the path and its permissions", what,
                            std::generic_category().message(error)));
}

struct Descriptor {
  int number;
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() {
    if (number > STDERR_FILENO) {
      ::close(number);
    }
  }
};

std::string read_all(int descriptor, std::size_t expected) {
  constexpr std::size_t chunk = std::size_t{1} << 16;
  std::string bytes;
  std::size_t size = 0;
  bytes.resize(expected + chunk);
  while (true) {
    if (bytes.size() - size < chunk) {
      bytes.resize(bytes.size() * 2);
    }
    const ssize_t got = ::read(descriptor, bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      fail("read the file", errno);
    }
    if (got == 0) {
      break;
    }
    size += static_cast<std::size_t>(got);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string read_file(const std::string& path) {
  if (path == "-") {
    return read_all(STDIN_FILENO, 0);
  }
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.number < 0) {
    fail("open the file", errno);
  }
  struct stat status = {};
  if (::fstat(file.number, &status) != 0) {
    fail("read the file", errno);
  }
  if (S_ISDIR(status.st_mode)) {
    fail("read the file", EISDIR);
  }
  return read_all(file.number,
                  S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0);
}

}  // namespace ucvt
