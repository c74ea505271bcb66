// The legend of a colour map: a bar with ticks.
#pragma once

#include <string_view>

#include "figure/svg.h"

namespace ucvt {

constexpr double colour_bar_height = 4.6;  ///< in heights of the font

struct ColourBar {
  double from = 0,
         to = 1;  ///< values at the map's low and high end; equal or the wrong way round too
  std::string_view title;
};

/// Draws the colour map with its values and title, centred below the point `top`.
void draw_colour_bar(Svg& svg, const ColourBar& bar, const Pixel& top, double width, double font);

}  // namespace ucvt
