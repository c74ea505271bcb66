// The header of a PLY file: which elements follow, with which properties.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ucvt {

enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float, Double };

std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float;
  std::optional<PlyType> list_count;  // of lists: the type of their length
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  bool ascii = true;
  std::endian order = std::endian::little;
  std::vector<PlyElement> elements;
  std::size_t data_start = 0;  // byte
  std::int64_t data_line = 1;  // line there
};

/// Reads the header and checks its counts against the bytes that follow. Throws InvalidInput.
PlyHeader read_ply_header(std::string_view bytes);

}  // namespace ucvt
