// Numbers of about 32 digits, as unevaluated sums of two doubles, for products of many isometries.
//
// A product of hyperbolic isometries that comes home over a distance r has lost exp(r) of its
// digits; doubles hold no relator of a real surface. Sums and products after Dekker 1971 and Hida,
// Li, Bailey 2001. Errors are a few times 2^-104, relative to the operands of a sum.
#pragma once

#include <cmath>
#include <string>

namespace ucvt {

struct DoubleDouble {
  double high = 0, low = 0;  ///< high is the double nearest to the sum

  DoubleDouble() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a double is one of these
  DoubleDouble(double value) : high(value) {}
  DoubleDouble(double h, double l) : high(h), low(l) {}

  [[nodiscard]] double value() const { return high + low; }
};

/// The sum of two doubles of which the first is the larger in magnitude.
inline DoubleDouble quick_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

inline DoubleDouble two_sum(double a, double b) {
  const double s = a + b, c = s - a;
  return {s, (a - (s - c)) + (b - c)};
}

inline DoubleDouble two_product(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

inline DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.high, -a.low};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  DoubleDouble s = two_sum(a.high, b.high);
  const DoubleDouble t = two_sum(a.low, b.low);
  s = quick_two_sum(s.high, s.low + t.high);
  return quick_two_sum(s.high, s.low + t.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble p = two_product(a.high, b.high);
  return quick_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double q1 = a.high / b.high;
  const DoubleDouble r1 = a - b * q1;
  const double q2 = r1.high / b.high;
  const DoubleDouble r2 = r1 - b * q2;
  return quick_two_sum(q1, q2) + DoubleDouble{r2.high / b.high};
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

/// Requires a >= 0.
inline DoubleDouble sqrt(const DoubleDouble& a) {
  if (!(a.high > 0)) {
    return {};
  }
  // Newton's step for 1/sqrt, Karp and Markstein 1997.
  const double x = 1 / std::sqrt(a.high), y = a.high * x;
  const DoubleDouble rest = a - two_product(y, y);
  return two_sum(y, rest.high * (x / 2));
}

/// The decimal number, 32 digits of it, as JSON writes numbers. Requires it to be finite.
std::string to_decimal(const DoubleDouble& a);

}  // namespace ucvt
