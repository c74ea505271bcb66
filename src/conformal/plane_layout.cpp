#include "conformal/plane_layout.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "space/moments.h"

namespace ucvt {

namespace {

/// The layout so far, breadth first: a queue of placed vertices, each with the direction of one of its
/// halfedges.
class PlaneLayout {
 public:
  PlaneLayout(const IntrinsicTriangulation& t, const std::vector<double>& u, Vertex puncture)
      : t_(t),
        c_(t.connectivity),
        u_(u),
        puncture_(puncture),
        at_(c_.vertex_count()),
        placed_(c_.vertex_count(), 0) {}

  std::vector<PlanePoint> from(Vertex root) {
    Halfedge first = c_.outgoing(root);
    while (c_.head(first) == puncture_) {
      first = c_.rotate(first);
    }
    queue_.push_back({root, first, 0});
    placed_[root.index()] = 1;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Item item = queue_[i];
      place_neighbours(item);
    }
    return std::move(at_);
  }

 private:
  struct Item {
    Vertex v;
    Halfedge h;        // outgoing from v
    double direction;  // of h
  };

  [[nodiscard]] double length(Halfedge h) const {
    return std::exp(t_.log_length[h.index()] +
                    (u_[c_.origin(h).index()] + u_[c_.head(h).index()]) / 2);
  }

  [[nodiscard]] bool has_geometry(Halfedge h) const {
    return c_.origin(h) != puncture_ && c_.head(h) != puncture_ && c_.head(h.next()) != puncture_;
  }

  /// At the origin of h inside its face.
  [[nodiscard]] double angle(Halfedge h) const {
    const double p = length(h), q = length(h.prev()), o = length(h.next());
    return std::atan2(triangle_determinant({0}, {p, q, o}), (p * p + (q - o) * (q + o)) / 2);
  }

  void place_head(Vertex v, Halfedge h, double direction) {
    const Vertex w = c_.head(h);
    if (placed_[w.index()]) {
      return;
    }
    placed_[w.index()] = 1;
    const double l = length(h);
    const PlanePoint& at = at_[v.index()];
    at_[w.index()] = {at.x + l * std::cos(direction), at.y + l * std::sin(direction)};
    queue_.push_back(
        {w, c_.twin(h), std::remainder(direction + std::numbers::pi, 2 * std::numbers::pi)});
  }

  /// Counterclockwise while faces have geometry, then clockwise from the start.
  void place_neighbours(const Item& item) {
    place_head(item.v, item.h, item.direction);
    double direction = item.direction;
    Halfedge h = item.h;
    while (has_geometry(h)) {
      direction += angle(h);
      h = c_.rotate(h);
      if (h == item.h) {
        return;
      }
      place_head(item.v, h, direction);
    }
    direction = item.direction;
    for (h = c_.twin(item.h).next(); has_geometry(h); h = c_.twin(h).next()) {
      direction -= angle(h);
      place_head(item.v, h, direction);
    }
  }

  const IntrinsicTriangulation& t_;
  const Connectivity& c_;
  const std::vector<double>& u_;
  Vertex puncture_;
  std::vector<PlanePoint> at_;
  std::vector<char> placed_;
  std::vector<Item> queue_;
};

}  // namespace

std::vector<PlanePoint> lay_out_plane(const IntrinsicTriangulation& t, const std::vector<double>& u,
                                      Vertex puncture, Vertex root) {
  return PlaneLayout(t, u, puncture).from(root);
}

}  // namespace ucvt
