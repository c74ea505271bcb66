#include "cvt/defects.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "cvt/consistency.h"
#include "cvt/local_sites.h"
#include "oracle/surfaces.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

double energy_of(const Tessellation& sites) {
  double sum = 0;
  for (const Moments& m : sites.cell_moments()) {
    sum += 2 * m.h;
  }
  return sum;
}

int irregular(const Tessellation& sites) {
  const Connectivity& d = sites.delaunay().connectivity();
  int out = 0;
  for (std::size_t i = 0; i < sites.site_count(); ++i) {
    out += d.degree({static_cast<std::int32_t>(i)}) == 6 ? 0 : 1;
  }
  return out;
}

void settle(SiteSystem& sites, int evaluations) {
  optimize(sites, {.evaluations = evaluations, .tolerance = 1e-6}, {});
}

/// The torus that a hexagonal lattice fits, and `per_side` squared sites on it.
class HexagonalTorus {
 public:
  static constexpr std::size_t per_side = 16, step = 2;

  [[nodiscard]] const SurfaceMass& mass() const { return mass_; }
  [[nodiscard]] std::vector<SurfacePoint> lattice() const {
    std::vector<SurfacePoint> out;
    for (std::size_t i = 0; i < per_side; ++i) {
      for (std::size_t j = 0; j < per_side; ++j) {
        const Vertex v{static_cast<std::int32_t>((i * per_side * step + j) * step)};
        const Halfedge h = t_.connectivity().outgoing(v);
        SurfacePoint p{h.face(), {}};
        for (std::size_t k = 0; k < 3; ++k) {
          p.bary[k] = halfedges(h.face())[k] == h ? 1 : 0;
        }
        out.push_back(p);
      }
    }
    return out;
  }

 private:
  UniformSurface t_ = oracle::flat_torus(per_side * step, per_side* step, 0.5, std::sqrt(0.75));
  SurfaceMass mass_{t_, std::vector<double>(t_.connectivity().vertex_count(), 1.0)};
};

TEST(Defects, ASiteTooManyMakesUpForOneTooFew) {
  const HexagonalTorus torus;
  const auto lattice = torus.lattice();
  const double least = energy_of(Tessellation(torus.mass(), lattice));
  std::vector<SurfacePoint> points = lattice;
  const std::size_t gap = 100, crowd = 8 * HexagonalTorus::per_side + 13;
  points[gap] = points[crowd];
  points[gap].bary = {0.4, 0.35, 0.25};
  auto sites = std::make_unique<Tessellation>(torus.mass(), points);
  settle(*sites, 200);
  const double before = energy_of(*sites);
  ASSERT_GT(irregular(*sites), 0);
  ASSERT_GT(before, (1 + 1e-3) * least);
  sites = mend_defects(std::move(sites), 3, {});
  settle(*sites, 200);
  EXPECT_EQ(sites->site_count(), lattice.size());
  EXPECT_EQ(irregular(*sites), 0);
  EXPECT_NEAR(energy_of(*sites) / least, 1, 1e-9);
}

TEST(Defects, NothingIsToBeMendedInALattice) {
  const HexagonalTorus torus;
  auto sites = std::make_unique<Tessellation>(torus.mass(), torus.lattice());
  const double before = energy_of(*sites);
  sites = mend_defects(std::move(sites), 3, {});
  EXPECT_EQ(energy_of(*sites), before);
}

TEST(Defects, RingsOfALatticeGrowBySix) {
  const HexagonalTorus torus;
  const Tessellation sites(torus.mass(), torus.lattice());
  const Connectivity& d = sites.delaunay().connectivity();
  const Neighbourhood part = neighbourhood(d, {{100}}, 2);
  ASSERT_EQ(part.moving.size(), 1U + 6 + 12);
  EXPECT_EQ(part.rim.size(), 18U);
  EXPECT_EQ(part.moving[0], Vertex{100});
  std::set<Vertex> all(part.moving.begin(), part.moving.end());
  all.insert(part.rim.begin(), part.rim.end());
  EXPECT_EQ(all.size(), 37U) << "each once";
  std::set<Vertex> neighbours;
  d.for_outgoing({100}, [&](Halfedge h) { neighbours.insert(d.head(h)); });
  EXPECT_EQ(neighbours, std::set<Vertex>(part.moving.begin() + 1, part.moving.begin() + 7));
  const Neighbourhood none = neighbourhood(d, {{3}, {100}}, 0);
  EXPECT_EQ(none.moving, (std::vector<Vertex>{{3}, {100}}));
  EXPECT_EQ(none.rim.size(), 12U);
}

TEST(Defects, CanBeInterrupted) {
  const HexagonalTorus torus;
  std::vector<SurfacePoint> points = torus.lattice();
  points[100] = points[137];
  points[100].bary = {0.4, 0.35, 0.25};
  auto sites = std::make_unique<Tessellation>(torus.mass(), points);
  settle(*sites, 200);
  EXPECT_THROW(mend_defects(std::move(sites), 3, [](const Progress&) { return false; }), Cancelled);
}

