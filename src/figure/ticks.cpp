#include "figure/ticks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

namespace ucvt {
namespace {

constexpr std::string_view minus = "\xE2\x88\x92", times_ten =
                                                       "\xC3\x97"
                                                       "10";

std::string superscript(int exponent) {
  static constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = exponent < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(exponent))) {
    out += digits[c - '0'];
  }
  return out;
}

/// A step of the form {1, 2, 5} 10^exponent.
struct Step {
  int digit = 1, exponent = 0;
};

/// Powers of ten below 1 are not doubles: dividing by the whole power keeps multiples correctly
/// rounded.
double multiple(double k, Step s) {
  const double power = std::pow(10.0, std::abs(s.exponent));
  return s.exponent < 0 ? k * s.digit / power : k * s.digit * power;
}

Step next(Step s) {
  return s.digit == 1   ? Step{2, s.exponent}
         : s.digit == 2 ? Step{5, s.exponent}
                        : Step{1, s.exponent + 1};
}

struct Range {
  double first = 0, last = 0;  ///< multiples of the step
};

/// A tick that misses the end of the range by rounding alone belongs to it.
constexpr double end_slack = 1e-9;

Range multiples_within(double lo, double hi, Step s) {
  const double step = multiple(1, s);
  return {std::ceil(lo / step - end_slack), std::floor(hi / step + end_slack)};
}

std::string label(double value, int decimals) {
  const std::string s = fmt::format("{:.{}f}", value == 0 ? 0.0 : value, std::max(decimals, 0));
  return s[0] == '-' ? fmt::format("{}{}", minus, s.substr(1)) : s;
}

}  // namespace

Ticks linear_ticks(double lo, double hi, int count) {
  Step step{1, static_cast<int>(std::floor(std::log10((hi - lo) / count))) - 1};
  Range k = multiples_within(lo, hi, step);
  while (k.last - k.first + 1 > count) {
    step = next(step);
    k = multiples_within(lo, hi, step);
  }
  // Long runs of zeros are taken out of the labels.
  const double largest = std::max(std::abs(lo), std::abs(hi));
  const int order = static_cast<int>(std::floor(std::log10(largest)));
  const int shift = order >= 5 || order <= -3 ? order : 0;
  Ticks out;
  if (shift != 0) {
    out.factor = fmt::format("{}{}", times_ten, superscript(shift));
  }
  for (int i = 0; k.first + i <= k.last; ++i) {
    out.at.push_back(multiple(k.first + i, step));
    const Step shifted{step.digit, step.exponent - shift};
    out.labels.push_back(label(multiple(k.first + i, shifted), -shifted.exponent));
  }
  return out;
}

Ticks log_ticks(double lo, double hi, int count) {
  const int first = static_cast<int>(std::ceil(std::log10(lo) - end_slack));
  const int last = static_cast<int>(std::floor(std::log10(hi) + end_slack));
  Ticks out;
  if (last - first >= 1) {
    const int stride = (last - first) / std::max(count, 1) + 1;
    const bool plain = first >= -3 && last <= 4;
    for (int e = first; e <= last; e += stride) {
      out.at.push_back(multiple(1, {1, e}));
      out.labels.push_back(plain ? label(out.at.back(), -e) : "10" + superscript(e));
    }
    return out;
  }
  for (int e = first - 1; e <= last + 1; ++e) {
    for (const int digit : {1, 2, 5}) {
      const double value = multiple(1, {digit, e});
      if (value >= lo * (1 - end_slack) && value <= hi * (1 + end_slack)) {
        out.at.push_back(value);
        out.labels.push_back(label(value, -e));
      }
    }
  }
  const bool legible = out.at.size() >= 2 && first >= -3 && last <= 5;
  return legible ? out : linear_ticks(lo, hi, count);
}

}  // namespace ucvt
