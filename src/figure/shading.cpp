#include "figure/shading.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

#include "figure/colour_bar.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

constexpr std::array<std::string_view, degree_classes> class_name{"4 or less", "5", "6", "7",
                                                                  "8 or more"};

void set_range(const std::vector<SpaceCell>& cells, const PictureOptions& options, Shading& out) {
  const auto [lo, hi] = options.fill_range;
  if (!std::isfinite(lo) || !std::isfinite(hi)) {
    throw InvalidInput(
        "fill_range is not finite; give two numbers, or equal ones for the cells' own");
  }
  out.lo = lo, out.hi = hi;
  if (lo != hi) {
    return;
  }
  out.lo = out.hi = measure_of(cells[0], options.measure);
  for (const SpaceCell& c : cells) {
    out.lo = std::min(out.lo, measure_of(c, options.measure));
    out.hi = std::max(out.hi, measure_of(c, options.measure));
  }
}

void degree_legend(Svg& svg, const Shading& shading, bool grey, const Pixel& top, double font) {
  std::vector<std::string> label;
  std::vector<std::size_t> shown;
  double width = 0;
  for (std::size_t i = 0; i < shading.count.size(); ++i) {
    label.push_back(fmt::format("{} ({})", class_name[i], shading.count[i]));
    if (shading.count[i] > 0) {
      shown.push_back(i);
      width += text_width(label[i], font) + 2.6 * font;
    }
  }
  const std::string name = "degree (cells):";
  Pixel at{top.x - (width + text_width(name, font)) / 2, top.y + 1.5 * font};
  svg.text(at, name);
  at.x += text_width(name, font) + font * 0.4;
  for (const std::size_t i : shown) {
    svg.element("rect", {{"x", number(at.x)},
                         {"y", number(at.y - 0.9 * font)},
                         {"width", number(font * 1.1)},
                         {"height", number(font * 1.1)},
                         {"fill", hex(degree_colour(static_cast<int>(i), grey))},
                         {"stroke", "#000000"},
                         {"stroke-width", "0.8"}});
    svg.text({at.x + 1.5 * font, at.y}, label[i]);
    at.x += text_width(label[i], font) + 2.6 * font;
  }
}

}  // namespace

double measure_of(const SpaceCell& cell, Measure measure) {
  switch (measure) {
    case Measure::Degree:
      return cell.degree;
    case Measure::Area:
      return cell.area;
    case Measure::Mass:
      return cell.mass;
    case Measure::Energy:
      return cell.energy;
    case Measure::Radius:
      return cell.radius;
    case Measure::Nearest:
      break;
  }
  return cell.nearest;
}

std::string_view measure_name(Measure measure) {
  constexpr std::array<std::string_view, 6> names{"degree",      "cell area",   "cell mass",
                                                  "cell energy", "cell radius", "nearest site"};
  return names[static_cast<std::size_t>(measure)];
}

Shading shade(const std::vector<SpaceCell>& cells, const PictureOptions& options) {
  Shading out;
  out.colour.assign(cells.size(), Colour{});
  if (options.fill == Fill::Measure) {
    set_range(cells, options, out);
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int degree = degree_class(cells[i].degree);
    ++out.count[static_cast<std::size_t>(degree)];
    if (options.fill == Fill::Measure) {
      const double value = measure_of(cells[i], options.measure), span = out.hi - out.lo;
      if (!std::isfinite(value)) {
        throw InvalidInput(fmt::format("{} of cell {} is not finite; choose another measure",
                                       measure_name(options.measure), i));
      }
      out.colour[i] = map_colour(span == 0 ? 0.5 : (value - out.lo) / span);
    } else if (options.fill != Fill::None) {
      out.colour[i] = degree_colour(degree, options.fill == Fill::DegreeGreys);
    }
  }
  return out;
}

double legend_height(Fill fill, double font_px) {
  return fill == Fill::None ? 0 : (fill == Fill::Measure ? colour_bar_height : 2.4) * font_px;
}

void draw_legend(Svg& svg, const Shading& shading, const PictureOptions& options, const Pixel& top,
                 double width, double font_px) {
  if (options.fill == Fill::None) {
    return;
  }
  svg.open("g", {{"class", "legend"}});
  if (options.fill == Fill::Measure) {
    draw_colour_bar(svg, {shading.lo, shading.hi, measure_name(options.measure)}, top, width,
                    font_px);
  } else {
    degree_legend(svg, shading, options.fill == Fill::DegreeGreys, top, font_px);
  }
  svg.close();
}

}  // namespace ucvt
