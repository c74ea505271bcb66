// Numbers of either byte order from memory.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace ucvt {

/// The number of type T that begins at `at`, which must lie far enough from the end.
template <typename T>
T load_number(std::string_view bytes, std::size_t at, std::endian order) {
  unsigned char raw[sizeof(T)];
  std::memcpy(raw, bytes.data() + at, sizeof(T));
  if (order != std::endian::native) {
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) {
      const unsigned char swapped = raw[i];
      raw[i] = raw[sizeof(T) - 1 - i];
      raw[sizeof(T) - 1 - i] = swapped;
    }
  }
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

}  // namespace ucvt
