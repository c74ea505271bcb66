// Which colour each cell of a picture has, and the legend that says so.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "figure/colour.h"
#include "figure/svg.h"
#include "ucvt/figure.h"

namespace ucvt {

double measure_of(const SpaceCell& cell, Measure measure);
std::string_view measure_name(Measure measure);

struct Shading {
  std::vector<Colour> colour;  ///< of each cell
  double lo = 0, hi = 0;       ///< Fill::Measure: values at the ends of the colour map
  std::array<std::int64_t, degree_classes> count{};  ///< cells in each degree class
};

/// Throws InvalidInput when a value to be shown or an end of the range is not finite.
Shading shade(const std::vector<SpaceCell>& cells, const PictureOptions& options);

double legend_height(Fill fill, double font_px);

/// Draws the legend centred below the point `top`, within about the given width.
void draw_legend(Svg& svg, const Shading& shading, const PictureOptions& options, const Pixel& top,
                 double width, double font_px);

}  // namespace ucvt
