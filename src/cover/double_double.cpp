#include "cover/double_double.h"

#include <algorithm>

#include <fmt/format.h>

namespace ucvt {

std::string to_decimal(const DoubleDouble& a) {
  constexpr int digits = 32;
  DoubleDouble rest = a.high < 0 ? -a : a;
  if (!(rest.high > 0)) {
    return "0.0";
  }
  int exponent = static_cast<int>(std::floor(std::log10(rest.high)));
  const DoubleDouble factor = exponent < 0 ? DoubleDouble{10} : DoubleDouble{1} / DoubleDouble{10};
  for (int i = 0; i < std::abs(exponent); ++i) {
    rest = rest * factor;
  }
  // The logarithm may have been rounded over a power of ten.
  if (!(rest < DoubleDouble{10})) {
    rest = rest / DoubleDouble{10}, ++exponent;
  } else if (rest < DoubleDouble{1}) {
    rest = rest * DoubleDouble{10}, --exponent;
  }
  std::string out;
  for (int i = 0; i < digits; ++i) {
    const double digit = std::clamp(std::floor(rest.high), 0.0, 9.0);
    out += static_cast<char>('0' + static_cast<int>(digit));
    rest = (rest - DoubleDouble{digit}) * DoubleDouble{10};
  }
  return fmt::format("{}{}.{}e{}", a.high < 0 ? "-" : "", out[0], out.substr(1), exponent);
}

}  // namespace ucvt
