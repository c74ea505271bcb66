#include "triangulation/connectivity.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracle/meshes.h"
#include "oracle/surfaces.h"

namespace ucvt {
namespace {

Connectivity connect(const TriangleMesh& mesh) {
  return {mesh.positions.size(), mesh.faces};
}

/// True when v has three distinct faces.
bool can_be_removed(const Connectivity& c, Vertex v) {
  if (c.outgoing(v).id < 0 || c.degree(v) != 3) {
    return false;
  }
  const Halfedge a = c.outgoing(v), b = c.rotate(a), d = c.rotate(b);
  return a.face() != b.face() && b.face() != d.face() && d.face() != a.face();
}

/// The surface with all vertices flipped down to three faces and removed, but for one: every edge is
/// a loop.
Connectivity one_vertex(Connectivity c) {
  std::mt19937_64 random(1);
  for (std::size_t v = c.vertex_count(); v-- > 1;) {
    const Vertex vertex{static_cast<std::int32_t>(v)};
    const auto lowers_degree = [&](Halfedge h) {
      const Halfedge t = c.twin(h);
      const auto ends = [&](Halfedge a, Halfedge b) {
        return (c.origin(a) == vertex ? 1 : 0) + (c.origin(b) == vertex ? 1 : 0);
      };
      return t.face() != h.face() && ends(h.prev(), t.prev()) < ends(h, t);
    };
    while (!can_be_removed(c, vertex)) {
      std::vector<Halfedge> star;
      c.for_outgoing(vertex, [&](Halfedge h) { star.push_back(h); });
      const auto best = std::ranges::find_if(star, lowers_degree);
      const Halfedge any{static_cast<std::int32_t>(random() % c.halfedge_count())};
      const Halfedge h = best != star.end() && star.size() > 3 ? *best : any;
      if (!c.is_removed(h.face()) && c.twin(h).face() != h.face()) {
        c.flip(h);
      }
    }
    c.remove_vertex_of_degree_3(vertex);
  }
  c.compact();
  return c;
}

Connectivity one_vertex_torus() {
  return one_vertex(connect(oracle::seven_vertex_torus()));
}

Connectivity one_vertex_double_torus() {
  return one_vertex(connect(oracle::voxel_frame(2)));
}

/// The laws of a gluing; a word for the first that is broken.
std::string broken_law(const Connectivity& c) {
  std::vector<int> seen(c.halfedge_count(), 0);
  std::size_t live = 0;
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (c.is_removed(h.face())) {
      continue;
    }
    ++live;
    const Halfedge t = c.twin(h);
    if (t.id < 0 || t == h || c.is_removed(t.face()) || c.twin(t) != h) {
      return "twins are an involution without fixed points";
    }
    if (c.origin(t) != c.head(h) || c.head(t) != c.origin(h)) {
      return "twins run between the same two vertices in opposite directions";
    }
    if (h.next().next().next() != h || h.next().prev() != h || h.next().face() != h.face()) {
      return "three halfedges go round a face";
    }
    if (c.is_canonical(h) == c.is_canonical(t)) {
      return "one halfedge of each edge is canonical";
    }
  }
  std::size_t reached = 0;
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    const Vertex vertex{static_cast<std::int32_t>(v)};
    if (c.outgoing(vertex).id < 0) {
      continue;
    }
    if (c.is_removed(c.outgoing(vertex).face()) || c.origin(c.outgoing(vertex)) != vertex) {
      return "a vertex knows a halfedge that starts there";
    }
    c.for_outgoing(vertex, [&](Halfedge h) {
      reached += c.origin(h) == vertex ? 1 : 0;
      ++seen[h.index()];
    });
  }
  if (reached != live || std::ranges::any_of(seen, [](int n) { return n > 1; })) {
    return "the halfedges of a vertex form one round";
  }
  return "";
}

/// Everything a Connectivity is, but for which outgoing halfedge a vertex knows.
std::vector<std::int32_t> state(const Connectivity& c) {
  std::vector<std::int32_t> out;
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    out.push_back(c.origin(h).id);
    out.push_back(c.is_removed(h.face()) ? -1 : c.twin(h).id);
  }
  return out;
}

std::vector<Connectivity> samples() {
  return {connect(oracle::seven_vertex_torus()), connect(oracle::tetrahedron()),
          connect(oracle::voxel_frame(2)), one_vertex_torus(), one_vertex_double_torus()};
}

