#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "mesh/byte_reader.h"
#include "mesh/invalid.h"
#include "mesh/ply_header.h"
#include "mesh/polygon_mesh.h"
#include "mesh/readers.h"
#include "mesh/text_scanner.h"

namespace ucvt {
namespace {

// One value after the other, as double, which holds all PLY types exactly.
class Values {
 public:
  Values(std::string_view bytes, const PlyHeader& header)
      : bytes_(bytes),
        header_(header),
        at_(header.data_start),
        scanner_(bytes.substr(header.data_start), {.hash_comments = false}) {}

  double next(PlyType type) { return header_.ascii ? next_word(type) : next_binary(type); }
  void skip(PlyType type, std::int64_t count);
  [[nodiscard]] std::string where() const {
    return header_.ascii ? at_line(header_.data_line + scanner_.line() - 1) : at_byte(at_);
  }
  /// Values of this type that the rest of the file can hold at most.
  [[nodiscard]] std::int64_t room(PlyType type) const {
    if (header_.ascii) {
      return static_cast<std::int64_t>(scanner_.bytes_left() / 2 + 1);
    }
    return static_cast<std::int64_t>((bytes_.size() - at_) / size_of(type));
  }
  void name_element(const PlyElement& element) { element_ = &element; }
  std::int64_t number = 0;  // of the element that is read

  [[noreturn]] void refuse_end() const {
    refuse("the file ends in {} {} of {} ({}); check that it is complete", element_->name, number,
           element_->count, where());
  }

 private:
  double next_word(PlyType type);
  double next_binary(PlyType type);

  std::string_view bytes_;
  const PlyHeader& header_;
  const PlyElement* element_ = nullptr;
  std::size_t at_;
  TextScanner scanner_;
};

double Values::next_word(PlyType type) {
  const std::string_view word = scanner_.word();
  if (word.empty()) {
    refuse_end();
  }
  std::int64_t integer = 0;
  if (type != PlyType::Float && type != PlyType::Double && parse_integer(word, integer)) {
    return static_cast<double>(integer);
  }
  double value = 0;
  if (!parse_real(word, value)) {
    refuse("{} {} has the value {} ({}); write a number", element_->name, number, in_quotes(word),
           where());
  }
  return value;
}

double Values::next_binary(PlyType type) {
  if (bytes_.size() - at_ < size_of(type)) {
    refuse_end();
  }
  const std::size_t at = at_;
  at_ += size_of(type);
  switch (type) {
    case PlyType::Int8:
      return load_number<std::int8_t>(bytes_, at, header_.order);
    case PlyType::Uint8:
      return load_number<std::uint8_t>(bytes_, at, header_.order);
    case PlyType::Int16:
      return load_number<std::int16_t>(bytes_, at, header_.order);
    case PlyType::Uint16:
      return load_number<std::uint16_t>(bytes_, at, header_.order);
    case PlyType::Int32:
      return load_number<std::int32_t>(bytes_, at, header_.order);
    case PlyType::Uint32:
      return load_number<std::uint32_t>(bytes_, at, header_.order);
    case PlyType::Float:
      return static_cast<double>(load_number<float>(bytes_, at, header_.order));
    case PlyType::Double:
      return load_number<double>(bytes_, at, header_.order);
  }
  return 0;
}

void Values::skip(PlyType type, std::int64_t count) {
  if (header_.ascii) {
    for (std::int64_t i = 0; i < count; ++i) {
      next_word(type);
    }
  } else {
    at_ += static_cast<std::size_t>(count) * size_of(type);
  }
}

class PlyReader {
 public:
  explicit PlyReader(std::string_view bytes)
      : header_(read_ply_header(bytes)), values_(bytes, header_) {}
  TriangleMesh read();

 private:
  [[nodiscard]] const PlyElement* find(std::string_view name) const;
  void read_vertices(const PlyElement& element);
  void read_faces(const PlyElement& element, bool strips);
  std::int64_t read_length(const PlyProperty& property);
  void read_corners(const PlyProperty& property, bool strips);
  void skip_element(const PlyElement& element);
  void add_polygon();
  void add_strips();

