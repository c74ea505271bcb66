#include "cvt/initial_sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <random>

namespace ucvt {
namespace {

/// Uniform in [0, 1) by the top 53 bits: unlike the standard's distributions, the same everywhere.
double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

}  // namespace

std::vector<SurfacePoint> random_sites(const UniformSurface& t, const std::vector<double>& density,
                                       std::size_t n, std::uint64_t seed) {
  const Connectivity& c = t.connectivity();
  std::vector<double> mass(c.face_count());
  double total = 0;
  const auto corner_density = [&](std::size_t f) {
    std::array<double, 3> rho{};
    for (std::size_t i = 0; i < 3; ++i) {
      rho[i] = density[c.origin(halfedges({static_cast<std::int32_t>(f)})[i]).index()];
    }
    return rho;
  };
  for (std::size_t f = 0; f < mass.size(); ++f) {
    const Face face{static_cast<std::int32_t>(f)};
    total += integrate(t.space(), t.triangle(face), corner_density(f)).mass;
    mass[f] = total;
  }
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> out;
  while (out.size() < n) {
    const auto at = std::upper_bound(mass.begin(), mass.end(), uniform(random) * total);
    const auto f = static_cast<std::size_t>(
        std::min(at - mass.begin(), static_cast<std::ptrdiff_t>(mass.size()) - 1));
    const auto rho = corner_density(f);
    const double top = *std::max_element(rho.begin(), rho.end());
    // Inside the face, by rejection; T's faces are small, so its area is the chord triangle's.
    SurfacePoint p{{static_cast<std::int32_t>(f)}, {}};
    for (int tries = 0; tries < 1000; ++tries) {
      const double r = std::sqrt(uniform(random)), s = uniform(random);
      p.bary = {1 - r, r * (1 - s), r * s};
      const double here = p.bary[0] * rho[0] + p.bary[1] * rho[1] + p.bary[2] * rho[2];
      if (uniform(random) * top <= here) {
        break;
      }
    }
    out.push_back(p);
  }
  return out;
}

std::vector<SurfacePoint> farthest_sites(const UniformSurface& t, const std::vector<double>& length,
                                         std::size_t n, std::uint64_t seed) {
  const Connectivity& c = t.connectivity();
  using Entry = std::pair<double, std::int32_t>;
  std::vector<double> distance(c.vertex_count(), std::numeric_limits<double>::infinity());
  std::priority_queue<Entry> farthest;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  std::mt19937_64 random(seed);
  auto next = static_cast<std::int32_t>(uniform(random) * static_cast<double>(distance.size()));
  std::vector<SurfacePoint> out;
  while (out.size() < n) {
    const Halfedge h = c.outgoing({next});
    SurfacePoint p{h.face(), {0, 0, 0}};
    p.bary[static_cast<std::size_t>(h.id % 3)] = 1;
    out.push_back(p);
    // Dijkstra's algorithm over the part that the new site is nearest to.
    distance[static_cast<std::size_t>(next)] = 0;
    front.push({0, next});
    while (!front.empty()) {
      const auto [d, v] = front.top();
      front.pop();
      if (d > distance[static_cast<std::size_t>(v)]) {
        continue;
      }
      c.for_outgoing({v}, [&](Halfedge e) {
        const Vertex w = c.head(e);
        const double through = d + length[e.index()];
        if (through >= distance[w.index()]) {
          return;
        }
        distance[w.index()] = through;
        front.push({through, w.id});
        farthest.push({through, w.id});
      });
    }
    while (!farthest.empty() &&
           farthest.top().first != distance[static_cast<std::size_t>(farthest.top().second)]) {
      farthest.pop();
    }
    if (farthest.empty()) {
      break;
    }
    next = farthest.top().second;
  }
  return out;
}

}  // namespace ucvt
