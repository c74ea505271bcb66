#include "mesh/ply_header.h"

#include <array>
#include <utility>

#include "mesh/invalid.h"
#include "mesh/text_scanner.h"

namespace ucvt {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names = {{
    {"char", PlyType::Int8},
    {"int8", PlyType::Int8},
    {"uchar", PlyType::Uint8},
    {"uint8", PlyType::Uint8},
    {"short", PlyType::Int16},
    {"int16", PlyType::Int16},
    {"ushort", PlyType::Uint16},
    {"uint16", PlyType::Uint16},
    {"int", PlyType::Int32},
    {"int32", PlyType::Int32},
    {"uint", PlyType::Uint32},
    {"uint32", PlyType::Uint32},
    {"float", PlyType::Float},
    {"float32", PlyType::Float},
    {"double", PlyType::Double},
    {"float64", PlyType::Double},
}};

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes)
      : bytes_(bytes), scanner_(bytes, {.hash_comments = false, .continued_lines = false}) {}
  PlyHeader read();

 private:
  std::string_view need_word(std::string_view what);
  PlyType read_type();
  void read_format();
  void read_element();
  void read_property();
  void check_counts() const;

  std::string_view bytes_;
  TextScanner scanner_;
  PlyHeader header_;
  bool has_format_ = false;
};

std::string_view HeaderReader::need_word(std::string_view what) {
  const std::string_view word = scanner_.word_in_line();
  if (word.empty()) {
    refuse("the PLY header lacks {} (line {}); check that the file is complete", what,
           scanner_.line());
  }
  return word;
}

PlyType HeaderReader::read_type() {
  const std::string_view word = need_word("a type");
  for (const auto& [name, type] : type_names) {
    if (name == word) {
      return type;
    }
  }
  refuse("the PLY header names type {} (line {}); use char to uint, float or double",
         in_quotes(word), scanner_.line());
}

void HeaderReader::read_format() {
  const std::string_view word = need_word("the format");
  header_.ascii = word == "ascii";
  header_.order = word == "binary_big_endian" ? std::endian::big : std::endian::little;
  if (!header_.ascii && word != "binary_little_endian" && word != "binary_big_endian") {
    refuse(
        "the PLY header names format {} (line {}); use ascii, binary_little_endian or "
        "binary_big_endian",
        in_quotes(word), scanner_.line());
  }
  has_format_ = true;
}

void HeaderReader::read_element() {
  PlyElement element;
  element.name = need_word("an element's name");
  const std::string_view word = need_word("an element's count");
  if (!parse_integer(word, element.count) || element.count < 0) {
    refuse("the PLY header counts {} of element {} (line {}); write a whole number",
           in_quotes(word), in_quotes(element.name), scanner_.line());
  }
  header_.elements.push_back(element);
}

void HeaderReader::read_property() {
  if (header_.elements.empty()) {
    refuse("the PLY header has a property before any element (line {}); put an element line first",
           scanner_.line());
  }
  PlyProperty property;
  TextScanner ahead = scanner_;
  if (ahead.word_in_line() == "list") {
    scanner_ = ahead;
    property.list_count = read_type();
    if (*property.list_count == PlyType::Float || *property.list_count == PlyType::Double) {
      refuse("the PLY header gives a list a length that is not an integer (line {}); use uchar",
             scanner_.line());
    }
  }
  property.type = read_type();
  property.name = need_word("a property's name");
  header_.elements.back().properties.push_back(property);
}

void HeaderReader::check_counts() const {
  const double left = static_cast<double>(bytes_.size() - header_.data_start);
  for (const PlyElement& element : header_.elements) {
    double least = 0;
    for (const PlyProperty& p : element.properties) {
      // As text, a digit and a separator.
      least += header_.ascii ? 2 : static_cast<double>(size_of(p.list_count.value_or(p.type)));
    }
    if (static_cast<double>(element.count) * least > left + 1) {
      refuse(
          "the header declares {} of element {}, but only {} follow (byte {}); check that the "
          "file is complete",
          element.count, in_quotes(element.name),
          counted(static_cast<long long>(left), "byte", "bytes"), header_.data_start);
    }
  }
}

PlyHeader HeaderReader::read() {
  scanner_.skip_line();
  while (true) {
    const std::string_view keyword = scanner_.word();
    if (keyword.empty()) {
      refuse("the PLY header has no end_header (line {}); check that the file is complete",
             scanner_.line());
    }
    if (keyword == "end_header") {
      break;
    }
    if (keyword == "format") {
      read_format();
    } else if (keyword == "element") {
      read_element();
    } else if (keyword == "property") {
      read_property();
    } else if (keyword != "comment" && keyword != "obj_info") {
      refuse("the PLY header has the line {} (line {}); check that this is a PLY file",
             in_quotes(keyword), scanner_.line());
    }
    scanner_.skip_line();
  }
  if (!has_format_) {
    refuse("the PLY header has no format line; add one such as format ascii 1.0");
  }
  scanner_.skip_line();
  header_.data_start = bytes_.size() - scanner_.bytes_left();
  header_.data_line = scanner_.line();
  check_counts();
  return header_;
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::Uint8:
      return 1;
    case PlyType::Int16:
    case PlyType::Uint16:
      return 2;
    case PlyType::Double:
      return 8;
    default:
      return 4;
  }
}

PlyHeader read_ply_header(std::string_view bytes) {
  return HeaderReader(bytes).read();
}

}  // namespace ucvt
