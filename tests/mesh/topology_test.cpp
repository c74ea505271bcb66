#include <algorithm>
#include <random>

#include "mesh_test_support.h"

namespace ucvt::test {
namespace {

TriangleMesh abstract_mesh(std::size_t vertices, std::vector<Corners> faces) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto x = static_cast<double>(i);
    mesh.positions.push_back({x, x * x, x * x * x});
  }
  mesh.faces = std::move(faces);
  return mesh;
}

TriangleMesh projective_plane() {
  return abstract_mesh(6, {{0, 1, 2},
                           {0, 2, 3},
                           {0, 3, 4},
                           {0, 4, 5},
                           {0, 5, 1},
                           {1, 2, 4},
                           {2, 3, 5},
                           {3, 4, 1},
                           {4, 5, 2},
                           {5, 1, 3}});
}

TriangleMesh two_tetrahedra(const Corners& second, std::int32_t fourth) {
  TriangleMesh mesh = tetrahedron();
  mesh.positions.insert(mesh.positions.end(), {{5, 0, 0}, {0, 5, 0}, {0, 0, 5}, {5, 5, 5}});
  const auto [a, b, c] = second;
  mesh.faces.insert(mesh.faces.end(), {{a, c, b}, {a, b, fourth}, {b, c, fourth}, {a, fourth, c}});
  return mesh;
}

TEST(ClosedSurface, TakesSpheresAndTori) {
  EXPECT_EQ(closed_surface(tetrahedron()).genus, 0);
  const ClosedSurface torus = closed_surface(grid_surface(7, 5));
  EXPECT_EQ(torus.genus, 1);
  EXPECT_EQ(torus.reoriented_faces, 0);
  EXPECT_EQ(torus.mesh.faces, grid_surface(7, 5).faces);
  TriangleMesh smallest = abstract_mesh(7, {});
  for (std::int32_t i = 0; i < 7; ++i) {
    smallest.faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    smallest.faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  EXPECT_EQ(closed_surface(smallest).genus, 1);
}

TEST(ClosedSurface, PositionsDoNotMatter) {
  TriangleMesh mesh = grid_surface(7, 5);
  std::fill(mesh.positions.begin(), mesh.positions.end(), Position{1, 1, 1});
  EXPECT_EQ(closed_surface(mesh).genus, 1);
}

TEST(ClosedSurface, DropsUnusedVertices) {
  TriangleMesh mesh = tetrahedron();
  mesh.positions.insert(mesh.positions.begin() + 1, Position{9, 9, 9});
  for (Corners& f : mesh.faces) {
    for (std::int32_t& v : f) {
      v += v > 0;
    }
  }
  const ClosedSurface surface = closed_surface(mesh);
  EXPECT_EQ(surface.mesh.positions, tetrahedron().positions);
  EXPECT_EQ(surface.mesh.faces, tetrahedron().faces);
  EXPECT_EQ(surface.input_vertex, (std::vector<std::int32_t>{0, 2, 3, 4}));
  EXPECT_EQ(survey(mesh).unused_vertices, 1);
}

TEST(ClosedSurface, TurnsTheFewerFaces) {
  const TriangleMesh good = grid_surface(7, 5);
  for (const std::size_t count : {std::size_t{1}, std::size_t{20}, std::size_t{34}}) {
    TriangleMesh mixed = good;
    for (std::size_t i = 0; i < count; ++i) {
      std::swap(mixed.faces[2 * i][0], mixed.faces[2 * i][1]);
    }
    const ClosedSurface surface = closed_surface(mixed);
    EXPECT_EQ(surface.reoriented_faces, static_cast<std::int64_t>(count));
    EXPECT_EQ(survey(surface.mesh).misoriented_edges, 0);
    EXPECT_GT(survey(mixed).misoriented_edges, 0);
    EXPECT_EQ(surface.mesh.faces[1], good.faces[1]);
  }
  TriangleMesh inside_out = good;
  for (Corners& f : inside_out.faces) {
    std::swap(f[0], f[1]);
  }
  EXPECT_EQ(closed_surface(inside_out).reoriented_faces, 0);
  EXPECT_EQ(closed_surface(inside_out).mesh.faces, inside_out.faces);
}

TEST(ClosedSurface, RefusesNonOrientableSurfaces) {
  EXPECT_HAS(closed_refusal(projective_plane()), "projective plane, Euler number 1");
  EXPECT_HAS(closed_refusal(grid_surface(7, 5, true)), "Klein bottle, Euler number 0");
  // A projective plane with a torus in place of a face.
  TriangleMesh mesh = projective_plane();
  const TriangleMesh torus = grid_surface(4, 4);
  const auto shift = static_cast<std::int32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), torus.positions.begin(), torus.positions.end());
  const Corners hole = mesh.faces.front();
  mesh.faces.erase(mesh.faces.begin());
  for (std::size_t f = 1; f < torus.faces.size(); ++f) {
    Corners face = torus.faces[f];
    for (std::int32_t& v : face) {
      std::int32_t glued = v + shift;
      for (std::size_t i = 0; i < 3; ++i) {
        if (torus.faces[0][i] == v) {
          glued = hole[i];
        }
      }
      v = glued;
    }
    mesh.faces.push_back(face);
  }
  EXPECT_HAS(closed_refusal(mesh), "a sphere with 3 cross-caps, Euler number -1");
}

