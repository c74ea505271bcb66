// What one task adds to the cells it meets.
#pragma once

#include <vector>

#include "space/moments.h"
#include "triangulation/connectivity.h"

namespace ucvt {

class CellShares {
 public:
  struct Share {
    Vertex site;
    Moments moments;
  };

  explicit CellShares(std::size_t sites) : slot_(sites, -1) {}

  /// The sums for the cell of the site, valid until the next call.
  Moments& of(Vertex site) {
    std::int32_t& slot = slot_[site.index()];
    if (slot < 0) {
      slot = static_cast<std::int32_t>(shares_.size());
      shares_.push_back({site, {}});
    }
    return shares_[static_cast<std::size_t>(slot)].moments;
  }

  /// What was gathered, in the order in which cells were met; afterwards there is nothing.
  std::vector<Share> take() {
    for (const Share& s : shares_) {
      slot_[s.site.index()] = -1;
    }
    std::vector<Share> out;
    out.swap(shares_);
    return out;
  }

 private:
  std::vector<std::int32_t> slot_;  // by site: its share, or -1
  std::vector<Share> shares_;
};

}  // namespace ucvt
