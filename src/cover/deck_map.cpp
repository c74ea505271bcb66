#include "cover/deck_map.h"

#include <algorithm>

namespace ucvt {

DeckMap product(double kappa, const DeckMap& first, const DeckMap& second) {
  const PreciseComplex turned = first.b * conj(second.b);
  return {first.a * second.a + DoubleDouble{-kappa} * turned,
          first.a * second.b + first.b * conj(second.a)};
}

DeckMap normalized(double kappa, const DeckMap& m) {
  const DoubleDouble size = norm2(m.a) + DoubleDouble{kappa} * norm2(m.b);
  const DoubleDouble scale = DoubleDouble{m.a.re.high < 0 ? -1.0 : 1.0} / sqrt(size);
  return {scale * m.a, scale * m.b};
}

DeckMap rounded(const DeckMap& m) {
  return {{m.a.re.value(), m.a.im.value()}, {m.b.re.value(), m.b.im.value()}};
}

double displacement(double kappa, const DeckMap& m) {
  return length_of_chord({kappa}, 2 * std::hypot(m.b.re.high, m.b.im.high));
}

double difference(const DeckMap& m, const DeckMap& n) {
  const auto with_sign = [&](double sign) {
    const auto off = [&](const DoubleDouble& x, const DoubleDouble& y) {
      return std::abs((x - DoubleDouble{sign} * y).high);
    };
    return std::max(
        {off(m.a.re, n.a.re), off(m.a.im, n.a.im), off(m.b.re, n.b.re), off(m.b.im, n.b.im)});
  };
  return std::min(with_sign(1), with_sign(-1));
}

double off_identity(const DeckMap& m) {
  return difference(m, {});
}

PreciseMatrix precise_matrix(double kappa, const DeckMap& m) {
  // With u = x + i y:  u' = a^2 u - kappa b^2 conj(u) + 2 a b z,
  // z' = (|a|^2 - kappa |b|^2) z - 2 kappa Re(a conj(b) u).
  const DoubleDouble k{kappa}, two{2};
  const PreciseComplex aa = m.a * m.a, bb = -k * (m.b * m.b);
  const PreciseComplex ab = two * (m.a * m.b), down = -two * k * (m.a * conj(m.b));
  return {{{aa.re + bb.re, bb.im - aa.im, ab.re},
           {aa.im + bb.im, aa.re - bb.re, ab.im},
           {down.re, -down.im, norm2(m.a) - k * norm2(m.b)}}};
}

ModelMatrix model_matrix(double kappa, const DeckMap& m) {
  const PreciseMatrix precise = precise_matrix(kappa, m);
  ModelMatrix out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      out[i][j] = precise[i][j].value();
    }
  }
  return out;
}

Offset image_of_origin(const DeckMap& m) {
  const PreciseComplex ab = m.a * m.b;
  return {2 * ab.re.value(), 2 * ab.im.value(), 2 * norm2(m.b).value()};
}

}  // namespace ucvt
