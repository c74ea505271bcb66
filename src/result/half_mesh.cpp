#include "result/half_mesh.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "cvt/multilevel.h"
#include "ucvt/error.h"

namespace ucvt {

std::vector<std::size_t> sides_in_half(const Uniformized& t, const MirrorSites& sites,
                                       std::size_t half_faces) {
  const MirrorLayout layout = sites.layout();
  std::vector<SurfacePoint> ones;
  for (const auto& pair : layout.pairs) {
    ones.push_back(pair[0]);
  }
  std::vector<std::size_t> out;
  for (const HomogeneousPoint& p : points_on_input(t, ones)) {
    const auto face = static_cast<std::size_t>(t.input_face[p.face.index()]);
    out.push_back(face < half_faces ? 0 : 1);
  }
  return out;
}

HalfView::HalfView(const MirrorSites& sites, const std::vector<std::vector<std::size_t>>& loops,
                   std::vector<std::size_t> side)
    : sites_(sites),
      d_(sites.tessellation().delaunay()),
      loops_(loops),
      side_(std::move(side)),
      wall_(d_.connectivity().halfedge_count(), false) {
  const Connectivity& c = d_.connectivity();
  for (const auto& loop : loops_) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vertex p{static_cast<std::int32_t>(loop[i])};
      const Vertex q{static_cast<std::int32_t>(loop[(i + 1) % loop.size()])};
      const int direction = forward(p);
      const MirrorSites::Ahead ahead = sites_.look_ahead(p, direction);
      if (ahead.on_line && c.head(ahead.halfedge) == q) {
        wall_[ahead.halfedge.index()] = wall_[c.twin(ahead.halfedge).index()] = true;
      } else {
        gaps_.push_back(gap_at(loop[i], ahead, direction));
      }
    }
  }
}

bool HalfView::in_half(Vertex site) const {
  const std::size_t n = site.index() - sites_.line_count();
  return side_[n / 2] == n % 2;
}

int HalfView::forward(Vertex p) const {
  const auto [x, y] = sites_.reflection(p).axis();
  double left = 0;
  d_.connectivity().for_outgoing(p, [&](Halfedge h) {
    const Vertex q = d_.connectivity().head(h);
    if (!sites_.on_line(q)) {
      const Offset& at = d_.offset(h);
      left += (in_half(q) ? 1 : -1) * (x * at.y - y * at.x) / std::hypot(at.x, at.y);
    }
  });
  return left < 0 ? -1 : 1;
}

HalfView::Gap HalfView::gap_at(std::size_t p, const MirrorSites::Ahead& ahead,
                               int direction) const {
  const Connectivity& c = d_.connectivity();
  Gap gap{p, std::nullopt, {}};
  if (ahead.on_line || ahead.halfedge.id < 0) {
    return gap;
  }
  Halfedge h = ahead.halfedge;
  if (sites_.on_line(c.head(h))) {
    h = c.rotate(h);
  }
  if (sites_.on_line(c.head(h))) {
    return gap;
  }
  const Vertex site{static_cast<std::int32_t>(p)};
  auto [x, y] = sites_.reflection(site).axis();
  x *= direction, y *= direction;
  const Offset& at = d_.offset(h);
  const double along = (x * at.x + y * at.y) / model_z(d_.space(), at);
  gap.pair = (c.head(h).index() - sites_.line_count()) / 2;
  gap.foot = sites_.point_at(site, from_central(d_.space(), along * x, along * y));
  return gap;
}

std::vector<HalfView::Gap> HalfView::gaps() const {
  return gaps_;
}

std::vector<Face> HalfView::faces() const {
  const Connectivity& c = d_.connectivity();
  std::vector<bool> seen(c.face_count(), false);
  std::vector<Face> out, stack;
  for (std::size_t f = 0; f < c.face_count() && out.empty(); ++f) {
    for (const Halfedge h : halfedges({static_cast<std::int32_t>(f)})) {
      if (out.empty() && !sites_.on_line(c.origin(h)) && in_half(c.origin(h))) {
        out.push_back(h.face());
      }
    }
  }
  stack = out;
  for (const Face f : out) {
    seen[f.index()] = true;
  }
  while (!stack.empty()) {
    const Face f = stack.back();
    stack.pop_back();
    for (const Halfedge h : halfedges(f)) {
      const Face next = c.twin(h).face();
      if (!wall_[h.index()] && !seen[next.index()]) {
        seen[next.index()] = true;
        out.push_back(next), stack.push_back(next);
      }
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<Halfedge> HalfView::edges_not_simplicial() const {
  const Connectivity& c = d_.connectivity();
  // The line's own edges first, then by length: the first between two sites stays.
  std::vector<std::tuple<std::int32_t, std::int32_t, bool, double, Halfedge>> edges;
  for (const Face f : faces()) {
    for (const Halfedge h : halfedges(f)) {
      const bool wall = wall_[h.index()];
      if (wall || c.is_canonical(h)) {
        const std::int32_t a = c.origin(h).id, b = c.head(h).id;
        edges.emplace_back(std::min(a, b), std::max(a, b), !wall, d_.offset(h).h, h);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Halfedge> out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b, inside, height, h] = edges[i];
    const bool again = i > 0 && std::get<0>(edges[i - 1]) == a && std::get<1>(edges[i - 1]) == b;
    if (a == b || again) {
      out.push_back(h);
    }
  }
  return out;
}

std::vector<Halfedge> HalfView::inner_edges() const {
  const Connectivity& c = d_.connectivity();
  std::vector<bool> in_half(c.halfedge_count(), false);
  for (const Face f : faces()) {
    for (const Halfedge h : halfedges(f)) {
      in_half[h.index()] = !wall_[h.index()];
    }
  }
  std::vector<Halfedge> out = longest_edges(d_, c.halfedge_count());
  std::erase_if(out, [&](Halfedge h) { return !in_half[h.index()]; });
  return out;
}

std::array<SurfacePoint, 2> HalfView::middle(Halfedge h) const {
  const Offset at = half_way(d_.space(), d_.offset(h));
  const Vertex site = d_.connectivity().origin(h);
  return {sites_.point_at(site, at),
          sites_.point_at(sites_.partner(site), sites_.reflection(site)(at))};
}

HalfMesh HalfView::mesh() const {
  const Connectivity& c = d_.connectivity();
  std::vector<std::int32_t> number(d_.vertex_count(), -1);
  HalfMesh out;
  const std::vector<Face> inside = faces();
  for (const Face f : inside) {
    for (const Halfedge h : halfedges(f)) {
      number[c.origin(h).index()] = 0;
    }
  }
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) {
      continue;
    }
    const Vertex site{static_cast<std::int32_t>(v)};
    if (!sites_.on_line(site) && !in_half(site)) {
      throw NumericalError("the mirror line does not separate the halves; ask for more sites");
    }
    number[v] = static_cast<std::int32_t>(out.sites.size());
    out.sites.push_back(site);
  }
  for (const Face f : inside) {
    Corners corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = number[c.origin(halfedges(f)[i]).index()];
    }
    out.faces.push_back(corners);
  }
  return out;
}

}  // namespace ucvt
