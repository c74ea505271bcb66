// Where the paper's section 5.2 is wrong; docs/paper.md cites these tests.
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "space/polygon_moments.h"
#include "space/polygon_test_support.h"

namespace ucvt {
namespace {

/// Projected from the centre onto the model.
Central projected(double x, double y, double z) {
  return {x / z, y / z};
}

TEST(PaperErrors, MediansOfAConstantDensityTriangleDoNotMeetAtTheModelCentroid) {
  // "although the centroid of a triangle with constant density is proved to be coincident with the
  // common point of its three medians": true of three equal masses at the corners, and of Stahl's
  // centroid, but not of the paper's own equation 4, nor of equation 3 on the sphere.
  for (const double kappa : {1.0, -1.0}) {
    const Space s{kappa};
    for (const double size : {0.8, 0.2}) {
      const Polygon c = from_central(s, {{1, 0}, {-0.2, 0.3}, {-0.3, -0.2}}, size);
      std::array<double, 3> sum{};
      for (const Offset& p : c) {
        sum[0] += p.x, sum[1] += p.y, sum[2] += model_z(s, p);
      }
      const Central meet = projected(sum[0], sum[1], sum[2]);
      const Offset at = ucvt::from_central(s, meet.x, meet.y);
      for (std::size_t i = 0; i < 3; ++i) {
        const Offset &a = c[(i + 1) % 3], &b = c[(i + 2) % 3];
        const Central k = projected(a.x + b.x, a.y + b.y, model_z(s, a) + model_z(s, b));
        const Offset middle = ucvt::from_central(s, k.x, k.y);
        EXPECT_NEAR(chord2(s, a, middle), chord2(s, b, middle), 1e-15);
        EXPECT_NEAR(orientation(s, c[i], middle, at), 0, 1e-15);
      }
      // The centroid two ways; it is nearer to the far corner's side by a multiple of size^3.
      const Moments m = uniform_moments(s, c), brute = brute_force(s, c, one, 2);
      const Offset exact = centroid(s, m);
      EXPECT_LT(std::sqrt(chord2(s, exact, centroid(s, brute))), 1e-14);
      const double apart = std::sqrt(chord2(s, exact, at));
      EXPECT_GT(apart, 0.01 * size * size * size) << kappa << " " << size;
      // Where the medians meet, the gradient of the cell's energy is not zero.
      const Moments seen = uniform_moments(s, moved(s, at, c));
      EXPECT_NEAR(std::hypot(seen.x, seen.y) / m.m, apart, 0.1 * apart);
    }
  }
  // In the plane it is true.
  const Polygon c = from_central({0}, {{1, 0}, {-0.2, 0.3}, {-0.3, -0.2}}, 1);
  const Moments m = uniform_moments({0}, c);
  EXPECT_NEAR(m.x / m.m, 0.5 / 3, 1e-15);
  EXPECT_NEAR(m.y / m.m, 0.1 / 3, 1e-15);
}

/// Centroid from samples on a grid of the plane z = 0, each with its weight.
Central grid_centroid(Space s, const Polygon& c, int n, bool over_z) {
  double sx = 0, sy = 0, sz = 0;
  for (int i = -n; i <= n; ++i) {
    for (int j = -n; j <= n; ++j) {
      const double x = (i + 0.37) * 3 / n, y = (j + 0.61) * 3 / n, q = x * x + y * y;
      if (s.kappa * q >= 1) {
        continue;
      }
      const double z = std::sqrt(1 - s.kappa * q);
      bool inside = true;
      for (std::size_t k = 0; k < c.size(); ++k) {
        const Offset p{x, y, s.kappa * (1 - z)};
        inside = inside && orientation(s, c[k], c[(k + 1) % c.size()], p) > 0;
      }
      if (inside) {
        const double weight = over_z ? 1 / z : 1;
        sx += weight * x, sy += weight * y, sz += weight * z;
      }
    }
  }
  return projected(sx, sy, sz);
}

TEST(PaperErrors, SumOverAUniformGridOnThePlaneNeedsTheFactorOneOverZ) {
  // "The plane z = 0 is uniformly sampled using a regular grid. We perform the summation over all
  // samples ... to approximate the integral": dx dy = z dsigma, on the sphere and the hyperboloid.
  for (const double kappa : {1.0, -1.0}) {
    const Space s{kappa};
    const Polygon c = from_central(s, {{1, 0.1}, {-0.2, 0.5}, {-0.5, -0.4}}, 0.85);
    const Offset exact = centroid(s, uniform_moments(s, c));
    const Offset other =
        centroid(s, brute_force(s, c, [&](const Offset& p) { return model_z(s, p); }, 4));
    const auto distance = [&](const Offset& to, int n, bool over_z) {
      const Central k = grid_centroid(s, c, n, over_z);
      return std::sqrt(chord2(s, ucvt::from_central(s, k.x, k.y), to));
    };
    for (const int n : {100, 400, 1600}) {
      EXPECT_LT(distance(exact, n, true), 0.5 / n) << kappa << " " << n;
      EXPECT_LT(distance(other, n, false), 0.5 / n) << kappa << " " << n;
      EXPECT_GT(distance(exact, n, false), 0.005) << kappa << " " << n;
    }
  }
}

}  // namespace
}  // namespace ucvt
