#include "ucvt/components.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "oracle/meshes.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

TriangleMesh together(const std::vector<TriangleMesh>& meshes) {
  TriangleMesh out;
  double shift = 0;
  for (const TriangleMesh& mesh : meshes) {
    const auto first = static_cast<std::int32_t>(out.positions.size());
    for (const Position& p : mesh.positions) {
      out.positions.push_back({p[0] + shift, p[1], p[2]});
    }
    for (const Corners& f : mesh.faces) {
      out.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
    }
    shift += 10;
  }
  return out;
}

std::vector<Component> parts_of(const std::vector<TriangleMesh>& meshes) {
  return closed_components(together(meshes));
}

RemeshOptions quick(int sites) {
  RemeshOptions options;
  options.sites = sites;
  options.iterations = 10;
  return options;
}

TEST(Components, ComeInTheOrderOfTheirFaces) {
  TriangleMesh mesh = together({oracle::cube(), oracle::grid_torus(8, 6)});
  mesh.positions.push_back({0, 0, 0});
  std::rotate(mesh.faces.begin(), mesh.faces.begin() + 12, mesh.faces.end());
  const std::vector<Component> parts = closed_components(mesh);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].surface.genus, 1);
  EXPECT_EQ(parts[1].surface.genus, 0);
  EXPECT_EQ(parts[1].input_face.front(), 96);
  EXPECT_EQ(parts[0].surface.input_vertex.front(), 8);
  for (const Component& part : parts) {
    for (std::size_t f = 0; f < part.input_face.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto v = static_cast<std::size_t>(part.surface.mesh.faces[f][i]);
        EXPECT_EQ(part.surface.input_vertex[v],
                  mesh.faces[static_cast<std::size_t>(part.input_face[f])][i]);
      }
    }
  }
}

TEST(Components, SitesAreSharedByArea) {
  const auto share = [](const std::vector<TriangleMesh>& meshes, int sites) {
    return share_sites(parts_of(meshes), sites);
  };
  using Numbers = std::vector<int>;
  const TriangleMesh one = oracle::cube();
  const TriangleMesh four = oracle::scaled(one, 2), tiny = oracle::scaled(one, 1e-3);
  EXPECT_EQ(share({one}, 7), Numbers{7});
  EXPECT_EQ(share({one, four}, 100), (Numbers{20, 80}));
  EXPECT_EQ(share({one, one, one}, 100), (Numbers{34, 33, 33}));
  EXPECT_EQ(share({tiny, one, four}, 104), (Numbers{4, 20, 80}));
  // A torus gets the seven that a simplicial one has, while they suffice for that.
  const TriangleMesh torus = oracle::scaled(oracle::grid_torus(8, 6), 1e-3);
  EXPECT_EQ(share({torus, one}, 30), (Numbers{7, 23}));
  EXPECT_EQ(share({torus, one}, 10), (Numbers{1, 9}));
  EXPECT_EQ(share({oracle::scaled(oracle::voxel_frame(2), 1e-3), one}, 30), (Numbers{10, 20}));
  EXPECT_THROW(share({torus, one}, 4), InvalidInput);
}

RC_GTEST_PROP(Components, SharesAddUp, (std::vector<unsigned char> sizes)) {
  std::vector<TriangleMesh> meshes{oracle::tetrahedron(), oracle::grid_torus(3, 3)};
  for (const unsigned char size : sizes) {
    meshes.push_back(oracle::scaled(oracle::tetrahedron(), 0.1 + size));
  }
  const int least = 4 * static_cast<int>(meshes.size()) - 3;
  const int sites = *rc::gen::inRange(least, 20 * least);
  const std::vector<int> shares = share_sites(parts_of(meshes), sites);
  RC_ASSERT(std::accumulate(shares.begin(), shares.end(), 0) == sites);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    RC_ASSERT(shares[i] >= (i == 1 ? 1 : 4));
  }
}

