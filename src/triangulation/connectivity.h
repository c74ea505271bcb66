// How the triangles of a closed oriented surface hang together, as a Delta-complex.
//
// Vertices, faces and halfedges are numbered. Face f has the halfedges 3f, 3f+1, 3f+2, which run
// round it counterclockwise; each starts at its origin and is glued to its twin. Loops and several
// edges between the same two vertices are allowed: an edge is never identified by its ends.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

namespace ucvt {

struct Vertex {
  std::int32_t id = -1;
  auto operator<=>(const Vertex&) const = default;
  [[nodiscard]] std::size_t index() const { return static_cast<std::size_t>(id); }
};

struct Face {
  std::int32_t id = -1;
  auto operator<=>(const Face&) const = default;
  [[nodiscard]] std::size_t index() const { return static_cast<std::size_t>(id); }
};

struct Halfedge {
  std::int32_t id = -1;
  auto operator<=>(const Halfedge&) const = default;
  [[nodiscard]] std::size_t index() const { return static_cast<std::size_t>(id); }
  [[nodiscard]] Face face() const { return {id / 3}; }
  /// The next halfedge round the same face.
  [[nodiscard]] Halfedge next() const { return {id % 3 == 2 ? id - 2 : id + 1}; }
  [[nodiscard]] Halfedge prev() const { return {id % 3 == 0 ? id + 2 : id - 1}; }
};

/// The three halfedges of a face in order.
inline std::array<Halfedge, 3> halfedges(Face f) {
  return {Halfedge{3 * f.id}, Halfedge{3 * f.id + 1}, Halfedge{3 * f.id + 2}};
}

/// The gluing of a closed oriented triangulated surface, with local changes that keep it one.
class Connectivity {
 public:
  Connectivity() = default;

  /// Glues faces along the edges that run between the same two vertices in opposite directions.
  /// Requires a closed oriented manifold triangle list (`closed_surface` makes one).
  Connectivity(std::size_t vertices, const std::vector<std::array<std::int32_t, 3>>& faces);

  [[nodiscard]] std::size_t vertex_count() const { return out_.size(); }
  [[nodiscard]] std::size_t face_count() const { return origin_.size() / 3; }
  [[nodiscard]] std::size_t halfedge_count() const { return origin_.size(); }
  /// Euler number; counts only vertices that have faces. O(1) unless vertices were removed.
  [[nodiscard]] std::int64_t euler_number() const;

  [[nodiscard]] Vertex origin(Halfedge h) const { return origin_[h.index()]; }
  [[nodiscard]] Vertex head(Halfedge h) const { return origin_[h.next().index()]; }
  [[nodiscard]] Halfedge twin(Halfedge h) const { return twin_[h.index()]; }
  /// Some halfedge that starts at v; id -1 when v was removed.
  [[nodiscard]] Halfedge outgoing(Vertex v) const { return out_[v.index()]; }
  /// The next halfedge with the same origin, counterclockwise.
  [[nodiscard]] Halfedge rotate(Halfedge h) const { return twin(h.prev()); }
  /// Asks for a face's twins ahead of time.
  void prefetch(Face f) const { __builtin_prefetch(&twin_[3 * f.index()]); }
  /// True for one halfedge of each edge.
  [[nodiscard]] bool is_canonical(Halfedge h) const { return h < twin(h); }
  [[nodiscard]] bool is_removed(Face f) const { return origin_[3 * f.index()].id < 0; }

  /// Calls visit(h) for every halfedge that starts at v, counterclockwise.
  template <class Visit>
  void for_outgoing(Vertex v, Visit visit) const {
    const Halfedge first = outgoing(v);
    Halfedge h = first;
    do {
      visit(h);
      h = rotate(h);
    } while (h != first);
  }
  [[nodiscard]] int degree(Vertex v) const;

  /// Replaces the edge of h by the other diagonal of its two faces, which must be distinct.
  ///
  /// With h from i to j in face (i, j, k) and twin t in face (j, i, m): afterwards h runs from m to
  /// k in face (m, k, i) and t from k to m in face (k, m, j), each starting its own face's round
  /// at the same number as before.
  void flip(Halfedge h);

  /// Undoes flip(h).
  void unflip(Halfedge h);

  /// Adds a vertex inside f. Afterwards halfedges(f)[0] is unchanged and the new vertex is opposite
  /// to it; the two new faces hold the other two sides at their own number 0, in order.
  ///
  /// The vertex takes the number `reuse` when that names a removed one; faces reuse removed ones.
  Vertex split_face(Face f, Vertex reuse = {});

  /// Adds a vertex on the edge of h: i -> j becomes i -> n -> j.
  ///
  /// h keeps i -> n, its face (i, n, k) and twin face (n, i, m); two faces are added: (n, j, k)
  /// with its number 0 running n -> j, and (j, n, m) with its number 0 running j -> n.
  Vertex split_edge(Halfedge h);

  /// Removes a vertex with three distinct faces; the faces of outgoing(v).rotate() twice are marked
  /// removed. Returns the face that is left.
  Face remove_vertex_of_degree_3(Vertex v);

  /// Where things went in `compact`: new numbers by old ones, id -1 for what was removed.
  struct Compaction {
    std::vector<Vertex> vertex;
    std::vector<Face> face;
  };
  /// Drops removed vertices and faces; the order of what stays is kept.
  Compaction compact();

  /// Gives vertex v the number to[v], a permutation.
  void renumber(const std::vector<Vertex>& to);
  /// Gives face f the number to[f], a permutation. Requires that no face was removed.
  void renumber_faces(const std::vector<Face>& to);

 private:
  void glue(Halfedge a, Halfedge b) {
    twin_[a.index()] = b;
    twin_[b.index()] = a;
  }
  void set_origin(Halfedge h, Vertex v) {
    origin_[h.index()] = v;
    out_[v.index()] = h;
  }
  Face add_face(Vertex a, Vertex b, Vertex c);

  std::vector<Vertex> origin_;
  std::vector<Halfedge> twin_;
  std::vector<Halfedge> out_;
  std::vector<Face> free_faces_;
};

}  // namespace ucvt
