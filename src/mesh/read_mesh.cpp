#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesh/byte_reader.h"
#include "mesh/file_extension.h"
#include "mesh/file_input.h"
#include "mesh/invalid.h"
#include "mesh/readers.h"
#include "mesh/text_scanner.h"
#include "ucvt/mesh.h"

namespace ucvt {
namespace {

enum class Format : std::uint8_t { Unknown, Off, Obj, Ply, StlText, StlBinary };

struct Stranger {
  std::string_view begin, message;
};

// Files that users give by mistake, told from their first bytes.
constexpr std::array<Stranger, 6> strangers = {{
    {"version https://git-lfs",
     "this is a Git LFS pointer, not the mesh; fetch it with git lfs pull"},
    {"\x1f\x8b", "this is a gzip file; unpack it first"},
    {"PK\x03\x04", "this is a zip file (3MF is one too); unpack it or write OFF, OBJ, PLY or STL"},
    {"glTF", "this is a glTF file; write it as OFF, OBJ, PLY or STL"},
    {"<?xml", "this is an XML file; write the mesh as OFF, OBJ, PLY or STL"},
    {"ISO-10303-21", "this is a STEP file; write a mesh of it as OFF, OBJ, PLY or STL"},
}};

// UTF-16 text with a byte order mark, as Windows programs write it; other characters than ASCII
// stand in names and comments only.
std::string narrowed(std::string_view bytes) {
  const std::endian order = bytes[0] == '\xfe' ? std::endian::big : std::endian::little;
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t at = 2; at + 1 < bytes.size(); at += 2) {
    const auto unit = load_number<std::uint16_t>(bytes, at, order);
    text += unit < 128 ? static_cast<char>(unit) : '?';
  }
  return text;
}

bool has_utf16_mark(std::string_view bytes) {
  return bytes.starts_with("\xfe\xff") || bytes.starts_with("\xff\xfe");
}

bool looks_like_binary_stl(std::string_view bytes) {
  if (bytes.size() < 84) {
    return false;
  }
  const std::uint64_t count = load_number<std::uint32_t>(bytes, 80, std::endian::little);
  return bytes.size() == 84 + 50 * count;
}

bool looks_like_ply(std::string_view bytes) {
  return bytes.starts_with("ply") && bytes.size() > 3 &&
         static_cast<unsigned char>(bytes[3]) <= ' ';
}

// "solid" begins the headers of many binary files too; text goes on with facets.
bool looks_like_stl_text(std::string_view bytes) {
  TextScanner scanner(bytes, {.hash_comments = false});
  if (lower_case(scanner.word()) != "solid") {
    return false;
  }
  scanner.skip_line();
  const std::string next = lower_case(scanner.word());
  return next == "facet" || next == "endsolid";
}

bool looks_like_obj(std::string_view bytes) {
  constexpr std::array<std::string_view, 11> keywords = {"v", "vn",     "vt",     "f", "o", "g",
                                                         "s", "mtllib", "usemtl", "l", "p"};
  TextScanner scanner(bytes, {.hash_comments = true, .continued_lines = true});
  const std::string_view first = scanner.word();
  return std::find(keywords.begin(), keywords.end(), first) != keywords.end();
}

// Control characters that no text has.
bool is_binary(std::string_view bytes) {
  return std::any_of(
      bytes.begin(),
      bytes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(bytes.size(), 4096)),
      [](char c) { return c >= 0 && c < ' ' && !(c >= '\t' && c <= '\r'); });
}

Format format_of(std::string_view bytes, const std::string& extension) {
  if (looks_like_ply(bytes)) {
    return Format::Ply;
  }
  if (looks_like_off(bytes)) {
    return Format::Off;
  }
  if (looks_like_binary_stl(bytes)) {
    return Format::StlBinary;
  }
  if (looks_like_stl_text(bytes)) {
    return Format::StlText;
  }
  if (extension == ".stl") {
    return is_binary(bytes) ? Format::StlBinary : Format::StlText;
  }
  if (is_binary(bytes)) {
    return Format::Unknown;
  }
  if (extension == ".off") {
    return Format::Off;
  }
  if (extension == ".obj" || looks_like_obj(bytes)) {
    return Format::Obj;
  }
  return Format::Unknown;
}

TriangleMesh read_as(Format format, std::string_view bytes) {
  switch (format) {
    case Format::Off:
      return read_off(bytes);
    case Format::Obj:
      return read_obj(bytes);
    case Format::Ply:
      return read_ply(bytes);
    case Format::StlText:
      return read_stl_text(bytes);
    case Format::StlBinary:
      return read_stl_binary(bytes);
    case Format::Unknown:
      break;
  }
  refuse("this is no mesh in a known format; give an OFF, OBJ, PLY or STL file");
}

}  // namespace

TriangleMesh read_mesh(const std::string& path) {
  std::string bytes = read_file(path);
  if (bytes.empty()) {
    refuse("the file is empty; give a mesh as OFF, OBJ, PLY or STL");
  }
  if (has_utf16_mark(bytes)) {
    bytes = narrowed(bytes);
  }
  std::string_view text = bytes;
  if (text.starts_with("\xef\xbb\xbf")) {
    text.remove_prefix(3);
  }
  for (const Stranger& stranger : strangers) {
    if (text.starts_with(stranger.begin)) {
      throw InvalidInput(std::string(stranger.message));
    }
  }
  return read_as(format_of(text, file_extension(path)), text);
}

}  // namespace ucvt
