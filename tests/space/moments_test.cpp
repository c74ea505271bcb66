#include "space/moments.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include <nlohmann/json.hpp>

#include "oracle/generators.h"

namespace ucvt {
namespace {

using oracle::norm;
using oracle::number;
using oracle::point;
using oracle::scale;
using oracle::space;
using Corner3 = std::array<Offset, 3>;

ChordTriangle chord_triangle(Space s, const Corner3& c) {
  return {{chord2(s, c[0], c[1]), chord2(s, c[1], c[2]), chord2(s, c[2], c[0])},
          orientation(s, c[0], c[1], c[2])};
}

Moments moments(Space s, const Corner3& c, const std::array<double, 3>& rho) {
  return moments_of(s, integrate(s, chord_triangle(s, c), rho), c);
}

/// A counterclockwise triangle round a random point, of about the given size.
Corner3 triangle(Space s, double size) {
  const double x = size * number(-0.3, 0.3), y = size * number(-0.3, 0.3), turn = number(-3, 3);
  const std::array<double, 3> angle{turn, turn + number(1, 2), turn + number(3.3, 4)};
  Corner3 c;
  for (std::size_t i = 0; i < 3; ++i) {
    const double r = size * number(0.1, 0.39);
    c[i] = from_central(s, x + r * std::cos(angle[i]), y + r * std::sin(angle[i]));
  }
  return c;
}

std::array<double, 3> density() {
  return {number(0.1, 3), number(0.1, 3), number(0.1, 3)};
}

/// The moments as seen from a frame carried parallel to `a`: the transvection, applied to the sums.
Moments seen_from(Space s, const Offset& a, const Moments& m) {
  const double ax = -a.x, ay = -a.y, dot = ax * m.x + ay * m.y;
  const double f = m.m - s.kappa * (m.h + dot / (2 - s.kappa * a.h));
  return {m.m, m.x + ax * f, m.y + ay * f, a.h * m.m + m.h - s.kappa * a.h * m.h + dot};
}

/// How far two moments differ, relative to the mass and the reach of the corners.
double difference(const Moments& p, const Moments& q, double reach) {
  return std::max({std::abs(p.m - q.m), std::abs(p.x - q.x) / reach, std::abs(p.y - q.y) / reach,
                   std::abs(p.h - q.h) / (reach * reach)}) /
         std::abs(q.m);
}

double reach_of(const Corner3& c) {
  return std::max({norm(c[0]), norm(c[1]), norm(c[2])});
}

RC_GTEST_PROP(Moments, AddUpWhenTheTriangleIsCut, ()) {
  const Space s = space();
  const Corner3 c = triangle(s, scale());
  const auto rho = density();
  const ChordTriangle t = chord_triangle(s, c);
  const double u = number(0.05, 0.9), v = number(0.05, 0.95) * (1 - u);
  const std::array<Barycentric, 3> corner{{{0, 0}, {1, 0}, {0, 1}}};
  Weights sum;
  for (std::size_t i = 0; i < 3; ++i) {
    sum += integrate_piece(s, t, rho, corner[i], corner[(i + 1) % 3], {u, v});
  }
  RC_ASSERT(difference(moments_of(s, sum, c), moments(s, c, rho), reach_of(c)) < 1e-11);
}

TEST(Moments, EverySizeIsIntegratedToTwelveDigits) {
  // Against the sum of 144 pieces, whose own rules leave errors smaller by powers of twelve: the
  // sizes run across every bound at which the order of the quadrature changes.
  for (const double kappa : {1.0, -1.0}) {
    const Space s{kappa};
    for (double size = 0.8; size > 1e-4; size /= 1.2) {
      const Corner3 c{from_central(s, size, 0), from_central(s, -0.4 * size, 0.7 * size),
                      from_central(s, -0.6 * size, -0.5 * size)};
      const std::array<double, 3> rho{0.3, 2, 1};
      const ChordTriangle t = chord_triangle(s, c);
      constexpr int n = 12;
      const auto at = [](int i, int j) {
        return Barycentric{static_cast<double>(i) / n, static_cast<double>(j) / n};
      };
      Weights sum;
      for (int i = 0; i < n; ++i) {
        for (int j = 0; i + j < n; ++j) {
          sum += integrate_piece(s, t, rho, at(i, j), at(i + 1, j), at(i, j + 1));
          if (i + j + 1 < n) {
            sum += integrate_piece(s, t, rho, at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
          }
        }
      }
      const Moments exact = moments_of(s, sum, c), got = moments(s, c, rho);
      EXPECT_NEAR(got.m / exact.m, 1, 1e-13) << kappa << " " << size;
      EXPECT_NEAR(got.x / exact.m / size, exact.x / exact.m / size, 1e-12) << kappa << " " << size;
      EXPECT_NEAR(got.y / exact.m / size, exact.y / exact.m / size, 1e-12) << kappa << " " << size;
      EXPECT_NEAR(got.h / exact.h, 1, 1e-12) << kappa << " " << size;
    }
  }
}

RC_GTEST_PROP(Moments, AreTheSameFromEveryFrame, ()) {
  const Space s = space();
  const double size = scale();
  const Corner3 c = triangle(s, size);
  const auto rho = density();
  const Offset a = point(s, size);
  Corner3 moved;
  for (std::size_t i = 0; i < 3; ++i) {
    moved[i] = on_quadric(s, transvect_back(s, a, c[i]));
  }
  RC_ASSERT(difference(moments(s, moved, rho), seen_from(s, a, moments(s, c, rho)),
                       reach_of(c) + reach_of(moved)) < 2e-11);
}

RC_GTEST_PROP(Moments, HaveAClosedFormInThePlane, ()) {
  const Space s{0};
  const Corner3 c = triangle(s, scale());
  const auto rho = density();
  const double area = chord_triangle(s, c).det / 2, sum = rho[0] + rho[1] + rho[2];
  Moments exact{area * sum / 3, 0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const double w = area * (sum + rho[i]) / 12;
    exact.x += w * c[i].x, exact.y += w * c[i].y;
    // int b_i b_j b_k, for int rho |p|^2 / 2.
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int same = (i == j) + (j == k) + (k == i);
        const double mean = same == 0 ? 1.0 / 60 : same == 1 ? 1.0 / 30 : 1.0 / 10;
        exact.h += area * mean * rho[k] * (c[i].x * c[j].x + c[i].y * c[j].y) / 2;
      }
    }
  }
  RC_ASSERT(difference(moments(s, c, rho), exact, reach_of(c)) < 1e-13);
}

/// DESIGN's closed form for uniform density: Lambert's sum in offsets.
Moments uniform_polygon(Space s, const Corner3& c) {
  Moments out;
  double area_minus = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Offset &a = c[i], &b = c[(i + 1) % 3];
    const double d = length_of_chord(s, std::sqrt(chord2(s, a, b))), d2 = d * d, k = s.kappa;
    double g = d2 / 6;
    if (k != 0 && d < 0.15) {
      g = 1.0 / 6 +
          d2 * (k * 7 / 360 + d2 * (31.0 / 15120 + d2 * (k * 127 / 604800 + d2 * 73.0 / 3421440)));
      g *= d2;
    } else if (k != 0) {
      g = k * (d / (k > 0 ? std::sin(d) : std::sinh(d)) - 1);
    }
    out.x += ((1 + k * g) * (a.h * b.y - a.y * b.h) + g * (a.y - b.y)) / 2;
    out.y += ((1 + k * g) * (a.x * b.h - a.h * b.x) + g * (b.x - a.x)) / 2;
    area_minus += (1 + k * g) * cross(a, b) / 2;
    out.m += central_triangle_area(s, a, b);
  }
  out.h = s.kappa * (out.m - area_minus);
  return out;
}

