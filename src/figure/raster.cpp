#include "figure/raster.h"

#include <cstddef>

namespace ucvt {
namespace {

/// Samples along a pixel's side: as many as keep the whole picture within this many columns.
constexpr int most_columns = 6000, least_samples = 2, most_samples = 4;

}  // namespace

Raster::Raster(int width, int height)
    : width_(width),
      height_(height),
      samples_(std::clamp(most_columns / std::max(width, height), least_samples, most_samples)),
      columns_(width * samples_),
      rows_(height * samples_),
      depth_(index(0, rows_), -std::numeric_limits<double>::infinity()),
      label_(depth_.size(), background),
      colour_(depth_.size(), {255, 255, 255}) {}

void Raster::outline(double width, const Colour& colour) {
  const double radius = width * samples_ / 2;
  const int reach = static_cast<int>(std::ceil(radius));
  std::vector<char> inked(label_.size(), 0);
  const auto ink_round = [&](double x, double y) {
    for (int v = static_cast<int>(y) - reach; v <= static_cast<int>(y) + reach; ++v) {
      for (int u = static_cast<int>(x) - reach; u <= static_cast<int>(x) + reach; ++u) {
        const double dx = u - x, dy = v - y;
        if (u >= 0 && v >= 0 && u < columns_ && v < rows_ && dx * dx + dy * dy <= radius * radius) {
          inked[index(u, v)] = 1;
        }
      }
    }
  };
  for (int y = 0; y + 1 < rows_; ++y) {
    for (int x = 0; x + 1 < columns_; ++x) {
      const std::int32_t here = label_[index(x, y)];
      if (label_[index(x + 1, y)] != here) {
        ink_round(x + 0.5, y);
      }
      if (label_[index(x, y + 1)] != here) {
        ink_round(x, y + 0.5);
      }
    }
  }
  for (std::size_t i = 0; i < inked.size(); ++i) {
    if (inked[i] != 0) {
      paint(i, colour);
    }
  }
}

std::int32_t Raster::label_at(double x, double y) const {
  const double u = std::floor(x * samples_), v = std::floor(y * samples_);
  const bool inside = u >= 0 && v >= 0 && u < columns_ && v < rows_;
  return inside ? label_[index(static_cast<int>(u), static_cast<int>(v))] : background;
}

Image Raster::image() const {
  Image out{width_, height_, {}};
  out.rgb.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3);
  const int count = samples_ * samples_;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      std::array<int, 3> sum{count / 2, count / 2, count / 2};
      for (int v = 0; v < samples_; ++v) {
        for (int u = 0; u < samples_; ++u) {
          const auto& c = colour_[index(x * samples_ + u, y * samples_ + v)];
          for (std::size_t k = 0; k < 3; ++k) {
            sum[k] += c[k];
          }
        }
      }
      for (const int s : sum) {
        out.rgb.push_back(static_cast<std::uint8_t>(s / count));
      }
    }
  }
  return out;
}

}  // namespace ucvt
