#include "cover/group_file.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "cover/layout.h"

namespace ucvt {
namespace {

/// "[x, y, ...]" of what `write` makes of every element.
template <class Range, class Write>
std::string list(const Range& range, Write write) {
  std::string out;
  for (const auto& x : range) {
    out += (out.empty() ? "[" : ", ") + write(x);
  }
  return out.empty() ? "[]" : out + "]";
}

/// JSON has no infinity.
std::string number(double x) {
  return std::isfinite(x) ? fmt::format("{}", x) : "null";
}

std::string integers(const Word& w) {
  return list(w, [](std::int32_t x) { return fmt::format("{}", x); });
}

std::string numbers(const DeckMap& m) {
  return fmt::format(R"({{"a": [{}, {}], "b": [{}, {}]}})", to_decimal(m.a.re), to_decimal(m.a.im),
                     to_decimal(m.b.re), to_decimal(m.b.im));
}

std::string generator(const DeckSystem& s, const DeckGroup& group, std::size_t i) {
  const DeckGenerator& g = group.generators[i];
  const DeckMap& m = s.canonical.map[i];
  const auto row = [](const auto& x) { return list(x, to_decimal); };
  const std::size_t side = 4 * (i / 2) + i % 2;
  return fmt::format(
      "    {{\"name\": \"{}\", \"sides\": [{}, {}], \"length\": {}, \"word\": {},\n"
      "     \"matrix\": {},\n     \"moebius\": {}}}",
      g.name, side, side + 2, number(g.length), integers(g.word),
      list(precise_matrix(s.kappa, m), row), numbers(m));
}

std::string corner(const DeckSystem& s, const DeckMap& m, const ModelPoint& p) {
  const auto pair = [&](CoverCoordinates c) { return list(coordinates_of(s.kappa, m, c), number); };
  std::string out = fmt::format("    {{\"model\": {}, \"klein\": {}", list(p, number),
                                pair(CoverCoordinates::Klein));
  if (s.kappa < 0) {
    out += fmt::format(", \"poincare\": {}", pair(CoverCoordinates::Poincare));
  }
  return out + "}";
}

}  // namespace

std::string group_json(const DeckSystem& s, const DeckGroup& group) {
  std::string generators, corners;
  for (std::size_t i = 0; i < group.generators.size(); ++i) {
    generators += (i == 0 ? "" : ",\n") + generator(s, group, i);
  }
  const auto at = corner_maps(s.kappa, group.relator, s.canonical.map);
  for (std::size_t i = 0; i < group.polygon.size(); ++i) {
    corners += (i == 0 ? "" : ",\n") + corner(s, at[i], group.polygon[i]);
  }
  const GroupCertificate& c = group.certificate;
  return fmt::format(
      "{{\n  \"geometry\": \"{}\",\n  \"genus\": {},\n  \"base\": {},\n  \"relator\": {},\n"
      "  \"generators\": [\n{}\n  ],\n  \"polygon\": [\n{}\n  ],\n  \"paired_side\": {},\n"
      "  \"certificate\": {{\"residual\": {}, \"residual_moebius\": {}, \"residual_matrix\": {}, "
      "\"residual_before\": {}, \"largest_change\": {}, \"angle_sum\": {}}}\n}}\n",
      group.kappa < 0 ? "hyperbolic" : "euclidean", group.genus, group.base,
      integers(group.relator), generators, corners, integers(group.paired_side), number(c.residual),
      number(c.residual_moebius), number(c.residual_matrix), number(c.residual_before),
      number(c.largest_change), number(c.angle_sum));
}

}  // namespace ucvt
