#include "ucvt/repair.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mesh/hole_triangles.h"
#include "mesh_test_support.h"
#include "ucvt/components.h"

namespace ucvt::test {
namespace {

/// Two unit cubes, the second one moved; corners at one place are one vertex.
TriangleMesh two_cubes(double x, double y, double z) {
  const Corners faces[] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  TriangleMesh mesh;
  for (int cube = 0; cube < 2; ++cube) {
    std::array<std::int32_t, 8> number{};
    for (std::size_t i = 0; i < 8; ++i) {
      const Position p = {static_cast<double>(i & 1) + cube * x,
                          static_cast<double>(i >> 1 & 1) + cube * y,
                          static_cast<double>(i >> 2) + cube * z};
      const auto found = std::find(mesh.positions.begin(), mesh.positions.end(), p);
      number[i] = static_cast<std::int32_t>(found - mesh.positions.begin());
      if (found == mesh.positions.end()) {
        mesh.positions.push_back(p);
      }
    }
    for (const auto& [a, b, c] : faces) {
      mesh.faces.push_back({number[static_cast<std::size_t>(a)],
                            number[static_cast<std::size_t>(b)],
                            number[static_cast<std::size_t>(c)]});
    }
  }
  return mesh;
}

/// Every face with vertices of its own, moved by up to `jitter`.
TriangleMesh soup_of(const TriangleMesh& mesh, double jitter = 0) {
  TriangleMesh soup;
  for (const Corners& f : mesh.faces) {
    const auto first = static_cast<std::int32_t>(soup.positions.size());
    for (const std::int32_t v : f) {
      Position p = mesh.positions[static_cast<std::size_t>(v)];
      p[soup.positions.size() % 3] += soup.positions.size() % 2 == 0 ? jitter : -jitter;
      soup.positions.push_back(p);
    }
    soup.faces.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// The repaired mesh as closed surfaces.
std::vector<Component> mended(const Repaired& r) {
  EXPECT_EQ(faults_of(r.mesh), "");
  EXPECT_EQ(r.input_vertex.size(), r.mesh.positions.size());
  EXPECT_EQ(r.input_face.size(), r.mesh.faces.size());
  return closed_components(r.mesh);
}

TEST(Repair, LeavesGoodMeshesAlone) {
  TriangleMesh mesh = grid_surface(7, 5);
  mesh.positions[3] = mesh.positions[4];
  const Repaired r = repair(mesh);
  EXPECT_FALSE(r.report.changed());
  EXPECT_EQ(r.mesh.faces, mesh.faces);
  EXPECT_EQ(r.mesh.positions, mesh.positions);
  EXPECT_EQ(summary_of(r.report), "nothing to repair");
}

TEST(Repair, WeldsOpenVertices) {
  const TriangleMesh whole = grid_surface(7, 5);
  const Repaired r = repair(soup_of(whole));
  const std::vector<Component> parts = mended(r);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].surface.genus, 1);
  EXPECT_EQ(parts[0].surface.mesh.positions.size(), 35U);
  EXPECT_EQ(r.report.welded_vertices, 210 - 35);
  EXPECT_EQ(summary_of(r.report), "welded 175 vertices");
}

TEST(Repair, WeldsUpToTheTolerance) {
  const TriangleMesh soup = soup_of(grid_surface(7, 5), 1e-5);
  EXPECT_NE(faults_of(repair(soup).mesh), "");
  const Repaired r = repair(soup, {.weld = 2e-5});
  EXPECT_EQ(mended(r).front().surface.genus, 1);
  TriangleMesh huge = soup;
  for (Position& p : huge.positions) {
    for (double& x : p) {
      x *= 1e30;
    }
  }
  EXPECT_EQ(repair(huge, {.weld = 2e-5}).mesh.faces, r.mesh.faces);
}

TEST(Repair, DropsRepeatedCornersAndCopies) {
  const TriangleMesh whole = grid_surface(7, 5);
  TriangleMesh mesh = whole;
  mesh.faces.insert(mesh.faces.begin(), {3, 3, 5});
  const auto [a, b, c] = whole.faces[9];
  mesh.faces.push_back({c, b, a});
  mesh.faces.push_back({b, c, a});
  const Repaired r = repair(mesh);
  EXPECT_EQ(r.mesh.faces, whole.faces);
  EXPECT_EQ(r.input_face.front(), 1);
  EXPECT_EQ(r.report.repeated_corners, 1);
  EXPECT_EQ(r.report.duplicate_faces, 2);
}

TEST(Repair, AMeshListedTwiceIsOne) {
  TriangleMesh mesh = grid_surface(7, 5);
  mesh.faces.insert(mesh.faces.end(), mesh.faces.begin(), mesh.faces.end());
  EXPECT_EQ(repair(mesh).mesh.faces, grid_surface(7, 5).faces);
}

TEST(Repair, WallsInsideGo) {
  const TriangleMesh cubes = two_cubes(1, 0, 0);
  EXPECT_NE(faults_of(cubes), "");
  const Repaired r = repair(cubes);
  EXPECT_EQ(r.report.duplicate_faces, 4);
  const std::vector<Component> parts = mended(r);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].surface.genus, 0);
  EXPECT_EQ(parts[0].surface.mesh.faces.size(), 20U);
}

