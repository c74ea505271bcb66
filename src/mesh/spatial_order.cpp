#include "mesh/spatial_order.h"

#include <algorithm>
#include <utility>

namespace ucvt {
namespace {

constexpr int bits_per_axis = 20;

/// Bit i of the value at bit 3 i.
std::uint64_t spread_bits(std::uint64_t value) {
  std::uint64_t out = 0;
  for (int i = 0; i < bits_per_axis; ++i) {
    out |= (value >> i & 1) << (3 * i);
  }
  return out;
}

}  // namespace

TriangleMesh with_faces_in_spatial_order(const TriangleMesh& mesh) {
  Position low = mesh.positions.front(), high = low;
  for (const Position& p : mesh.positions) {
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
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  order.reserve(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    std::uint64_t key = 0;
    for (std::size_t c = 0; c < 3 && extent > 0; ++c) {
      double centroid = 0;
      for (const std::int32_t v : mesh.faces[f]) {
        centroid += (mesh.positions[static_cast<std::size_t>(v)][c] / 2 - low[c] / 2) / extent / 3;
      }
      const double cell = std::clamp(centroid, 0.0, 1.0) * ((1 << bits_per_axis) - 1);
      key |= spread_bits(static_cast<std::uint64_t>(cell)) << c;
    }
    order.emplace_back(key, f);
  }
  std::sort(order.begin(), order.end());
  TriangleMesh out{mesh.positions, {}};
  out.faces.reserve(mesh.faces.size());
  for (const auto& [key, f] : order) {
    out.faces.push_back(mesh.faces[f]);
  }
  return out;
}

}  // namespace ucvt
