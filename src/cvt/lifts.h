// Where the vertices of T lie: in which cell, and where in that cell's site's frame.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "cvt/cell_walk.h"
#include "cvt/stars.h"

namespace ucvt {

/// The vertices of T in an order in which those of one face are near each other in memory: as faces,
/// which lie along a space-filling curve, first have them.
struct VertexOrder {
  explicit VertexOrder(const Connectivity& t);

  std::vector<std::int32_t> rank;                   ///< by vertex
  std::vector<std::array<std::int32_t, 3>> corner;  ///< by face: the ranks of its corners
};

/// By rank of the vertex.
struct Lifts {
  std::shared_ptr<const VertexOrder> order;
  std::vector<Offset> at;
  std::vector<Vertex> owner;

  /// The ranks of a face's corners.
  [[nodiscard]] std::array<std::size_t, 3> corners(Face f) const {
    const auto& c = order->corner[f.index()];
    return {static_cast<std::size_t>(c[0]), static_cast<std::size_t>(c[1]),
            static_cast<std::size_t>(c[2])};
  }
};

/// Two points of a frame are the ends of an edge when their squared chord is its own within this part.
constexpr double same_chord2 = 1e-3;

/// True when p and q, in the frame of the site, can be the ends of h: lifts of another edge are
/// farther apart.
inline bool joins(const UniformSurface& t, const Stars& stars, Halfedge h, Vertex site,
                  const Offset& p, const Offset& q) {
  const Space s = t.space();
  if (s.kappa > 0) {
    return true;
  }
  const double chord = t.chord(h), gap = std::abs(chord2(s, p, q) - chord * chord);
  if (gap < same_chord2 * chord * chord) {
    return true;
  }
  const double rounding = lift_rounding(s, p, stars.reach(site));
  return gap < rounding * (2 * chord + rounding);
}

}  // namespace ucvt
