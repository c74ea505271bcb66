#include "conformal/uniformize.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "conformal/metric_solver.h"
#include "oracle/surfaces.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// The Delaunay condition in chords, the same in all three geometries.
double worst_delaunay(const UniformSurface& t) {
  double worst = 4;
  for (std::size_t i = 0; i < t.chords().size(); ++i) {
    double sum = 0;
    for (const Halfedge h : {Halfedge{static_cast<std::int32_t>(i)},
                             t.connectivity().twin({static_cast<std::int32_t>(i)})}) {
      const double a = t.chord(h.next()), b = t.chord(h.prev()), c = t.chord(h);
      sum += a / b + b / a - (c / a) * (c / b);
    }
    worst = std::min(worst, sum);
  }
  return worst;
}

/// Everything that uniformize promises.
void expect_uniform(const Uniformized& u) {
  const UniformSurface& t = u.surface;
  const Connectivity& c = t.connectivity();
  EXPECT_LE(oracle::worst_angle_error(t), 1e-10);
  EXPECT_LE(u.report.max_angle_error, 1e-10);
  double area = 0;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    area += t.area({static_cast<std::int32_t>(f)});
  }
  // The plane's scale is free; whatever it is, the report says it.
  const double wanted = t.space().kappa == 0 ? u.report.area : oracle::gauss_bonnet_area(t);
  EXPECT_NEAR(area / wanted, 1, 1e-9);
  EXPECT_NEAR(u.report.area / wanted, 1, 1e-9);
  EXPECT_GT(worst_delaunay(t), -1e-7);
  ASSERT_EQ(u.log_scale.size(), c.vertex_count());
  // Discrete conformality: edges of the input that no flip touched keep their length up to scales.
  std::set<std::int32_t> touched;
  for (const Change& change : u.intrinsic.log.changes()) {
    touched.insert({change.h.id, change.t.id});
    for (const Halfedge h : {change.h, change.t}) {
      touched.insert({h.next().id, h.prev().id});
    }
  }
  for (std::size_t f = 0; f < u.input.faces.size(); ++f) {
    for (const Halfedge h : halfedges({static_cast<std::int32_t>(f)})) {
      if (touched.contains(h.id)) {
        continue;
      }
      const Position& p = u.input.positions[c.origin(h).index()];
      const Position& q = u.input.positions[c.head(h).index()];
      const double length = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      const double scale =
          std::exp((u.log_scale[c.origin(h).index()] + u.log_scale[c.head(h).index()]) / 2);
      EXPECT_NEAR(t.chord(h) / (scale * length), 1, 1e-9);
    }
  }
}

struct Case {
  const char* name;
  TriangleMesh mesh;
  const char* geometry;
};

class UniformizeTest : public testing::TestWithParam<Case> {};

TEST_P(UniformizeTest, KeepsItsPromises) {
  const Uniformized u = uniformize_surface(oracle::closed(GetParam().mesh), {});
  EXPECT_EQ(u.report.geometry, GetParam().geometry);
  expect_uniform(u);
}

TEST_P(UniformizeTest, IsTheSameAtEveryScale) {
  const Uniformized u = uniformize_surface(oracle::closed(GetParam().mesh), {});
  for (const double factor : {1e-12, 1e30}) {
    const auto other =
        uniformize_surface(oracle::closed(oracle::scaled(GetParam().mesh, factor)), {});
    const double unit =
        u.surface.space().kappa == 0 ? std::sqrt(other.report.area / u.report.area) : 1;
    ASSERT_EQ(other.surface.chords().size(), u.surface.chords().size());
    // Flips of cocircular points may differ; chords are compared as a multiset.
    auto a = u.surface.chords(), b = other.surface.chords();
    std::ranges::sort(a), std::ranges::sort(b);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(b[i] / (unit * a[i]), 1, 1e-6);
    }
  }
}

