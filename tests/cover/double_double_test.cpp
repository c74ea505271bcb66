#include "cover/double_double.h"

#include <gtest/gtest.h>

namespace ucvt {
namespace {

TEST(DoubleDouble, KeepsThirtyDigits) {
  const DoubleDouble third = DoubleDouble{1} / DoubleDouble{3};
  EXPECT_LT(std::abs((third * DoubleDouble{3} - DoubleDouble{1}).value()), 1e-31);
  const DoubleDouble root = sqrt(DoubleDouble{2});
  EXPECT_LT(std::abs((root * root - DoubleDouble{2}).value()), 1e-31);
  const DoubleDouble tiny{1e-25};
  EXPECT_EQ((DoubleDouble{1} + tiny - DoubleDouble{1}).value(), 1e-25);
}

TEST(DoubleDouble, IsWrittenWithItsDigits) {
  EXPECT_EQ(to_decimal(sqrt(DoubleDouble{2})).substr(0, 31), "1.41421356237309504880168872420");
  EXPECT_EQ(to_decimal(DoubleDouble{-1} / DoubleDouble{3}).substr(0, 31),
            "-3.3333333333333333333333333333");
  for (const double x : {1.0, -10.0, 0.1, 9.999999999999999, 1e22, 123456.789, 1e-20, 0.0}) {
    EXPECT_EQ(std::stod(to_decimal(DoubleDouble{x})), x);
  }
}

}  // namespace
}  // namespace ucvt
