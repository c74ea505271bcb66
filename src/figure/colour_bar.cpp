#include "figure/colour_bar.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

#include "figure/colour.h"
#include "figure/ticks.h"

namespace ucvt {
namespace {

constexpr int bar_steps = 96;

}  // namespace

void draw_colour_bar(Svg& svg, const ColourBar& bar, const Pixel& top, double width, double font) {
  const auto& [from, to, title] = bar;
  const double left = top.x - width / 2, y = top.y + 1.6 * font, high = font;
  for (int i = 0; i < bar_steps; ++i) {
    // Each step runs under the next, so that no seam shows.
    const double x0 = width * i / bar_steps, x1 = width * std::min(i + 2, bar_steps) / bar_steps;
    svg.element("rect", {{"x", number(left + x0)},
                         {"y", number(y)},
                         {"width", number(x1 - x0)},
                         {"height", number(high)},
                         {"fill", hex(map_colour((i + 0.5) / bar_steps))}});
  }
  svg.element("rect", {{"x", number(left)},
                       {"y", number(y)},
                       {"width", number(width)},
                       {"height", number(high)},
                       {"fill", "none"},
                       {"stroke", "#000000"},
                       {"stroke-width", "0.8"}});
  // Equal values have a colour but no axis: one tick in the middle of a range around them.
  const double middle = from, pad = middle == 0 ? 1 : std::abs(middle) * 0.5;
  const bool flat = from == to;
  const double lo = std::min(from, to) - (flat ? pad : 0);
  const double hi = std::max(from, to) + (flat ? pad : 0);
  const int count = std::clamp(static_cast<int>(width / (5 * font)), 2, 7);
  const Ticks ticks = linear_ticks(lo, hi, count);
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double t = (ticks.at[i] - lo) / (hi - lo);
    const double x = left + width * (from <= to ? t : 1 - t);
    svg.line({x, y + high}, {x, y + high + 4}, {{"stroke", "#000000"}});
    svg.text({x, y + high + 4 + font}, ticks.labels[i], {{"text-anchor", "middle"}});
  }
  const std::string unit = ticks.factor.empty() ? "" : fmt::format(" ({})", ticks.factor);
  svg.text({top.x, top.y + 1.2 * font}, fmt::format("{}{}", title, unit),
           {{"text-anchor", "middle"}});
}

}  // namespace ucvt
