// What the fuzz targets share: a fault of the input is an exception of ours, anything else is a bug.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include <sys/mman.h>
#include <unistd.h>

#include "ucvt/error.h"

namespace ucvt::fuzz {

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Runs the work; acceptable failures end it. Refusals must be one line with a remedy.
template <typename Work>
void tolerate_faults(const Work& work) {
  try {
    work();
  } catch (const InvalidInput& error) {
    const std::string_view message = error.what();
    if (message.empty() || message.find("; ") == std::string_view::npos) {
      std::abort();
    }
  } catch (const NumericalError&) {
    // The arithmetic may give up.
  }
}

/// Bytes as a file that has a path.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : descriptor_(::memfd_create("input", MFD_CLOEXEC)) {
    if (descriptor_ < 0 ||
        ::write(descriptor_, bytes.data(), bytes.size()) != static_cast<::ssize_t>(bytes.size())) {
      std::abort();
    }
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace ucvt::fuzz
