// The extension that names a file's format.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ucvt {

/// ASCII letters made small.
inline std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') {
      c = static_cast<char>(c - 'A' + 'a');
    }
  }
  return lower;
}

/// ".off" of "a/B.OFF"; empty when there is none.
inline std::string file_extension(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

}  // namespace ucvt
