#include "triangulation/hilbert_order.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace ucvt {
namespace {

constexpr int bits_per_axis = 20;

/// Place of a cell on the Hilbert curve (Skilling 2004: undo the excess work from the finest level up,
/// then Gray-decode); its bits are interleaved, the first axis leading.
std::uint64_t curve_key(std::array<std::uint32_t, 3> x) {
  constexpr std::uint32_t top = std::uint32_t{1} << (bits_per_axis - 1);
  for (std::uint32_t bit = top; bit > 1; bit >>= 1) {
    const std::uint32_t below = bit - 1;
    for (std::uint32_t& xi : x) {
      if ((xi & bit) != 0) {
        x[0] ^= below;
      } else {
        const std::uint32_t swap = (x[0] ^ xi) & below;
        x[0] ^= swap, xi ^= swap;
      }
    }
  }
  x[1] ^= x[0], x[2] ^= x[1];
  std::uint32_t gray = 0;
  for (std::uint32_t bit = top; bit > 1; bit >>= 1) {
    gray ^= (x[2] & bit) != 0 ? bit - 1 : 0;
  }
  std::uint64_t key = 0;
  for (int i = bits_per_axis - 1; i >= 0; --i) {
    for (const std::uint32_t xi : x) {
      key = key << 1 | ((xi ^ gray) >> i & 1);
    }
  }
  return key;
}

}  // namespace

std::vector<std::size_t> hilbert_order(const std::vector<std::array<double, 3>>& points) {
  if (points.empty()) {
    return {};
  }
  std::array<double, 3> low = points.front(), high = low;
  for (const auto& p : points) {
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  }
  // Halved, so that no difference of finite coordinates overflows.
  double extent = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    extent = std::max(extent, high[c] / 2 - low[c] / 2);
  }
  std::vector<std::pair<std::uint64_t, std::size_t>> keys;
  keys.reserve(points.size());
  constexpr double cells = static_cast<double>((std::uint32_t{1} << bits_per_axis) - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t c = 0; c < 3 && extent > 0; ++c) {
      const double t = (points[i][c] / 2 - low[c] / 2) / extent;
      cell[c] = static_cast<std::uint32_t>(std::clamp(t, 0.0, 1.0) * cells);
    }
    keys.emplace_back(curve_key(cell), i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> out;
  out.reserve(keys.size());
  for (const auto& [key, i] : keys) {
    out.push_back(i);
  }
  return out;
}

}  // namespace ucvt
