#include "cvt/polygon_delaunay.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "cvt/domain.h"
#include "oracle/generators.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

double area(Space s, const PolygonCell& cell) {
  double sum = 0;
  for (std::size_t i = 0; i < cell.corner.size(); ++i) {
    sum += central_triangle_area(s, cell.corner[i], cell.corner[(i + 1) % cell.corner.size()]);
  }
  return sum;
}

std::vector<PolygonCell> cells_of(const Domain& domain, const std::vector<ModelPoint>& sites,
                                  const PolygonDelaunay& d) {
  std::vector<PolygonCell> out;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    out.push_back(clipped_cell(model_corners(domain), frame_at(domain.kappa, sites[i]), sites,
                               d.neighbours(i)));
  }
  return out;
}

double total_area(const Domain& domain, const std::vector<PolygonCell>& cells) {
  return std::accumulate(cells.begin(), cells.end(), 0.0, [&](double sum, const PolygonCell& c) {
    return sum + area({domain.kappa}, c);
  });
}

/// The cells' areas sum up, and each is what all pairs of sites make it.
void expect_cells(const Domain& domain, const std::vector<ModelPoint>& sites,
                  double tolerance = 1e-12) {
  const PolygonDelaunay d = delaunay_in_polygon(domain, sites);
  const auto cells = cells_of(domain, sites, d);
  EXPECT_NEAR(total_area(domain, cells), domain.area, tolerance * domain.area);
  for (std::size_t i = 0; i < sites.size() && sites.size() <= 300; ++i) {
    std::vector<std::int32_t> others;
    for (std::size_t j = 0; j < sites.size(); ++j) {
      if (j != i) {
        others.push_back(static_cast<std::int32_t>(j));
      }
    }
    const Frame frame = frame_at(domain.kappa, sites[i]);
    const auto whole = clipped_cell(model_corners(domain), frame, sites, others);
    EXPECT_NEAR(area({domain.kappa}, cells[i]), area({domain.kappa}, whole),
                tolerance * domain.area)
        << i;
    EXPECT_TRUE(std::ranges::is_sorted(d.neighbours(i)));
    for (const std::int32_t j : d.neighbours(i)) {
      EXPECT_TRUE(std::ranges::binary_search(d.neighbours(static_cast<std::size_t>(j)),
                                             static_cast<std::int32_t>(i)));
    }
  }
}

/// The triangles are those of the corners of the cells; for sites in general position.
void expect_dual(const Domain& domain, const std::vector<ModelPoint>& sites) {
  const PolygonDelaunay d = delaunay_in_polygon(domain, sites);
  const auto cells = cells_of(domain, sites, d);
  std::set<std::array<std::int32_t, 3>> dual;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto& across = cells[i].across;
    for (std::size_t k = 0; k < across.size(); ++k) {
      std::array<std::int32_t, 3> t{static_cast<std::int32_t>(i),
                                    across[(k + across.size() - 1) % across.size()], across[k]};
      if (t[1] >= 0 && t[2] >= 0) {
        std::ranges::rotate(t, std::ranges::min_element(t));
        dual.insert(t);
      }
    }
  }
  EXPECT_EQ(d.triangles, (std::vector(dual.begin(), dual.end())));
}

Domain square(double kappa) {
  return polygon_domain(kappa, {{-0.6, -0.6}, {0.6, -0.6}, {0.6, 0.6}, {-0.6, 0.6}});
}

Domain any_polygon(double kappa) {
  // Corners in order on an ellipse.
  std::vector<double> angles;
  const auto n = *rc::gen::inRange(3, 9);
  for (int i = 0; i < n; ++i) {
    angles.push_back((i + oracle::number(0.1, 0.9)) * 2 * std::numbers::pi / n);
  }
  const double a = oracle::number(0.2, 0.95), b = oracle::number(0.1, 0.95);
  std::vector<CentralPoint> corners;
  for (const double angle : angles) {
    corners.push_back({a * std::cos(angle), b * std::sin(angle)});
  }
  return polygon_domain(kappa, corners);
}

RC_GTEST_PROP(PolygonDelaunayTest, AgreesWithAllPairs, ()) {
  const Domain domain = any_polygon(*rc::gen::element(0.0, -1.0));
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(1, 60));
  const auto sites =
      random_points(domain, n, static_cast<std::uint64_t>(*rc::gen::inRange(0, 999)));
  expect_cells(domain, sites);
  expect_dual(domain, sites);
  RC_ASSERT(!testing::Test::HasFailure());
}

