#include "result/density.h"

#include <algorithm>

namespace ucvt {

std::vector<double> conformal_factor(const Uniformized& t) {
  const Connectivity& c = t.surface.connectivity();
  std::vector<double> area(c.vertex_count());
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    const Face face{static_cast<std::int32_t>(f)};
    for (const Halfedge h : halfedges(face)) {
      area[c.origin(h).index()] += t.surface.area(face) / 3;
    }
  }
  std::vector<double> out(area.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    out[v] = t.vertex_area_3d[v] / area[v];
  }
  return out;
}

std::vector<double> uniform_sizing_density(const std::vector<double>& conformal_factor) {
  const double top = *std::max_element(conformal_factor.begin(), conformal_factor.end());
  std::vector<double> out;
  out.reserve(conformal_factor.size());
  for (const double cf : conformal_factor) {
    out.push_back((cf / top) * (cf / top));
  }
  return out;
}

}  // namespace ucvt
