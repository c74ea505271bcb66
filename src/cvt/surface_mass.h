// A surface with a density: what integrals over its faces need, computed once.
//
// The integral of the density over a face is shared out to its corners: to each its weight mu
// (space/moments.h) and a third of the excess. What the faces around a vertex add to the cell that the vertex
// lies in is then two numbers.
#pragma once

#include <utility>
#include <vector>

#include "space/moments.h"
#include "triangulation/uniform_surface.h"

namespace ucvt {

/// What a corner of a face has of the integral over it, or a vertex of those over its faces.
struct CornerShare {
  double mu = 0, excess = 0;

  /// As moments in the frame that the vertex is given in.
  [[nodiscard]] Moments moments(Space s, const Offset& vertex) const {
    return {mu + s.kappa * excess, mu * vertex.x, mu * vertex.y, excess + mu * vertex.h};
  }
};

/// What integrals over pieces of a face need, together in memory.
struct FacePieces {
  ChordTriangle triangle;
  std::array<double, 3> density;  ///< at the corners
  Weights weights;                ///< of the whole face

  [[nodiscard]] CornerShare share(std::size_t corner) const {
    return {weights.mu[corner], weights.excess / 3};
  }
};

class SurfaceMass {
 public:
  /// Takes the density at the vertices of T; it is linear over each face's chord triangle. Keeps a
  /// reference to t.
  SurfaceMass(const UniformSurface& t, std::vector<double> density);

  [[nodiscard]] const UniformSurface& surface() const { return t_; }
  [[nodiscard]] const std::vector<double>& density() const { return density_; }
  [[nodiscard]] const FacePieces& pieces(Face f) const { return pieces_[f.index()]; }
  /// By rank in T's `vertex_order`.
  [[nodiscard]] const CornerShare& share(std::size_t rank) const { return share_[rank]; }
  /// Asks for what cutting the face will read, ahead of time: it waits for memory otherwise.
  void prefetch(Face f) const {
    __builtin_prefetch(&pieces_[f.index()]);
    __builtin_prefetch(&pieces_[f.index()].weights);
  }
  /// Mass of the whole surface.
  [[nodiscard]] double total() const;

 private:
  const UniformSurface& t_;
  std::vector<double> density_;
  std::vector<FacePieces> pieces_;
  std::vector<CornerShare> share_;
};

}  // namespace ucvt
