#include "cvt/domain.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "oracle/generators.h"
#include "triangulation/closed_spaces.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<Domain> closed_domains() {
  std::vector<Domain> out{torus_domain({1, 0}, {0, 1}), torus_domain({2, 1}, {1.5, -0.5})};
  for (int genus = 2; genus <= 6; ++genus) {
    out.push_back(surface_domain(genus, SidePairing::Opposite));
    out.push_back(surface_domain(genus, SidePairing::Canonical));
  }
  return out;
}

double gap(const CentralPoint& a, const CentralPoint& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

std::string fault(const std::function<void()>& make) {
  try {
    make();
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
}

TEST(Domain, FaultsAreNamed) {
  const auto says = [](const char* part, const std::function<void()>& make) {
    const std::string line = fault(make);
    EXPECT_NE(line.find(part), std::string::npos) << part << ": " << line;
    EXPECT_NE(line.find("; "), std::string::npos) << line;
  };
  const double inf = std::numeric_limits<double>::infinity();
  says("span", [] { torus_domain({1, 2}, {2, 4}); });
  says("span", [] { torus_domain({1, 2}, {0, 0}); });
  says("span", [&] { torus_domain({1, 2}, {inf, 0}); });
  says("genus 1", [] { surface_domain(1, SidePairing::Opposite); });
  says("curvature 1", [] { polygon_domain(1, {{0, 0}, {1, 0}, {0, 1}}); });
  says("2 corners", [] { polygon_domain(0, {{0, 0}, {1, 0}}); });
  says("corner 2 at (0, 1)", [] { polygon_domain(-1, {{0, 0}, {.5, 0}, {0, 1}}); });
  says("not finite", [&] { polygon_domain(0, {{0, 0}, {inf, 0}, {0, 1}}); });
  says("twice", [] { polygon_domain(0, {{0, 0}, {1, 0}, {1, 0}, {0, 1}}); });
  says("convex", [] { polygon_domain(0, {{0, 0}, {2, 0}, {1, 0.5}, {0, 2}}); });
  says("convex", [] { polygon_domain(0, {{0, 0}, {1, 0}, {2, 0}}); });
  says("winds", [] {
    std::vector<CentralPoint> star;
    for (int i = 0; i < 5; ++i) {
      star.push_back({std::cos(4 * pi * i / 5), std::sin(4 * pi * i / 5)});
    }
    polygon_domain(0, star);
  });
}

TEST(Domain, AreasAndGenera) {
  EXPECT_DOUBLE_EQ(sphere_domain().area, 4 * pi);
  EXPECT_DOUBLE_EQ(torus_domain({2, 1}, {1.5, -0.5}).area, 2.5);
  EXPECT_NEAR(polygon_domain(0, {{10, 10}, {10, 11}, {12, 11}, {12, 10}}).area, 2, 1e-15);
  for (const Domain& d : closed_domains()) {
    // The polygon's own area against Gauss and Bonnet's; angles of corners instead of triangles.
    if (d.genus > 1) {
      EXPECT_NEAR(polygon_domain(-1, d.polygon).area, 4 * pi * (d.genus - 1), 1e-11);
    }
    EXPECT_NEAR(polygon_domain(d.kappa, d.polygon).area, d.area, 1e-12 * d.area);
  }
}

TEST(PolygonDomain, IsTurnedCounterclockwise) {
  const Domain d = polygon_domain(-1, {{0, 0}, {0, 0.5}, {0.5, 0.5}, {0.5, 0}});
  EXPECT_EQ(d.kind, DomainKind::HyperbolicPolygon);
  EXPECT_EQ(d.polygon, (std::vector<CentralPoint>{{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}));
  EXPECT_GT(d.area, 0);
  // Straight corners are allowed.
  EXPECT_NEAR(polygon_domain(0, {{0, 0}, {0.3, 0.1}, {0.6, 0.2}, {0, 1}}).area, 0.3, 1e-15);
}

TEST(ClosedDomain, SidesAreGlued) {
  for (const Domain& d : closed_domains()) {
    const auto corners = model_corners(d);
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = glued_side(d, i);
      const auto image = [&](std::size_t k) {
        return central_point(transformed(d.across[i], corners[k % n]));
      };
      EXPECT_LT(gap(image(j), d.polygon[(i + 1) % n]), 1e-13);
      EXPECT_LT(gap(image(j + 1), d.polygon[i]), 1e-13);
    }
  }
}

TEST(ClosedDomain, SidesArePairedAsAsked) {
  const Domain opposite = surface_domain(3, SidePairing::Opposite);
  const Domain canonical = surface_domain(3, SidePairing::Canonical);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(glued_side(opposite, i), (i + 6) % 12);
    EXPECT_EQ(glued_side(canonical, i), i % 4 < 2 ? i + 2 : i - 2);
  }
}

TEST(ClosedDomain, RelatorIsTheIdentity) {
  for (const Domain& d : closed_domains()) {
    // Round corner 0 from polygon to polygon, through the side after the corner. A frame at the
    // corner stays at corners on its way, so that long translations do not magnify rounding.
    std::vector<std::size_t> sides;
    std::size_t corner = 0;
    do {
      sides.push_back(corner);
      corner = (glued_side(d, corner) + 1) % d.polygon.size();
    } while (corner != 0 && sides.size() < 100);
    EXPECT_EQ(sides.size(), d.polygon.size());
    const Frame start = frame_at(d.kappa, model_corners(d)[0]);
    Frame f = start;
    std::ranges::reverse(sides);
    for (const std::size_t side : sides) {
      f.P = transformed(d.across[side], f.P), f.E1 = transformed(d.across[side], f.E1);
      f = orthonormal(f);
    }
    const Offset moved = offset_in(start, f.P);
    const Frame back = carried(f, {-moved.x, -moved.y, moved.h});
    const Offset axis = offset_in(start, model_point(back, from_chord({d.kappa}, 1e-3, 1, 0)));
    const double turned_by = std::atan2(axis.y, axis.x);
    EXPECT_LT(std::hypot(moved.x, moved.y), 1e-12 * start.P[2]) << d.genus;
    EXPECT_LT(std::abs(turned_by), 1e-12 * start.P[2]) << d.genus;
  }
}

TEST(ClosedDomain, PolygonsAcrossTile) {
  for (const Domain& d : closed_domains()) {
    for (const ModelPoint& p : random_points(d, 100, 3)) {
      ASSERT_TRUE(contains(d, p));
      for (const ModelMatrix& m : d.across) {
        const ModelPoint q = on_model(d.kappa, transformed(m, p));
        EXPECT_FALSE(contains(d, q));
        EXPECT_LT(gap(central_point(into_polygon(d, q)), central_point(p)), 1e-11);
      }
    }
    // No gaps: two steps away everything has its image in the polygon, and only one.
    for (const ModelPoint& p : random_points(d, 30, 4)) {
      for (std::size_t i = 0; i < d.across.size(); ++i) {
        const ModelPoint q = on_model(
            d.kappa, transformed(d.across[i], transformed(d.across[(i + 1) % d.across.size()], p)));
        EXPECT_LT(gap(central_point(into_polygon(d, q)), central_point(p)), 1e-9);
      }
    }
  }
}

TEST(IntoPolygon, FindsTheNearestImageToTheCentre) {
  const Domain d = surface_domain(2, SidePairing::Canonical);
  const Frame centre{-1};
  std::mt19937_64 random(2);
  for (int i = 0; i < 1000; ++i) {
    const auto p = model_point(centre, from_chord({-1}, 6, std::cos(i), std::sin(i)));
    const ModelPoint q = into_polygon(d, p);
    EXPECT_TRUE(contains(d, q));
    for (const ModelMatrix& m : d.across) {
      EXPECT_GE(transformed(m, q)[2], q[2] - 1e-9);
    }
  }
  EXPECT_THROW(into_polygon(torus_domain({1, 0}, {0, 1}), {1e300, 0, 1}), NumericalError);
}

TEST(Contains, KnowsTheSidesAndTheModel) {
  const Domain square = polygon_domain(0, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_TRUE(contains(square, {0.5, 0, 1}));
  EXPECT_TRUE(contains(square, {1, 1, 1}));
  EXPECT_FALSE(contains(square, {0.5, -1e-9, 1}));
  EXPECT_FALSE(contains(square, {0.5, 0.5, 1.001}));
  EXPECT_FALSE(contains(square, {std::nan(""), 0.5, 1}));
  EXPECT_TRUE(contains(sphere_domain(), {0, -0.6, -0.8}));
  EXPECT_FALSE(contains(sphere_domain(), {0, -0.6, -0.7}));
  EXPECT_FALSE(contains(surface_domain(2, SidePairing::Opposite), {0, 0, -1}));
}

TEST(RandomPoints, AreUniformByArea) {
  const std::size_t n = 40000;
  for (const Domain& d :
       {surface_domain(2, SidePairing::Opposite), surface_domain(4, SidePairing::Canonical),
        torus_domain({1, 0}, {0.3, 0.8}), sphere_domain(),
        polygon_domain(-1, {{0.9, 0}, {0.99, 0.05}, {0.2, 0.9}, {-0.9, -0.4}})}) {
    // Shares of disks about some points inside against 2 pi h.
    const auto points = random_points(d, n, 5);
    const Frame f = central_frame(d);
    double inside = 10;
    for (std::size_t i = 0; i < d.polygon.size(); ++i) {
      const auto corners = model_corners(d);
      for (int t = 0; t <= 100; ++t) {
        const Offset a = offset_in(f, corners[i]),
                     b = offset_in(f, corners[(i + 1) % corners.size()]);
        const double za = model_z({d.kappa}, a), zb = model_z({d.kappa}, b), u = t / 100.0;
        inside = std::min(inside, from_central({d.kappa}, (1 - u) * a.x / za + u * b.x / zb,
                                               (1 - u) * a.y / za + u * b.y / zb)
                                      .h);
      }
    }
    for (const double share : {0.05, 0.2, 0.5, 0.95}) {
      const double h = share * std::min(inside, 2.0);
      const double expected = 2 * pi * h / d.area;
      const auto count =
          std::ranges::count_if(points, [&](const ModelPoint& p) { return offset_in(f, p).h < h; });
      const double sigma = std::sqrt(expected * (1 - expected) / static_cast<double>(n));
      EXPECT_NEAR(static_cast<double>(count) / static_cast<double>(n), expected, 5 * sigma);
    }
    EXPECT_TRUE(std::ranges::all_of(points, [&](const ModelPoint& p) { return contains(d, p); }));
  }
}

TEST(RandomPoints, FillThePolygonToItsCorners) {
  // The fraction of a triangle cut off by a line through its sides.
  const Domain whole = polygon_domain(-1, {{0, 0}, {0.98, 0}, {0, 0.98}});
  const Domain part = polygon_domain(-1, {{0.7, 0}, {0.98, 0}, {0.7, 0.28}});
  const auto points = random_points(whole, 40000, 6);
  const auto count =
      std::ranges::count_if(points, [&](const ModelPoint& p) { return contains(part, p); });
  const double expected = part.area / whole.area;
  EXPECT_NEAR(static_cast<double>(count) / 40000, expected, 5 * std::sqrt(expected / 40000));
}

TEST(RandomPoints, AreDeterministicForASeed) {
  const Domain d = surface_domain(2, SidePairing::Opposite);
  EXPECT_EQ(random_points(d, 20, 7), random_points(d, 20, 7));
  EXPECT_NE(random_points(d, 20, 7), random_points(d, 20, 8));
}

// Found by fuzzing: convex as far as doubles tell, and its area was 0.
TEST(Polygons, WithoutAreaInDoublesAreRefused) {
  EXPECT_THROW(polygon_domain(0, {{0.5, 0}, {3.3e38, 5}, {0, 0}}), InvalidInput);
  EXPECT_THROW(polygon_domain(0, {{0, 0}, {1e300, 0}, {0, 1e300}}), InvalidInput);
}

}  // namespace
}  // namespace ucvt
