// A surface with a density: what integrals over its faces need, computed once.
#pragma once

#include <utility>
#include <vector>

#include "space/moments.h"
#include "triangulation/uniform_surface.h"

namespace ucvt {

class SurfaceMass {
 public:
  /// Takes the density at the vertices of T; it is linear over each face's chord triangle. Keeps a
  /// reference to t.
  SurfaceMass(const UniformSurface& t, std::vector<double> density);

  [[nodiscard]] const UniformSurface& surface() const { return t_; }
  [[nodiscard]] const std::vector<double>& density() const { return density_; }
  /// The density at the corners of a face.
  [[nodiscard]] std::array<double, 3> corner_densities(Face f) const;
  /// Weights of the density over a whole face.
  [[nodiscard]] const Weights& weights(Face f) const { return weights_[f.index()]; }

 private:
  const UniformSurface& t_;
  std::vector<double> density_;
  std::vector<Weights> weights_;
};

}  // namespace ucvt
