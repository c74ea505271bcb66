#include "triangulation/vertex_order.h"

namespace ucvt {

VertexOrder::VertexOrder(const Connectivity& t)
    : rank(t.vertex_count(), -1), corner(t.face_count()) {
  std::int32_t next = 0;
  for (std::size_t f = 0; f < corner.size(); ++f) {
    const auto side = halfedges({static_cast<std::int32_t>(f)});
    for (std::size_t i = 0; i < 3; ++i) {
      std::int32_t& r = rank[t.origin(side[i]).index()];
      if (r < 0) {
        r = next++;
      }
      corner[f][i] = r;
    }
  }
}

}  // namespace ucvt
