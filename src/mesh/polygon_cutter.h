// Cutting polygons into triangles without using an edge of the mesh twice.
//
// A polygon is cut by clipping ears in its best-fit plane (Newell's normal), the best shaped first,
// so concave polygons and collinear corners come out as a valid triangulation. A diagonal that is
// an edge of the mesh already would become an edge of four faces: such diagonals are taken only
// when there is no other. The result does not depend on the scale of the positions.
#pragma once

#include <cstdint>
#include <queue>
#include <span>
#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

/// The undirected edges of a mesh, as pairs of vertices in a hash table.
class EdgeSet {
 public:
  explicit EdgeSet(std::size_t expected);
  void insert(std::int32_t a, std::int32_t b);
  [[nodiscard]] bool contains(std::int32_t a, std::int32_t b) const;

 private:
  [[nodiscard]] std::size_t slot(std::uint64_t key) const;
  void grow();

  std::vector<std::uint64_t> slots_;
  std::size_t size_ = 0;
};

class PolygonCutter {
 public:
  PolygonCutter(const std::vector<Position>& positions, std::size_t expected_edges)
      : positions_(positions), edges_(expected_edges) {}

  /// Marks the sides of a face as edges; all faces come before the first cut.
  void add_boundary(std::span<const std::int32_t> corners);

  /// Appends corners.size() - 2 triangles, oriented like the polygon.
  void cut(std::span<const std::int32_t> corners, std::vector<Corners>& triangles);

 private:
  struct Corner {
    double x = 0, y = 0;
    std::int32_t vertex = 0;
    std::int32_t prev = 0, next = 0;
    std::int32_t version = 0;
    bool reflex = false;
  };
  struct Ear {
    double quality;
    std::int32_t corner;
    std::int32_t version;
    bool operator<(const Ear& other) const {
      return quality != other.quality ? quality < other.quality : corner > other.corner;
    }
  };

  void emit(std::int32_t a, std::int32_t b, std::int32_t c, std::vector<Corners>& triangles);
  void cut_fan(std::span<const std::int32_t> corners, std::size_t apex,
               std::vector<Corners>& triangles);
  void cut_quad(std::span<const std::int32_t> corners, const Position& normal,
                std::vector<Corners>& triangles);
  void cut_leftover(const Position& normal, std::int32_t start, std::vector<Corners>& triangles);
  Position load_points(std::span<const std::int32_t> corners);
  void project(std::span<const std::int32_t> corners, const Position& normal);
  std::int32_t clip_ears(std::vector<Corners>& triangles);
  std::int32_t clip(std::int32_t corner, std::vector<Corners>& triangles);
  void classify(std::int32_t corner);
  [[nodiscard]] bool blocks(std::int32_t other, std::int32_t corner) const;
  [[nodiscard]] bool is_ear(std::int32_t corner) const;
  void offer(std::int32_t corner);
  [[nodiscard]] double area(std::int32_t a, std::int32_t b, std::int32_t c) const;
  [[nodiscard]] std::size_t best_apex(std::span<const std::int32_t> corners) const;

  const std::vector<Position>& positions_;
  EdgeSet edges_;
  std::vector<Position> points_;  // of the polygon at hand, in a box of size one
  std::vector<Corner> ring_;
  std::vector<std::int32_t> reflex_;       // sorted by x
  std::vector<std::int32_t> late_reflex_;  // that rounding made so after the first clip
  std::priority_queue<Ear> ears_;
};

}  // namespace ucvt
