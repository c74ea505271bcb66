#include "cvt/uniformity.h"

#include <algorithm>
#include <cmath>

namespace ucvt {

Spread spread_of(const std::vector<double>& values) {
  Spread out;
  if (values.empty()) {
    return out;
  }
  const auto n = static_cast<double>(values.size());
  for (const double v : values) {
    out.mean += v / n;
  }
  double variance = 0;
  for (const double v : values) {
    variance += (v - out.mean) * (v - out.mean) / n;
  }
  out.cv = out.mean != 0 ? std::sqrt(variance) / std::abs(out.mean) : 0;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  out.min = *low, out.max = *high;
  return out;
}

UniformityReport measure_uniformity(const DelaunayTriangulation& d) {
  const Connectivity& c = d.connectivity();
  const Space s = d.space();
  UniformityReport out;
  std::vector<double> radius, nearest, area;
  for (std::size_t v = 0; v < d.vertex_count(); ++v) {
    const Vertex site{static_cast<std::int32_t>(v)};
    std::vector<Offset> corner;
    double least = HUGE_VAL, farthest = 0, total = 0;
    c.for_outgoing(site, [&](Halfedge h) {
      least = std::min(least, length_of_chord(s, std::sqrt(2 * d.offset(h).h)));
      const Central k = circumcentre(d.offset(h), d.offset(c.rotate(h)));
      corner.push_back(from_central(s, k.x, k.y));
      farthest = std::max(farthest, length_of_chord(s, std::sqrt(2 * corner.back().h)));
    });
    for (std::size_t i = 0; i < corner.size(); ++i) {
      total += central_triangle_area(s, corner[i], corner[(i + 1) % corner.size()]);
    }
    radius.push_back(farthest), nearest.push_back(least), area.push_back(total);
    ++out.degree[static_cast<int>(corner.size())];
  }
  out.radius = spread_of(radius), out.nearest = spread_of(nearest), out.area = spread_of(area);
  const auto six = out.degree.find(6);
  out.hexagons = six == out.degree.end()
                     ? 0
                     : static_cast<double>(six->second) / static_cast<double>(d.vertex_count());
  return out;
}

}  // namespace ucvt
