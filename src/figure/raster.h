// A picture of solid bodies by a z-buffer: of all that is drawn the nearest is seen.
//
// Coordinates are pixels: x to the right, y down, z towards the viewer in the same unit. Every pixel
// is the mean of a square of samples. A sample keeps the label of what is seen there, so that lines
// can be drawn where labels meet: edges of faces, boundaries of cells, silhouettes; hidden ones need
// no care. One thread: the same calls give the same bytes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "figure/colour.h"
#include "figure/png.h"
#include "ucvt/mesh.h"

namespace ucvt {

class Raster {
 public:
  static constexpr std::int32_t background = -1;

  /// White, of so many pixels.
  Raster(int width, int height);

  /// Draws a triangle; colour(bary) is asked for at every sample that it covers and is nearest at.
  template <class ColourAt>
  void triangle(const std::array<Position, 3>& corner, std::int32_t label, const ColourAt& colour) {
    std::array<Position, 3> c = corner;
    for (Position& p : c) {
      p[0] *= samples_, p[1] *= samples_;
    }
    const double area = cross(c[0], c[1], c[2][0], c[2][1]);
    if (!(std::abs(area) > 0)) {
      return;
    }
    const auto [x0, x1] = range(std::min({c[0][0], c[1][0], c[2][0]}),
                                std::max({c[0][0], c[1][0], c[2][0]}), columns_);
    const auto [y0, y1] =
        range(std::min({c[0][1], c[1][1], c[2][1]}), std::max({c[0][1], c[1][1], c[2][1]}), rows_);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const std::array<double, 3> b{cross(c[1], c[2], x + 0.5, y + 0.5) / area,
                                      cross(c[2], c[0], x + 0.5, y + 0.5) / area,
                                      cross(c[0], c[1], x + 0.5, y + 0.5) / area};
        if (b[0] >= 0 && b[1] >= 0 && b[2] >= 0) {
          put(x, y, b[0] * c[0][2] + b[1] * c[1][2] + b[2] * c[2][2], label,
              [&] { return colour(b); });
        }
      }
    }
  }

  /// Draws a ball; colour(normal) as above, the normal being of unit length, y down.
  template <class ColourAt>
  void ball(const Position& centre, double radius, std::int32_t label, const ColourAt& colour) {
    const double cx = centre[0] * samples_, cy = centre[1] * samples_, r = radius * samples_;
    const auto [x0, x1] = range(cx - r, cx + r, columns_);
    const auto [y0, y1] = range(cy - r, cy + r, rows_);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const double nx = (x + 0.5 - cx) / r, ny = (y + 0.5 - cy) / r;
        const double nz2 = 1 - nx * nx - ny * ny;
        if (nz2 >= 0) {
          const double nz = std::sqrt(nz2);
          put(x, y, centre[2] + radius * nz, label, [&] { return colour(Position{nx, ny, nz}); });
        }
      }
    }
  }

  /// Draws a line of this width, in pixels, where samples of different labels meet.
  void outline(double width, const Colour& colour);

  /// What is seen at a place; `background` where nothing is or it is outside.
  [[nodiscard]] std::int32_t label_at(double x, double y) const;

  [[nodiscard]] Image image() const;

 private:
  struct Range {
    int first, last;
  };
  [[nodiscard]] static double cross(const Position& a, const Position& b, double x, double y) {
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
  }
  /// The samples, by number, that lie within lo to hi: from first to before last.
  [[nodiscard]] static Range range(double lo, double hi, int size) {
    const auto clamped = [size](double v) {
      return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(size)));
    };
    return {clamped(std::ceil(lo - 0.5)), clamped(std::floor(hi - 0.5) + 1)};
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }
  template <class ColourOf>
  void put(int x, int y, double depth, std::int32_t label, const ColourOf& colour) {
    const std::size_t i = index(x, y);
    if (depth > depth_[i]) {
      depth_[i] = depth, label_[i] = label;
      paint(i, colour());
    }
  }
  void paint(std::size_t i, const Colour& c) {
    colour_[i] = {static_cast<std::uint8_t>(c.r), static_cast<std::uint8_t>(c.g),
                  static_cast<std::uint8_t>(c.b)};
  }

  int width_, height_;
  int samples_;  // along a pixel's side
  int columns_, rows_;
  std::vector<double> depth_;
  std::vector<std::int32_t> label_;
  std::vector<std::array<std::uint8_t, 3>> colour_;
};

}  // namespace ucvt
