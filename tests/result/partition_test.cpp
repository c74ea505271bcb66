#include "ucvt/partition.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <set>

#include <gtest/gtest.h>
#include <unistd.h>

#include "oracle/meshes.h"
#include "result/cell_complex.h"
#include "result/colouring.h"
#include "result/polygon_triangles.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

std::size_t index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

Position minus(const Position& a, const Position& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Position crossed(const Position& a, const Position& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Position& a, const Position& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Twice the area, along the normal.
Position area_vector(const TriangleMesh& mesh, const Corners& f) {
  const Position& a = mesh.positions[index(f[0])];
  return crossed(minus(mesh.positions[index(f[1])], a), minus(mesh.positions[index(f[2])], a));
}

struct Case {
  const char* name;
  TriangleMesh mesh;
  int sites;
};

class PartitionTest : public testing::TestWithParam<Case> {
 protected:
  PartitionTest() : surface(oracle::closed(GetParam().mesh)) {
    RemeshOptions options;
    options.sites = GetParam().sites, options.iterations = 40;
    result = std::make_unique<RemeshResult>(remesh(surface, options));
    cut = partition(*result);
  }

  ClosedSurface surface;
  std::unique_ptr<RemeshResult> result;
  Partition cut;
};

TEST_P(PartitionTest, IsAClosedManifoldOfTheSameGenus) {
  const ClosedSurface again = closed_surface(cut.mesh);
  EXPECT_EQ(again.genus, surface.genus);
  EXPECT_EQ(again.reoriented_faces, 0);
  EXPECT_EQ(survey(cut.mesh).unused_vertices, 0);
  EXPECT_TRUE(std::equal(surface.mesh.positions.begin(), surface.mesh.positions.end(),
                         cut.mesh.positions.begin()));
}

TEST_P(PartitionTest, EveryCellIsADisk) {
  ASSERT_TRUE(result->report.simplicial);
  const std::size_t n = result->sites.size();
  std::vector<std::set<std::int32_t>> vertices(n);
  std::vector<std::set<std::pair<std::int32_t, std::int32_t>>> edges(n);
  std::vector<int> faces(n), rim(n);
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> left;
  for (std::size_t f = 0; f < cut.cell.size(); ++f) {
    const std::size_t c = index(cut.cell[f]);
    ++faces[c];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = cut.mesh.faces[f][k], b = cut.mesh.faces[f][(k + 1) % 3];
      vertices[c].insert(a);
      edges[c].insert({std::min(a, b), std::max(a, b)});
      left[{a, b}] = cut.cell[f];
    }
  }
  // One loop round it: as many vertices as edges on the rim, and Euler number 1.
  std::vector<std::set<std::int32_t>> rim_vertices(n);
  std::vector<std::set<std::int32_t>> across(n);
  for (const auto& [edge, c] : left) {
    const std::int32_t other = left.at({edge.second, edge.first});
    if (other != c) {
      ++rim[index(c)];
      rim_vertices[index(c)].insert(edge.first);
      across[index(c)].insert(other);
    }
  }
  for (std::size_t c = 0; c < n; ++c) {
    EXPECT_EQ(static_cast<int>(vertices[c].size()) - static_cast<int>(edges[c].size()) + faces[c],
              1);
    EXPECT_EQ(static_cast<int>(rim_vertices[c].size()), rim[c]);
    EXPECT_EQ(std::vector<std::int32_t>(across[c].begin(), across[c].end()),
              cut.cells[c].neighbours);
    EXPECT_EQ(cut.cells[c].degree, static_cast<int>(cut.cells[c].neighbours.size()));
    for (const std::int32_t other : cut.cells[c].neighbours) {
      EXPECT_NE(cut.cells[c].colour, cut.cells[index(other)].colour);
    }
  }
  EXPECT_LE(cut.colours, surface.genus == 0 ? 6 : 7);
}

TEST_P(PartitionTest, FillsEveryFaceOfTheInputExactly) {
  std::vector<double> filled(surface.mesh.faces.size()), of_cell(cut.cells.size());
  std::vector<std::map<std::int32_t, double>> shares(filled.size());
  for (std::size_t f = 0; f < cut.mesh.faces.size(); ++f) {
    const Corners& outer = surface.mesh.faces[index(cut.input_face[f])];
    const Position normal = area_vector(surface.mesh, outer);
    const double size = std::sqrt(dot(normal, normal));
    const double area = dot(area_vector(cut.mesh, cut.mesh.faces[f]), normal) / size / 2;
    EXPECT_GT(area, -1e-14 * size) << "turned over";
    filled[index(cut.input_face[f])] += area, of_cell[index(cut.cell[f])] += area;
    shares[index(cut.input_face[f])][cut.cell[f]] += area;
    for (const std::int32_t v : cut.mesh.faces[f]) {
      const Position& p = cut.mesh.positions[index(v)];
      const Position& a = surface.mesh.positions[index(outer[0])];
      EXPECT_LT(std::abs(dot(minus(p, a), normal)) / size, 1e-13 * std::sqrt(size));
      for (std::size_t k = 0; k < 3; ++k) {
        const Position& u = surface.mesh.positions[index(outer[k])];
        const Position& w = surface.mesh.positions[index(outer[(k + 1) % 3])];
        EXPECT_GT(dot(crossed(minus(w, u), minus(p, u)), normal) / size / size, -1e-13);
      }
    }
  }
  for (std::size_t f = 0; f < filled.size(); ++f) {
    const Position normal = area_vector(surface.mesh, surface.mesh.faces[f]);
    EXPECT_NEAR(filled[f] / (std::sqrt(dot(normal, normal)) / 2), 1, 1e-12);
    for (const auto& [cell, area] : shares[f]) {
      EXPECT_LE(area, shares[f][cut.face_cell[f]] * (1 + 1e-12));
    }
  }
  const double total = survey(surface.mesh).area;
  EXPECT_NEAR(std::accumulate(of_cell.begin(), of_cell.end(), 0.0) / total, 1, 1e-12);
  for (std::size_t c = 0; c < of_cell.size(); ++c) {
    EXPECT_NEAR(cut.cells[c].area_3d / of_cell[c], 1, 1e-9);
  }
}

TEST_P(PartitionTest, CellsHoldTheirSitesAndVertices) {
  for (std::size_t f = 0; f < cut.mesh.faces.size(); ++f) {
    for (const std::int32_t v : cut.mesh.faces[f]) {
      if (index(v) < cut.vertex_cell.size()) {
        EXPECT_EQ(cut.vertex_cell[index(v)], cut.cell[f]);
      }
    }
  }
  // The site's nearest face of the cut surface, by the distance to its inside, bears its number.
  for (std::size_t c = 0; c < cut.cells.size(); ++c) {
    double least = HUGE_VAL;
    std::int32_t owner = -1;
    for (std::size_t f = 0; f < cut.mesh.faces.size(); ++f) {
      const Corners& t = cut.mesh.faces[f];
      const Position n = area_vector(cut.mesh, t), &p = cut.cells[c].site;
      const double size = std::sqrt(dot(n, n));
      double out = std::abs(dot(n, minus(p, cut.mesh.positions[index(t[0])]))) / size;
      for (std::size_t k = 0; k < 3; ++k) {
        const Position& u = cut.mesh.positions[index(t[k])];
        const Position& w = cut.mesh.positions[index(t[(k + 1) % 3])];
        const Position side = minus(w, u);
        out =
            std::max(out, -dot(crossed(side, minus(p, u)), n) / size / std::sqrt(dot(side, side)));
      }
      if (out < least) {
        least = out, owner = cut.cell[f];
      }
    }
    EXPECT_EQ(owner, static_cast<std::int32_t>(c));
  }
}

TEST_P(PartitionTest, AgreesWithTheMomentsOfTheCells) {
  // Cells' areas by a density that is linear on T's faces: the same to a few per cent.
  double total = 0;
  for (const PartitionCell& c : cut.cells) {
    total += c.area_3d;
  }
  EXPECT_NEAR(result->cell_area_3d.mean * static_cast<double>(cut.cells.size()) / total, 1, 1e-2);
  double area = 0;
  for (const PartitionCell& c : cut.cells) {
    area += c.area;
    EXPECT_GT(c.radius, c.nearest / 2);
  }
  EXPECT_NEAR(area / result->surface.report().area, 1, 1e-9);
}

TEST_P(PartitionTest, IsTheSameEveryTime) {
  const Partition again = partition(*result);
  EXPECT_EQ(again.mesh.positions, cut.mesh.positions);
  EXPECT_EQ(again.mesh.faces, cut.mesh.faces);
  EXPECT_EQ(again.cell, cut.cell);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, PartitionTest,
    testing::Values(Case{"sphere", oracle::icosphere(2), 40}, Case{"cube", oracle::cube(), 100},
                    Case{"four_on_a_tetrahedron", oracle::tetrahedron(), 4},
                    Case{"torus", oracle::grid_torus(16, 10), 60},
                    Case{"bumpy_torus", oracle::bumpy(oracle::grid_torus(24, 12), 0.05, 1), 30},
                    Case{"seven_vertex_torus", oracle::seven_vertex_torus(), 50},
                    Case{"double_torus", oracle::voxel_frame(2), 80}),
    [](const auto& name) { return std::string(name.param.name); });

TEST(Partition, FewSitesThatAreNotSimplicialStillMakeAClosedSurface) {
  for (const auto& mesh : {oracle::grid_torus(16, 10), oracle::voxel_frame(2)}) {
    const ClosedSurface surface = oracle::closed(mesh);
    for (const int n : {1, 2, 5}) {
      RemeshOptions options;
      options.sites = n, options.iterations = 20, options.ensure_simplicial = false;
      options.init = InitialSites::Random;
      const Partition cut = partition(remesh(surface, options));
      EXPECT_EQ(closed_surface(cut.mesh).genus, surface.genus);
      EXPECT_EQ(std::set<std::int32_t>(cut.cell.begin(), cut.cell.end()).size(),
                static_cast<std::size_t>(n));
      EXPECT_NEAR(survey(cut.mesh).area / survey(surface.mesh).area, 1, 1e-9);
    }
  }
}

TEST(Partition, SymmetricSitesWithCocircularNeighboursAreCut) {
  // Sites at the corners' opposite: eight on a cube, whose Voronoi vertices fall together in pairs.
  const ClosedSurface surface = oracle::closed(oracle::cube());
  RemeshOptions options;
  options.iterations = 0, options.ensure_simplicial = false;
  options.refine_for = 1;  // T is the cube itself
  for (std::int32_t f = 0; f < 12; ++f) {
    options.initial_sites.push_back({f, {0.5, 0.25, 0.25}});
  }
  const Partition cut = partition(remesh(surface, options));
  EXPECT_EQ(closed_surface(cut.mesh).genus, 0);
  EXPECT_EQ(cut.cells.size(), 12u);
}

TEST(PartitionFiles, HoldWhatTheySay) {
  const ClosedSurface surface = oracle::closed(oracle::cube());
  RemeshOptions options;
  options.sites = 20, options.iterations = 5;
  const Partition cut = partition(remesh(surface, options));
  std::string folder = (std::filesystem::temp_directory_path() / "ucvt-part-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  write_partition(folder + "/p.ply", cut);
  write_labels(folder + "/labels.csv", cut, {0, 1, 5, 6, 7, 8, 9, 10});
  write_cells(folder + "/cells.csv", cut);
  const TriangleMesh back = read_mesh(folder + "/p.ply");
  EXPECT_EQ(back.positions, cut.mesh.positions);
  EXPECT_EQ(back.faces, cut.mesh.faces);
  const auto lines = [&](const char* name) {
    std::ifstream in(folder + name);
    std::vector<std::string> out;
    for (std::string line; std::getline(in, line);) {
      out.push_back(line);
    }
    return out;
  };
  const auto labels = lines("/labels.csv"), cells = lines("/cells.csv");
  ASSERT_EQ(labels.size(), 1 + 8 + 12u);
  EXPECT_EQ(labels[0], "element,number,cell");
  EXPECT_EQ(labels[3], "vertex,5," + std::to_string(cut.vertex_cell[2]));
  EXPECT_EQ(labels[9], "face,0," + std::to_string(cut.face_cell[0]));
  ASSERT_EQ(cells.size(), 1 + cut.cells.size());
  const auto columns = [](const std::string& s) { return std::count(s.begin(), s.end(), ','); };
  EXPECT_EQ(columns(cells[0]), columns(cells[1]));
  std::filesystem::remove_all(folder);
  EXPECT_THROW(write_partition("/no/such/folder/p.ply", cut), IoError);
}

TEST(Colouring, NeighboursDiffer) {
  // A wheel with an even rim takes three colours, one with an odd rim four; a loop is passed over.
  for (const std::int32_t rim : {6, 7}) {
    std::vector<std::vector<std::int32_t>> graph(index(rim + 1));
    graph[0].push_back(0);
    for (std::int32_t i = 1; i <= rim; ++i) {
      graph[0].push_back(i);
      graph[index(i)] = {0, i == rim ? 1 : i + 1, i == 1 ? rim : i - 1};
    }
    const auto colour = colour_graph(graph);
    EXPECT_EQ(*std::max_element(colour.begin(), colour.end()), rim == 6 ? 2 : 3);
  }
}

TEST(PolygonTriangles, TwoSidesOfAFlatCornerDoNotCutTheSameDiagonal) {
  // Two points of a line together to rounding, which either side may see bend its way.
  const std::array<double, 3> a{0.6, 0.2, 0.2}, b{0.2, 0.6, 0.2}, up{0.2, 0.2, 0.6},
      down{0.45, 0.45, 0.1}, twice{0.6 - 1e-16, 0.2, 0.2 + 1e-16};
  const std::vector<std::array<double, 3>> corner{a, twice, b, up, down};
  for (const auto& [first, second] : {std::pair{0, 1}, {1, 0}}) {
    for (const std::vector<std::int32_t>& above :
         {std::vector<std::int32_t>{first, second, 2, 3}, {second, 2, 3, first}}) {
      for (const std::vector<std::int32_t>& below :
           {std::vector<std::int32_t>{2, second, first, 4}, {first, 4, 2, second}}) {
        int uses = 0;
        for (const auto& round : {above, below}) {
          std::vector<std::array<double, 3>> polygon;
          for (const std::int32_t i : round) {
            polygon.push_back(corner[index(i)]);
          }
          for (const Corners& f : triangulate_polygon(polygon).triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
              const std::size_t p = index(f[k]), q = index(f[(k + 1) % 3]);
              uses += p < 4 && q < 4 && std::minmax(round[p], round[q]) == std::minmax(first, 2);
            }
          }
        }
        EXPECT_LE(uses, 2) << "triangles at the line from a to b";
      }
    }
  }
}

}  // namespace
}  // namespace ucvt