/// Surfaces of the three geometries whose edges are short next to the cells of 150 sites.
class LocalTest : public testing::TestWithParam<double> {
 protected:
  static const UniformSurface& t() { return oracle::fine_surface_of(GetParam()); }
  const SurfaceMass mass{t(), density()};
  static std::vector<double> density() {
    std::vector<double> out;
    for (std::size_t v = 0; v < t().connectivity().vertex_count(); ++v) {
      out.push_back(1.5 + std::sin(3.0 * static_cast<double>(v)));
    }
    return out;
  }
  [[nodiscard]] std::unique_ptr<Tessellation> settled(std::size_t n) const {
    auto out = std::make_unique<Tessellation>(mass, oracle::random_points(t(), n, 7));
    settle(*out, 40);
    return out;
  }
};

TEST_P(LocalTest, MendingLowersTheEnergyOfRandomSites) {
  auto sites = settled(150);
  const double before = energy_of(*sites);
  sites = mend_defects(std::move(sites), 3, {});
  EXPECT_EQ(sites->site_count(), 150U);
  EXPECT_LT(energy_of(*sites), before);
  std::vector<Place> places;
  for (std::int32_t i = 0; i < 150; ++i) {
    places.push_back(sites->place({i}));
  }
  const Consistency c = measure_consistency(t(), sites->delaunay(), places);
  EXPECT_LT(c.angle_sum_rad, 1e-9);
  EXPECT_LT(c.circle, 1e-9);
  EXPECT_LT(c.place, 1e-9);
}

TEST_P(LocalTest, AnExchangeNeverRaisesTheEnergyOfSitesAtRest) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    auto sites = std::make_unique<Tessellation>(mass, oracle::random_points(t(), 150, seed));
    settle(*sites, 300);
    const double before = energy_of(*sites);
    EXPECT_LE(energy_of(*mend_defects(std::move(sites), 1, {})), before) << seed;
  }
}

TEST_P(LocalTest, SitesTakenAwayLeaveTheSameAsNeverPut) {
  Tessellation sites(mass, oracle::random_points(t(), 150, 11));
  const Connectivity& d = sites.delaunay().connectivity();
  const Vertex first{20};
  std::vector<bool> near(150);
  near[first.index()] = true;
  d.for_outgoing(first, [&](Halfedge h) { near[d.head(h).index()] = true; });
  const Vertex second{
      static_cast<std::int32_t>(std::find(near.begin() + 40, near.end(), false) - near.begin())};
  std::vector<SurfacePoint> left = sites.sites();
  left.erase(left.begin() + second.id);
  left.erase(left.begin() + first.id);
  const std::vector<Vertex> number = sites.remove_sites({first, second});
  EXPECT_EQ(number[first.index()].id, -1);
  EXPECT_EQ(number[second.index()].id, -1);
  EXPECT_EQ(number[149].id, 147);
  const Tessellation anew(mass, left);
  const auto m = sites.cell_moments(), expected = anew.cell_moments();
  ASSERT_EQ(m.size(), 148U);
  for (std::size_t i = 0; i < m.size(); ++i) {
    EXPECT_NEAR(m[i].m / expected[i].m, 1, 1e-9);
    EXPECT_NEAR(m[i].h / expected[i].h, 1, 1e-9);
  }
}

TEST_P(LocalTest, SomeSitesMoveAsAmongAllThatStay) {
  const auto sites = settled(150);
  const Connectivity& d = sites->delaunay().connectivity();
  const Neighbourhood part = neighbourhood(d, {{3}}, 0);
  const std::vector<Vertex>&moving = part.moving, &rim = part.rim;
  LocalSites local(*sites, part);
  std::vector<CellState> all, some;
  const auto expect_same = [&] {
    sites->measure(all);
    local.measure(some);
    ASSERT_EQ(some.size(), 1 + rim.size());
    for (std::size_t i = 0; i < some.size(); ++i) {
      const CellState& whole = all[(i == 0 ? moving[0] : rim[i - 1]).index()];
      EXPECT_NEAR(some[i].moments.m / whole.moments.m, 1, 1e-12);
      EXPECT_NEAR(some[i].moments.h / whole.moments.h, 1, 1e-12);
      EXPECT_NEAR(some[i].moments.x, i == 0 ? whole.moments.x : 0, 1e-12 * whole.moments.m);
      EXPECT_EQ(some[i].spacing, whole.spacing);
    }
  };
  expect_same();
  const std::vector<SurfacePoint> before = sites->sites();
  std::vector<Offset> target(1 + rim.size());
  target[0] = from_chord(t().space(), 0.2 * some[0].spacing, 0.6, 0.8);
  target[1] = target[0];  // of the rim: stays
  local.move(target);
  expect_same();
  const std::vector<SurfacePoint> after = sites->sites();
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].face == before[i].face && after[i].bary == before[i].bary, i != 3) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Geometries, LocalTest, testing::Values(1.0, 0.0, -1.0));

}  // namespace
}  // namespace ucvt