TEST(Repair, BodiesThatTouchAreTakenApart) {
  const Repaired edge = repair(two_cubes(1, 1, 0));
  EXPECT_EQ(edge.report.split_edges, 1);
  EXPECT_EQ(edge.report.split_vertices, 2);
  const std::vector<Component> parts = mended(edge);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].surface.mesh.faces.size(), 12U);
  EXPECT_EQ(survey(parts[1].surface.mesh).bbox_diagonal, std::sqrt(3.0));
  const Repaired corner = repair(two_cubes(1, 1, 1));
  EXPECT_EQ(corner.report.split_vertices, 1);
  EXPECT_EQ(corner.input_vertex.back(), 7);
  EXPECT_EQ(mended(corner).size(), 2U);
}

TEST(Repair, OrientsEachComponent) {
  TriangleMesh mesh = two_cubes(3, 0, 0);
  for (const std::size_t f : {std::size_t{0}, std::size_t{15}, std::size_t{16}}) {
    std::swap(mesh.faces[f][0], mesh.faces[f][1]);
  }
  const Repaired r = repair(mesh);
  EXPECT_EQ(r.report.reoriented_faces, 3);
  EXPECT_EQ(survey(r.mesh).misoriented_edges, 0);
}

TEST(Repair, ClosesSmallHoles) {
  const TriangleMesh whole = grid_surface(12, 9);
  TriangleMesh mesh = whole;
  mesh.faces.erase(mesh.faces.begin() + 60, mesh.faces.begin() + 62);  // a quadrilateral
  mesh.faces.erase(mesh.faces.begin() + 5);
  const Repaired r = repair(mesh);
  EXPECT_EQ(r.report.closed_holes, 2);
  EXPECT_EQ(r.report.added_faces, 3);
  EXPECT_EQ(std::count(r.input_face.begin(), r.input_face.end(), -1), 3);
  EXPECT_EQ(mended(r).front().surface.genus, 1);
  EXPECT_EQ(survey(r.mesh).misoriented_edges, 0);
  EXPECT_EQ(repair(mesh, {.hole_edges = 3}).report.left_holes, 1);
}

TEST(Repair, HolesThatTouchStayTwo) {
  const TriangleMesh whole = grid_surface(12, 9);
  // Faces 0 and 11 x 18 + 17 meet at vertex 0 only.
  TriangleMesh mesh = whole;
  mesh.faces.pop_back();
  std::swap(mesh.faces.front(), mesh.faces.back());
  mesh.faces.pop_back();
  const Repaired r = repair(mesh);
  EXPECT_EQ(r.report.split_vertices, 0);
  EXPECT_EQ(r.report.closed_holes, 2);
  EXPECT_EQ(r.report.added_faces, 2);
  EXPECT_EQ(mended(r).front().surface.genus, 1);
}

