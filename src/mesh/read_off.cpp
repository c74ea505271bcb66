#include <algorithm>
#include <bit>
#include <optional>
#include <string>
#include <vector>

#include "mesh/byte_reader.h"
#include "mesh/invalid.h"
#include "mesh/polygon_mesh.h"
#include "mesh/readers.h"
#include "mesh/text_scanner.h"

namespace ucvt {
namespace {

// A line with more numbers than a vertex with normal, colour and texture can have holds several
// vertices: the file is one stream of numbers.
constexpr int most_numbers_of_vertex = 3 + 3 + 4 + 2;

struct Dress {
  bool texture = false, colours = false, normals = false;
  std::string_view magic;  // with the prefix letters
  [[nodiscard]] std::size_t numbers_per_vertex() const {
    return 3U + (texture ? 2U : 0U) + (colours ? 4U : 0U) + (normals ? 3U : 0U);
  }
};

// The magic word at the front of a word, such as STCNOFF; digits may follow without a blank.
std::optional<Dress> parse_magic(std::string_view word) {
  Dress dress;
  std::size_t at = 0;
  bool other_dimension = false;
  while (at < word.size() && word.substr(at, 3) != "OFF" && word.substr(at, 3) != "off") {
    if (word.substr(at, 2) == "ST") {
      dress.texture = true;
      ++at;
    } else if (word[at] == 'C') {
      dress.colours = true;
    } else if (word[at] == 'N') {
      dress.normals = true;
    } else if (word[at] == '4' || word[at] == 'n') {
      other_dimension = true;
    } else {
      return std::nullopt;
    }
    ++at;
  }
  if (at >= word.size()) {
    return std::nullopt;
  }
  dress.magic = word.substr(0, at + 3);
  const std::string_view rest = word.substr(at + 3);
  if (rest.find_first_not_of("0123456789") != std::string_view::npos) {
    return std::nullopt;
  }
  if (other_dimension) {
    refuse("{} is a file of points in four or n dimensions; write it as OFF with x y z",
           in_quotes(dress.magic));
  }
  return dress;
}

class OffReader {
 public:
  explicit OffReader(std::string_view bytes) : bytes_(bytes), scanner_(bytes) {}
  TriangleMesh read();

 private:
  void read_counts();
  std::int64_t read_count(std::string_view what, std::string_view word);
  void check_counts();
  [[nodiscard]] bool one_record_per_line() const;
  void read_vertices();
  void read_faces();
  void read_face(std::int64_t face);
  std::string_view need_word(std::string_view what, std::int64_t number, std::int64_t total);

