#include "cvt/mirror_sites.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "conformal/uniformize.h"
#include "mesh/doubled_surface.h"
#include "mesh/edge_bisection.h"
#include "oracle/open_meshes.h"

namespace ucvt {
namespace {

SurfacePoint at_vertex(const UniformSurface& t, std::int32_t v) {
  const Halfedge h = t.connectivity().outgoing({v});
  SurfacePoint p{h.face(), {0, 0, 0}};
  p.bary[static_cast<std::size_t>(h.id % 3)] = 1;
  return p;
}

/// A double with every seventh vertex a site, boundary vertices and inner ones alike.
struct Doubled {
  explicit Doubled(const TriangleMesh& mesh) {
    const OpenSurface open = open_surface(mesh);
    TriangleMesh half = open.mesh;
    std::vector<double> size(half.positions.size(), 0.2);
    bisect_edges(half, size);
    const DoubledSurface both = doubled(half, open.genus, boundary_loops(half));
    t = std::make_unique<Uniformized>(uniformize_surface(both.surface, {}));
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(half.positions.size()); v += 7) {
      const std::int32_t image = both.mirror[static_cast<std::size_t>(v)];
      if (image == v) {
        layout.on_line.push_back(at_vertex(t->surface, v));
        layout.fixed.push_back(layout.on_line.size() % 5 == 0);
      } else {
        layout.pairs.push_back({at_vertex(t->surface, v), at_vertex(t->surface, image)});
      }
    }
    mass = std::make_unique<SurfaceMass>(t->surface, std::vector<double>(t->log_scale.size(), 1.0));
  }
  std::unique_ptr<Uniformized> t;
  std::unique_ptr<SurfaceMass> mass;
  MirrorLayout layout;
};

std::vector<Offset> random_steps(const MirrorSites& sites, double part, std::mt19937& random) {
  std::vector<CellState> cells;
  sites.measure(cells);
  std::uniform_real_distribution<double> uniform(-part, part);
  std::vector<Offset> out;
  for (const CellState& c : cells) {
    const double x = uniform(random), y = uniform(random);
    out.push_back(from_central(sites.space(), c.spacing * x, c.spacing * y));
  }
  return out;
}

double energy(const MirrorSites& sites) {
  std::vector<CellState> cells;
  sites.measure(cells);
  double sum = 0;
  for (const CellState& c : cells) {
    sum += 2 * c.moments.h;
  }
  return sum;
}

/// The farthest that a neighbour of a site is from the image of its partner's nearest neighbour.
double asymmetry(const MirrorSites& sites) {
  const DelaunayTriangulation& d = sites.tessellation().delaunay();
  double worst = 0;
  for (std::size_t i = 0; i < d.vertex_count(); ++i) {
    const Vertex site{static_cast<std::int32_t>(i)};
    const auto nearest = [&](Vertex v) {
      Offset best{0, 0, HUGE_VAL};
      d.connectivity().for_outgoing(
          v, [&](Halfedge h) { best = d.offset(h).h < best.h ? d.offset(h) : best; });
      return best;
    };
    const Offset a = nearest(site), b = nearest(sites.partner(site));
    worst = std::max(worst, std::abs(a.h - b.h) / a.h);
  }
  return worst;
}

class MirrorSitesTest : public testing::TestWithParam<int> {
 protected:
  static TriangleMesh mesh() {
    const int n = GetParam();
    return n == 0   ? oracle::plate(6)
           : n == 1 ? oracle::tube(24, 12)
                    : oracle::bumpy(oracle::torus_with_holes(2), 0.02, 3);
  }
};

TEST_P(MirrorSitesTest, MovesKeepTheSymmetry) {
  const Doubled on(mesh());
  MirrorSites sites(*on.mass, on.layout);
  EXPECT_LT(asymmetry(sites), 1e-7);
  std::mt19937 random(1);
  for (int step = 0; step < 20; ++step) {
    sites.move(random_steps(sites, 0.03, random));
  }
  EXPECT_LT(asymmetry(sites), 1e-7);
  EXPECT_EQ(sites.tessellation().delaunay().connectivity().euler_number(),
            on.t->surface.connectivity().euler_number());
}

TEST_P(MirrorSitesTest, SitesOnTheLineStayOnItAndFixedOnesWhereTheyAre) {
  const Doubled on(mesh());
  MirrorSites sites(*on.mass, on.layout);
  const std::vector<Position> before = positions_on_input(*on.t, sites.layout().on_line);
  std::mt19937 random(2);
  for (int step = 0; step < 10; ++step) {
    sites.move(random_steps(sites, 0.1, random));
  }
  const std::vector<Position> after = positions_on_input(*on.t, sites.layout().on_line);
  const auto loops = boundary_loops(open_surface(mesh()).mesh);
  const TriangleMesh half = open_surface(mesh()).mesh;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto from = [&](const Position& p) {
      return std::hypot(after[i][0] - p[0], after[i][1] - p[1], after[i][2] - p[2]);
    };
    EXPECT_EQ(from(before[i]) < 1e-7, on.layout.fixed[i]);
    double excess = HUGE_VAL;  // of the way over the point from one end of an edge to the other
    for (const auto& loop : loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Position& p = half.positions[static_cast<std::size_t>(loop[k])];
        const Position& q = half.positions[static_cast<std::size_t>(loop[(k + 1) % loop.size()])];
        const double edge = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        excess = std::min(excess, (from(p) + from(q)) / edge - 1);
      }
    }
    EXPECT_LT(excess, 1e-6);
  }
}

TEST_P(MirrorSitesTest, GradientIsTheDerivativeOfTheEnergy) {
  const Doubled on(mesh());
  MirrorSites sites(*on.mass, on.layout);
  std::mt19937 random(3);
  sites.move(random_steps(sites, 0.1, random));
  std::vector<CellState> cells;
  sites.measure(cells);
  const auto direction = random_steps(sites, 0.1, random);
  double slope = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    slope -= 2 * (cells[i].moments.x * direction[i].x + cells[i].moments.y * direction[i].y);
  }
  const double step = 1e-4;
  const auto at = [&](double s) {
    std::vector<Offset> target;
    for (const Offset& d : direction) {
      target.push_back(from_central(sites.space(), s * d.x, s * d.y));
    }
    sites.save();
    sites.move(target);
    const double out = energy(sites);
    sites.restore();
    return out;
  };
  const double found = (at(step) - at(-step)) / (2 * step);
  EXPECT_NEAR(found, slope, 1e-4 * std::abs(slope));
}

TEST_P(MirrorSitesTest, EnergyNeverRises) {
  const Doubled on(mesh());
  for (const Method method : {Method::Lbfgs, Method::Lloyd}) {
    MirrorSites sites(*on.mass, on.layout);
    const OptimizeResult result = optimize(sites, {method, 40, 1e-4}, {});
    for (std::size_t i = 1; i < result.energy.size(); ++i) {
      EXPECT_LE(result.energy[i], result.energy[i - 1] * (1 + 1e-12)) << i;
    }
    EXPECT_LT(result.energy.back(), result.energy.front());
    EXPECT_LT(asymmetry(sites), 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, MirrorSitesTest, testing::Values(0, 1, 2));

}  // namespace
}  // namespace ucvt
