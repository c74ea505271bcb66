#include "triangulation/connectivity.h"

#include <algorithm>

namespace ucvt {
namespace {

std::int32_t narrow(std::size_t n) {
  return static_cast<std::int32_t>(n);
}

}  // namespace

Connectivity::Connectivity(std::size_t vertices,
                           const std::vector<std::array<std::int32_t, 3>>& faces)
    : out_(vertices) {
  origin_.reserve(3 * faces.size());
  for (const auto& f : faces) {
    add_face({f[0]}, {f[1]}, {f[2]});
  }
  // Twins share an unordered pair of ends: sort the halfedges by it.
  struct Side {
    std::int32_t low, high;
    Halfedge h;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  sides.reserve(origin_.size());
  for (std::size_t i = 0; i < origin_.size(); ++i) {
    const Halfedge h{narrow(i)};
    const std::int32_t low = std::min(origin(h).id, head(h).id);
    const std::int32_t high = std::max(origin(h).id, head(h).id);
    sides.push_back({low, high, h});
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    glue(sides[i].h, sides[i + 1].h);
  }
}

std::int64_t Connectivity::euler_number() const {
  const auto live = std::count_if(out_.begin(), out_.end(), [](Halfedge h) { return h.id >= 0; });
  std::int64_t faces = 0;
  for (std::size_t f = 0; f < face_count(); ++f) {
    faces += is_removed({narrow(f)}) ? 0 : 1;
  }
  return live - faces / 2;
}

int Connectivity::degree(Vertex v) const {
  int n = 0;
  for_outgoing(v, [&](Halfedge) { ++n; });
  return n;
}

Face Connectivity::add_face(Vertex a, Vertex b, Vertex c) {
  Face f{narrow(face_count())};
  if (free_faces_.empty()) {
    origin_.resize(origin_.size() + 3);
    twin_.resize(origin_.size());
  } else {
    f = free_faces_.back();
    free_faces_.pop_back();
  }
  const auto h = halfedges(f);
  set_origin(h[0], a), set_origin(h[1], b), set_origin(h[2], c);
  return f;
}

void Connectivity::flip(Halfedge h) {
  const Halfedge t = twin(h);
  const Halfedge hn = h.next(), hp = h.prev(), tn = t.next(), tp = t.prev();
  const Vertex i = origin(h), j = origin(t), k = origin(hp), m = origin(tp);
  const Halfedge jk = twin(hn), ki = twin(hp), im = twin(tn), mj = twin(tp);
  // A side may be glued to another side of the same quadrilateral; its partner moves with it.
  const auto moved = [&](Halfedge x) {
    if (x == hn) {
      return tp;
    }
    if (x == hp) {
      return hn;
    }
    if (x == tn) {
      return hp;
    }
    return x == tp ? tn : x;
  };
  set_origin(h, m), set_origin(hn, k), set_origin(hp, i);
  set_origin(t, k), set_origin(tn, m), set_origin(tp, j);
  glue(hn, moved(ki)), glue(hp, moved(im)), glue(tn, moved(mj)), glue(tp, moved(jk));
}

void Connectivity::unflip(Halfedge h) {
  // Flipping three times more comes back to the same diagonal with the faces' rounds restored.
  for (int n = 0; n < 3; ++n) {
    flip(h);
  }
}

Vertex Connectivity::split_face(Face f, Vertex reuse) {
  const auto [a, b, c] = halfedges(f);
  const Vertex u = origin(a), v = origin(b), w = origin(c);
  const Halfedge tb = twin(b);
  const Halfedge tc = twin(c);
  const Vertex n = reuse.id >= 0 ? reuse : Vertex{narrow(out_.size())};
  if (n.index() == out_.size()) {
    out_.emplace_back();
  }
  const Face g1 = add_face(v, w, n), g2 = add_face(w, u, n);
  const auto [b0, b1, b2] = halfedges(g1);
  const auto [c0, c1, c2] = halfedges(g2);
  set_origin(c, n);
  out_[u.index()] = a, out_[v.index()] = b, out_[w.index()] = c0;
  // A side of f may be glued to another side of f.
  // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): b0 and c0 are set
  const auto moved = [&](Halfedge x) { return x == b ? b0 : x == c ? c0 : x; };
  glue(b0, moved(tb));
  glue(c0, moved(tc));
  glue(b, b2);
  glue(b1, c2);
  glue(c1, c);
  return n;
}

Vertex Connectivity::split_edge(Halfedge h) {
  const Halfedge t = twin(h), hn = h.next(), tp = t.prev();
  const Vertex j = origin(t), k = origin(h.prev()), m = origin(tp);
  const Halfedge jk = twin(hn), mj = twin(tp);
  const Vertex n{narrow(out_.size())};
  out_.emplace_back();
  const Face g1 = add_face(n, j, k), g2 = add_face(j, n, m);
  const auto [a0, a1, a2] = halfedges(g1);
  const auto [b0, b1, b2] = halfedges(g2);
  set_origin(hn, n), set_origin(t, n);
  out_[m.index()] = tp, out_[j.index()] = a1, out_[k.index()] = h.prev();
  // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): a1 and b2 are set
  const auto moved = [&](Halfedge x) { return x == hn ? a1 : x == tp ? b2 : x; };
  glue(a1, moved(jk));
  glue(b2, moved(mj));
  glue(a0, b0);
  glue(a2, hn);
  glue(b1, tp);
  return n;
}

Face Connectivity::remove_vertex_of_degree_3(Vertex v) {
  const Halfedge a = outgoing(v), b = rotate(a), c = rotate(b);
  const Face keep = a.face();
  const std::array<Halfedge, 3> rim{a.next(), b.next(), c.next()};
  const std::array<Vertex, 3> corner{origin(rim[0]), origin(rim[1]), origin(rim[2])};
  const std::array<Halfedge, 3> outer{twin(rim[0]), twin(rim[1]), twin(rim[2])};
  const auto side = halfedges(keep);
  const auto moved = [&](Halfedge x) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (x == rim[i]) {
        return side[i];
      }
    }
    return x;
  };
  for (const Halfedge dead : {b, c}) {
    for (const Halfedge h : halfedges(dead.face())) {
      origin_[h.index()] = Vertex{};
    }
    free_faces_.push_back(dead.face());
  }
  out_[v.index()] = Halfedge{};
  for (std::size_t i = 0; i < 3; ++i) {
    set_origin(side[i], corner[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    glue(side[i], moved(outer[i]));
  }
  return keep;
}

Connectivity::Compaction Connectivity::compact() {
  Compaction to;
  to.vertex.resize(vertex_count());
  to.face.resize(face_count());
  std::size_t vertices = 0, faces = 0;
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    if (out_[v].id >= 0) {
      to.vertex[v] = {narrow(vertices++)};
    }
  }
  for (std::size_t f = 0; f < face_count(); ++f) {
    if (!is_removed({narrow(f)})) {
      to.face[f] = {narrow(faces++)};
    }
  }
  const auto renumber = [&](Halfedge h) {
    return Halfedge{3 * to.face[h.face().index()].id + h.id % 3};
  };
  // New numbers never exceed old ones, so everything can move in place.
  for (std::size_t i = 0; i < origin_.size(); ++i) {
    const Halfedge h{narrow(i)};
    if (is_removed(h.face())) {
      continue;
    }
    const Halfedge g = renumber(h);
    twin_[g.index()] = renumber(twin_[i]);
    origin_[g.index()] = to.vertex[origin_[i].index()];
  }
  for (std::size_t v = 0; v < out_.size(); ++v) {
    if (out_[v].id >= 0) {
      out_[to.vertex[v].index()] = renumber(out_[v]);
    }
  }
  free_faces_.clear();
  origin_.resize(3 * faces);
  twin_.resize(3 * faces);
  out_.resize(vertices);
  return to;
}

void Connectivity::renumber(const std::vector<Vertex>& to) {
  for (Vertex& v : origin_) {
    v = v.id >= 0 ? to[v.index()] : v;
  }
  const std::vector<Halfedge> old = out_;
  for (std::size_t v = 0; v < old.size(); ++v) {
    out_[to[v].index()] = old[v];
  }
}

void Connectivity::renumber_faces(const std::vector<Face>& to) {
  const auto renumbered = [&to](Halfedge h) {
    return Halfedge{3 * to[h.face().index()].id + h.id % 3};
  };
  const std::vector<Vertex> origin = origin_;
  const std::vector<Halfedge> twin = twin_;
  for (std::size_t i = 0; i < origin.size(); ++i) {
    const Halfedge g = renumbered({narrow(i)});
    origin_[g.index()] = origin[i], twin_[g.index()] = renumbered(twin[i]);
  }
  for (Halfedge& h : out_) {
    h = h.id >= 0 ? renumbered(h) : h;
  }
}

}  // namespace ucvt
