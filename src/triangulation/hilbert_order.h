// An order of points in which neighbours in space are neighbours in memory.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ucvt {

/// The numbers of the points, sorted along a Hilbert curve through their bounding cube;
/// points at one place keep their order. Requires finite coordinates.
std::vector<std::size_t> hilbert_order(const std::vector<std::array<double, 3>>& points);

}  // namespace ucvt