TEST(Components, EachIsRemeshedAsIfItWereAlone) {
  const std::vector<Component> parts = parts_of({oracle::icosphere(2), oracle::grid_torus(16, 10)});
  const std::vector<RemeshResult> results = remesh(parts, quick(90));
  const std::vector<int> sites = share_sites(parts, 90);
  ASSERT_EQ(results.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const RemeshResult alone = remesh(parts[i].surface, quick(sites[i]));
    EXPECT_EQ(alone.mesh.positions, results[i].mesh.positions);
    EXPECT_EQ(alone.mesh.faces, results[i].mesh.faces);
  }
  const std::vector<Component> again = closed_components(joined_mesh(results));
  ASSERT_EQ(again.size(), 2U);
  EXPECT_EQ(again[0].surface.genus, 0);
  EXPECT_EQ(again[1].surface.genus, 1);
}

TEST(Components, JoinedReportAddsUp) {
  const std::vector<Component> parts = parts_of({oracle::icosphere(2), oracle::grid_torus(16, 10)});
  const std::vector<RemeshResult> results = remesh(parts, quick(90));
  const JoinedReport joined = joined_report(results);
  EXPECT_EQ(joined.remesh.genus, 1);
  EXPECT_EQ(joined.cvt.sites, results[0].cvt.sites + results[1].cvt.sites);
  double count = 0, sum = 0, squares = 0;
  for (const RemeshResult& r : results) {
    const Spread& area = r.cell_area_3d;
    const auto n = static_cast<double>(r.cvt.sites);
    count += n, sum += n * area.mean,
        squares += n * area.mean * area.mean * (1 + area.cv * area.cv);
  }
  const double mean = sum / count;
  EXPECT_NEAR(joined.cell_area_3d.mean, mean, 1e-12 * mean);
  EXPECT_NEAR(joined.cell_area_3d.cv, std::sqrt(squares / count - mean * mean) / mean, 1e-9);
  EXPECT_EQ(joined.cell_area_3d.min,
            std::min(results[0].cell_area_3d.min, results[1].cell_area_3d.min));
  EXPECT_EQ(joined.cell_area_3d.max,
            std::max(results[0].cell_area_3d.max, results[1].cell_area_3d.max));
}

TEST(Components, PartitionsAreNumberedThrough) {
  TriangleMesh mesh = together({oracle::icosphere(2), oracle::grid_torus(16, 10)});
  std::rotate(mesh.faces.begin(), mesh.faces.begin() + 400, mesh.faces.end());
  const std::vector<Component> parts = closed_components(mesh);
  const std::vector<RemeshResult> results = remesh(parts, quick(60));
  const JoinedPartition cut = partition(parts, results);
  const Partition& p = cut.partition;
  EXPECT_EQ(cut.input_vertex.size(), mesh.positions.size());
  EXPECT_EQ(cut.input_face.size(), mesh.faces.size());
  EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), p.mesh.positions.begin()));
  EXPECT_EQ(closed_components(p.mesh).size(), 2U);
  EXPECT_NEAR(survey(p.mesh).area, survey(mesh).area, 1e-12 * survey(mesh).area);
  const std::int64_t first = results[0].cvt.sites;
  for (std::size_t f = 0; f < p.mesh.faces.size(); ++f) {
    const Corners& input = mesh.faces[static_cast<std::size_t>(p.input_face[f])];
    const bool on_first = parts[0].surface.input_vertex[0] <= input[0] &&
                          input[0] <= parts[0].surface.input_vertex.back();
    EXPECT_EQ(p.cell[f] < first, on_first);
    for (const std::int32_t v : p.mesh.faces[f]) {
      if (static_cast<std::size_t>(v) < mesh.positions.size()) {
        EXPECT_EQ(p.vertex_cell[static_cast<std::size_t>(v)] < first, on_first);
      }
    }
  }
  for (std::size_t i = 0; i < p.cells.size(); ++i) {
    for (const std::int32_t j : p.cells[i].neighbours) {
      EXPECT_EQ(j < first, static_cast<std::int64_t>(i) < first);
    }
  }
}

TEST(Components, InitialSitesAreOfOne) {
  const std::vector<Component> parts = parts_of({oracle::cube(), oracle::cube()});
  RemeshOptions options = quick(20);
  options.initial_sites.resize(20);
  EXPECT_THROW(remesh(parts, options), InvalidInput);
}

}  // namespace
}  // namespace ucvt
