#include "cvt/local_sites.h"

#include <utility>

namespace ucvt {

Neighbourhood neighbourhood(const Connectivity& d, std::vector<Vertex> sites, int rings) {
  Neighbourhood out{std::move(sites), {}};
  std::vector<bool> taken(d.vertex_count());
  for (const Vertex v : out.moving) {
    taken[v.index()] = true;
  }
  std::size_t inner = 0;
  for (int ring = 0; ring <= rings; ++ring) {
    std::vector<Vertex> next;
    for (std::size_t i = inner; i < out.moving.size(); ++i) {
      d.for_outgoing(out.moving[i], [&](Halfedge h) {
        const Vertex v = d.head(h);
        if (!taken[v.index()]) {
          taken[v.index()] = true;
          next.push_back(v);
        }
      });
    }
    if (ring == rings) {
      out.rim = std::move(next);
      break;
    }
    inner = out.moving.size();
    out.moving.insert(out.moving.end(), next.begin(), next.end());
  }
  return out;
}

LocalSites::LocalSites(Tessellation& sites, const Neighbourhood& part)
    : sites_(sites), members_(part.moving), moving_(part.moving.size()), near_(sites.site_count()) {
  members_.insert(members_.end(), part.rim.begin(), part.rim.end());
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
