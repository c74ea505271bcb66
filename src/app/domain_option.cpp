#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "app/space_options.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

constexpr int most_corners = 1000;
constexpr int most_handles = 100;
constexpr double default_klein_radius = 0.8;

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> out;
  while (true) {
    const std::size_t at = text.find(separator);
    out.emplace_back(text.substr(0, at));
    if (at == std::string_view::npos) {
      return out;
    }
    text.remove_prefix(at + 1);
  }
}

/// Two numbers with a separator between them.
std::optional<CentralPoint> parse_pair(std::string_view text, char separator) {
  const std::vector<std::string> parts = split(text, separator);
  CentralPoint out{};
  if (parts.size() != 2 || !parse_decimal(parts[0], out[0]) || !parse_decimal(parts[1], out[1])) {
    return std::nullopt;
  }
  return out;
}

[[noreturn]] void refuse(const std::string& text, const std::string& wanted) {
  throw InvalidInput(fmt::format("'{}' cannot be read; give {}", text, wanted));
}

/// "regular:K" or "regular:K:RADIUS", with a side at the bottom.
Domain regular(double kappa, const std::string& text, const std::vector<std::string>& parts) {
  int corners = 0;
  double radius = kappa < 0 ? default_klein_radius : 1;
  const bool read = (parts.size() == 2 || parts.size() == 3) && parse_decimal(parts[1], corners) &&
                    (parts.size() == 2 || parse_decimal(parts[2], radius));
  if (!read || corners < 3 || corners > most_corners || !(radius > 0) || !std::isfinite(radius) ||
      (kappa < 0 && radius >= 1)) {
    refuse(text, fmt::format("regular:K or regular:K:RADIUS, K from 3 to {}, RADIUS above 0{}",
                             most_corners, kappa < 0 ? " and below 1" : ""));
  }
  std::vector<CentralPoint> polygon;
  const double step = 2 * std::numbers::pi / corners;
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + 0.5) * step - std::numbers::pi / 2;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon_domain(kappa, polygon);
}

/// "rectangle:WxH" about the origin.
Domain rectangle(double kappa, const std::string& text) {
  if (kappa < 0) {
    refuse(text, "regular:K, surface:G or a file; the hyperbolic plane has no rectangles");
  }
  const auto size = parse_pair(text.substr(text.find(':') + 1), 'x');
  if (!size || !((*size)[0] > 0) || !((*size)[1] > 0)) {
    refuse(text, "rectangle:WxH, both above 0");
  }
  const double x = (*size)[0] / 2, y = (*size)[1] / 2;
  return polygon_domain(kappa, {{-x, -y}, {x, -y}, {x, y}, {-x, y}});
}

/// "surface:G" or "surface:G:canonical".
Domain surface(double kappa, const std::string& text, const std::vector<std::string>& parts) {
  if (kappa == 0) {
    refuse(text, "regular:K, rectangle:WxH or a file; surfaces are hyperbolic");
  }
  int genus = 0;
  const bool canonical = parts.size() == 3 && parts[2] == "canonical";
  if ((parts.size() != 2 && !canonical) || !parse_decimal(parts[1], genus) || genus < 2 ||
      genus > most_handles) {
    refuse(text, fmt::format("surface:G or surface:G:canonical, G from 2 to {}", most_handles));
  }
  return surface_domain(genus, canonical ? SidePairing::Canonical : SidePairing::Opposite);
}

}  // namespace

Domain parse_lattice(const std::string& text) {
  if (text == "square") {
    return torus_domain({1, 0}, {0, 1});
  }
  if (text == "hexagonal") {
    return torus_domain({1, 0}, {0.5, std::numbers::sqrt3 / 2});
  }
  const std::vector<std::string> vectors = split(text, ':');
  const auto a = vectors.size() == 2 ? parse_pair(vectors[0], ',') : std::nullopt;
  const auto b = a ? parse_pair(vectors[1], ',') : std::nullopt;
  if (!b) {
    refuse(text, "square, hexagonal or two vectors such as 1,0:0.5,2");
  }
  return torus_domain(*a, *b);
}

std::optional<Domain> parse_domain(double kappa, const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() == 1) {
    return std::nullopt;
  }
  if (parts[0] == "regular") {
    return regular(kappa, text, parts);
  }
  if (parts[0] == "rectangle") {
    return rectangle(kappa, text);
  }
  if (parts[0] == "surface") {
    return surface(kappa, text, parts);
  }
  return std::nullopt;
}

}  // namespace ucvt
