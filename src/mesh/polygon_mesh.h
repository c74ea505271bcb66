// What the readers gather: positions and polygons, and the triangles that become of them.
//
// Triangles are taken as they come; other polygons wait until all positions are known, since a file
// may list faces first.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

class PolygonMesh {
 public:
  std::vector<Position> positions;

  /// Adds a polygon of three corners or more.
  void add_face(std::span<const std::int32_t> corners);
  void reserve_triangles(std::size_t count) { triangles_.reserve(count); }
  [[nodiscard]] std::int64_t face_count() const { return face_count_; }

  /// The mesh, polygons cut into triangles that stand where the polygon stood. Throws InvalidInput
  /// when there is no face. Leaves this empty.
  TriangleMesh take_triangles();

 private:
  struct Polygon {
    std::size_t triangles_before;
    std::size_t first_corner;
    std::size_t size;
  };
  std::vector<Corners> triangles_;
  std::vector<Polygon> polygons_;
  std::vector<std::int32_t> polygon_corners_;
  std::int64_t face_count_ = 0;
};

/// Where a reader stands, for messages: "line 12" or "byte 1040".
std::string at_line(std::int64_t line);
std::string at_byte(std::size_t byte);

/// Throws InvalidInput unless each coordinate is finite.
void check_finite(const Position& position, std::int64_t vertex, const std::string& where);
void check_finite(const Position& position, std::int64_t vertex, std::int64_t line);

/// Throws InvalidInput: the face's vertex index is none of the `vertices`.
[[noreturn]] void refuse_index(std::int64_t face, std::int64_t index, std::int64_t vertices,
                               const std::string& where);

/// Throws InvalidInput: the face has fewer than three corners.
[[noreturn]] void refuse_corner_count(std::int64_t face, std::int64_t corners,
                                      const std::string& where);

/// The largest counts that index arithmetic in 32 bits allows; more are refused.
inline constexpr std::int64_t max_vertices = 2'147'483'647;
inline constexpr std::int64_t max_faces = 715'827'882;
void check_size(std::int64_t vertices, std::int64_t faces);

}  // namespace ucvt