TEST(Repair, AFaceAmongThreeHolesStays) {
  const TriangleMesh whole = grid_surface(12, 9);
  const Corners& kept = whole.faces[50];
  TriangleMesh mesh = whole;
  std::erase_if(mesh.faces, [&](const Corners& f) {
    return std::count_if(f.begin(), f.end(), [&](std::int32_t v) {
             return std::find(kept.begin(), kept.end(), v) != kept.end();
           }) == 2;
  });
  const Repaired r = repair(mesh);
  EXPECT_EQ(r.report.closed_holes, 3);
  EXPECT_EQ(r.report.added_faces, 3);
  EXPECT_EQ(mended(r).front().surface.genus, 1);
}

TEST(Repair, EdgesThatNoSplittingPartsAreCut) {
  // Inside out, the cubes are holes in a body that touches itself between them.
  TriangleMesh mesh = two_cubes(1, 1, 0);
  for (Corners& f : mesh.faces) {
    std::swap(f[0], f[1]);
  }
  const Repaired r = repair(mesh);
  EXPECT_EQ(r.report.cut_edges, 1);
  EXPECT_EQ(r.input_vertex.back(), -1);
  const std::vector<Component> parts = mended(r);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].surface.genus, 0);
}

TEST(Repair, AnUmbrellaIsNotClosed) {
  TriangleMesh mesh = {{{0, 0, 0}}, {}};
  for (std::int32_t i = 0; i < 6; ++i) {
    mesh.positions.push_back({std::cos(i), std::sin(i), 0.1});
    mesh.faces.push_back({0, 1 + i, 1 + (i + 1) % 6});
  }
  const Repaired r = repair(mesh);
  EXPECT_EQ(r.report.left_holes, 1);
  EXPECT_EQ(r.mesh.faces, mesh.faces);
}

TEST(HoleTriangles, NeitherFoldNorUseForbiddenDiagonals) {
  // A strip folded at the edge 1-4.
  const std::vector<Position> folded = {{0, 0, 0},   {1, 0, 0}, {0, 0, 0.1},
                                        {0, 1, 0.1}, {1, 1, 0}, {0, 1, 0}};
  const auto only_along = [](std::size_t i, std::size_t j) { return i != 1 && j != 4; };
  EXPECT_TRUE(hole_triangles(folded, only_along).empty());
  const std::vector<Position> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto first = [](std::size_t i, std::size_t) { return i == 0; };
  for (const Corners& t : hole_triangles(square, first)) {
    EXPECT_EQ(std::count(t.begin(), t.end(), 1) + std::count(t.begin(), t.end(), 3), 2);
  }
  EXPECT_EQ(hole_triangles(square, first).size(), 2U);
  EXPECT_TRUE(hole_triangles(square, [](std::size_t, std::size_t) { return true; }).empty());
}

TEST(Repair, OpenSurfacesStayOpen) {
  const TriangleMesh one = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_HAS(faults_of(repair(one).mesh), "1 boundary loop of 3 edges");
  // Half a torus: two loops of nine edges, and more than that.
  TriangleMesh half = grid_surface(12, 9);
  half.faces.resize(half.faces.size() / 2);
  const Repaired r = repair(half);
  EXPECT_EQ(r.report.left_holes, 2);
  EXPECT_EQ(r.mesh.faces, half.faces);
}

TEST(Repair, FaultsAreListedTogether) {
  TriangleMesh mesh = two_cubes(1, 1, 0);
  mesh.faces.pop_back();
  mesh.faces.push_back({0, 0, 1});
  const std::string faults = faults_of(mesh);
  EXPECT_HAS(faults, "open and not manifold: 1 boundary loop of 3 edges (first ");
  EXPECT_HAS(faults, "1 face has a repeated corner (first face 23: 0 0 1)");
  EXPECT_HAS(faults, "1 non-manifold edge (first 3-7, of 4 faces)");
  EXPECT_EQ(faults_of(grid_surface(7, 5)), "");
}

