// A surface with a density: what integrals over its faces need, computed once.
#pragma once

#include <utility>
#include <vector>

#include "space/moments.h"
#include "triangulation/uniform_surface.h"

namespace ucvt {

/// What integrals over pieces of a face need, together in memory.
struct FacePieces {
  ChordTriangle triangle;
  std::array<double, 3> density;  ///< at the corners
};

class SurfaceMass {
 public:
  /// Takes the density at the vertices of T; it is linear over each face's chord triangle. Keeps a
  /// reference to t.
  SurfaceMass(const UniformSurface& t, std::vector<double> density);

  [[nodiscard]] const UniformSurface& surface() const { return t_; }
  [[nodiscard]] const std::vector<double>& density() const { return density_; }
  /// Weights of the density over a whole face.
  [[nodiscard]] const Weights& weights(Face f) const { return weights_[f.index()]; }
  [[nodiscard]] const FacePieces& pieces(Face f) const { return pieces_[f.index()]; }
  /// Asks for what cutting the face will read, ahead of time: it waits for memory otherwise.
  void prefetch(Face f) const {
    __builtin_prefetch(&pieces_[f.index()]);
    __builtin_prefetch(&weights_[f.index()]);
  }
  /// Mass of the whole surface.
  [[nodiscard]] double total() const;

 private:
  const UniformSurface& t_;
  std::vector<double> density_;
  std::vector<Weights> weights_;
  std::vector<FacePieces> pieces_;
};

}  // namespace ucvt
