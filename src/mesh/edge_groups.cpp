#include "mesh/edge_groups.h"

#include <algorithm>

namespace ucvt {

EdgeGroups::EdgeGroups(const TriangleMesh& mesh) {
  std::vector<std::size_t> bucket(mesh.positions.size() + 1, 0);
  const auto each_side = [&mesh](const auto& visit) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Corners& corners = mesh.faces[f];
      if (has_repeated_corner(corners)) {
        continue;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
        visit(static_cast<std::size_t>(low), EdgeSide{high, static_cast<std::int32_t>(3 * f + i)});
      }
    }
  };
  each_side([&bucket](std::size_t low, EdgeSide) { ++bucket[low + 1]; });
  for (std::size_t v = 1; v < bucket.size(); ++v) {
    bucket[v] += bucket[v - 1];
  }
  sides_.resize(bucket.back());
  std::vector<std::size_t> next = bucket;
  each_side([&](std::size_t low, EdgeSide side) { sides_[next[low]++] = side; });
  first_.reserve(sides_.size() / 2 + 1);
  for (std::size_t v = 0; v + 1 < bucket.size(); ++v) {
    const auto begin = sides_.begin() + static_cast<std::ptrdiff_t>(bucket[v]);
    const auto end = sides_.begin() + static_cast<std::ptrdiff_t>(bucket[v + 1]);
    std::sort(begin, end, [](const EdgeSide& a, const EdgeSide& b) {
      return a.high != b.high ? a.high < b.high : a.side < b.side;
    });
    for (auto s = begin; s != end; ++s) {
      if (s == begin || s->high != (s - 1)->high) {
        first_.push_back(static_cast<std::size_t>(s - sides_.begin()));
      }
    }
  }
  first_.push_back(sides_.size());
}

}  // namespace ucvt