TEST(ClosedSurface, NamesTheFault) {
  EXPECT_HAS(closed_refusal({}), "no faces");
  TriangleMesh mesh = tetrahedron();
  mesh.faces.push_back({1, 3, 1});
  EXPECT_HAS(closed_refusal(mesh), "1 face has a repeated corner (first face 4: 1 3 1)");
  mesh.faces.back() = {2, 0, 1};
  EXPECT_HAS(closed_refusal(mesh), "1 duplicate face (first face 4, of face 0)");
  mesh.faces.pop_back();
  mesh.faces.pop_back();
  EXPECT_HAS(closed_refusal(mesh), "the surface is open: 1 boundary loop of 3 edges (first 0-2)");
  EXPECT_HAS(closed_refusal(abstract_mesh(3, {{0, 1, 2}, {0, 2, 1}})), "duplicate");
  EXPECT_HAS(closed_refusal(two_tetrahedra({4, 5, 6}, 7)), "2 components");
  EXPECT_HAS(closed_refusal(two_tetrahedra({2, 5, 6}, 7)),
             "1 non-manifold vertex (first 2, of 2 fans)");
  EXPECT_HAS(closed_refusal(two_tetrahedra({2, 3, 6}, 7)),
             "1 non-manifold edge (first 2-3, of 4 faces)");
  EXPECT_HAS(closed_refusal(abstract_mesh(5, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}})), "of 3 faces");
}

TEST(ClosedSurface, TellsUnweldedFromOpen) {
  const TriangleMesh whole = grid_surface(7, 5);
  TriangleMesh soup;
  for (const Corners& f : whole.faces) {
    const auto first = static_cast<std::int32_t>(soup.positions.size());
    for (const std::int32_t v : f) {
      soup.positions.push_back(whole.positions[static_cast<std::size_t>(v)]);
    }
    soup.faces.push_back({first, first + 1, first + 2});
  }
  EXPECT_HAS(closed_refusal(soup), "175 vertices repeat the place of another one; try --repair");
}

