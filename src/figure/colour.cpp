#include "figure/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace ucvt {
namespace {

int mix(int a, int b, double t) {
  return static_cast<int>(std::lround(a + t * (b - a)));
}

Colour mix(const Colour& a, const Colour& b, double t) {
  return {mix(a.r, b.r, t), mix(a.g, b.g, t), mix(a.b, b.b, t)};
}

// Equal steps of OKLab lightness from 0.36 to 0.94 (black lines show on all) and of hue from 305
// to 105 degrees; chroma 0.15, or the most that sRGB holds.
constexpr std::array<Colour, 9> control{{{80, 29, 122},
                                         {68, 64, 159},
                                         {25, 100, 183},
                                         {0, 133, 176},
                                         {8, 162, 175},
                                         {1, 192, 168},
                                         {95, 216, 145},
                                         {179, 231, 121},
                                         {250, 241, 112}}};

// Blue below six, red above, darker the farther away.
constexpr std::array<Colour, degree_classes> by_degree{
    {{45, 95, 165}, {150, 195, 230}, {255, 255, 255}, {245, 170, 130}, {190, 50, 50}}};
constexpr std::array<Colour, degree_classes> by_degree_grey{
    {{95, 95, 95}, {205, 205, 205}, {255, 255, 255}, {150, 150, 150}, {50, 50, 50}}};

}  // namespace

std::string hex(const Colour& c) {
  return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}

Colour map_colour(double t) {
  const double s = std::clamp(t, 0.0, 1.0) * (control.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(s), control.size() - 2);
  return mix(control[i], control[i + 1], s - static_cast<double>(i));
}

Colour faded(const Colour& c) {
  return mix(c, {238, 238, 238}, 0.7);
}

int degree_class(int degree) {
  return std::clamp(degree, 4, 8) - 4;
}

Colour degree_colour(int degree_class, bool grey) {
  return (grey ? by_degree_grey : by_degree)[static_cast<std::size_t>(degree_class)];
}

}  // namespace ucvt
