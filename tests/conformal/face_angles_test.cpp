#include "conformal/face_angles.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace ucvt {
namespace {

/// The angle opposite to c, from its cosine law in half chords, and cot(beta) of c.
struct Expected {
  long double angle, cot;
};
Expected expected(long double kappa, long double a, long double b, long double c) {
  const long double f = (a + b + c) * (a + b - c) * (b + c - a) * (c + a - b);
  const long double s = std::sqrt(f - 4 * kappa * a * a * b * b * c * c);
  const long double cosine = a * a + b * b - c * c;
  return {std::atan2(s, cosine - 2 * kappa * a * a * b * b), cosine / s};
}

class FaceAnglesTest : public testing::TestWithParam<double> {
 protected:
  std::mt19937_64 random{7};

  /// Half chords of a triangle whose sides are up to `size` long, as thin as `thin`.
  void set_triangle(double size, double thin, double* half) {
    std::uniform_real_distribution<double> unit(0, 1);
    const double x = size * unit(random), y = size * thin * (0.1 + unit(random)), base = size;
    std::array<double, 3> side{base, std::hypot(base - x, y), std::hypot(x, y)};
    std::shuffle(side.begin(), side.end(), random);
    std::copy(side.begin(), side.end(), half);
  }
};

TEST_P(FaceAnglesTest, AgreeWithTheCosineLaw) {
  FourFaces half, angle, cot;
  for (int round = 0; round < 2000; ++round) {
    // Thin triangles have room on the sphere only where they are small.
    const double thin = std::pow(0.5, round % 7), size = 0.04 * thin * std::pow(0.5, round % 20);
    for (std::size_t k = 0; k < 12; k += 3) {
      set_triangle(size, thin, &half[k]);
    }
    ASSERT_TRUE(face_angles({GetParam()}, half, angle, cot));
    for (std::size_t k = 0; k < 12; ++k) {
      const std::size_t face = k / 3 * 3;
      const auto e =
          expected(GetParam(), half[face + (k + 1) % 3], half[face + (k + 2) % 3], half[k]);
      // Thin triangles: rounding of their sides changes angles by as much more.
      const double rounding = 1e-14 / (thin * thin);
      EXPECT_NEAR(angle[k], static_cast<double>(e.angle), rounding);
      EXPECT_NEAR(cot[k], static_cast<double>(e.cot), rounding * (1 + std::pow(cot[k], 2)));
    }
  }
}

TEST_P(FaceAnglesTest, AnglesFromZeroToPiAreExactToRounding) {
  // Isosceles triangles, so flat or so steep that every part of the arc tangent is met.
  FourFaces half, angle, cot;
  for (int step = 1; step < 4000; ++step) {
    const double apex = std::numbers::pi * step / 4000, leg = 1e-6;
    for (std::size_t k = 0; k < 12; k += 3) {
      half[k] = 2 * leg * std::sin(apex / 2), half[k + 1] = half[k + 2] = leg;
    }
    ASSERT_TRUE(face_angles({GetParam()}, half, angle, cot));
    const auto e = expected(GetParam(), half[1], half[2], half[0]);
    EXPECT_NEAR(angle[0], static_cast<double>(e.angle), 4e-15 / std::sin(apex));
  }
}

TEST_P(FaceAnglesTest, OneFaceThatIsNoneIsNoticedWhereverItStands) {
  for (const double scale : {1e-3, 1e-90}) {
    FourFaces good, angle, cot;
    good.fill(scale);
    ASSERT_TRUE(face_angles({GetParam()}, good, angle, cot));
    for (std::size_t k = 0; k < 12; ++k) {
      FourFaces half = good;
      half[k] = 2.5 * scale;
      EXPECT_FALSE(face_angles({GetParam()}, half, angle, cot));
      half[k] = std::numeric_limits<double>::quiet_NaN();
      EXPECT_FALSE(face_angles({GetParam()}, half, angle, cot));
    }
  }
}

TEST_P(FaceAnglesTest, TinyFacesAreFlat) {
  FourFaces half, angle, cot;
  half.fill(0.1);
  half[3] = 3e-90, half[4] = 4e-90, half[5] = 5e-90;
  ASSERT_TRUE(face_angles({GetParam()}, half, angle, cot));
  EXPECT_NEAR(angle[5], std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(angle[3], std::atan2(3, 4), 1e-15);
  EXPECT_NEAR(cot[3], 4.0 / 3, 1e-15);
  EXPECT_NEAR(angle[0], static_cast<double>(expected(GetParam(), 0.1L, 0.1L, 0.1L).angle), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Geometries, FaceAnglesTest, testing::Values(1.0, 0.0, -1.0));

}  // namespace
}  // namespace ucvt
