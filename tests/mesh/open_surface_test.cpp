#include <algorithm>

#include "mesh/doubled_surface.h"
#include "mesh/edge_bisection.h"
#include "mesh_test_support.h"
#include "oracle/meshes.h"

namespace ucvt::test {
namespace {

/// A torus without two of its faces, far apart.
TriangleMesh torus_with_two_holes() {
  TriangleMesh mesh = oracle::grid_torus(20, 12);
  mesh.faces.erase(mesh.faces.begin() + 200);
  mesh.faces.pop_back();
  return mesh;
}

template <class Read>
std::string refused(Read read) {
  try {
    read();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(OpenSurface, HasGenusAndBoundaryLoops) {
  const OpenSurface surface = open_surface(torus_with_two_holes());
  EXPECT_EQ(surface.genus, 1);
  EXPECT_EQ(surface.boundary_loops, 2);
  const auto loops = boundary_loops(surface.mesh);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].size(), 3U);
  EXPECT_EQ(loops[1].size(), 3U);
}

TEST(OpenSurface, RefusesWhatIsClosedUnweldedOrOneSided) {
  EXPECT_NE(refused([] { open_surface(oracle::cube()); }).find("closed"), std::string::npos);
  TriangleMesh cut = oracle::grid_torus(8, 6);
  for (std::int32_t& v : cut.faces[0]) {
    cut.positions.push_back(cut.positions[static_cast<std::size_t>(v)]);
    v = static_cast<std::int32_t>(cut.positions.size()) - 1;
  }
  EXPECT_FALSE(has_boundary(cut));
  EXPECT_TRUE(has_boundary(torus_with_two_holes()));
  EXPECT_FALSE(has_boundary(oracle::cube()));
  TriangleMesh band;
  const int n = 10;
  for (std::int32_t i = 0; i < n; ++i) {
    const double a = i * 0.628318;
    const double x = std::cos(a / 2) / 4;
    const double c = std::cos(a), s = std::sin(a), z = std::sin(a / 2) / 4;
    band.positions.push_back({(1 - x) * c, (1 - x) * s, -z});
    band.positions.push_back({(1 + x) * c, (1 + x) * s, z});
    const std::int32_t j = (i + 1) % n, turn = j == 0 ? 1 : 0;
    band.faces.push_back({2 * i, 2 * j + turn, 2 * i + 1});
    band.faces.push_back({2 * i + 1, 2 * j + turn, 2 * j + 1 - turn});
  }
  EXPECT_NE(refused([&] { open_surface(band); }).find("not orientable"), std::string::npos);
}

TEST(BisectEdges, MakesEdgesShortAndKeepsTheSurface) {
  TriangleMesh mesh = open_surface(torus_with_two_holes()).mesh;
  const MeshSurvey before = survey(mesh);
  std::vector<double> size(mesh.positions.size(), 0.1);
  const TriangleMesh coarse = mesh;
  const auto part_of = bisect_edges(mesh, size);
  const MeshSurvey after = survey(mesh);
  ASSERT_EQ(part_of.size(), mesh.faces.size());
  std::vector<double> area(coarse.faces.size(), 0);
  for (std::size_t f = 0; f < part_of.size(); ++f) {
    area[static_cast<std::size_t>(part_of[f])] += face_area(mesh, mesh.faces[f]);
  }
  for (std::size_t f = 0; f < area.size(); ++f) {
    EXPECT_NEAR(area[f] / face_area(coarse, coarse.faces[f]), 1, 1e-12);
  }
  EXPECT_EQ(size.size(), mesh.positions.size());
  EXPECT_LE(after.edge_max, 0.1);
  EXPECT_NEAR(after.area, before.area, 1e-12 * before.area);
  EXPECT_EQ(after.euler_number, before.euler_number);
  EXPECT_EQ(after.boundary_loops, 2);
  EXPECT_EQ(after.misoriented_edges, 0);
  EXPECT_EQ(after.nonmanifold_edges + after.nonmanifold_vertices, 0);
  EXPECT_GE(after.angle_min_deg, before.angle_min_deg / 2);
}

TEST(BisectEdges, LeavesNoInnerEdgeBetweenBoundaryVertices) {
  // A strip of triangles: every inner edge joins two boundary vertices.
  TriangleMesh strip;
  for (std::int32_t i = 0; i < 8; ++i) {
    strip.positions.push_back({0.5 * i, i % 2 == 0 ? 0.0 : 1.0, 0});
    if (i >= 2) {
      strip.faces.push_back(i % 2 == 0 ? Corners{i - 2, i, i - 1} : Corners{i - 2, i - 1, i});
    }
  }
  std::vector<double> size(8, 100.0);
  bisect_edges(strip, size);
  EXPECT_EQ(strip.positions.size(), 8U + 5U);
  const DoubledSurface both = doubled(strip, 0, boundary_loops(strip));
  EXPECT_EQ(closed_surface(both.surface.mesh).genus, 0);
}

TEST(Doubled, IsAClosedSurfaceWithAMirror) {
  TriangleMesh half = open_surface(torus_with_two_holes()).mesh;
  std::vector<double> size(half.positions.size(), 10.0);
  bisect_edges(half, size);
  const auto loops = boundary_loops(half);
  const DoubledSurface both = doubled(half, 1, loops);
  EXPECT_EQ(both.surface.genus, 3);
  const ClosedSurface checked = closed_surface(both.surface.mesh);
  EXPECT_EQ(checked.genus, 3);
  EXPECT_EQ(checked.reoriented_faces, 0);
  const auto n = static_cast<std::int32_t>(both.mirror.size());
  ASSERT_EQ(both.surface.mesh.positions.size(), both.mirror.size());
  std::size_t shared = 0;
  for (std::int32_t v = 0; v < n; ++v) {
    const std::int32_t image = both.mirror[static_cast<std::size_t>(v)];
    EXPECT_EQ(both.mirror[static_cast<std::size_t>(image)], v);
    EXPECT_EQ(both.surface.mesh.positions[static_cast<std::size_t>(image)],
              both.surface.mesh.positions[static_cast<std::size_t>(v)]);
    shared += image == v ? 1 : 0;
  }
  EXPECT_EQ(shared, loops[0].size() + loops[1].size());
}

}  // namespace
}  // namespace ucvt::test
