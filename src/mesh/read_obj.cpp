#include <charconv>
#include <string>
#include <vector>

#include "mesh/invalid.h"
#include "mesh/polygon_mesh.h"
#include "mesh/readers.h"
#include "mesh/text_scanner.h"

namespace ucvt {
namespace {

class ObjReader {
 public:
  explicit ObjReader(std::string_view text) : scanner_(text, {true, true}) {}
  TriangleMesh read();

 private:
  void read_vertex();
  void read_face();
  std::int32_t read_corner(std::string_view word);

  TextScanner scanner_;
  PolygonMesh mesh_;
  std::vector<std::int32_t> corners_;
  // A face may name a vertex that comes later: the farthest such index is checked at the end.
  std::int64_t farthest_index_ = 0, farthest_face_ = 0, farthest_line_ = 0;
};

void ObjReader::read_vertex() {
  const auto number = static_cast<std::int64_t>(mesh_.positions.size());
  Position position;
  for (double& coordinate : position) {
    const std::string_view word = scanner_.word_in_line();
    if (word.empty()) {
      refuse(
          "vertex {} has fewer than three coordinates (line {}); check that the file is complete",
          number, scanner_.line());
    }
    if (!parse_real(word, coordinate)) {
      refuse("vertex {} has coordinate {} (line {}); write a number, with a point", number,
             in_quotes(word), scanner_.line());
    }
  }
  check_finite(position, number, scanner_.line());
  mesh_.positions.push_back(position);
}

// "7", "7/1", "7//3", "7/1/3", "7//": the first number is the vertex.
std::int32_t ObjReader::read_corner(std::string_view word) {
  const std::int64_t face = mesh_.face_count();
  const std::string_view number = word.substr(0, word.find('/'));
  std::int64_t index = 0;
  const bool rest_is_indices =
      word.find_first_not_of("0123456789/-+", number.size()) == std::string_view::npos;
  if (!parse_integer(number, index) || !rest_is_indices) {
    refuse("face {} has corner {} (line {}); write vertex indices such as 7, 7/1 or 7//3", face,
           in_quotes(word), scanner_.line());
  }
  const auto vertices = static_cast<std::int64_t>(mesh_.positions.size());
  if (index == 0) {
    refuse("face {} has vertex index 0 (line {}); OBJ counts vertices from 1", face,
           scanner_.line());
  }
  if (index < -vertices) {
    refuse(
        "face {} has vertex index {}, but there are {} so far (line {}); check that the file is "
        "complete",
        face, index, counted(vertices, "vertex", "vertices"), scanner_.line());
  }
  if (index > max_vertices) {
    refuse_index(face, index, vertices, at_line(scanner_.line()));
  }
  if (index > vertices && index > farthest_index_) {
    farthest_index_ = index;
    farthest_face_ = face;
    farthest_line_ = scanner_.line();
  }
  return static_cast<std::int32_t>(index > 0 ? index - 1 : vertices + index);
}

void ObjReader::read_face() {
  corners_.clear();
  const std::int64_t line = scanner_.line();
  for (auto word = scanner_.word_in_line(); !word.empty(); word = scanner_.word_in_line()) {
    corners_.push_back(read_corner(word));
  }
  if (corners_.size() < 3) {
    refuse_corner_count(mesh_.face_count(), static_cast<std::int64_t>(corners_.size()),
                        at_line(line));
  }
  mesh_.add_face(corners_);
}

TriangleMesh ObjReader::read() {
  while (true) {
    const std::string_view keyword = scanner_.word();
    if (keyword.empty()) {
      break;
    }
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f" || keyword == "fo") {
      read_face();
    }
    scanner_.skip_line();
  }
  const auto vertices = static_cast<std::int64_t>(mesh_.positions.size());
  if (vertices == 0 && mesh_.face_count() == 0) {
    refuse("there are no vertices and no faces; check that this is an OBJ file");
  }
  if (farthest_index_ > vertices) {
    refuse_index(farthest_face_, farthest_index_, vertices, at_line(farthest_line_));
  }
  return mesh_.take_triangles();
}

}  // namespace

TriangleMesh read_obj(std::string_view bytes) {
  return ObjReader(bytes).read();
}

}  // namespace ucvt