RC_GTEST_PROP(Moments, HaveLambertsClosedFormAtUniformDensity, ()) {
  const Space s = space();
  const Corner3 c = triangle(s, scale());
  const Moments exact = uniform_polygon(s, c), got = moments(s, c, {1, 1, 1});
  const double reach = reach_of(c), rounding = 1e-13 * (exact.m + reach * reach);
  RC_ASSERT(std::abs(got.m - exact.m) < rounding);
  RC_ASSERT(std::abs(got.x - exact.x) < rounding * reach);
  RC_ASSERT(std::abs(got.y - exact.y) < rounding * reach);
  if (s.kappa != 0) {
    RC_ASSERT(std::abs(got.h - exact.h) < rounding);
  }
}

TEST(Moments, MatchTheGoldenFile) {
  const char* shared = std::getenv("UCVT_SHARED");
  if (shared == nullptr) {
    GTEST_SKIP() << "set UCVT_SHARED to the folder that holds golden/moments.json";
  }
  std::ifstream file(std::string(shared) + "/golden/moments.json");
  ASSERT_TRUE(file) << "no golden/moments.json in " << shared;
  const auto json = nlohmann::json::parse(file);
  ASSERT_GE(json["cases"].size(), 72U);
  for (const auto& g : json["cases"]) {
    const Space s{g["kappa"].get<double>()};
    Corner3 c;
    double rim = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      c[i] = from_central(s, g["corners"][i][0], g["corners"][i][1]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      rim = std::max(rim, std::sqrt(chord2(s, c[i], c[(i + 1) % 3])));
    }
    const Moments got = moments(s, c, g["rho"].get<std::array<double, 3>>());
    // A unit in the last place of the corners changes the determinant by this much.
    const double reach = reach_of(c), det = orientation(s, c[0], c[1], c[2]);
    const double tolerance = 1e-12 + 8 * std::numeric_limits<double>::epsilon() * reach * rim / det;
    const double mass = g["mass"].get<double>(), mh = g["mh"].get<double>();
    SCOPED_TRACE(g.dump());
    EXPECT_NEAR(got.m / mass, 1, tolerance);
    EXPECT_NEAR(got.x / mass / reach, g["mx"].get<double>() / mass / reach, tolerance);
    EXPECT_NEAR(got.y / mass / reach, g["my"].get<double>() / mass / reach, tolerance);
    EXPECT_NEAR(got.h / mh, 1, tolerance);
  }
}

