#include "figure/raster.h"

#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

namespace ucvt {
namespace {

constexpr Colour red{200, 0, 0}, blue{0, 0, 200};

Colour pixel_of(const Image& image, int x, int y) {
  const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(x));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

void square(Raster& raster, double z, std::int32_t label, const Colour& colour) {
  const auto all = [&](const auto&) { return colour; };
  raster.triangle({Position{10, 10, z}, {30, 10, z}, {30, 30, z}}, label, all);
  raster.triangle({Position{10, 10, z}, {30, 30, z}, {10, 30, z}}, label, all);
}

TEST(Raster, TheNearestIsSeenInWhateverOrderItIsDrawn) {
  for (const bool near_first : {true, false}) {
    Raster raster(40, 40);
    square(raster, near_first ? 2 : 1, near_first ? 7 : 8, near_first ? red : blue);
    square(raster, near_first ? 1 : 2, near_first ? 8 : 7, near_first ? blue : red);
    EXPECT_EQ(raster.label_at(20, 20), 7);
    EXPECT_EQ(pixel_of(raster.image(), 20, 20).r, 200);
    EXPECT_EQ(pixel_of(raster.image(), 20, 20).b, 0);
    EXPECT_EQ(raster.label_at(5, 20), Raster::background);
    EXPECT_EQ(pixel_of(raster.image(), 5, 20).g, 255);
  }
}

TEST(Raster, TrianglesThatShareASideLeaveNoGap) {
  Raster raster(40, 40);
  square(raster, 0, 1, red);
  for (int y = 10; y < 30; ++y) {
    for (int x = 10; x < 30; ++x) {
      ASSERT_EQ(pixel_of(raster.image(), x, y).r, 200) << x << ' ' << y;
    }
  }
}

TEST(Raster, ABallHasTheAreaOfItsDisk) {
  Raster raster(200, 200);
  raster.ball({100, 100, 0}, 80, 1, [](const Position&) { return Colour{0, 0, 0}; });
  double area = 0;
  for (const std::uint8_t channel : raster.image().rgb) {
    area += (255 - channel) / 255.0 / 3;
  }
  EXPECT_NEAR(area, std::numbers::pi * 80 * 80, 0.01 * std::numbers::pi * 80 * 80);
}

TEST(Raster, ABallBulgesThroughAPlaneAtItsCentre) {
  Raster raster(40, 40);
  square(raster, 0, 1, red);
  raster.ball({20, 20, 0}, 5, 2, [](const Position&) { return blue; });
  EXPECT_EQ(raster.label_at(20, 20), 2);
  EXPECT_EQ(raster.label_at(26, 20), 1);
  Raster hidden(40, 40);
  square(hidden, 6, 1, red);
  hidden.ball({20, 20, 0}, 5, 2, [](const Position&) { return blue; });
  EXPECT_EQ(hidden.label_at(20, 20), 1);
}

TEST(Raster, LinesRunWhereLabelsMeet) {
  Raster raster(40, 40);
  const auto white = [](const auto&) { return Colour{255, 255, 255}; };
  raster.triangle({Position{10, 10, 0}, {30, 10, 0}, {30, 30, 0}}, 1, white);
  raster.triangle({Position{10, 10, 0}, {30, 30, 0}, {10, 30, 0}}, 2, white);
  raster.outline(2, {0, 0, 0});
  const Image image = raster.image();
  EXPECT_LT(pixel_of(image, 20, 20).r, 80);
  EXPECT_LT(pixel_of(image, 20, 9).r + pixel_of(image, 20, 10).r, 300);
  EXPECT_EQ(pixel_of(image, 25, 15).r, 255);
  EXPECT_EQ(pixel_of(image, 15, 25).r, 255);
  EXPECT_EQ(pixel_of(image, 5, 5).r, 255);
}

TEST(Png, DecodesToTheImage) {
  Raster raster(50, 20);
  raster.ball({25, 10, 0}, 8, 1, [](const Position& n) {
    return Colour{static_cast<int>(100 + 100 * n[0]), 30, 200};
  });
  const Image image = raster.image();
  const std::string bytes = png_bytes(image);
  png_image head{};
  head.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&head, bytes.data(), bytes.size()), 0);
  EXPECT_EQ(head.width, 50U);
  EXPECT_EQ(head.height, 20U);
  head.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(head));
  ASSERT_NE(png_image_finish_read(&head, nullptr, rgb.data(), 0, nullptr), 0);
  EXPECT_EQ(rgb, image.rgb);
}

TEST(Png, Base64IsThatOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

}  // namespace
}  // namespace ucvt
