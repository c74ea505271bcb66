#include "cvt/stars.h"

#include <cmath>

namespace ucvt {

Stars::Stars(const DelaunayTriangulation& d) {
  const Connectivity& c = d.connectivity();
  first_.reserve(c.vertex_count() + 1);
  offset_.reserve(c.halfedge_count());
  site_.reserve(c.halfedge_count());
  frame_.reserve(c.halfedge_count());
  for (std::size_t i = 0; i < c.vertex_count(); ++i) {
    first_.push_back(offset_.size());
    double least = HUGE_VAL, most = 0;
    c.for_outgoing({static_cast<std::int32_t>(i)}, [&](Halfedge h) {
      offset_.push_back(d.offset(h));
      site_.push_back(c.head(h));
      frame_.push_back(d.frame_change(h));
      least = std::min(least, d.offset(h).h);
      most = std::max(most, d.offset(h).h);
    });
    reach_.push_back(std::sqrt(2 * most));
    inner_h_.push_back(half_way(d.space(), least));
  }
  first_.push_back(offset_.size());
}

}  // namespace ucvt
