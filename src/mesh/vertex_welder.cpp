#include "mesh/vertex_welder.h"

#include <algorithm>
#include <bit>

namespace ucvt {

VertexWelder::VertexWelder(std::size_t expected)
    : slots_(std::bit_ceil(std::max<std::size_t>(64, expected * 2)), -1) {
  positions_.reserve(expected);
}

std::size_t VertexWelder::slot(const Position& position) const {
  const std::size_t mask = slots_.size() - 1;
  std::uint64_t hash = 0;
  for (const double c : position) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 29;
  }
  hash ^= hash >> 32;
  std::size_t i = static_cast<std::size_t>(hash) & mask;
  while (slots_[i] >= 0 && positions_[static_cast<std::size_t>(slots_[i])] != position) {
    i = (i + 1) & mask;
  }
  return i;
}

void VertexWelder::grow() {
  slots_.assign(slots_.size() * 2, -1);
  for (std::size_t v = 0; v < positions_.size(); ++v) {
    slots_[slot(positions_[v])] = static_cast<std::int32_t>(v);
  }
}

std::int32_t VertexWelder::number(Position position) {
  for (double& c : position) {
    c += 0.0;  // -0 becomes 0
  }
  std::int32_t& found = slots_[slot(position)];
  if (found >= 0) {
    return found;
  }
  const auto added = static_cast<std::int32_t>(positions_.size());
  found = added;
  positions_.push_back(position);
  if (positions_.size() * 10 > slots_.size() * 6) {
    grow();
  }
  return added;
}

}  // namespace ucvt
