#include "cvt/initial_sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <random>

namespace ucvt {
namespace {

/// Uniform in [0, 1) by the top 53 bits: unlike the standard's distributions, the same everywhere.
double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

}  // namespace

std::vector<SurfacePoint> random_sites(const UniformSurface& t, const std::vector<double>& weight,
                                       std::size_t n, std::uint64_t seed) {
  const Connectivity& c = t.connectivity();
  std::vector<double> until(weight.size());
  std::partial_sum(weight.begin(), weight.end(), until.begin());
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> out;
  while (out.size() < n) {
    const auto at = std::upper_bound(until.begin(), until.end(), uniform(random) * until.back());
    const auto v = std::min(at - until.begin(), static_cast<std::ptrdiff_t>(until.size()) - 1);
    const Vertex vertex{static_cast<std::int32_t>(v)};
    Halfedge h = c.outgoing(vertex);
    for (auto turns = random() % static_cast<std::uint64_t>(c.degree(vertex)); turns > 0; --turns) {
      h = c.rotate(h);
    }
    // Uniform over the part of the face that is nearest, in barycentric terms, to the vertex.
    const double r = std::sqrt(uniform(random)), s = uniform(random);
    SurfacePoint p{h.face(), {1 - r, r * (1 - s), r * s}};
    std::iter_swap(std::max_element(p.bary.begin(), p.bary.end()), p.bary.begin() + h.id % 3);
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
