#include "result/density.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>
#include <utility>

#include "cvt/surface_mass.h"

namespace ucvt {
namespace {

/// Rings round a vertex over which areas are compared.
constexpr int mean_rings = 2;

}  // namespace

std::vector<double> conformal_factor(const Uniformized& t) {
  const Connectivity& c = t.surface.connectivity();
  const std::size_t n = c.vertex_count();
  std::vector<double> area(n);
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    const Face face{static_cast<std::int32_t>(f)};
    for (const Halfedge h : halfedges(face)) {
      area[c.origin(h).index()] += t.surface.area(face) / 3;
    }
  }
  std::vector<double> out(n), scaled(n);
  for (std::size_t v = 0; v < n; ++v) {
    out[v] = std::exp(-2 * t.log_scale[v]);
    scaled[v] = area[v] * out[v];
  }
  std::vector<double> on_input = t.vertex_area_3d;
  const auto spread = [&](std::vector<double>& x) {
    std::vector<double> y = x;
    for (std::size_t v = 0; v < n; ++v) {
      c.for_outgoing({static_cast<std::int32_t>(v)},
                     [&](Halfedge h) { y[v] += x[c.head(h).index()]; });
    }
    x = std::move(y);
  };
  for (int ring = 0; ring < mean_rings; ++ring) {
    spread(on_input);
    spread(scaled);
  }
  double total = 0;
  for (std::size_t v = 0; v < n; ++v) {
    out[v] *= on_input[v] / scaled[v];
    total += out[v] * area[v];
  }
  const double whole = std::accumulate(t.vertex_area_3d.begin(), t.vertex_area_3d.end(), 0.0);
  for (double& factor : out) {
    factor *= whole / total;
  }
  return out;
}

std::vector<double> sizing_density(const std::vector<double>& conformal_factor,
                                   const std::vector<double>& size) {
  std::vector<double> log_root(size.size());
  for (std::size_t v = 0; v < size.size(); ++v) {
    log_root[v] = std::log(conformal_factor[v]) - 2 * std::log(size[v]);
  }
  const auto [low, high] = std::minmax_element(log_root.begin(), log_root.end());
  const double middle = (*low + *high) / 2;
  std::vector<double> out;
  out.reserve(log_root.size());
  for (const double l : log_root) {
    out.push_back(std::exp(2 * (l - middle)));
  }
  return out;
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