  PlyHeader header_;
  Values values_;
  PolygonMesh mesh_;
  std::int64_t vertices_ = 0;
  std::vector<std::int32_t> corners_;
};

const PlyElement* PlyReader::find(std::string_view name) const {
  for (const PlyElement& element : header_.elements) {
    if (element.name == name) {
      return &element;
    }
  }
  return nullptr;
}

std::int64_t PlyReader::read_length(const PlyProperty& property) {
  const double length = values_.next(*property.list_count);
  if (!(length >= 0) || length != std::floor(length)) {
    refuse("list {} has length {} ({}); check that the file is complete", in_quotes(property.name),
           length, values_.where());
  }
  if (length > static_cast<double>(values_.room(property.type))) {
    values_.refuse_end();
  }
  return static_cast<std::int64_t>(length);
}

void PlyReader::read_vertices(const PlyElement& element) {
  std::array<std::size_t, 3> slot_of = {};
  constexpr std::array<std::string_view, 3> names = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t i = 0;
    while (i < element.properties.size() &&
           (element.properties[i].name != names[k] || element.properties[i].list_count)) {
      ++i;
    }
    if (i == element.properties.size()) {
      refuse("the vertices have no property {}; check that this is a mesh", names[k]);
    }
    slot_of[k] = i;
  }
  std::vector<double> record(element.properties.size());
  mesh_.positions.reserve(static_cast<std::size_t>(element.count));
  for (std::int64_t& i = values_.number; i < element.count; ++i) {
    for (std::size_t k = 0; k < record.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (property.list_count) {
        values_.skip(property.type, read_length(property));
      } else {
        record[k] = values_.next(property.type);
      }
    }
    const Position position = {record[slot_of[0]], record[slot_of[1]], record[slot_of[2]]};
    for (const double c : position) {
      if (!std::isfinite(c)) {
        check_finite(position, i, values_.where());
      }
    }
    mesh_.positions.push_back(position);
  }
}

void PlyReader::read_corners(const PlyProperty& property, bool strips) {
  const std::int64_t length = read_length(property);
  corners_.clear();
  for (std::int64_t k = 0; k < length; ++k) {
    const double index = values_.next(property.type);
    if (strips && index == -1) {
      corners_.push_back(-1);
      continue;
    }
    if (!(index >= 0) || index >= static_cast<double>(vertices_) || index != std::floor(index)) {
      refuse("face {} has vertex index {}, but there are {} ({}); check that the file is complete",
             mesh_.face_count(), index, counted(vertices_, "vertex", "vertices"), values_.where());
    }
    corners_.push_back(static_cast<std::int32_t>(index));
  }
}

void PlyReader::add_polygon() {
  if (corners_.size() < 3) {
    refuse_corner_count(mesh_.face_count(), static_cast<std::int64_t>(corners_.size()),
                        values_.where());
  }
  mesh_.add_face(corners_);
}

// Every corner after the second of a strip makes a triangle, turned round every other time; -1
// begins a new strip, and a repeated corner only turns the strip.
void PlyReader::add_strips() {
  std::size_t start = 0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (corners_[i] == -1) {
      start = i + 1;
    } else if (i >= start + 2) {
      const std::int32_t a = corners_[i - 2], b = corners_[i - 1], c = corners_[i];
      if (a == b || b == c || c == a) {
        continue;
      }
      const bool turned = (i - start) % 2 == 1;
      mesh_.add_face(Corners{turned ? b : a, turned ? a : b, c});
    }
  }
}

void PlyReader::read_faces(const PlyElement& element, bool strips) {
  bool found = false;
  for (const PlyProperty& p : element.properties) {
    found |= p.list_count && (p.name == "vertex_indices" || p.name == "vertex_index");
  }
  if (!found) {
    refuse("the {}s have no list vertex_indices; check that this is a mesh of polygons",
           element.name);
  }
  if (!strips) {
    mesh_.reserve_triangles(static_cast<std::size_t>(element.count));
  }
  for (std::int64_t& i = values_.number; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) {
      if (!property.list_count) {
        values_.next(property.type);
      } else if (property.name == "vertex_indices" || property.name == "vertex_index") {
        read_corners(property, strips);
        strips ? add_strips() : add_polygon();
      } else {
        values_.skip(property.type, read_length(property));
      }
    }
  }
}

void PlyReader::skip_element(const PlyElement& element) {
  for (std::int64_t& i = values_.number; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) {
      if (property.list_count) {
        values_.skip(property.type, read_length(property));
      } else {
        values_.next(property.type);
      }
    }
  }
}

TriangleMesh PlyReader::read() {
  const PlyElement* vertex = find("vertex");
  if (vertex == nullptr) {
    refuse("the PLY header has no vertex element; give a mesh");
  }
  vertices_ = vertex->count;
  check_size(vertices_, 0);
  for (const PlyElement& element : header_.elements) {
    values_.name_element(element);
    values_.number = 0;
    if (&element == vertex) {
      read_vertices(element);
    } else if (element.name == "face" || element.name == "tristrips") {
      check_size(0, element.count);
      read_faces(element, element.name == "tristrips");
    } else if (!element.properties.empty()) {
      skip_element(element);
    }
  }
  return mesh_.take_triangles();
}

}  // namespace

TriangleMesh read_ply(std::string_view bytes) {
  return PlyReader(bytes).read();
}

}  // namespace ucvt
