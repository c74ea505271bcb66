#include "result/colouring.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace ucvt {
namespace {

std::size_t index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

std::vector<std::int32_t> colour_graph(const std::vector<std::vector<std::int32_t>>& neighbours) {
  const std::size_t n = neighbours.size();
  std::vector<std::int32_t> colour(n, -1);
  std::vector<std::set<std::int32_t>> seen(n);
  // Most colours seen, then most neighbours, then the least number.
  using Entry = std::tuple<std::int64_t, std::int64_t, std::int32_t>;
  const auto entry = [&](std::size_t v) {
    return Entry{-static_cast<std::int64_t>(seen[v].size()),
                 -static_cast<std::int64_t>(neighbours[v].size()), static_cast<std::int32_t>(v)};
  };
  std::set<Entry> queue;
  for (std::size_t v = 0; v < n; ++v) {
    queue.insert(entry(v));
  }
  while (!queue.empty()) {
    const std::size_t v = index(std::get<2>(*queue.begin()));
    queue.erase(queue.begin());
    while (seen[v].contains(++colour[v])) {
    }
    for (const std::int32_t w : neighbours[v]) {
      if (colour[index(w)] < 0 && !seen[index(w)].contains(colour[v])) {
        queue.erase(entry(index(w)));
        seen[index(w)].insert(colour[v]);
        queue.insert(entry(index(w)));
      }
    }
  }
  return colour;
}

}  // namespace ucvt