TEST_P(UniformizeTest, VerticesAndPointsComeBackToTheInput) {
  const TriangleMesh& mesh = GetParam().mesh;
  const Uniformized u = uniformize_surface(oracle::closed(mesh), {});
  const Connectivity& c = u.surface.connectivity();
  std::vector<SurfacePoint> corners;
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    const Halfedge h = c.outgoing({static_cast<std::int32_t>(v)});
    corners.push_back({h.face(), {0, 0, 0}});
    corners.back().bary[static_cast<std::size_t>(h.id % 3)] = 1;
  }
  const auto at = positions_on_input(u, corners);
  const double size = survey(mesh).bbox_diagonal;
  for (std::size_t v = 0; v < at.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(at[v][k], u.input.positions[v][k], 1e-9 * size);
    }
  }
  // Points lie on some face's plane, inside it.
  for (const Position& p : positions_on_input(u, oracle::random_points(u.surface, 40, 5))) {
    double least = HUGE_VAL;
    for (const Corners& f : u.input.faces) {
      const auto corner = [&](std::size_t i) {
        return u.input.positions[static_cast<std::size_t>(f[i])];
      };
      const Position a = corner(0), b = corner(1), d = corner(2);
      const auto minus = [](const Position& x, const Position& y) {
        return Position{x[0] - y[0], x[1] - y[1], x[2] - y[2]};
      };
      const auto crossed = [](const Position& x, const Position& y) {
        return Position{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
                        x[0] * y[1] - x[1] * y[0]};
      };
      const auto dot = [](const Position& x, const Position& y) {
        return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
      };
      const Position n = crossed(minus(b, a), minus(d, a));
      const double nn = dot(n, n);
      if (nn == 0) {
        continue;
      }
      double out = std::abs(dot(n, minus(p, a))) / std::sqrt(nn) / size;
      for (const auto& [x, y] : {std::pair{a, b}, {b, d}, {d, a}}) {
        out = std::max(out, -dot(n, crossed(minus(y, x), minus(p, x))) / nn);
      }
      least = std::min(least, out);
    }
    EXPECT_LT(least, 1e-9);
  }
}

TEST_P(UniformizeTest, RefinesToTheAskedLength) {
  const TriangleMesh& mesh = GetParam().mesh;
  UniformizeOptions options;
  options.longest_edge = std::sqrt(survey(mesh).area / 400);
  const Uniformized u = uniformize_surface(oracle::closed(mesh), options);
  EXPECT_LE(oracle::worst_angle_error(u.surface), 1e-10);
  EXPECT_GT(u.surface.connectivity().vertex_count(), mesh.positions.size());
  EXPECT_EQ(static_cast<std::size_t>(u.report.refined_vertices),
            u.surface.connectivity().vertex_count() - mesh.positions.size());
  double area = 0;
  for (const double a : u.vertex_area_3d) {
    area += a;
  }
  EXPECT_NEAR(area / survey(mesh).area, 1, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, UniformizeTest,
    testing::Values(
        Case{"tetrahedron", oracle::tetrahedron(), "spherical"},
        Case{"cube", oracle::cube(), "spherical"},
        Case{"octahedron", oracle::octahedron(), "spherical"},
        Case{"icosphere", oracle::icosphere(2), "spherical"},
        Case{"bumpy_sphere", oracle::bumpy(oracle::icosphere(2), 0.12, 4), "spherical"},
        Case{"latitudes", oracle::latitude_sphere(7, 10), "spherical"},
        Case{"torus_of_seven", oracle::seven_vertex_torus(), "euclidean"},
        Case{"torus", oracle::grid_torus(12, 8), "euclidean"},
        Case{"bumpy_torus", oracle::bumpy(oracle::grid_torus(12, 8), 0.1, 3), "euclidean"},
        Case{"double_torus", oracle::voxel_frame(2), "hyperbolic"},
        Case{"bumpy_double_torus", oracle::bumpy(oracle::voxel_frame(2), 0.25, 5), "hyperbolic"},
        Case{"triple_torus", oracle::voxel_frame(3), "hyperbolic"}),
    [](const auto& name) { return std::string(name.param.name); });

TEST(Uniformize, ALongFingerSpansManyScales) {
  const Uniformized u = uniformize_surface(oracle::closed(oracle::finger(3, 0.1, 10)), {});
  expect_uniform(u);
  EXPECT_GT(u.report.log_scale_max - u.report.log_scale_min, 15);
}

TEST(Uniformize, AFaceWithoutAreaIsMended) {
  TriangleMesh mesh = oracle::grid_torus(8, 6);
  const Corners f = mesh.faces[10];
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](std::size_t i) -> double& {
      return mesh.positions[static_cast<std::size_t>(f[i])][k];
    };
    at(0) = (at(1) + at(2)) / 2;
  }
  const Uniformized u = uniformize_surface(oracle::closed(mesh), {});
  EXPECT_LE(oracle::worst_angle_error(u.surface), 1e-10);
  EXPECT_GT(worst_delaunay(u.surface), -1e-7);
}

TEST(Uniformize, CoincidentVerticesAreMended) {
  TriangleMesh mesh = oracle::grid_torus(8, 6);
  const Corners f = mesh.faces[10];
  mesh.positions[static_cast<std::size_t>(f[0])] = mesh.positions[static_cast<std::size_t>(f[1])];
  const Uniformized u = uniformize_surface(oracle::closed(mesh), {});
  EXPECT_LE(oracle::worst_angle_error(u.surface), 1e-10);
  EXPECT_GT(worst_delaunay(u.surface), -1e-7);
}