TEST(Connectivity, LawsAndEulerNumbersOfMeshes) {
  const std::vector<std::pair<TriangleMesh, int>> meshes{
      {oracle::tetrahedron(), 2},    {oracle::cube(), 2},
      {oracle::octahedron(), 2},     {oracle::icosphere(2), 2},
      {oracle::grid_torus(5, 4), 0}, {oracle::seven_vertex_torus(), 0},
      {oracle::voxel_frame(2), -2},  {oracle::voxel_frame(3), -4}};
  for (const auto& [mesh, chi] : meshes) {
    const Connectivity c = connect(mesh);
    EXPECT_EQ(broken_law(c), "");
    EXPECT_EQ(c.euler_number(), chi);
    EXPECT_EQ(c.vertex_count(), mesh.positions.size());
    EXPECT_EQ(c.face_count(), mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Halfedge h = halfedges({static_cast<std::int32_t>(f)})[i];
        EXPECT_EQ(c.origin(h).id, mesh.faces[f][i]);
        EXPECT_EQ(c.head(h).id, mesh.faces[f][(i + 1) % 3]);
      }
    }
  }
}

TEST(Connectivity, OneVertexSurfaces) {
  const Connectivity torus = one_vertex_torus(), two = one_vertex_double_torus();
  EXPECT_EQ(broken_law(torus), "");
  EXPECT_EQ(broken_law(two), "");
  EXPECT_EQ(torus.vertex_count(), 1U);
  EXPECT_EQ(torus.face_count(), 2U);
  EXPECT_EQ(torus.degree({0}), 6);
  EXPECT_EQ(two.face_count(), 6U);
  EXPECT_EQ(two.degree({0}), 18);
}

TEST(Connectivity, RotateGoesCounterclockwise) {
  const Connectivity c = connect(oracle::octahedron());
  // About the north pole, vertex 4: the equator in the order 0, 2, 1, 3.
  std::vector<std::int32_t> heads;
  c.for_outgoing({4}, [&](Halfedge h) { heads.push_back(c.head(h).id); });
  std::ranges::rotate(heads, std::ranges::find(heads, 0));
  EXPECT_EQ(heads, (std::vector<std::int32_t>{0, 2, 1, 3}));
}

TEST(Connectivity, FlipDoesWhatItsContractSays) {
  Connectivity c = connect(oracle::octahedron());
  const Halfedge h{1}, t = c.twin(h);
  const Vertex i = c.origin(h), j = c.head(h), k = c.head(h.next()), m = c.head(t.next());
  c.flip(h);
  EXPECT_EQ(c.twin(h), t);
  EXPECT_EQ(c.origin(h), m);
  EXPECT_EQ(c.head(h), k);
  EXPECT_EQ(c.head(h.next()), i);
  EXPECT_EQ(c.origin(t), k);
  EXPECT_EQ(c.head(t), m);
  EXPECT_EQ(c.head(t.next()), j);
  EXPECT_EQ(c.degree(i), 3);
  EXPECT_EQ(c.degree(k), 5);
}

TEST(Connectivity, FourFlipsAndFlipUnflipAreTheIdentity) {
  for (Connectivity c : samples()) {
    const auto before = state(c);
    for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)};
      if (c.twin(h).face() == h.face()) {
        continue;
      }
      c.flip(h);
      // The flipped torus of one vertex is glued as before.
      EXPECT_TRUE(c.vertex_count() == 1 || state(c) != before);
      EXPECT_EQ(broken_law(c), "");
      c.unflip(h);
      ASSERT_EQ(state(c), before);
      for (int n = 0; n < 4; ++n) {
        c.flip(h);
      }
      ASSERT_EQ(state(c), before);
    }
  }
}

