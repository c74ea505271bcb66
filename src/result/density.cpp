#include "result/density.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>

#include "cvt/surface_mass.h"

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

std::vector<double> sizing_density(const std::vector<double>& conformal_factor,
                                   const std::vector<double>& size) {
  std::vector<double> root(size.size());
  for (std::size_t v = 0; v < size.size(); ++v) {
    root[v] = conformal_factor[v] / (size[v] * size[v]);
  }
  const double top = *std::max_element(root.begin(), root.end());
  for (double& r : root) {
    r = (r / top) * (r / top);
  }
  return root;
}

void limit_growth(const Uniformized& t, double growth, std::vector<double>& size) {
  const Connectivity& c = t.intrinsic.connectivity;
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for (std::size_t v = 0; v < size.size(); ++v) {
    front.push({size[v], static_cast<std::int32_t>(v)});
  }
  while (!front.empty()) {
    const auto [at, v] = front.top();
    front.pop();
    if (at > size[static_cast<std::size_t>(v)]) {
      continue;
    }
    c.for_outgoing({v}, [&](Halfedge h) {
      const Vertex w = c.head(h);
      const double grown = at + growth * std::exp(t.intrinsic.log_length[h.index()]);
      if (grown < size[w.index()]) {
        size[w.index()] = grown;
        front.push({grown, w.id});
      }
    });
  }
}

double hexagonal_energy(const UniformSurface& t, const std::vector<double>& density,
                        std::size_t sites) {
  std::vector<double> root;
  for (const double rho : density) {
    root.push_back(std::sqrt(rho));
  }
  const double sum = SurfaceMass(t, std::move(root)).total();
  return 5 / (18 * std::numbers::sqrt3) * sum * sum / static_cast<double>(sites);
}

}  // namespace ucvt