TEST(Survey, CountsFaults) {
  MeshSurvey s = survey(two_tetrahedra({2, 3, 6}, 7));
  EXPECT_EQ(s.nonmanifold_edges, 1);
  EXPECT_EQ(s.nonmanifold_vertices, 0);
  EXPECT_EQ(s.components, 1);
  s = survey(two_tetrahedra({2, 5, 6}, 7));
  EXPECT_EQ(s.nonmanifold_vertices, 1);
  EXPECT_EQ(s.unused_vertices, 1);
  s = survey(two_tetrahedra({4, 5, 6}, 7));
  EXPECT_EQ(s.components, 2);
  EXPECT_EQ(s.euler_number, 4);
  s = survey(projective_plane());
  EXPECT_FALSE(s.orientable);
  EXPECT_EQ(s.euler_number, 1);
  TriangleMesh torn = grid_surface(7, 5);
  torn.faces.erase(torn.faces.begin() + 40);
  torn.faces.erase(torn.faces.begin());
  s = survey(torn);
  EXPECT_EQ(s.boundary_edges, 6);
  EXPECT_EQ(s.boundary_loops, 2);
  EXPECT_TRUE(s.orientable);
  TriangleMesh doubled = tetrahedron();
  doubled.faces.push_back({0, 1, 2});
  doubled.faces.push_back({1, 2, 0});
  s = survey(doubled);
  EXPECT_EQ(s.duplicate_faces, 2);
  EXPECT_EQ(s.nonmanifold_edges, 3);
  EXPECT_EQ(survey({}).faces, 0);
}

// The fast survey against counts by brute force, on random heaps of triangles.
TEST(Survey, AgreesWithBruteForce) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    std::uniform_int_distribution<std::int32_t> vertex(0, 3 + trial % 9);
    TriangleMesh mesh = abstract_mesh(12, {});
    for (int f = 0; f < 2 + trial % 17; ++f) {
      mesh.faces.push_back({vertex(random), vertex(random), vertex(random)});
    }
    std::int64_t edges = 0, boundary = 0, nonmanifold = 0, repeated = 0, duplicates = 0;
    std::vector<Corners> sorted;
    for (Corners f : mesh.faces) {
      std::sort(f.begin(), f.end());
      const bool bad = f[0] == f[1] || f[1] == f[2];
      repeated += bad;
      if (bad) {
        continue;
      }
      duplicates += std::find(sorted.begin(), sorted.end(), f) != sorted.end();
      sorted.push_back(f);
    }
    for (std::int32_t a = 0; a < 12; ++a) {
      for (std::int32_t b = a + 1; b < 12; ++b) {
        const auto uses = std::count_if(sorted.begin(), sorted.end(), [&](const Corners& f) {
          return std::count(f.begin(), f.end(), a) + std::count(f.begin(), f.end(), b) == 2;
        });
        edges += uses > 0;
        boundary += uses == 1;
        nonmanifold += uses > 2;
      }
    }
    const MeshSurvey s = survey(mesh);
    EXPECT_EQ(s.edges, edges);
    EXPECT_EQ(s.boundary_edges, boundary);
    EXPECT_EQ(s.nonmanifold_edges, nonmanifold);
    EXPECT_EQ(s.repeated_corner_faces, repeated);
    EXPECT_EQ(s.duplicate_faces, duplicates);
  }
}

TEST(Survey, Measures) {
  const MeshSurvey s = survey(tetrahedron());
  EXPECT_NEAR(s.area, 1.5 + std::sqrt(3.0) / 2, 1e-15);
  EXPECT_NEAR(surface_area(tetrahedron()), s.area, 1e-15);
  EXPECT_NEAR(s.bbox_diagonal, std::sqrt(3.0), 1e-15);
  EXPECT_EQ(s.edge_min, 1);
  EXPECT_NEAR(s.edge_max, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(s.angle_min_deg, 45, 1e-13);
  TriangleMesh flat = tetrahedron();
  flat.positions[3] = flat.positions[0];
  EXPECT_EQ(survey(flat).coincident_vertices, 1);
  EXPECT_EQ(survey(flat).edge_min, 0);
  EXPECT_EQ(survey(flat).angle_min_deg, 0);
  TriangleMesh small = tetrahedron();
  for (Position& p : small.positions) {
    for (double& c : p) {
      c *= 0x1p-600;
    }
  }
  EXPECT_NEAR(survey(small).angle_min_deg, 45, 1e-13);
}

}  // namespace
}  // namespace ucvt::test