  std::string_view bytes_;
  TextScanner scanner_;
  Dress dress_;
  std::int64_t vertices_ = 0, faces_ = 0;
  bool lines_ = true;
  PolygonMesh mesh_;
  std::vector<std::int32_t> corners_;
};

std::int64_t OffReader::read_count(std::string_view what, std::string_view word) {
  std::int64_t count = 0;
  if (word.empty()) {
    refuse("the file ends before the number of {} (line {}); check that it is complete", what,
           scanner_.line());
  }
  if (!parse_integer(word, count) || count < 0) {
    refuse("the number of {} is {} (line {}); check that this is an OFF file", what,
           in_quotes(word), scanner_.line());
  }
  return count;
}

void OffReader::read_counts() {
  vertices_ = read_count("vertices", scanner_.word());
  const std::int64_t line = scanner_.line();
  faces_ = read_count("faces", scanner_.word());
  // Some writers leave the number of edges away.
  const bool same_line = scanner_.line() == line;
  const std::string_view edges = same_line ? scanner_.word_in_line() : scanner_.word();
  if (!edges.empty()) {
    read_count("edges", edges);
  }
}

void OffReader::check_counts() {
  const auto left = static_cast<std::int64_t>(scanner_.bytes_left());
  // "0 0 0" and "0" with their line ends; as doubles, since the counts may be anything.
  const double least = 6.0 * static_cast<double>(vertices_) + 2.0 * static_cast<double>(faces_);
  if (least > static_cast<double>(left) + 1) {
    refuse(
        "the header declares {} and {}, but only {} follow (line {}); check that the file is "
        "complete",
        counted(vertices_, "vertex", "vertices"), counted(faces_, "face", "faces"),
        counted(left, "byte", "bytes"), scanner_.line());
  }
  check_size(vertices_, faces_);
}

// Only then can numbers past the ones we need be told from the next record.
bool OffReader::one_record_per_line() const {
  TextScanner ahead = scanner_;
  ahead.word();
  int numbers = 1;
  while (!ahead.word_in_line().empty()) {
    ++numbers;
  }
  return numbers <= most_numbers_of_vertex;
}

std::string_view OffReader::need_word(std::string_view what, std::int64_t number,
                                      std::int64_t total) {
  const std::string_view word = scanner_.word();
  if (word.empty()) {
    refuse("the file ends in {} {} of {} (line {}); check that it is complete", what, number, total,
           scanner_.line());
  }
  return word;
}

void OffReader::read_vertices() {
  mesh_.positions.resize(static_cast<std::size_t>(vertices_));
  const std::size_t unused_numbers = dress_.numbers_per_vertex() - 3;
  for (std::int64_t i = 0; i < vertices_; ++i) {
    Position& position = mesh_.positions[static_cast<std::size_t>(i)];
    for (double& coordinate : position) {
      const std::string_view word = need_word("vertex", i, vertices_);
      if (!parse_real(word, coordinate)) {
        refuse("vertex {} has coordinate {} (line {}); write a number, with a point", i,
               in_quotes(word), scanner_.line());
      }
    }
    check_finite(position, i, scanner_.line());
    if (lines_) {
      scanner_.skip_line();
    } else {
      for (std::size_t k = 0; k < unused_numbers; ++k) {
        need_word("vertex", i, vertices_);
      }
    }
  }
}

void OffReader::read_face(std::int64_t face) {
  std::int64_t size = 0;
  const std::string_view word = need_word("face", face, faces_);
  if (!parse_integer(word, size)) {
    refuse("face {} has {} for its number of corners (line {}); check the counts in the header",
           face, in_quotes(word), scanner_.line());
  }
  if (size < 3) {
    refuse_corner_count(face, size, at_line(scanner_.line()));
  }
  corners_.clear();
  for (std::int64_t i = 0; i < size; ++i) {
    std::int64_t index = 0;
    const std::string_view corner = need_word("face", face, faces_);
    if (!parse_integer(corner, index)) {
      refuse("face {} has vertex index {} (line {}); write a whole number", face, in_quotes(corner),
             scanner_.line());
    }
    if (index < 0 || index >= vertices_) {
      refuse_index(face, index, vertices_, at_line(scanner_.line()));
    }
    corners_.push_back(static_cast<std::int32_t>(index));
  }
  mesh_.add_face(corners_);
}

void OffReader::read_faces() {
  mesh_.reserve_triangles(static_cast<std::size_t>(faces_));
  for (std::int64_t i = 0; i < faces_; ++i) {
    read_face(i);
    if (lines_) {
      scanner_.skip_line();
    }
  }
}

// OFF BINARY: 32-bit integers and floats, faces with a number of colour components. Writers differ
// in the byte order and some leave the colours away; only the right reading fits the file's size.
class BinaryOffReader {
 public:
  BinaryOffReader(std::string_view bytes, std::size_t start, const Dress& dress)
      : bytes_(bytes), start_(start), dress_(dress) {}
  TriangleMesh read();

 private:
  [[nodiscard]] std::int64_t integer(std::size_t at) const {
    return load_number<std::int32_t>(bytes_, at, order_);
  }
  [[nodiscard]] bool counts_fit() const;
  [[nodiscard]] bool faces_fit(bool colours) const;
  TriangleMesh take(bool colours);
  [[nodiscard]] std::size_t vertex_stride() const { return 4 * dress_.numbers_per_vertex(); }
  [[nodiscard]] std::size_t faces_start() const {
    return start_ + 12 + static_cast<std::size_t>(integer(start_)) * vertex_stride();
  }

