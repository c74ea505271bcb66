#include "figure/ticks.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace ucvt {
namespace {

/// Whether the ticks are consecutive multiples of 1, 2 or 5 times a power of ten.
bool nice(const std::vector<double>& at) {
  if (at.size() < 2) {
    return true;
  }
  const double step = at[1] - at[0];
  const double mantissa = step / std::pow(10, std::floor(std::log10(step) + 1e-6));
  // Differences of ticks lose digits as large offsets carry them.
  const double slack = 1e-6 + 1e-15 * std::abs(at[0]) / step * 10;
  bool good = false;
  for (const double digit : {1.0, 2.0, 5.0}) {
    good = good || std::abs(mantissa - digit) < slack * digit;
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double multiple = at[i] / step;
    good = good && std::abs(multiple - std::round(multiple)) < slack * (1 + std::abs(multiple));
    good = good && (i == 0 || std::abs(at[i] - at[i - 1] - step) < slack * step);
  }
  return good;
}

RC_GTEST_PROP(Ticks, LinearTicksAreNiceDistinctAndWithinTheRange, ()) {
  const double scale = std::pow(10.0, *rc::gen::inRange(-12, 13));
  const double offset = *rc::gen::inRange(-1000, 1001) * 0.37;
  const double lo = scale * offset, hi = lo + scale * (1 + *rc::gen::inRange(0, 1000)) * 0.013;
  const int count = *rc::gen::inRange(2, 12);
  const Ticks t = linear_ticks(lo, hi, count);
  RC_ASSERT(t.at.size() == t.labels.size());
  RC_ASSERT(static_cast<int>(t.at.size()) <= count);
  RC_ASSERT(!t.at.empty());
  RC_ASSERT(nice(t.at));
  const double slack = 1e-8 * (hi - lo);
  RC_ASSERT(t.at.front() >= lo - slack && t.at.back() <= hi + slack);
  RC_ASSERT(std::set<std::string>(t.labels.begin(), t.labels.end()).size() == t.labels.size());
}

TEST(Ticks, LinearLabels) {
  EXPECT_EQ(linear_ticks(0, 1, 6).labels,
            (std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(linear_ticks(-1, 1, 3).labels, (std::vector<std::string>{"−1", "0", "1"}));
  EXPECT_EQ(linear_ticks(1, 200, 5).labels, (std::vector<std::string>{"50", "100", "150", "200"}));
  EXPECT_EQ(linear_ticks(0, 1, 6).factor, "");
}

TEST(Ticks, PowersOfTenAreTakenOutOfLongLabels) {
  const Ticks small = linear_ticks(0, 3e-7, 4);
  EXPECT_EQ(small.labels, (std::vector<std::string>{"0", "1", "2", "3"}));
  EXPECT_EQ(small.factor, "×10⁻⁷");
  EXPECT_EQ(linear_ticks(1e6, 3e6, 3).factor, "×10⁶");
}

TEST(Ticks, LogTicks) {
  EXPECT_EQ(log_ticks(1, 1000, 6).labels, (std::vector<std::string>{"1", "10", "100", "1000"}));
  EXPECT_EQ(log_ticks(0.009, 11, 6).labels, (std::vector<std::string>{"0.01", "0.1", "1", "10"}));
  EXPECT_EQ(log_ticks(1e-8, 1, 5).labels,
            (std::vector<std::string>{"10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "10⁰"}));
  EXPECT_EQ(log_ticks(1.5, 15, 6).labels, (std::vector<std::string>{"2", "5", "10"}));
}

RC_GTEST_PROP(Ticks, LogTicksLieWithinTheRange, ()) {
  const double lo = std::pow(10.0, *rc::gen::inRange(-200, 200) * 0.05);
  const double hi = lo * std::pow(10.0, *rc::gen::inRange(1, 200) * 0.05);
  const int count = *rc::gen::inRange(2, 12);
  const Ticks t = log_ticks(lo, hi, count);
  RC_ASSERT(t.at.size() == t.labels.size());
  RC_ASSERT(!t.at.empty());
  RC_ASSERT(t.at.front() >= lo * (1 - 1e-6) && t.at.back() <= hi * (1 + 1e-6));
  RC_ASSERT(std::set<std::string>(t.labels.begin(), t.labels.end()).size() == t.labels.size());
}

}  // namespace
}  // namespace ucvt
