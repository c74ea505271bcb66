// The colours of figures.
#pragma once

#include <string>

namespace ucvt {

/// sRGB, each channel 0 to 255.
struct Colour {
  int r = 255, g = 255, b = 255;
};

/// "#rrggbb".
std::string hex(const Colour& c);

/// Violet over green to yellow at t = 0..1 in even steps of lightness; t outside is clamped.
Colour map_colour(double t);

/// Faded towards light grey, for copies.
Colour faded(const Colour& c);

/// Cells are told apart by degree in five classes: up to 4, 5, 6, 7, and 8 or more.
constexpr int degree_classes = 5;
int degree_class(int degree);
Colour degree_colour(int degree_class, bool grey);

}  // namespace ucvt