TEST(Repair, OneSidedSurfacesAreNamed) {
  TriangleMesh klein = grid_surface(7, 5, true);
  EXPECT_HAS(faults_of(repair(klein).mesh), "it is a Klein bottle, Euler number 0");
  TriangleMesh band = klein;
  band.faces.clear();
  for (std::int32_t i = 0; i < 5; ++i) {
    band.faces.push_back({2 * i, (2 * i + 1) % 10, (2 * i + 2) % 10});
    band.faces.push_back({(2 * i + 1) % 10, (2 * i + 3) % 10, (2 * i + 2) % 10});
  }
  std::swap(band.faces[8][2], band.faces[9][1]);
  band.faces[8] = {8, 9, 1}, band.faces[9] = {9, 0, 1};
  EXPECT_HAS(faults_of(band), "a Moebius band, Euler number 0");
  const TriangleMesh torus = grid_surface(7, 5);
  const auto shift = static_cast<std::int32_t>(torus.positions.size());
  TriangleMesh both = torus;
  both.positions.insert(both.positions.end(), klein.positions.begin(), klein.positions.end());
  for (const auto& [a, b, c] : klein.faces) {
    both.faces.push_back({a + shift, b + shift, c + shift});
  }
  EXPECT_HAS(faults_of(both), "the component of face 70 is a Klein bottle, Euler number 0");
}

/// Random damage: copies of faces, faces turned round, faces with vertices of their own, and holes.
RC_GTEST_PROP(Repair, MendsRandomDamageOrNamesIt, ()) {
  const TriangleMesh whole = grid_surface(11, 8);
  TriangleMesh mesh = whole;
  const auto some_face = [&] { return *rc::gen::inRange<std::size_t>(0, mesh.faces.size()); };
  for (int n = *rc::gen::inRange(0, 20); n > 0; --n) {
    Corners& f = mesh.faces[some_face()];
    std::swap(f[0], f[1]);
  }
  for (int n = *rc::gen::inRange(0, 10); n > 0; --n) {
    Corners& f = mesh.faces[some_face()];
    for (std::int32_t& v : f) {
      mesh.positions.push_back(mesh.positions[static_cast<std::size_t>(v)]);
      v = static_cast<std::int32_t>(mesh.positions.size() - 1);
    }
  }
  for (int n = *rc::gen::inRange(0, 8); n > 0; --n) {
    const Corners f = mesh.faces[some_face()];
    mesh.faces.push_back(f);
  }
  const int holes = *rc::gen::inRange(0, 4);
  for (int n = 0; n < holes; ++n) {
    mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(some_face()));
  }
  const Repaired r = repair(mesh);
  if (const std::string faults = faults_of(r.mesh); !faults.empty()) {
    RC_ASSERT(holes > 0);
    RC_ASSERT(faults.find("the surface is ") == 0U);
    return;
  }
  const std::vector<Component> parts = closed_components(r.mesh);
  RC_ASSERT(parts.size() == 1U);
  RC_ASSERT(parts[0].surface.genus == 1);
}

/// Heaps of triangles: whatever comes, it is closed or its faults are named, and a second repair
/// finds nothing to do in what is closed.
RC_GTEST_PROP(Repair, NeverFailsOnHeapsOfTriangles, ()) {
  TriangleMesh mesh = grid_surface(3, 4);
  mesh.faces.clear();
  const auto vertex = [] { return *rc::gen::inRange(0, 12); };
  for (int n = *rc::gen::inRange(1, 40); n > 0; --n) {
    mesh.faces.push_back({vertex(), vertex(), vertex()});
  }
  const Repaired r = repair(mesh);
  const MeshSurvey counts = survey(r.mesh);
  RC_ASSERT(counts.duplicate_faces == 0);
  RC_ASSERT(counts.repeated_corner_faces == 0);
  RC_ASSERT(counts.nonmanifold_vertices == 0);
  if (faults_of(r.mesh).empty()) {
    RC_ASSERT(!r.mesh.faces.empty());
    RC_ASSERT(!repair(r.mesh).report.changed());
  }
}

TEST(Repair, VerticesWhereCuttingADoubleEdgePartsFansAreSplit) {
  TriangleMesh mesh;
  for (int i = 0; i < 5; ++i) {
    mesh.positions.push_back({i % 4 + 0.0, i / 4 + 0.0, 0.1 * i * i});
  }
  mesh.faces = {{1, 4, 2}, {3, 2, 1}, {0, 3, 4}, {1, 4, 0}, {0, 1, 2}, {3, 1, 0}, {3, 2, 0}};
  EXPECT_EQ(survey(repair(mesh).mesh).nonmanifold_vertices, 0);
}

}  // namespace
}  // namespace ucvt::test
