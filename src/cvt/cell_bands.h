// Faces that a cell crosses between two others, two at a time. Its sides with either cell run from side
// to side of the face and do not meet within: each cuts off a corner, as in `cut_corners`.
#pragma once

#include <vector>

#include "cvt/cut_corners.h"

namespace ucvt {

class CellBands {
 public:
  /// Keeps references to all of them; one object for one thread.
  CellBands(const SurfaceMass& mass, const Stars& stars, const Lifts& lifts)
      : mass_(mass),
        stars_(stars),
        lifts_(lifts),
        batches_(CutCorners::batches(mass.surface().space().kappa, 2)) {}

  /// Takes a face whose corners, by their ranks, lie in three cells, the first one's of which crosses the
  /// side between the others. Adds to the cells once there are two of a kind. Faces that turn out to be
  /// cut in other ways go to `uncut`.
  void take_crossed(Face f, const std::array<std::size_t, 3>& vertices, std::size_t first,
                    CellShares& out, std::vector<Uncut>& uncut);

  /// Takes a face whose corner `alone` lies in one cell, the others in another's, between which a third
  /// cell passes: that after (or before) the other corners' cell round the corner's.
  void take_parted(Face f, const std::array<std::size_t, 3>& vertices, std::size_t alone,
                   bool is_after, CellShares& out, std::vector<Uncut>& uncut);

  /// Adds what was taken and not yet added.
  void finish(CellShares& out, std::vector<Uncut>& uncut) { batches_.finish(out, uncut); }

 private:
  void gather(Face f, const std::array<CutCorners::Corner, 2>& cuts, CellShares& out,
              std::vector<Uncut>& uncut);

  const SurfaceMass& mass_;
  const Stars& stars_;
  const Lifts& lifts_;
  FaceBatches<CutCorners::Faces, CutCorners::Shares> batches_;
};

}  // namespace ucvt