RC_GTEST_PROP(Moments, TheCentroidIsWhereTheEnergyHasNoSlope, ()) {
  const Space s = space();
  const double size = scale();
  const Corner3 c = triangle(s, size);
  const Moments m = moments(s, c, density());
  const Offset at = centroid(s, m);
  RC_ASSERT(norm(at) < reach_of(c) * 1.5);
  const Moments there = seen_from(s, at, m);
  RC_ASSERT(std::hypot(there.x, there.y) < 1e-13 * m.m * reach_of(c) * 4);
  // Energies 2 Mh round it, by finite differences.
  const double step = 1e-3 * size;
  const auto energy = [&](double x, double y) {
    return 2 * seen_from(s, from_central(s, x, y), there).h;
  };
  const double ex = (energy(step, 0) - energy(-step, 0)) / (2 * step);
  const double ey = (energy(0, step) - energy(0, -step)) / (2 * step);
  RC_ASSERT(std::hypot(ex, ey) < 1e-10 * m.m * size);
  RC_ASSERT(std::min({energy(step, 0), energy(-step, 0), energy(0, step), energy(0, -step)}) >
            2 * there.h);
  // Away from the centroid the gradient is -2 (Mx, My).
  const auto moved = [&](double x, double y) {
    return 2 * seen_from(s, from_central(s, x, y), m).h;
  };
  const double gx = (moved(step, 0) - moved(-step, 0)) / (2 * step);
  RC_ASSERT(std::abs(gx + 2 * m.x) < 1e-5 * m.m * (norm(at) + size));
}

TEST(Moments, SignsOfWeights) {
  for (const double kappa : {1.0, 0.0, -1.0}) {
    const Space s{kappa};
    const Corner3 c{from_central(s, 0, 0), from_central(s, 0.3, 0), from_central(s, 0, 0.4)};
    const Weights w = integrate(s, chord_triangle(s, c), {1, 2, 3});
    EXPECT_LT(w.excess, 0);
    EXPECT_GT(std::min({w.mu[0], w.mu[1], w.mu[2], w.mass(s)}), 0);
    EXPECT_GT(moments_of(s, w, c).h, 0);
  }
}

RC_GTEST_PROP(TriangleDeterminant, AgreesWithTheCorners, ()) {
  const Space s = space();
  const Corner3 c = triangle(s, scale());
  const ChordTriangle t = chord_triangle(s, c);
  const double det = triangle_determinant(
      s, {std::sqrt(t.chord2[0]), std::sqrt(t.chord2[1]), std::sqrt(t.chord2[2])});
  RC_ASSERT(std::abs(det - t.det) < 1e-10 * t.det);
}

TEST(TriangleDeterminant, KnownAndDegenerate) {
  EXPECT_DOUBLE_EQ(triangle_determinant({0}, {3, 4, 5}), 12);
  EXPECT_NEAR(triangle_determinant({1}, {M_SQRT2, M_SQRT2, M_SQRT2}), 1, 1e-15);
  EXPECT_EQ(triangle_determinant({0}, {1, 2, 3.5}), 0);
  EXPECT_EQ(triangle_determinant({-1}, {1, 2, 8}), 0);
  // No three points of the sphere are so far apart; in space the triangle exists.
  EXPECT_EQ(triangle_determinant({1}, {1.9, 1.9, 1.9}), 0);
  // A needle, by (base x height) to the last digits.
  const double height = 1e-9, side = std::hypot(0.5, height);
  EXPECT_NEAR(triangle_determinant({0}, {1e-5, 1, 1}), 1e-5 * std::sqrt(1 - 0.25e-10), 1e-19);
  EXPECT_NEAR(triangle_determinant({0}, {1, side, side}), height, 1e-6);
  for (const double kappa : {1.0, 0.0, -1.0}) {
    const double d = triangle_determinant({kappa}, {0.3, 0.4, 0.45});
    EXPECT_EQ(d, triangle_determinant({kappa}, {0.45, 0.3, 0.4}));
    EXPECT_EQ(d, triangle_determinant({kappa}, {0.4, 0.45, 0.3}));
  }
}

}  // namespace
}  // namespace ucvt
