// Some sites of a tessellation, to be moved while all others stay.
#pragma once

#include <vector>

#include "cvt/tessellation.h"

namespace ucvt {

/// What moves when some sites do, and what feels it.
struct Neighbourhood {
  std::vector<Vertex> moving;  ///< those sites first, then ring by ring round them
  std::vector<Vertex> rim;     ///< the ring after: cells there change too
};
Neighbourhood neighbourhood(const Connectivity& d, std::vector<Vertex> sites, int rings);

class LocalSites : public SiteSystem {
 public:
  /// Keeps a reference to the tessellation.
  LocalSites(Tessellation& sites, const Neighbourhood& part);

  [[nodiscard]] Space space() const override { return sites_.space(); }
  /// First those that move, then the rim.
  [[nodiscard]] std::size_t site_count() const override { return members_.size(); }
  /// Nothing pulls at sites of the rim.
  void measure(std::vector<CellState>& out) const override;
  void move(const std::vector<Offset>& target) override;
  void save() override { sites_.save(); }
  void restore() override { sites_.restore(); }

 private:
  Tessellation& sites_;
  std::vector<Vertex> members_;
  std::size_t moving_;
  std::vector<bool> near_;  ///< by site: that it is a member or next to one
};

}  // namespace ucvt
