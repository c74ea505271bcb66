#include "mesh/doubled_surface.h"

#include <cstddef>
#include <numeric>

namespace ucvt {

DoubledSurface doubled(const TriangleMesh& half, int genus,
                       const std::vector<std::vector<std::int32_t>>& boundary) {
  const std::size_t n = half.positions.size(), faces = half.faces.size();
  DoubledSurface out;
  std::vector<bool> shared(n, false);
  for (const auto& loop : boundary) {
    for (const std::int32_t v : loop) {
      shared[static_cast<std::size_t>(v)] = true;
    }
  }
  TriangleMesh& mesh = out.surface.mesh;
  mesh = half;
  out.mirror.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    out.mirror[v] = static_cast<std::int32_t>(v);
    if (!shared[v]) {
      out.mirror[v] = static_cast<std::int32_t>(mesh.positions.size());
      mesh.positions.push_back(half.positions[v]);
      out.mirror.push_back(static_cast<std::int32_t>(v));
    }
  }
  for (std::size_t f = 0; f < faces; ++f) {
    const auto image = [&](std::size_t i) {
      return out.mirror[static_cast<std::size_t>(half.faces[f][i])];
    };
    mesh.faces.push_back({image(2), image(1), image(0)});
  }
  out.surface.genus = 2 * genus + static_cast<int>(boundary.size()) - 1;
  out.surface.input_vertex.resize(mesh.positions.size());
  std::iota(out.surface.input_vertex.begin(), out.surface.input_vertex.end(), 0);
  return out;
}

}  // namespace ucvt
