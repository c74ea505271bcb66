// Images as PNG, and PNG as text inside of an SVG document.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ucvt {

/// Rows from the top, three bytes sRGB for each pixel.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// The bytes of a PNG file. Throws NumericalError when libpng gives up.
std::string png_bytes(const Image& image);

/// The usual alphabet, padded.
std::string base64(std::string_view bytes);

}  // namespace ucvt
