#include "cvt/local_sites.h"

namespace ucvt {

LocalSites::LocalSites(Tessellation& sites, const std::vector<Vertex>& moving,
                       const std::vector<Vertex>& rim)
    : sites_(sites), members_(moving), moving_(moving.size()), near_(sites.site_count()) {
  members_.insert(members_.end(), rim.begin(), rim.end());
  const Connectivity& d = sites.delaunay().connectivity();
  for (const Vertex v : members_) {
    near_[v.index()] = true;
    d.for_outgoing(v, [&](Halfedge h) { near_[d.head(h).index()] = true; });
  }
}

void LocalSites::measure(std::vector<CellState>& out) const {
  sites_.measure(members_, near_, out);
  for (std::size_t i = moving_; i < out.size(); ++i) {
    out[i].moments.x = out[i].moments.y = 0;
  }
}

void LocalSites::move(const std::vector<Offset>& target) {
  std::vector<Offset> all(sites_.site_count());
  for (std::size_t i = 0; i < moving_; ++i) {
    all[members_[i].index()] = target[i];
  }
  sites_.move(all);
}

}  // namespace ucvt
