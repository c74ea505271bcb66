// The vertices of a triangulation in an order in which those of one face are near each other in memory.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triangulation/connectivity.h"

namespace ucvt {

/// Vertices as faces, which lie along a space-filling curve, first have them.
struct VertexOrder {
  explicit VertexOrder(const Connectivity& t);

  std::vector<std::int32_t> rank;                   ///< by vertex
  std::vector<std::array<std::int32_t, 3>> corner;  ///< by face: the ranks of its corners

  /// The ranks of a face's corners.
  [[nodiscard]] std::array<std::size_t, 3> corners(Face f) const {
    const auto& c = corner[f.index()];
    return {static_cast<std::size_t>(c[0]), static_cast<std::size_t>(c[1]),
            static_cast<std::size_t>(c[2])};
  }
};

}  // namespace ucvt
