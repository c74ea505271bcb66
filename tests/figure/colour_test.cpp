#include "figure/colour.h"

#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace ucvt {
namespace {

double linear(int channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Lightness of OKLab (B. Ottosson, A perceptual color space for image processing, 2020).
double lightness(const Colour& c) {
  const double r = linear(c.r), g = linear(c.g), b = linear(c.b);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
}

TEST(Colour, MapRisesEvenlyInLightness) {
  for (int i = 0; i <= 64; ++i) {
    const double t = i / 64.0;
    EXPECT_NEAR(lightness(map_colour(t)), 0.36 + 0.58 * t, 0.012) << t;
  }
}

TEST(Colour, MapIsClamped) {
  EXPECT_EQ(hex(map_colour(-1)), hex(map_colour(0)));
  EXPECT_EQ(hex(map_colour(2)), hex(map_colour(1)));
}

TEST(Colour, Hex) {
  EXPECT_EQ(hex({0, 10, 255}), "#000aff");
}

TEST(Colour, DegreesAreToldApartAndHexagonsWhite) {
  for (const bool grey : {false, true}) {
    std::set<std::string> seen;
    for (int degree = 4; degree <= 8; ++degree) {
      seen.insert(hex(degree_colour(degree_class(degree), grey)));
    }
    EXPECT_EQ(seen.size(), 5U);
    EXPECT_EQ(hex(degree_colour(degree_class(6), grey)), "#ffffff");
  }
  EXPECT_EQ(degree_class(3), degree_class(4));
  EXPECT_EQ(degree_class(12), degree_class(8));
}

TEST(Colour, CopiesAreLighter) {
  for (int i = 0; i <= 8; ++i) {
    const Colour c = map_colour(i / 8.0);
    EXPECT_GT(lightness(faded(c)), std::min(lightness(c), 0.93)) << i;
  }
  EXPECT_NE(hex(faded({})), "#ffffff") << "the fundamental domain stands out unshaded";
}

}  // namespace
}  // namespace ucvt