TEST(Connectivity, SplitsDoWhatTheirContractsSay) {
  for (const Connectivity& c : samples()) {
    for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)};
      if (c.twin(h).face() == h.face()) {
        continue;
      }
      Connectivity e = c;
      const Halfedge t = e.twin(h);
      const Vertex from = e.origin(h), to = e.head(h);
      const Face added{static_cast<std::int32_t>(e.face_count())};
      const Vertex n = e.split_edge(h);
      ASSERT_EQ(broken_law(e), "");
      EXPECT_EQ(e.euler_number(), c.euler_number());
      EXPECT_EQ(e.origin(h), from);
      EXPECT_EQ(e.head(h), n);
      EXPECT_EQ(e.twin(h), t);
      EXPECT_EQ(e.degree(n), 4);
      EXPECT_EQ(e.origin(halfedges(added)[0]), n);
      EXPECT_EQ(e.head(halfedges(added)[0]), to);
      EXPECT_EQ(e.twin(halfedges(added)[0]), halfedges({added.id + 1})[0]);
    }
    for (std::size_t f = 0; f < c.face_count(); ++f) {
      Connectivity e = c;
      const auto side = halfedges({static_cast<std::int32_t>(f)});
      const Vertex u = e.origin(side[0]), v = e.origin(side[1]), w = e.origin(side[2]);
      const Face g{static_cast<std::int32_t>(e.face_count())};
      const Vertex n = e.split_face({static_cast<std::int32_t>(f)});
      ASSERT_EQ(broken_law(e), "");
      EXPECT_EQ(e.euler_number(), c.euler_number());
      EXPECT_EQ(e.degree(n), 3);
      EXPECT_EQ(e.origin(side[0]), u);
      EXPECT_EQ(e.origin(side[1]), v);
      EXPECT_EQ(e.origin(side[2]), n);
      EXPECT_EQ(e.origin(halfedges(g)[0]), v);
      EXPECT_EQ(e.origin(halfedges({g.id + 1})[0]), w);
      EXPECT_EQ(e.origin(halfedges({g.id + 1})[1]), u);
      e.remove_vertex_of_degree_3(n);
      EXPECT_EQ(broken_law(e), "");
      const auto to = e.compact();
      EXPECT_EQ(to.vertex[n.index()].id, -1);
      EXPECT_EQ(e.face_count(), c.face_count());
      EXPECT_EQ(e.vertex_count(), c.vertex_count());
    }
  }
}

TEST(Connectivity, LawsSurviveRandomSequences) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::mt19937_64 random(seed);
    auto all = samples();
    Connectivity& c = all[seed % all.size()];
    const auto chi = c.euler_number();
    std::vector<Vertex> removed;
    for (int step = 0; step < 150; ++step) {
      const auto pick = [&](std::size_t n) {
        return static_cast<std::int32_t>(oracle::uniform(random) * static_cast<double>(n));
      };
      const Halfedge h{pick(c.halfedge_count())};
      if (c.is_removed(h.face())) {
        continue;
      }
      const int action = pick(12);
      const bool own_twin = c.twin(h).face() == h.face();
      if (action == 0) {
        const Vertex reuse = removed.empty() ? Vertex{} : removed.back();
        const Vertex n = c.split_face(h.face(), reuse);
        if (!removed.empty()) {
          ASSERT_EQ(n, reuse);
          removed.pop_back();
        }
      } else if (action == 1 && !own_twin) {
        c.split_edge(h);
      } else if (action <= 5) {
        for (std::size_t v = 0; v < c.vertex_count(); ++v) {
          const Vertex vertex{static_cast<std::int32_t>(v)};
          if (c.face_count() > 4 && can_be_removed(c, vertex)) {
            EXPECT_FALSE(c.is_removed(c.remove_vertex_of_degree_3(vertex)));
            removed.push_back(vertex);
            break;
          }
        }
      } else if (action == 6) {
        const auto before = c.vertex_count();
        const auto to = c.compact();
        EXPECT_EQ(c.vertex_count(), before - removed.size());
        EXPECT_TRUE(std::ranges::is_sorted(to.vertex, {}, [last = -1](Vertex v) mutable {
          return v.id < 0 ? last : last = v.id;
        }));
        removed.clear();
      } else if (!own_twin) {
        action % 2 == 0 ? c.flip(h) : c.unflip(h);
      }
      ASSERT_EQ(broken_law(c), "") << "seed " << seed << " step " << step << " action " << action;
      ASSERT_EQ(c.euler_number(), chi);
    }
  }
}

TEST(Connectivity, RenumberedFacesKeepTheirNeighbours) {
  const TriangleMesh mesh = oracle::grid_torus(7, 5);
  const Connectivity before(mesh.positions.size(), mesh.faces);
  std::vector<Face> to;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    to.push_back({static_cast<std::int32_t>((f * 9 + 4) % mesh.faces.size())});  // 70 faces
  }
  Connectivity after = before;
  after.renumber_faces(to);
  const auto now = [&](Halfedge h) { return Halfedge{3 * to[h.face().index()].id + h.id % 3}; };
  for (std::size_t i = 0; i < before.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    EXPECT_EQ(after.origin(now(h)), before.origin(h));
    EXPECT_EQ(after.twin(now(h)), now(before.twin(h)));
  }
  for (std::size_t v = 0; v < before.vertex_count(); ++v) {
    const Vertex vertex{static_cast<std::int32_t>(v)};
    EXPECT_EQ(after.outgoing(vertex), now(before.outgoing(vertex)));
  }
}

}  // namespace
}  // namespace ucvt