  std::string_view bytes_;
  std::size_t start_;
  Dress dress_;
  std::endian order_ = std::endian::big;
};

bool BinaryOffReader::counts_fit() const {
  if (bytes_.size() < start_ + 12) {
    return false;
  }
  const std::int64_t vertices = integer(start_), faces = integer(start_ + 4);
  const auto room = static_cast<std::int64_t>(bytes_.size() - start_ - 12);
  return vertices >= 0 && faces >= 0 &&
         vertices * static_cast<std::int64_t>(vertex_stride()) + faces * 4 <= room;
}

bool BinaryOffReader::faces_fit(bool colours) const {
  std::size_t at = faces_start();
  for (std::int64_t i = 0; i < integer(start_ + 4); ++i) {
    if (bytes_.size() - at < 4) {
      return false;
    }
    const std::int64_t size = integer(at);
    const auto room = static_cast<std::int64_t>((bytes_.size() - at) / 4) - 1;
    if (size < 0 || size + (colours ? 1 : 0) > room) {
      return false;
    }
    at += 4 + 4 * static_cast<std::size_t>(size);
    if (!colours) {
      continue;
    }
    const std::int64_t components = integer(at);
    if (components < 0 || components > room - size - 1 || components > 4) {
      return false;
    }
    at += 4 + 4 * static_cast<std::size_t>(components);
  }
  return at == bytes_.size();
}

TriangleMesh BinaryOffReader::take(bool colours) {
  PolygonMesh mesh;
  const std::int64_t vertices = integer(start_), faces = integer(start_ + 4);
  for (std::int64_t i = 0; i < vertices; ++i) {
    const std::size_t at = start_ + 12 + static_cast<std::size_t>(i) * vertex_stride();
    Position position;
    for (std::size_t k = 0; k < 3; ++k) {
      position[k] = static_cast<double>(load_number<float>(bytes_, at + 4 * k, order_));
    }
    check_finite(position, i, at_byte(at));
    mesh.positions.push_back(position);
  }
  std::size_t at = faces_start();
  std::vector<std::int32_t> corners;
  for (std::int64_t i = 0; i < faces; ++i) {
    const std::int64_t size = integer(at);
    if (size < 3) {
      refuse_corner_count(i, size, at_byte(at));
    }
    corners.clear();
    for (std::int64_t k = 0; k < size; ++k) {
      at += 4;
      const std::int64_t index = integer(at);
      if (index < 0 || index >= vertices) {
        refuse_index(i, index, vertices, at_byte(at));
      }
      corners.push_back(static_cast<std::int32_t>(index));
    }
    at += 4;
    if (colours) {
      at += 4 + 4 * static_cast<std::size_t>(integer(at));
    }
    mesh.add_face(corners);
  }
  return mesh.take_triangles();
}

TriangleMesh BinaryOffReader::read() {
  for (const std::endian order : {std::endian::big, std::endian::little}) {
    order_ = order;
    if (!counts_fit()) {
      continue;
    }
    for (const bool colours : {true, false}) {
      if (faces_fit(colours)) {
        return take(colours);
      }
    }
  }
  refuse(
      "the counts of this binary OFF file do not fit its {} bytes (byte {}); check that it is "
      "complete, or write it as text",
      bytes_.size(), start_);
}

TriangleMesh OffReader::read() {
  const std::string_view first = scanner_.word();
  if (const std::optional<Dress> dress = parse_magic(first)) {
    dress_ = *dress;
    scanner_.put_back(first.substr(dress_.magic.size()));
    TextScanner ahead = scanner_;
    if (ahead.word_in_line() == "BINARY") {
      // A binary count may look like a line end: pass exactly one.
      std::size_t start = bytes_.size() - ahead.bytes_left();
      if (start < bytes_.size() && bytes_[start] == '\r') {
        ++start;
      }
      if (start < bytes_.size() && bytes_[start] == '\n') {
        ++start;
      }
      return BinaryOffReader(bytes_, start, dress_).read();
    }
  } else {
    scanner_.put_back(first);
  }
  read_counts();
  check_counts();
  lines_ = one_record_per_line();
  read_vertices();
  read_faces();
  return mesh_.take_triangles();
}

}  // namespace

TriangleMesh read_off(std::string_view bytes) {
  return OffReader(bytes).read();
}

bool looks_like_off(std::string_view bytes) {
  return parse_magic(TextScanner(bytes).word()).has_value();
}

}  // namespace ucvt
