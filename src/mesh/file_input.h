// The bytes of a file or of standard input.
#pragma once

#include <string>

namespace ucvt {

/// Reads the whole file, or standard input for "-". Throws IoError.
std::string read_file(const std::string& path);

}  // namespace ucvt
