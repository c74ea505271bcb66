#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include "cvt/surface_mass.h"
#include "cvt/tessellation.h"
#include "cvt/uniformity.h"
#include "oracle/brute_voronoi.h"
#include "oracle/surfaces.h"

namespace ucvt {
namespace {

Vertex site(std::size_t i) {
  return {static_cast<std::int32_t>(i)};
}

double sum_of(const std::vector<Moments>& moments, double Moments::* part) {
  return std::accumulate(moments.begin(), moments.end(), 0.0,
                         [&](double sum, const Moments& m) { return sum + m.*part; });
}

OptimizeOptions lloyd(int evaluations, double tolerance) {
  return {Method::Lloyd, evaluations, tolerance};
}

class CellsTest : public testing::TestWithParam<double> {
 protected:
  const UniformSurface& t = oracle::surface_of(GetParam());
  const SurfaceMass uniform{t, std::vector<double>(t.connectivity().vertex_count(), 1.0)};
  const SurfaceMass bumpy{t, density()};

  std::vector<double> density() const {
    std::vector<double> out;
    for (std::size_t v = 0; v < t.connectivity().vertex_count(); ++v) {
      out.push_back(1.5 + std::sin(3.0 * static_cast<double>(v)));
    }
    return out;
  }
};

TEST_P(CellsTest, TotalMassIsTheAreaAtUniformDensity) {
  EXPECT_NEAR(uniform.total() / oracle::gauss_bonnet_area(t), 1, 1e-11);
}

TEST_P(CellsTest, MassesAddUpToTheTotalWhateverTheSites) {
  for (const std::size_t n : {12, 30, 200}) {
    for (const SurfaceMass* mass : {&uniform, &bumpy}) {
      const Tessellation sites(*mass, oracle::random_points(t, n, n));
      EXPECT_NEAR(sum_of(sites.cell_moments(), &Moments::m) / mass->total(), 1, 1e-11);
      for (const Moments& m : sites.cell_moments()) {
        EXPECT_GT(m.m, 0);
        EXPECT_GT(m.h, 0);
      }
    }
  }
}

TEST_P(CellsTest, MassAtUniformDensityIsTheAreaOfTheBruteForceCell) {
  const Tessellation sites(uniform, oracle::random_points(t, 25, 2));
  const auto points = sites.sites();
  const auto moments = sites.cell_moments();
  double total = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const auto cell = oracle::brute_cell(t, sites.place(site(i)), points);
    EXPECT_NEAR(moments[i].m / cell.area, 1, 1e-9);
    total += cell.area;
  }
  EXPECT_NEAR(total / oracle::gauss_bonnet_area(t), 1, 1e-10);
}

TEST_P(CellsTest, MomentsAgreeWithPointsCountedInTheCover) {
  // A fine grid of points in every face goes to the nearest lift of a site.
  const Tessellation sites(bumpy, oracle::random_points(t, 12, 3));
  const auto points = sites.sites();
  const auto moments = sites.cell_moments();
  const std::size_t i = 5;
  const Space s = t.space();
  const auto cell = oracle::brute_cell(t, sites.place(site(i)), points);
  // Fan of the cell's corners about the site, by midpoints of a fine polar grid.
  double m = 0, mx = 0;
  const int rays = 1500, rings = 400;
  const auto rho_at = [&](const Offset& p) {
    Place place = sites.place(site(i));
    move_place(t, place, p);
    const SurfacePoint at = point_of(place);
    double rho = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      rho += at.bary[k] * bumpy.density()[t.connectivity().origin(halfedges(at.face)[k]).index()];
    }
    return rho;
  };
  for (int ray = 0; ray < rays; ++ray) {
    const double angle = 2 * M_PI * (ray + 0.5) / rays, c = std::cos(angle), d = std::sin(angle);
    double reach = HUGE_VAL;
    for (const auto& n : cell.neighbours) {
      const double along = n.at.x * c + n.at.y * d;
      if (along > 0) {
        reach = std::min(reach, n.at.h / along);
      }
    }
    for (int ring = 0; ring < rings; ring += 10) {
      const double k = reach * (ring + 5) / rings, q = 1 + s.kappa * k * k;
      const double dm = reach * 10 / rings * (2 * M_PI / rays) * k / (q * std::sqrt(q));
      const Offset p = from_central(s, k * c, k * d);
      const double rho = rho_at(p);
      m += dm * rho, mx += dm * rho * p.x;
    }
  }
  EXPECT_NEAR(m / moments[i].m, 1, 2e-3);
  EXPECT_NEAR(mx, moments[i].x, 2e-3 * moments[i].m * cell.radius);
}

TEST_P(CellsTest, BytesDoNotDependOnThreads) {
  std::vector<double> bytes[2];
  for (const int threads : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    Tessellation sites(bumpy, oracle::random_points(t, 50, 4));
    optimize(sites, lloyd(10, 0), {});
    for (const Moments& m : sites.cell_moments()) {
      bytes[threads - 1].insert(bytes[threads - 1].end(), {m.m, m.x, m.y, m.h});
    }
  }
  EXPECT_EQ(bytes[0], bytes[1]);
}

