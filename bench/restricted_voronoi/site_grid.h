// Sites in space in a hash grid, for questions about near ones.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ucvt/mesh.h"

namespace ucvt::restricted {

inline double distance2(const Position& p, const Position& q) {
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return x * x + y * y + z * z;
}

class SiteGrid {
 public:
  /// Keeps a reference to the sites. `spacing` is their usual distance.
  SiteGrid(const std::vector<Position>& sites, double spacing);

  [[nodiscard]] std::int32_t nearest(const Position& p) const;

  /// The other sites in order of their distance from this one, as (distance, site); complete up to the
  /// radius at least. What is known grows at its end only.
  const std::vector<std::pair<double, std::int32_t>>& around(std::int32_t site, double radius);

 private:
  struct Known {
    double radius = -1;
    std::vector<std::pair<double, std::int32_t>> others;
  };

  [[nodiscard]] std::array<std::int64_t, 3> box(const Position& p) const;
  static std::uint64_t key(const std::array<std::int64_t, 3>& box);
  /// Calls visit(site) for the sites in the boxes within the radius and perhaps more.
  template <class Visit>
  void for_near(const Position& p, double radius, Visit visit) const;

  const std::vector<Position>& sites_;
  double spacing_;
  std::unordered_map<std::uint64_t, std::vector<std::int32_t>> boxes_;
  std::vector<Known> known_;
};

}  // namespace ucvt::restricted
