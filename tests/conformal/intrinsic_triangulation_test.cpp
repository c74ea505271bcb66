#include "conformal/intrinsic_triangulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "oracle/meshes.h"
#include "oracle/surfaces.h"
#include "space/moments.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

double length(const IntrinsicTriangulation& t, Halfedge h) {
  return std::exp(t.log_length[h.index()]);
}

double area(const IntrinsicTriangulation& t) {
  const auto areas = euclidean_vertex_areas(t);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

/// Angle sums by the law of cosines.
std::vector<double> angle_sums(const IntrinsicTriangulation& t) {
  std::vector<double> out(t.connectivity.vertex_count());
  for (std::size_t i = 0; i < t.log_length.size(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const double a = length(t, h), b = length(t, h.prev()), c = length(t, h.next());
    out[t.connectivity.origin(h).index()] += std::acos((a * a + b * b - c * c) / (2 * a * b));
  }
  return out;
}

bool twins_agree(const IntrinsicTriangulation& t) {
  for (std::size_t i = 0; i < t.log_length.size(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (t.log_length[i] != t.log_length[t.connectivity.twin(h).index()]) {
      return false;
    }
  }
  return true;
}

std::vector<TriangleMesh> meshes() {
  return {oracle::cube(), oracle::seven_vertex_torus(), oracle::voxel_frame(2),
          oracle::bumpy(oracle::grid_torus(9, 7), 0.15, 1),
          oracle::bumpy(oracle::icosphere(2), 0.1, 2)};
}

TEST(IntrinsicTriangulation, HasTheLengthsOfTheMesh) {
  for (const TriangleMesh& mesh : meshes()) {
    const IntrinsicTriangulation t = intrinsic_triangulation(mesh);
    EXPECT_TRUE(twins_agree(t));
    EXPECT_NEAR(area(t) / survey(mesh).area, 1, 1e-12);
    for (std::size_t i = 0; i < t.log_length.size(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)};
      const Position& p = mesh.positions[t.connectivity.origin(h).index()];
      const Position& q = mesh.positions[t.connectivity.head(h).index()];
      EXPECT_NEAR(length(t, h) / std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 1, 1e-14);
    }
  }
}

TEST(IntrinsicTriangulation, EuclideanFlipsKeepTheMetricAndEndDelaunay) {
  for (const TriangleMesh& mesh : meshes()) {
    IntrinsicTriangulation t = intrinsic_triangulation(mesh);
    const auto before = angle_sums(t);
    const double area_before = area(t);
    make_euclidean_delaunay(t);
    const auto after = angle_sums(t);
    EXPECT_TRUE(twins_agree(t));
    EXPECT_NEAR(area(t) / area_before, 1, 1e-12);
    for (std::size_t v = 0; v < before.size(); ++v) {
      EXPECT_NEAR(after[v], before[v], 1e-10);
    }
    for (std::size_t i = 0; i < t.log_length.size(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)};
      double opposite = 0;
      for (const Halfedge g : {h, t.connectivity.twin(h)}) {
        const double a = length(t, g.next()), b = length(t, g.prev()), c = length(t, g);
        opposite += std::acos((a * a + b * b - c * c) / (2 * a * b));
      }
      EXPECT_LT(opposite, std::numbers::pi + 1e-7);
    }
    EXPECT_EQ(t.euclidean_flips, static_cast<std::int64_t>(t.log.size()));
  }
}

TEST(IntrinsicTriangulation, AFlipOfASquareKnowsItsDiagonal) {
  // The cube's faces are squares: any flip of a diagonal gives one of the same length.
  IntrinsicTriangulation t = intrinsic_triangulation(oracle::cube());
  const Halfedge diagonal{2};
  ASSERT_NEAR(length(t, diagonal), 2 * std::numbers::sqrt2 / std::numbers::sqrt3, 1e-15);
  ptolemy_flip(t, diagonal);
  EXPECT_NEAR(length(t, diagonal), 2 * std::numbers::sqrt2 / std::numbers::sqrt3, 1e-15);
  EXPECT_EQ(t.ptolemy_flips, 1);
}

TEST(IntrinsicTriangulation, PtolemyFlipsComeBackAfterFour) {
  for (const TriangleMesh& mesh : meshes()) {
    IntrinsicTriangulation t = intrinsic_triangulation(mesh);
    const auto before = t.log_length;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)};
      if (t.connectivity.twin(h).face() == h.face()) {
        continue;
      }
      for (int n = 0; n < 4; ++n) {
        ptolemy_flip(t, h);
      }
      ASSERT_TRUE(twins_agree(t));
      for (std::size_t j = 0; j < before.size(); ++j) {
        ASSERT_NEAR(t.log_length[j], before[j], 1e-12);
      }
    }
  }
}