TEST_P(CellsTest, EnergyNeverRisesUnderLloyd) {
  for (const SurfaceMass* mass : {&uniform, &bumpy}) {
    Tessellation sites(*mass, oracle::random_points(t, 30, 5));
    const OptimizeResult result = optimize(sites, lloyd(50, 0), {});
    ASSERT_EQ(result.energy.size(), 51U);
    for (std::size_t i = 1; i < result.energy.size(); ++i) {
      EXPECT_LE(result.energy[i], result.energy[i - 1] * (1 + 1e-12)) << i;
    }
    EXPECT_LT(result.max_move.back(), result.max_move.front() / 3);
    EXPECT_NEAR(sum_of(sites.cell_moments(), &Moments::m) / mass->total(), 1, 1e-11);
  }
}

TEST_P(CellsTest, TheGradientIsMinusTwiceTheFirstMoments) {
  const auto start = oracle::random_points(t, 20, 6);
  const Tessellation at_rest(bumpy, start);
  const auto moments = at_rest.cell_moments();
  for (const std::size_t i : {0, 7, 19}) {
    const double step = 1e-4;
    const auto energy = [&](double x, double y) {
      Tessellation sites(bumpy, start);
      std::vector<Offset> target(start.size());
      target[i] = from_central(t.space(), x, y);
      sites.move(target);
      return 2 * sum_of(sites.cell_moments(), &Moments::h);
    };
    const double scale = 2 * moments[i].m;
    EXPECT_NEAR((energy(step, 0) - energy(-step, 0)) / (2 * step), -2 * moments[i].x, 1e-6 * scale);
    EXPECT_NEAR((energy(0, step) - energy(0, -step)) / (2 * step), -2 * moments[i].y, 1e-6 * scale);
  }
}

TEST_P(CellsTest, LloydConvergesStopsAndCancels) {
  Tessellation sites(uniform, oracle::random_points(t, 14, 7));
  const OptimizeResult done = optimize(sites, lloyd(5000, 1e-5), {});
  EXPECT_TRUE(done.converged);
  EXPECT_LE(done.max_move.back(), 1e-5);
  const auto moments = sites.cell_moments();
  for (const Moments& m : moments) {
    EXPECT_LT(std::hypot(m.x, m.y), 1e-4 * m.m);
  }
  int calls = 0;
  const OptimizeResult stopped =
      optimize(sites, lloyd(50, 0), [&](const Progress&) { return ++calls < 3; });
  EXPECT_TRUE(stopped.cancelled);
  EXPECT_EQ(stopped.energy.size(), 3U);
}

TEST_P(CellsTest, UniformityMeasuresTheCells) {
  const Tessellation sites(uniform, oracle::random_points(t, 40, 8));
  const UniformityReport report = measure_uniformity(sites.delaunay());
  const auto moments = sites.cell_moments();
  EXPECT_NEAR(report.area.mean * 40, oracle::gauss_bonnet_area(t), 1e-8);
  double least = HUGE_VAL, degrees = 0;
  for (const Moments& m : moments) {
    least = std::min(least, m.m);
  }
  EXPECT_NEAR(report.area.min / least, 1, 1e-8);
  for (const auto& [degree, count] : report.degree) {
    degrees += degree * static_cast<double>(count);
  }
  EXPECT_EQ(degrees, 6.0 * static_cast<double>(40 - t.connectivity().euler_number()));
  EXPECT_LE(report.nearest.max, 2 * report.radius.max);
}

INSTANTIATE_TEST_SUITE_P(Curvatures, CellsTest, testing::Values(1.0, 0.0, -1.0));

TEST(FewSites, CellsThatTouchThemselvesKeepTheMass) {
  const UniformSurface t = oracle::flat_torus(6, 5);
  const SurfaceMass mass(t, std::vector<double>(30, 1.0));
  for (const std::size_t n : {1, 2, 3}) {
    Tessellation sites(mass, oracle::random_points(t, n, n));
    EXPECT_NEAR(sum_of(sites.cell_moments(), &Moments::m), 1, 1e-12);
    optimize(sites, lloyd(20, 0), {});
    EXPECT_NEAR(sum_of(sites.cell_moments(), &Moments::m), 1, 1e-12);
    EXPECT_NEAR(sites.delaunay().area(), 1, 1e-12);
  }
}

TEST(FewSites, OneSiteOnATorusHasTheLatticesHexagon) {
  const UniformSurface t = oracle::flat_torus(6, 5, 0.5, std::sqrt(0.75));
  const SurfaceMass mass(t, std::vector<double>(30, 1.0));
  const Tessellation sites(mass, oracle::random_points(t, 1, 3));
  const Moments m = sites.cell_moments()[0];
  EXPECT_NEAR(std::hypot(m.x, m.y), 0, 1e-13);
  // A regular hexagon of area 1: int r^2 = 5 / (18 sqrt 3).
  EXPECT_NEAR(2 * m.h, 5 / (18 * std::sqrt(3)), 1e-12);
}

// Runs in a process of its own with an alarm: removing T's vertices once flipped for ever.
TEST(FewSitesDeathTest, OneSiteOnADoubleTorusKeepsTheMass) {
  const UniformSurface& t = oracle::double_torus().surface;
  EXPECT_EXIT(
      {
        alarm(10);
        const SurfaceMass mass(t, std::vector<double>(t.connectivity().vertex_count(), 1.0));
        bool sound = true;
        for (const std::size_t n : {1, 2, 3}) {
          const Tessellation sites(mass, oracle::random_points(t, n, n));
          sound = sound && std::abs(sum_of(sites.cell_moments(), &Moments::m) - 4 * M_PI) < 1e-9;
        }
        std::_Exit(sound ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace ucvt
