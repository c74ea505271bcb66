// Giving one number to all corners at exactly the same place.
#pragma once

#include <cstdint>
#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

/// A hash table from positions to their numbers, in order of first appearance; -0 is the same as 0.
class VertexWelder {
 public:
  explicit VertexWelder(std::size_t expected = 0);

  /// The number of the position, a new one if it was not met before.
  std::int32_t number(Position position);
  std::vector<Position>& positions() { return positions_; }

 private:
  [[nodiscard]] std::size_t slot(const Position& position) const;
  void grow();

  std::vector<Position> positions_;
  std::vector<std::int32_t> slots_;
};

}  // namespace ucvt
