#include "conformal/plane_layout.h"

#include <cmath>
#include <numbers>

#include "space/moments.h"

namespace ucvt {

std::vector<PlanePoint> lay_out_plane(const IntrinsicTriangulation& t, const std::vector<double>& u,
                                      Vertex puncture, Vertex root) {
  const Connectivity& c = t.connectivity;
  const auto length = [&](Halfedge h) {
    return std::exp(t.log_length[h.index()] + (u[c.origin(h).index()] + u[c.head(h).index()]) / 2);
  };
  const auto has_geometry = [&](Halfedge h) {
    return c.origin(h) != puncture && c.head(h) != puncture && c.head(h.next()) != puncture;
  };
  // Angle at the origin of h inside its face.
  const auto angle = [&](Halfedge h) {
    const double p = length(h), q = length(h.prev()), o = length(h.next());
    return std::atan2(triangle_determinant({0}, {p, q, o}), (p * p + (q - o) * (q + o)) / 2);
  };
  std::vector<PlanePoint> out(c.vertex_count());
  std::vector<char> placed(c.vertex_count(), 0);
  struct Item {
    Vertex v;
    Halfedge h;        // outgoing from v
    double direction;  // of h
  };
  std::vector<Item> queue;
  Halfedge first = c.outgoing(root);
  while (c.head(first) == puncture) {
    first = c.rotate(first);
  }
  queue.push_back({root, first, 0});
  placed[root.index()] = 1;
  const auto visit = [&](Vertex v, Halfedge h, double direction) {
    const Vertex w = c.head(h);
    if (placed[w.index()]) {
      return;
    }
    placed[w.index()] = 1;
    const double l = length(h);
    const PlanePoint& at = out[v.index()];
    out[w.index()] = {at.x + l * std::cos(direction), at.y + l * std::sin(direction)};
    queue.push_back(
        {w, c.twin(h), std::remainder(direction + std::numbers::pi, 2 * std::numbers::pi)});
  };
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Item item = queue[i];
    visit(item.v, item.h, item.direction);
    // Counterclockwise while faces have geometry, then clockwise from the start.
    double direction = item.direction;
    Halfedge h = item.h;
    while (has_geometry(h)) {
      direction += angle(h);
      h = c.rotate(h);
      if (h == item.h) {
        break;
      }
      visit(item.v, h, direction);
    }
    if (h == item.h) {
      continue;
    }
    direction = item.direction;
    for (h = c.twin(item.h).next(); has_geometry(h); h = c.twin(h).next()) {
      direction -= angle(h);
      visit(item.v, h, direction);
    }
  }
  return out;
}

}  // namespace ucvt
