#include "cvt/face_cuts.h"

#include <cstdlib>

namespace ucvt {

void FaceCuts::cut(std::span<const Face> faces, CellShares& out, std::vector<Uncut>& others) {
  others.clear(), uncut_.clear();
  for (const Face f : faces) {
    const auto v = order_.corners(f);
    const CornerCells cells = cells_of(lifts_, v);
    if (cells.count == 3) {
      cell_corners_.take(f, v, out, uncut_);
    } else if (cells.count == 2) {
      cut_corners_.take(f, v, cells.alone, out, uncut_);
    } else {
      others.push_back({f, 0});
    }
  }
  cut_corners_.finish(out, uncut_);
  // No face comes back to a kernel that is done: what one leaves, only later ones take.
  again_.swap(uncut_);
  uncut_.clear();
  for (const Uncut& u : again_) {
    const auto v = order_.corners(u.face);
    const CornerCells cells = cells_of(lifts_, v);
    if (cells.count == 2 && std::abs(u.third) == 1) {
      cell_corners_.take_tip(u.face, v, cells.alone, u.third > 0, out, uncut_);
    } else if (cells.count == 2 && std::abs(u.third) == 2) {
      bands_.take_parted(u.face, v, cells.alone, u.third > 0, out, others);
    } else {
      uncut_.push_back(u);
    }
  }
  cell_corners_.finish(out, uncut_);
  for (const Uncut& u : uncut_) {
    const auto v = order_.corners(u.face);
    if (cells_of(lifts_, v).count == 3 && u.third > 0) {
      bands_.take_crossed(u.face, v, static_cast<std::size_t>(u.third - 1), out, others);
    } else {
      others.push_back(u);
    }
  }
  bands_.finish(out, others);
}

}  // namespace ucvt