TEST(IntrinsicTriangulation, PtolemyFlipsCommuteWithScalings) {
  IntrinsicTriangulation t = intrinsic_triangulation(oracle::voxel_frame(2)), scaled = t;
  std::mt19937_64 random(4);
  std::vector<double> u(t.connectivity.vertex_count());
  for (double& x : u) {
    x = 40 * (oracle::uniform(random) - 0.5);
  }
  const auto ends = [&](Halfedge h) {
    return (u[t.connectivity.origin(h).index()] + u[t.connectivity.head(h).index()]) / 2;
  };
  for (std::size_t i = 0; i < t.log_length.size(); ++i) {
    scaled.log_length[i] += ends({static_cast<std::int32_t>(i)});
  }
  for (int n = 0; n < 300; ++n) {
    const Halfedge h{static_cast<std::int32_t>(random() % t.log_length.size())};
    if (t.connectivity.twin(h).face() != h.face()) {
      ptolemy_flip(t, h), ptolemy_flip(scaled, h);
    }
  }
  for (std::size_t i = 0; i < t.log_length.size(); ++i) {
    EXPECT_NEAR(scaled.log_length[i], t.log_length[i] + ends({static_cast<std::int32_t>(i)}), 1e-9);
  }
}

TEST(IntrinsicTriangulation, RefiningKeepsTheSurfaceAndLeavesNoLongEdge) {
  for (const TriangleMesh& mesh : meshes()) {
    IntrinsicTriangulation t = intrinsic_triangulation(mesh);
    make_euclidean_delaunay(t);
    const double longest = std::sqrt(area(t) / 300), before = area(t);
    const auto sums = angle_sums(t);
    const auto chi = t.connectivity.euler_number();
    std::vector<double> size(t.connectivity.vertex_count(), longest), log_scale(size.size());
    refine(t, size, log_scale);
    EXPECT_TRUE(twins_agree(t));
    EXPECT_EQ(size.size(), t.connectivity.vertex_count());
    EXPECT_EQ(log_scale.size(), t.connectivity.vertex_count());
    EXPECT_EQ(static_cast<std::size_t>(t.splits), t.connectivity.vertex_count() - sums.size());
    EXPECT_GT(t.splits, 50);
    EXPECT_EQ(t.connectivity.euler_number(), chi);
    EXPECT_NEAR(area(t) / before, 1, 1e-10);
    EXPECT_LE(std::exp(*std::ranges::max_element(t.log_length)), longest * (1 + 1e-12));
    const auto after = angle_sums(t);
    for (std::size_t v = 0; v < after.size(); ++v) {
      EXPECT_NEAR(after[v], v < sums.size() ? sums[v] : 2 * std::numbers::pi, 1e-8);
    }
  }
}

TEST(IntrinsicTriangulation, DegenerateFacesGetRoomAndNothingElseIsTouched) {
  TriangleMesh mesh = oracle::octahedron();
  mesh.positions[5] = mesh.positions[3];
  const IntrinsicTriangulation t = intrinsic_triangulation(mesh);
  for (std::size_t i = 0; i < t.log_length.size(); ++i) {
    EXPECT_TRUE(std::isfinite(t.log_length[i]));
  }
  for (const double a : euclidean_vertex_areas(t)) {
    EXPECT_GT(a, 0);
  }
  for (Position& p : mesh.positions) {
    p = {1, 2, 3};
  }
  EXPECT_THROW(intrinsic_triangulation(mesh), InvalidInput);
}

TEST(IntrinsicTriangulation, RefusesASurfaceOnALine) {
  TriangleMesh mesh = oracle::grid_torus(8, 6);
  for (Position& p : mesh.positions) {
    p = {p[0], p[0] / 2, 0.1};
  }
  EXPECT_THROW(intrinsic_triangulation(mesh), InvalidInput);
}

// ---- the log

/// Random weights in random faces.
std::vector<HomogeneousPoint> random_points(std::size_t faces, std::size_t n) {
  std::mt19937_64 random(12);
  std::vector<HomogeneousPoint> out;
  while (out.size() < n) {
    out.push_back({{static_cast<std::int32_t>(random() % faces)},
                   {oracle::uniform(random), oracle::uniform(random), oracle::uniform(random)}});
  }
  return out;
}

