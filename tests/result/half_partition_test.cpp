// Surfaces with boundary: their partitions and their uniformization, both by way of the double.
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "conformal/uniformize.h"
#include "mesh/edge_bisection.h"
#include "oracle/open_meshes.h"
#include "ucvt/components.h"
#include "ucvt/partition.h"
#include "ucvt/remesh.h"

namespace ucvt {
namespace {

std::size_t index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

double boundary_length(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& loop : boundary_loops(mesh)) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Position &p = mesh.positions[index(loop[i])],
                     &q = mesh.positions[index(loop[(i + 1) % loop.size()])];
      sum += std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    }
  }
  return sum;
}

struct Case {
  const char* name;
  TriangleMesh mesh;
  int sites;
};

class OpenPartitionTest : public testing::TestWithParam<Case> {
 protected:
  const OpenSurface surface = open_surface(GetParam().mesh);
  const RemeshResult result = remesh(surface, options());
  const Partition cut = partition(result);

 private:
  static RemeshOptions options() {
    RemeshOptions out;
    out.sites = GetParam().sites;
    return out;
  }
};

TEST_P(OpenPartitionTest, IsTheSurfaceItself) {
  const MeshSurvey in = survey(surface.mesh), out = survey(cut.mesh);
  EXPECT_EQ(out.euler_number, in.euler_number);
  EXPECT_EQ(out.boundary_loops, in.boundary_loops);
  EXPECT_EQ(out.components, 1);
  EXPECT_EQ(out.unused_vertices + out.misoriented_edges, 0);
  EXPECT_EQ(out.nonmanifold_edges + out.nonmanifold_vertices, 0);
  EXPECT_NEAR(boundary_length(cut.mesh) / boundary_length(surface.mesh), 1, 1e-12);
  for (std::size_t v = 0; v < surface.mesh.positions.size(); ++v) {
    EXPECT_EQ(cut.mesh.positions[v], surface.mesh.positions[v]);
  }
  std::vector<double> area(surface.mesh.faces.size(), 0);
  for (std::size_t f = 0; f < cut.mesh.faces.size(); ++f) {
    area[index(cut.input_face[f])] += face_area(cut.mesh, cut.mesh.faces[f]);
  }
  for (std::size_t f = 0; f < area.size(); ++f) {
    EXPECT_NEAR(area[f] / face_area(surface.mesh, surface.mesh.faces[f]), 1, 1e-9);
  }
}

TEST_P(OpenPartitionTest, CellsAreDisksThatBelongToTheMeshsVertices) {
  ASSERT_EQ(cut.cells.size(), result.mesh.positions.size());
  std::vector<TriangleMesh> part(cut.cells.size(), TriangleMesh{cut.mesh.positions, {}});
  for (std::size_t f = 0; f < cut.mesh.faces.size(); ++f) {
    part[index(cut.cell[f])].faces.push_back(cut.mesh.faces[f]);
  }
  std::vector<std::set<std::int32_t>> neighbours(part.size());
  for (const Corners& f : result.mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      neighbours[index(f[k])].insert({f[(k + 1) % 3], f[(k + 2) % 3]});
    }
  }
  double area_3d = 0, area = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const PartitionCell& cell = cut.cells[i];
    const MeshSurvey found = survey(part[i]);
    EXPECT_EQ(found.euler_number, 1) << i;
    EXPECT_EQ(found.components, 1) << i;
    EXPECT_EQ(cell.site, result.mesh.positions[i]);
    EXPECT_NEAR(cell.area_3d / found.area, 1, 1e-12);
    EXPECT_TRUE(std::ranges::equal(cell.neighbours, neighbours[i])) << i;
    EXPECT_EQ(cell.degree, neighbours[i].size()) << i;
    for (const std::int32_t n : cell.neighbours) {
      EXPECT_NE(cell.colour, cut.cells[index(n)].colour);
    }
    area_3d += cell.area_3d, area += cell.area;
  }
  EXPECT_NEAR(area_3d / surface_area(surface.mesh), 1, 1e-12);
  EXPECT_NEAR(area / (result.surface.report().area / 2), 1, 1e-9);
}

TEST_P(OpenPartitionTest, NamesVerticesAndFacesOfTheInput) {
  std::vector<std::set<std::int32_t>> cells_at(cut.mesh.positions.size());
  std::vector<std::map<std::int32_t, double>> share(surface.mesh.faces.size());
  for (std::size_t f = 0; f < cut.mesh.faces.size(); ++f) {
    share[index(cut.input_face[f])][cut.cell[f]] += face_area(cut.mesh, cut.mesh.faces[f]);
    for (const std::int32_t v : cut.mesh.faces[f]) {
      cells_at[index(v)].insert(cut.cell[f]);
    }
  }
  ASSERT_EQ(cut.vertex_cell.size(), surface.mesh.positions.size());
  for (std::size_t v = 0; v < cut.vertex_cell.size(); ++v) {
    EXPECT_TRUE(cells_at[v].contains(cut.vertex_cell[v])) << v;
  }
  ASSERT_EQ(cut.face_cell.size(), share.size());
  for (std::size_t f = 0; f < share.size(); ++f) {
    for (const auto& [cell, area] : share[f]) {
      EXPECT_LE(area, share[f][cut.face_cell[f]]) << f;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Open, OpenPartitionTest,
    testing::Values(Case{"disk", oracle::plate(8), 100}, Case{"annulus", oracle::tube(30, 20), 120},
                    Case{"torus", oracle::torus_with_holes(1), 150},
                    Case{"torus_with_two_holes", oracle::torus_with_holes(2), 150}),
    [](const auto& c) { return c.param.name; });

TEST(UniformizeOpen, TheDoubleIsSymmetric) {
  const OpenSurface surface = open_surface(oracle::torus_with_holes(2));
  for (const double longest_edge : {0.0, 0.2}) {
    const UniformizedSurface uniformized = uniformize(surface, {longest_edge, {}});
    EXPECT_EQ(uniformized.report().genus, 3);
    EXPECT_EQ(uniformized.report().geometry, "hyperbolic");
    const Uniformized& t = uniformized.value();
    const std::size_t n = t.input.positions.size();
    ASSERT_EQ(t.mirror.size(), n);
    EXPECT_EQ(uniformized.report().vertices, n);
    std::size_t fixed = 0;
    for (std::size_t v = 0; v < n; ++v) {
      const std::size_t image = index(t.mirror[v]);
      EXPECT_EQ(index(t.mirror[image]), v);
      EXPECT_EQ(t.input.positions[image], t.input.positions[v]);
      EXPECT_NEAR(t.log_scale[image], t.log_scale[v], 1e-9);
      fixed += image == v ? 1 : 0;
    }
    EXPECT_GE(fixed, 12U);  // two holes of six edges
    EXPECT_LT(fixed, n / 4);
    EXPECT_EQ(longest_edge > 0, n > 2 * surface.mesh.positions.size());
  }
}

}  // namespace
}  // namespace ucvt
