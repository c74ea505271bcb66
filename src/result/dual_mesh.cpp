#include "result/dual_mesh.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ucvt {

TriangleMesh dual_mesh(const Uniformized& t, const DelaunayTriangulation& d,
                       const std::vector<SurfacePoint>& sites) {
  TriangleMesh out;
  out.positions = positions_on_input(t, sites);
  const Connectivity& c = d.connectivity();
  out.faces.reserve(c.face_count());
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    const auto side = halfedges({static_cast<std::int32_t>(f)});
    out.faces.push_back({c.origin(side[0]).id, c.origin(side[1]).id, c.origin(side[2]).id});
  }
  return out;
}

std::vector<NonSimplicialEdge> edges_not_simplicial(const DelaunayTriangulation& d) {
  const Connectivity& c = d.connectivity();
  using Edge = std::tuple<std::int32_t, std::int32_t, double, std::int32_t>;
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (!c.is_canonical(h)) {
      continue;
    }
    const std::int32_t a = c.origin(h).id, b = c.head(h).id;
    edges.emplace_back(std::min(a, b), std::max(a, b), d.offset(h).h, h.id);
  }
  std::sort(edges.begin(), edges.end());
  std::vector<NonSimplicialEdge> out;
  double shortest = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b, height, h] = edges[i];
    const double length = std::sqrt(2 * height);
    const bool again = i > 0 && std::get<0>(edges[i - 1]) == a && std::get<1>(edges[i - 1]) == b;
    if (!again) {
      shortest = length;
    }
    if (a == b) {
      out.push_back({{h}, length});
    } else if (again) {
      out.push_back({{h}, shortest + length});
    }
  }
  return out;
}

}  // namespace ucvt
