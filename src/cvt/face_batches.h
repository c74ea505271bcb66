// Faces that are cut four at a time, gathered by their kind.
#pragma once

#include <vector>

#include "cvt/cell_shares.h"
#include "cvt/face_lanes.h"

namespace ucvt {

/// `Faces` are four faces with what cutting them takes, by lane, among it their numbers, `face`. `Shares`
/// are what cells get of them: `is_valid` is 1 by lane where a face is cut as it should be, and
/// `add_to(cells, faces, n)` adds lane n.
template <class Faces, class Shares>
class FaceBatches {
 public:
  using Cut = void (*)(const Faces&, double kappa, const std::vector<QuadratureNode>& rule,
                       Shares& out);

  /// Cuts faces of small kinds by `small`, the others by `bigger`.
  FaceBatches(double kappa, Cut small, Cut bigger)
      : kappa_(kappa), small_(small), bigger_(bigger) {}

  /// The faces of a kind, and the lane that the next one takes.
  Faces& faces(std::size_t kind) { return batches_[kind].faces; }
  std::size_t next_lane(std::size_t kind) { return batches_[kind].size++; }

  /// Cuts the faces of a kind once there are four. Those that are not as they should be go to `others`.
  void cut_if_full(std::size_t kind, CellShares& out, std::vector<Face>& others) {
    if (batches_[kind].size == 4) {
      cut(kind, out, others);
    }
  }

  /// Cuts all that there are.
  void finish(CellShares& out, std::vector<Face>& others) {
    for (std::size_t kind = 0; kind < batches_.size(); ++kind) {
      cut(kind, out, others);
    }
  }

 private:
  struct Batch {
    Faces faces;
    std::size_t size = 0;
  };

  void cut(std::size_t kind, CellShares& out, std::vector<Face>& others) {
    Batch& batch = batches_[kind];
    if (batch.size == 0) {
      return;
    }
    Shares shares;
    const Cut how = face_kinds[kind].side2 <= short_series_side2 ? small_ : bigger_;
    how(batch.faces, kappa_, triangle_rule(face_kinds[kind].degree), shares);
    for (std::size_t n = 0; n < batch.size; ++n) {
      if (shares.is_valid[n] > 0) {
        shares.add_to(out, batch.faces, n);
      } else {
        others.push_back(batch.faces.face[n]);
      }
    }
    batch.size = 0;
  }

  double kappa_;
  Cut small_, bigger_;
  std::array<Batch, face_kinds.size()> batches_;
};

}  // namespace ucvt