TEST(ChangeLog, FourFlipsCarryEveryPointBackToItself) {
  for (const TriangleMesh& mesh : meshes()) {
    IntrinsicTriangulation t = intrinsic_triangulation(mesh);
    std::mt19937_64 random(3);
    for (int n = 0; n < 30; ++n) {
      const Halfedge h{static_cast<std::int32_t>(random() % t.log_length.size())};
      if (t.connectivity.twin(h).face() != h.face()) {
        for (int i = 0; i < 4; ++i) {
          ptolemy_flip(t, h);
        }
      }
    }
    const auto before = random_points(mesh.faces.size(), 300);
    auto after = before;
    t.log.undo(after);
    for (std::size_t p = 0; p < before.size(); ++p) {
      const auto &a = before[p].weight, &b = after[p].weight;
      ASSERT_EQ(after[p].face, before[p].face);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(b[i] * (a[0] + a[1] + a[2]), a[i] * (b[0] + b[1] + b[2]), 1e-9);
      }
    }
  }
}

TEST(ChangeLog, PointsOfRefinedFlatSurfacesComeBackWhereTheyAre) {
  // A flat square torus cannot lie in space, a prism can: split and flip its plane sides and see
  // that the vertices of the refined surface come back to the middles they were made at.
  const TriangleMesh mesh = oracle::cube();
  IntrinsicTriangulation t = intrinsic_triangulation(mesh);
  make_euclidean_delaunay(t);
  const auto height = [](const Position& p) { return p[0] + 2 * p[1] + 3 * p[2]; };
  std::vector<double> size(8, 0.2), log_scale;
  for (const Position& p : mesh.positions) {
    log_scale.push_back(height(p));
  }
  refine(t, size, log_scale);
  std::vector<HomogeneousPoint> points;
  for (std::size_t f = 0; f < t.connectivity.face_count(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      points.push_back({{static_cast<std::int32_t>(f)}, {0, 0, 0}});
      points.back().weight[i] = 1;
    }
  }
  t.log.undo(points);
  std::vector<Position> at;
  for (const HomogeneousPoint& p : points) {
    Position x{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Position& c = mesh.positions[static_cast<std::size_t>(mesh.faces[p.face.index()][i])];
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] += p.weight[i] * c[k] / (p.weight[0] + p.weight[1] + p.weight[2]);
      }
    }
    at.push_back(x);
  }
  int compared = 0, carried = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const Position &p = at[i], &q = at[h.next().index()];
    carried += std::abs(log_scale[t.connectivity.origin(h).index()] - height(p)) < 1e-9 ? 1 : 0;
    const Position& r = at[t.connectivity.twin(h).index()];
    EXPECT_LT(std::hypot(q[0] - r[0], q[1] - r[1], q[2] - r[2]), 1e-9) << "a vertex is one point";
    const double chord = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    EXPECT_LE(chord, length(t, h) * (1 + 1e-9));
    compared += chord > length(t, h) * (1 - 1e-9) ? 1 : 0;
  }
  // Most edges lie in one side of the cube and are as long as in the metric.
  EXPECT_GT(compared, static_cast<int>(points.size()) / 2);
  // So do the means of ends, of a function that is linear there.
  EXPECT_GT(carried, static_cast<int>(points.size()) / 2);
}

TEST(Refine, FacesThatAreNeighboursHaveNumbersNearEachOther) {
  const TriangleMesh mesh = oracle::grid_torus(20, 12);
  IntrinsicTriangulation t = intrinsic_triangulation(mesh);
  make_euclidean_delaunay(t);
  std::vector<double> size(mesh.positions.size(), 0.03), log_scale(size.size());
  refine(t, size, log_scale);
  const Connectivity& c = t.connectivity;
  ASSERT_GT(c.face_count(), 20 * mesh.faces.size());
  std::size_t near = 0;
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    near += std::abs(c.twin(h).face().id - h.face().id) < 200 ? 1 : 0;
  }
  EXPECT_GT(near, c.halfedge_count() * 3 / 4);
  // The input's numbers are not lost, each once.
  std::set<std::int32_t> names;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    names.insert(t.log.first_name({static_cast<std::int32_t>(f)}).id);
  }
  EXPECT_EQ(names.size(), c.face_count());
  EXPECT_EQ(*names.rbegin(), static_cast<std::int32_t>(c.face_count()) - 1);
}

}  // namespace
}  // namespace ucvt
