#include "cover/cut_graph.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace ucvt {
namespace {

double edge_length(const UniformSurface& t, Halfedge h) {
  return length_of_chord(t.space(), t.chord(h));
}

struct Distances {
  std::vector<double> distance;
  std::vector<Halfedge> home;
  std::vector<Vertex> order;
};

/// Dijkstra along the edges; ties go to the smaller number.
Distances distances_from(const UniformSurface& t, Vertex base) {
  const Connectivity& c = t.connectivity();
  Distances out;
  out.distance.assign(c.vertex_count(), std::numeric_limits<double>::infinity());
  out.home.assign(c.vertex_count(), Halfedge{});
  std::vector<char> done(c.vertex_count(), 0);
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  out.distance[base.index()] = 0;
  queue.emplace(0.0, base.id);
  while (!queue.empty()) {
    const Vertex v{queue.top().second};
    queue.pop();
    if (done[v.index()]) {
      continue;
    }
    done[v.index()] = 1;
    out.order.push_back(v);
    c.for_outgoing(v, [&](Halfedge h) {
      const Vertex w = c.head(h);
      const double through = out.distance[v.index()] + edge_length(t, h);
      if (through < out.distance[w.index()]) {
        out.distance[w.index()] = through;
        out.home[w.index()] = c.twin(h);
        queue.emplace(through, w.id);
      }
    });
  }
  return out;
}

/// Union of faces by the dual tree, with halving of paths.
std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t f) {
  const auto at = [&](std::int32_t i) -> std::int32_t& {
    return parent[static_cast<std::size_t>(i)];
  };
  while (at(f) != f) {
    at(f) = at(at(f));
    f = at(f);
  }
  return f;
}

/// The edges that neither tree uses: the dual tree takes edges with long loops first.
void choose_edges(const UniformSurface& t, const Distances& d, CutGraph& cut) {
  const Connectivity& c = t.connectivity();
  std::vector<std::pair<double, Halfedge>> edges;
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const Vertex u = c.origin(h), v = c.head(h);
    if (c.is_canonical(h) && d.home[u.index()] != h && d.home[v.index()] != c.twin(h)) {
      edges.emplace_back(-(d.distance[u.index()] + edge_length(t, h) + d.distance[v.index()]), h);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::int32_t> parent(c.face_count());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [minus_length, h] : edges) {
    const std::int32_t f = root_of(parent, h.face().id), g = root_of(parent, c.twin(h).face().id);
    if (f != g) {
      parent[static_cast<std::size_t>(std::max(f, g))] = std::min(f, g);
    } else {
      cut.edge.push_back(h);
      cut.length.push_back(-minus_length);
    }
  }
}

/// Walks once round the disk, with the disk to the left.
void read_rim(const Connectivity& c, CutGraph& cut) {
  constexpr std::int32_t uncut = std::numeric_limits<std::int32_t>::max();
  std::vector<std::int32_t> letter(c.halfedge_count(), uncut);
  for (const Halfedge h : cut.towards_base) {
    if (h.id >= 0) {
      letter[h.index()] = letter[c.twin(h).index()] = 0;
    }
  }
  for (std::size_t i = 0; i < cut.edge.size(); ++i) {
    const auto name = static_cast<std::int32_t>(i + 1);
    letter[cut.edge[i].index()] = name;
    letter[c.twin(cut.edge[i]).index()] = -name;
  }
  const auto sides = static_cast<std::int32_t>(2 * cut.edge.size());
  cut.letters_before.assign(c.halfedge_count(), 0);
  Halfedge first = c.outgoing(cut.base);
  while (letter[first.index()] == uncut) {
    first = c.rotate(first);
  }
  Halfedge h = first;
  do {
    if (letter[h.index()] != 0) {
      cut.rim.push_back(letter[h.index()]);
    }
    h = h.next();
    const auto before = static_cast<std::int32_t>(cut.rim.size()) % sides;
    cut.letters_before[h.index()] = before;
    while (letter[h.index()] == uncut) {
      h = c.twin(h).next();
      cut.letters_before[h.index()] = before;
    }
  } while (h != first);
}

}  // namespace

CutGraph cut_graph(const UniformSurface& t, Vertex base) {
  Distances d = distances_from(t, base);
  CutGraph cut;
  cut.base = base;
  choose_edges(t, d, cut);
  cut.towards_base = std::move(d.home);
  cut.by_distance = std::move(d.order);
  read_rim(t.connectivity(), cut);
  return cut;
}

std::vector<Vertex> spread_vertices(const UniformSurface& t, std::size_t count) {
  std::vector<Vertex> out{{0}};
  std::vector<double> nearest(t.connectivity().vertex_count(),
                              std::numeric_limits<double>::infinity());
  while (out.size() < std::min(count, nearest.size())) {
    const Distances d = distances_from(t, out.back());
    for (std::size_t v = 0; v < nearest.size(); ++v) {
      nearest[v] = std::min(nearest[v], d.distance[v]);
    }
    const auto far = std::max_element(nearest.begin(), nearest.end());
    out.push_back({static_cast<std::int32_t>(far - nearest.begin())});
  }
  return out;
}

std::vector<Halfedge> loop_path(const CutGraph& cut, const Connectivity& c, const Word& word) {
  std::vector<Halfedge> path;
  const auto step = [&](Halfedge h) {
    if (!path.empty() && path.back() == c.twin(h)) {
      path.pop_back();
    } else {
      path.push_back(h);
    }
  };
  const auto home = [&](Vertex v) { return cut.towards_base[v.index()]; };
  for (const std::int32_t x : word) {
    const Halfedge e = cut.edge[static_cast<std::size_t>(std::abs(x) - 1)];
    const Halfedge h = x > 0 ? e : c.twin(e);
    std::vector<Halfedge> up;
    for (Halfedge s = home(c.origin(h)); s.id >= 0; s = home(c.head(s))) {
      up.push_back(c.twin(s));
    }
    std::for_each(up.rbegin(), up.rend(), step);
    step(h);
    for (Halfedge s = home(c.head(h)); s.id >= 0; s = home(c.head(s))) {
      step(s);
    }
  }
  return path;
}

}  // namespace ucvt
