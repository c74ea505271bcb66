#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/byte_reader.h"
#include "mesh/invalid.h"
#include "mesh/polygon_mesh.h"
#include "mesh/readers.h"
#include "mesh/text_scanner.h"
#include "mesh/vertex_welder.h"

namespace ucvt {
namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t facet_size = 50;

bool same_word(std::string_view word, std::string_view lower_case) {
  return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

class StlTextReader {
 public:
  explicit StlTextReader(std::string_view text) : scanner_(text, {.hash_comments = false}) {}
  TriangleMesh read();

 private:
  void read_facet();
  Position read_vertex();

  TextScanner scanner_;
  VertexWelder welder_;
  std::vector<Corners> faces_;
  bool in_solid_ = false;
};

Position StlTextReader::read_vertex() {
  Position position;
  for (double& coordinate : position) {
    const std::string_view word = scanner_.word();
    if (!parse_real(word, coordinate)) {
      refuse("facet {} has coordinate {} (line {}); write a number, with a point", faces_.size(),
             in_quotes(word), scanner_.line());
    }
  }
  check_finite(position, static_cast<std::int64_t>(welder_.positions().size()), scanner_.line());
  return position;
}

void StlTextReader::read_facet() {
  Corners corners = {};
  std::size_t count = 0;
  scanner_.skip_line();  // the normal, which may be anything
  for (auto word = scanner_.word(); !same_word(word, "endfacet"); word = scanner_.word()) {
    if (word.empty()) {
      refuse("the file ends in facet {} (line {}); check that it is complete", faces_.size(),
             scanner_.line());
    }
    if (!same_word(word, "vertex")) {
      continue;
    }
    const Position position = read_vertex();
    if (count < 3) {
      corners[count] = welder_.number(position);
    }
    ++count;
  }
  if (count != 3) {
    refuse("facet {} has {} (line {}); STL facets have three", faces_.size(),
           counted(static_cast<long long>(count), "vertex", "vertices"), scanner_.line());
  }
  faces_.push_back(corners);
}

TriangleMesh StlTextReader::read() {
  for (auto word = scanner_.word(); !word.empty(); word = scanner_.word()) {
    if (same_word(word, "solid")) {
      in_solid_ = true;
      scanner_.skip_line();
    } else if (same_word(word, "endsolid")) {
      in_solid_ = false;
      scanner_.skip_line();
    } else if (same_word(word, "facet")) {
      read_facet();
    } else {
      refuse("the STL file has {} where a facet should begin (line {}); check that it is complete",
             in_quotes(word), scanner_.line());
    }
  }
  if (in_solid_) {
    refuse("the file ends without endsolid (line {}); check that it is complete", scanner_.line());
  }
  if (faces_.empty()) {
    refuse("there are no faces; give a mesh with triangles or polygons");
  }
  check_size(0, static_cast<std::int64_t>(faces_.size()));
  return {std::move(welder_.positions()), std::move(faces_)};
}

/// Corner k of facet i of a binary STL.
Position facet_corner(std::string_view bytes, std::size_t i, std::size_t k) {
  const std::size_t at = header_size + facet_size * i + 12 + 12 * k;
  Position position;
  for (std::size_t c = 0; c < 3; ++c) {
    position[c] = static_cast<double>(load_number<float>(bytes, at + 4 * c, std::endian::little));
    if (!(std::abs(position[c]) < 1e39)) {
      refuse("facet {} has coordinate {} = {} (byte {}); coordinates must be finite numbers", i,
             "xyz"[c], position[c], at + 4 * c);
    }
  }
  return position;
}

}  // namespace

TriangleMesh read_stl_text(std::string_view bytes) {
  return StlTextReader(bytes).read();
}

TriangleMesh read_stl_binary(std::string_view bytes) {
  if (bytes.size() < header_size) {
    refuse("the file has {} bytes, a binary STL at least 84 (byte {}); check that it is complete",
           bytes.size(), bytes.size());
  }
  const auto count =
      static_cast<std::size_t>(load_number<std::uint32_t>(bytes, 80, std::endian::little));
  const std::size_t room = (bytes.size() - header_size) / facet_size;
  if (count != room) {
    refuse(
        "the header declares {}, but the file has room for {} (byte 80); check that it is "
        "complete",
        counted(static_cast<long long>(count), "facet", "facets"), room);
  }
  if (count == 0) {
    refuse("there are no faces; give a mesh with triangles or polygons");
  }
  check_size(0, static_cast<std::int64_t>(count));
  VertexWelder welder(count / 2 + 3);
  TriangleMesh mesh;
  mesh.faces.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = welder.number(facet_corner(bytes, i, k));
    }
    mesh.faces.push_back(corners);
  }
  mesh.positions = std::move(welder.positions());
  return mesh;
}

}  // namespace ucvt
