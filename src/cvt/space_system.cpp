#include "cvt/space_system.h"

namespace ucvt {
namespace {

/// Spacing of a hexagonal lattice over the circumradius of its cells.
constexpr double spacing_per_radius = 1.7320508075688772;

}  // namespace

void SpaceSystem::measure(std::vector<CellState>& out) const {
  out.resize(sites_.count());
  for_cells(sites_, [&](std::size_t i, const SiteCell& cell) {
    double error = 0;
    out[i] = {measure_(sites_.frame(i), cell, error), spacing_per_radius * reach(space_, cell)};
  });
}

}  // namespace ucvt
