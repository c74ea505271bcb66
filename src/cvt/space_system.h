// Sites in a domain of the bare spaces as an optimiser sees them.
#pragma once

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "cvt/cell_measure.h"
#include "cvt/optimize.h"
#include "cvt/space_sites.h"

namespace ucvt {

/// Calls work(i, cell) for every site, in parallel.
template <class Work>
void for_cells(const SpaceSites& sites, const Work& work) {
  tbb::enumerable_thread_specific<SiteCell> scratch;
  tbb::parallel_for(std::size_t{0}, sites.count(), [&](std::size_t i) {
    SiteCell& cell = scratch.local();
    sites.cell(i, cell);
    work(i, cell);
  });
}

/// Moves the sites that it is given, and measures their cells by a density. A site's spacing is that
/// of a hexagonal lattice whose cells reach as far as its own.
class SpaceSystem : public SiteSystem {
 public:
  /// Keeps references to all of them.
  SpaceSystem(Space space, SpaceSites& sites, const CellMeasure& measure)
      : space_(space), sites_(sites), measure_(measure) {}

  [[nodiscard]] Space space() const override { return space_; }
  [[nodiscard]] std::size_t site_count() const override { return sites_.count(); }
  void measure(std::vector<CellState>& out) const override;
  void move(const std::vector<Offset>& target) override { sites_.move(target); }
  void save() override { sites_.save(); }
  void restore() override { sites_.restore(); }

 private:
  Space space_;
  SpaceSites& sites_;
  const CellMeasure& measure_;
};

}  // namespace ucvt