TEST(PolygonDelaunay, FewSites) {
  for (const double kappa : {0.0, -1.0}) {
    for (std::size_t n = 1; n <= 12; ++n) {
      expect_cells(square(kappa), random_points(square(kappa), n, n));
      expect_dual(square(kappa), random_points(square(kappa), n, n));
      // On a circle, with and without its centre: every triangle is cocircular with the others.
      std::vector<ModelPoint> ring;
      for (std::size_t i = 0; i < n; ++i) {
        const double a = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        ring.push_back(model_point(kappa, CentralPoint{0.4 * std::cos(a), 0.4 * std::sin(a)}));
      }
      expect_cells(square(kappa), ring);
      EXPECT_EQ(delaunay_in_polygon(square(kappa), ring).triangles.size(), n < 3 ? 0 : n - 2);
      ring.push_back({0, 0, 1});
      expect_cells(square(kappa), ring);
    }
  }
}

TEST(PolygonDelaunay, RegularGrid) {
  for (const double kappa : {0.0, -1.0}) {
    std::vector<ModelPoint> sites;
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j < 12; ++j) {
        sites.push_back(model_point(kappa, CentralPoint{-0.55 + 0.1 * i, -0.55 + 0.1 * j}));
      }
    }
    expect_cells(square(kappa), sites);
    const PolygonDelaunay d = delaunay_in_polygon(square(kappa), sites);
    if (kappa == 0) {
      // Each of the 11 x 11 crossings is cut in two, and no cell has a side of no length.
      EXPECT_EQ(d.triangles.size(), 2 * 11 * 11);
      for (const PolygonCell& c : cells_of(square(0), sites, d)) {
        EXPECT_EQ(c.corner.size(), 4);
        EXPECT_NEAR(area({0}, c), 0.01, 1e-15);
      }
    }
  }
}

TEST(PolygonDelaunay, SitesOnALineAndNearIt) {
  for (const double kappa : {0.0, -1.0}) {
    for (const double off : {0.0, 1e-16, 1e-14, 1e-12, 1e-9, 1e-6, 1e-3}) {
      std::mt19937_64 random(1);
      std::vector<ModelPoint> sites;
      for (int i = 0; i < 30; ++i) {
        const double t = -0.5 + i / 29.0, bump = static_cast<double>(random() % 1000) / 1000 - 0.5;
        sites.push_back(model_point(kappa, CentralPoint{t, 0.3 * t + 0.1 + off * bump}));
      }
      SCOPED_TRACE(testing::Message() << kappa << " " << off);
      expect_cells(square(kappa), sites);
    }
  }
}

TEST(PolygonDelaunay, SitesOnTheSidesAndAtCorners) {
  for (const double kappa : {0.0, -1.0}) {
    auto sites = random_points(square(kappa), 40, 3);
    for (int i = 0; i <= 10; ++i) {
      sites.push_back(model_point(kappa, CentralPoint{-0.6 + 0.12 * i, -0.6}));
      sites.push_back(model_point(kappa, CentralPoint{0.6 - 1e-13, -0.55 + 0.113 * i}));
    }
    expect_cells(square(kappa), sites);
  }
}

TEST(PolygonDelaunay, ClustersOfEveryScale) {
  for (const double kappa : {0.0, -1.0}) {
    std::vector<ModelPoint> sites;
    for (int k = 0; k < 12; ++k) {
      for (int i = 0; i < 9; ++i) {
        const double r = 0.5 * std::pow(4.0, -k), a = 0.7 * i + 0.1 * k;
        sites.push_back(model_point(kappa, CentralPoint{0.05 + r * std::cos(a), r * std::sin(a)}));
      }
    }
    expect_cells(square(kappa), sites);
  }
}

TEST(PolygonDelaunay, CoincidingSitesAreRefused) {
  auto sites = random_points(square(-1), 20, 3);
  sites.push_back(sites[4]);
  try {
    delaunay_in_polygon(square(-1), sites);
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("sites 4 and 20 coincide"), std::string::npos) << e.what();
  }
  EXPECT_THROW(delaunay_in_polygon(sphere_domain(), {{0, 0, 1}}), InvalidInput);
}

TEST(PolygonDelaunay, ManySitesAreQuick) {
  for (const double kappa : {0.0, -1.0}) {
    const auto sites = random_points(square(kappa), 5000, 3);
    const auto start = std::chrono::steady_clock::now();
    const PolygonDelaunay d = delaunay_in_polygon(square(kappa), sites);
    const auto middle = std::chrono::steady_clock::now();
    const auto cells = cells_of(square(kappa), sites, d);
    const auto end = std::chrono::steady_clock::now();
    EXPECT_NEAR(total_area(square(kappa), cells), square(kappa).area, 1e-12);
    const std::chrono::duration<double> hull = middle - start, clip = end - middle;
    RecordProperty("seconds", std::to_string(hull.count()) + " " + std::to_string(clip.count()));
    EXPECT_LT(hull.count() + clip.count(), 2) << "ten times what it takes";
  }
}

}  // namespace
}  // namespace ucvt
