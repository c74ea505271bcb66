// Some sites of a tessellation, to be moved while all others stay.
#pragma once

#include <vector>

#include "cvt/tessellation.h"

namespace ucvt {

class LocalSites : public SiteSystem {
 public:
  /// `rim` holds sites whose cells change with those that move. Keeps a reference to the tessellation.
  LocalSites(Tessellation& sites, const std::vector<Vertex>& moving,
             const std::vector<Vertex>& rim);

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