TEST(Uniformize, TheSphereIsBalanced) {
  // An icosphere is its own uniformization: inscribed, its centroid at the centre.
  const TriangleMesh mesh = oracle::icosphere(2);
  const Uniformized u = uniformize_surface(oracle::closed(mesh), {});
  const UniformSurface t = oracle::sphere(mesh);
  for (std::size_t i = 0; i < t.chords().size(); ++i) {
    const auto all = t.chords();
    double least = 1;
    for (const double c : all) {
      least = std::min(least, std::abs(c - u.surface.chords()[i]));
    }
    EXPECT_LT(least, 1e-7);
  }
  EXPECT_LT(u.report.log_scale_max - u.report.log_scale_min, 1e-6);
}

TEST(Uniformize, FewStepsFromAnInversion) {
  // Large enough for multigrid; from the input's metric it takes twice as many steps.
  const TriangleMesh mesh = oracle::bumpy(oracle::icosphere(5), 0.01, 3);
  const Uniformized u = uniformize_surface(oracle::closed(mesh), {});
  expect_uniform(u);
  EXPECT_LE(u.report.newton_iterations, 5);
}

TEST(Uniformize, RefusesAPointAndStopsWhenTold) {
  EXPECT_THROW(uniformize_surface(oracle::closed(oracle::scaled(oracle::cube(), 0)), {}),
               InvalidInput);
  UniformizeOptions options;
  options.monitor = [](const Progress&) { return false; };
  EXPECT_THROW(uniformize_surface(oracle::closed(oracle::voxel_frame(2)), options), Cancelled);
}

// ---- the solver

struct Trial {
  IntrinsicTriangulation t;
  std::vector<double> u;
};

TEST(MetricSolver, ConvergesQuadraticallyNearTheSolution) {
  for (const TriangleMesh& mesh :
       {oracle::voxel_frame(2), oracle::bumpy(oracle::grid_torus(9, 7), 0.1, 3)}) {
    const Uniformized solved = uniformize_surface(oracle::closed(mesh), {});
    Trial trial{solved.intrinsic, solved.log_scale};
    std::vector<VertexRole> role(trial.u.size(), VertexRole::Solved);
    if (solved.surface.space().kappa == 0) {
      role[0] = VertexRole::Held;
    }
    for (std::size_t v = 1; v < trial.u.size(); ++v) {
      trial.u[v] += 0.01 * std::sin(3.0 * static_cast<double>(v));
    }
    std::vector<double> error;
    MetricSolver solver(solved.surface.space(), trial.t, trial.u, role);
    double first = 0;
    for (const double sum : solver.angle_sums()) {
      first = std::max(first, std::abs(sum - 2 * std::numbers::pi));
    }
    error.push_back(first);
    const auto result = solver.solve(1e-11, 20, [&](int, double e) {
      error.push_back(e);
      return true;
    });
    EXPECT_TRUE(result.converged);
    // Every full step squares the error; no wrong Hessian does that.
    for (std::size_t i = 1; i < error.size(); ++i) {
      EXPECT_LT(error[i], std::max(30 * error[i - 1] * error[i - 1], 1e-11)) << i;
    }
    EXPECT_LE(result.iterations, 5);
  }
}

TEST(MetricSolver, CountsVerticesHeldToFixAnIsometry) {
  const Uniformized torus = uniformize_surface(oracle::closed(oracle::grid_torus(9, 7)), {});
  Trial trial{torus.intrinsic, torus.log_scale};
  std::vector<VertexRole> role(trial.u.size(), VertexRole::Held);
  trial.u[0] += 0.1;
  const auto result = MetricSolver({0}, trial.t, trial.u, role).solve(1e-11, 5, {});
  EXPECT_FALSE(result.converged);
  EXPECT_GT(result.max_angle_error, 0.01);
}

TEST(MetricSolver, AngleSumsAreThoseOfTheSurface) {
  const Uniformized& u = oracle::double_torus();
  Trial trial{u.intrinsic, u.log_scale};
  MetricSolver solver({-1}, trial.t, trial.u,
                      std::vector<VertexRole>(trial.u.size(), VertexRole::Solved));
  const auto& sums = solver.angle_sums();
  for (std::size_t v = 0; v < trial.u.size(); ++v) {
    EXPECT_NEAR(sums[v], 2 * std::numbers::pi, 1e-10);
  }
}

}  // namespace
}  // namespace ucvt
