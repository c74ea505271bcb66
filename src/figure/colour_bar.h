// The legend of a colour map: a bar with ticks.
#pragma once

#include <string_view>

#include "figure/svg.h"

namespace ucvt {

constexpr double colour_bar_height = 4.6;  ///< in heights of the font

/// Draws the colour map over the values from its low end to its high one, with a title, centred below
/// the point `top`. The ends may be equal or the wrong way round.
void draw_colour_bar(Svg& svg, double from, double to, std::string_view title, const Pixel& top,
                     double width, double font);

}  // namespace ucvt
