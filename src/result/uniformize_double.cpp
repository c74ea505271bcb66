#include "result/uniformize_double.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "conformal/uniformize.h"
#include "mesh/edge_bisection.h"

namespace ucvt {

UniformizedSurface uniformize(const DoubledSurface& doubled, const UniformizeOptions& options) {
  Uniformized t = uniformize_surface(doubled.surface, options);
  t.mirror = doubled.mirror;
  return UniformizedSurface(std::make_shared<const Uniformized>(std::move(t)));
}

UniformizedSurface uniformize(const OpenSurface& surface, const UniformizeOptions& options) {
  // The double would not be refined symmetrically.
  TriangleMesh half = surface.mesh;
  std::vector<double> size(half.positions.size(),
                           options.longest_edge > 0 ? options.longest_edge : HUGE_VAL);
  bisect_edges(half, size);
  UniformizeOptions of_double = options;
  of_double.longest_edge = 0;
  return uniformize(doubled(half, surface.genus, boundary_loops(half)), of_double);
}

}  // namespace ucvt
