// Where the vertices of T lie: in which cell, and where in that cell's site's frame.
#pragma once

#include <vector>

#include "cvt/cell_walk.h"
#include "cvt/stars.h"

namespace ucvt {

/// By rank of the vertex in T's `vertex_order`.
struct Lifts {
  std::vector<Offset> at;
  std::vector<Vertex> owner;
};

/// How many cells three vertices lie in, and which of them lies alone in its cell where there are two.
struct CornerCells {
  int count;
  std::size_t alone;
};

inline CornerCells cells_of(const Lifts& lifts, const std::array<std::size_t, 3>& vertices) {
  const Vertex a = lifts.owner[vertices[0]], b = lifts.owner[vertices[1]],
               c = lifts.owner[vertices[2]];
  if (a != b && b != c && c != a) {
    return {3, 0};
  }
  return {a == b && b == c ? 1 : 2, b == c ? 0U : c == a ? 1U : 2U};
}

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
