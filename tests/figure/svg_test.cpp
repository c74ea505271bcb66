#include "figure/svg.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "figure/svg_reader.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

TEST(Svg, NumbersAreShort) {
  EXPECT_EQ(number(0), "0");
  EXPECT_EQ(number(-0.0001), "0");
  EXPECT_EQ(number(100), "100");
  EXPECT_EQ(number(1.5), "1.5");
  EXPECT_EQ(number(-2.0 / 3), "-0.667");
}

TEST(Svg, NumbersThatAreNotFiniteAreRefused) {
  EXPECT_THROW(number(std::nan("")), InvalidInput);
  EXPECT_THROW(number(std::numeric_limits<double>::infinity()), InvalidInput);
}

TEST(Svg, MarkupIsEscaped) {
  EXPECT_EQ(escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
}

TEST(Svg, Utf8IsKeptAndWhatIsNotIsReplaced) {
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(escaped("π ≤ 𝕊²"), "π ≤ 𝕊²");
  EXPECT_EQ(escaped("a\x01"
                    "b"),
            "a" + bad + "b");
  EXPECT_EQ(escaped("\xFF"), bad);
  EXPECT_EQ(escaped("\xC0\xAF"), bad + bad) << "overlong";
  EXPECT_EQ(escaped("\xE0\x80\x80"), bad + bad + bad) << "overlong";
  EXPECT_EQ(escaped("\xED\xA0\x80"), bad + bad + bad) << "surrogate";
  EXPECT_EQ(escaped("x\xE2\x82"), "x" + bad + bad) << "cut short";
}

TEST(Svg, PathData) {
  Path path;
  EXPECT_TRUE(path.empty());
  path.move({0, 1}).line({2.25, -3}).arc(7, true, {4, 5}).close();
  EXPECT_EQ(path.data(), "M0 1L2.25 -3A7 7 0 0 1 4 5Z");
}

TEST(Svg, DocumentsAreWellFormed) {
  Svg svg(100, 50.5, 12);
  svg.open("g", {{"class", "a \"quoted\" <class>"}});
  svg.circle({1, 2}, 3, {{"fill", "#000000"}});
  svg.text({4, 5}, "6 < 7 & 8");
  svg.close();
  const auto elements = oracle::read_svg(std::move(svg).finish());
  ASSERT_EQ(elements.size(), 5U);
  EXPECT_EQ(elements[0].name, "svg");
  EXPECT_EQ(elements[0].attributes.at("viewBox"), "0 0 100 50.5");
  EXPECT_EQ(elements[3].group, "a \"quoted\" <class>");
  EXPECT_EQ(elements[4].text, "6 < 7 & 8");
}

TEST(SvgReader, RefusesWhatIsNotWellFormed) {
  const std::string head = "<?xml version=\"1.0\"?>\n";
  EXPECT_NO_THROW(oracle::read_svg(head + "<a><b c=\"d\"/></a>"));
  EXPECT_THROW(oracle::read_svg("<a/>"), std::runtime_error);
  EXPECT_THROW(oracle::read_svg(head + "<a><b></a>"), std::runtime_error);
  EXPECT_THROW(oracle::read_svg(head + "<a><b></a></b>"), std::runtime_error);
  EXPECT_THROW(oracle::read_svg(head + "<a/><a/>"), std::runtime_error);
  EXPECT_THROW(oracle::read_svg(head + "<a b=c/>"), std::runtime_error);
  EXPECT_THROW(oracle::read_svg(head + "<a b=\"1\" b=\"2\"/>"), std::runtime_error);
  EXPECT_THROW(oracle::read_svg(head + "<a>&</a>"), std::out_of_range);
}

TEST(Svg, LongerTextIsWider) {
  EXPECT_LT(text_width("abc", 10), text_width("abcd", 10));
  EXPECT_DOUBLE_EQ(text_width("0⁷", 20), 2 * text_width("00", 10)) << "bytes are not characters";
}

}  // namespace
}  // namespace ucvt
