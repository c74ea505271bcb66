#include "mesh/polygon_mesh.h"

#include <cmath>
#include <utility>

#include "mesh/invalid.h"
#include "mesh/polygon_cutter.h"

namespace ucvt {

void PolygonMesh::add_face(std::span<const std::int32_t> corners) {
  ++face_count_;
  if (corners.size() == 3) {
    triangles_.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  polygons_.push_back({triangles_.size(), polygon_corners_.size(), corners.size()});
  polygon_corners_.insert(polygon_corners_.end(), corners.begin(), corners.end());
}

TriangleMesh PolygonMesh::take_triangles() {
  if (face_count_ == 0) {
    refuse("there are no faces; give a mesh with triangles or polygons");
  }
  check_size(static_cast<std::int64_t>(positions.size()),
             static_cast<std::int64_t>(triangles_.size() + polygon_corners_.size()));
  TriangleMesh mesh;
  mesh.positions = std::move(positions);
  if (polygons_.empty()) {
    mesh.faces = std::move(triangles_);
  } else {
    PolygonCutter cutter(mesh.positions, triangles_.size() * 2 + polygon_corners_.size());
    for (const Corners& t : triangles_) {
      cutter.add_boundary(t);
    }
    const std::span<const std::int32_t> all(polygon_corners_);
    for (const Polygon& p : polygons_) {
      cutter.add_boundary(all.subspan(p.first_corner, p.size));
    }
    mesh.faces.reserve(triangles_.size() + polygon_corners_.size() - 2 * polygons_.size());
    std::size_t done = 0;
    for (const Polygon& p : polygons_) {
      for (; done < p.triangles_before; ++done) {
        mesh.faces.push_back(triangles_[done]);
      }
      cutter.cut(all.subspan(p.first_corner, p.size), mesh.faces);
    }
    for (; done < triangles_.size(); ++done) {
      mesh.faces.push_back(triangles_[done]);
    }
  }
  *this = PolygonMesh();
  return mesh;
}

std::string at_line(std::int64_t line) {
  return fmt::format("line {}", line);
}

std::string at_byte(std::size_t byte) {
  return fmt::format("byte {}", byte);
}

void check_finite(const Position& position, std::int64_t vertex, const std::string& where) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(position[i])) {
      refuse("vertex {} has coordinate {} = {} ({}); coordinates must be finite numbers", vertex,
             "xyz"[i], position[i], where);
    }
  }
}

void check_finite(const Position& position, std::int64_t vertex, std::int64_t line) {
  if (std::isfinite(position[0]) && std::isfinite(position[1]) && std::isfinite(position[2])) {
    return;
  }
  check_finite(position, vertex, at_line(line));
}

void refuse_index(std::int64_t face, std::int64_t index, std::int64_t vertices,
                  const std::string& where) {
  if (index < 0) {
    refuse("face {} has vertex index {} ({}); vertex indices here are 0 to {}", face, index, where,
           vertices - 1);
  }
  refuse("face {} has vertex index {}, but there are {} ({}); check that the file is complete",
         face, index, counted(vertices, "vertex", "vertices"), where);
}

void refuse_corner_count(std::int64_t face, std::int64_t corners, const std::string& where) {
  refuse("face {} has {} ({}); remove it, faces need three corners or more", face,
         counted(corners, "corner", "corners"), where);
}

void check_size(std::int64_t vertices, std::int64_t faces) {
  if (vertices > max_vertices) {
    refuse("there are {} vertices; at most {} can be taken", vertices, max_vertices);
  }
  if (faces > max_faces) {
    refuse("there are {} faces; at most {} can be taken", faces, max_faces);
  }
}

}  // namespace ucvt
