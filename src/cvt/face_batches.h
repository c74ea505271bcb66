// Faces that are cut four at a time, gathered by their kind.
#pragma once

#include <vector>

#include "cvt/cell_shares.h"
#include "cvt/face_lanes.h"

namespace ucvt {

/// A face that is not cut in the way that was tried, and what is known of a third cell that shares it:
/// 0 for nothing.
struct Uncut {
  Face face;
  int third;
};

/// `Faces` are four faces with what cutting them takes, by lane, among it their numbers, `face`. `Shares`
/// are what cells get of them: `is_valid` is 1 by lane where a face is cut as it should be, `third` as in
/// `Uncut`, and `add_to(cells, faces, n)` adds lane n.
template <class Faces, class Shares>
class FaceBatches {
 public:
  using Cut = void (*)(const Faces&, double kappa, const std::vector<QuadratureNode>& rule,
                       Shares& out);

  /// Cuts faces of small kinds by `small`, the others by `bigger`. A face has so many lanes, one after
  /// the other; all of them are added or none.
  FaceBatches(double kappa, Cut small, Cut bigger, std::size_t lanes_a_face = 1)
      : kappa_(kappa), small_(small), bigger_(bigger), lanes_a_face_(lanes_a_face) {}

  /// The faces of a kind, and the next lane.
  Faces& faces(std::size_t kind) { return batches_[kind].faces; }
  std::size_t next_lane(std::size_t kind) { return batches_[kind].size++; }

  /// Cuts the faces of a kind once four lanes are taken. Those that are not as they should be go to
  /// `uncut`.
  void cut_if_full(std::size_t kind, CellShares& out, std::vector<Uncut>& uncut) {
    if (batches_[kind].size == 4) {
      cut(kind, out, uncut);
    }
  }

  /// Cuts all that there are.
  void finish(CellShares& out, std::vector<Uncut>& uncut) {
    for (std::size_t kind = 0; kind < batches_.size(); ++kind) {
      cut(kind, out, uncut);
    }
  }

 private:
  struct Batch {
    Faces faces;
    std::size_t size = 0;
  };

  void cut(std::size_t kind, CellShares& out, std::vector<Uncut>& uncut) {
    Batch& batch = batches_[kind];
    if (batch.size == 0) {
      return;
    }
    Shares shares;
    const Cut how = face_kinds[kind].side2 <= short_series_side2 ? small_ : bigger_;
    how(batch.faces, kappa_, triangle_rule(face_kinds[kind].degree), shares);
    for (std::size_t n = 0; n < batch.size; n += lanes_a_face_) {
      bool is_valid = true;
      for (std::size_t k = n; k < n + lanes_a_face_; ++k) {
        is_valid = is_valid && shares.is_valid[k] > 0;
      }
      if (!is_valid) {
        uncut.push_back({batch.faces.face[n], static_cast<int>(shares.third[n])});
        continue;
      }
      for (std::size_t k = n; k < n + lanes_a_face_; ++k) {
        shares.add_to(out, batch.faces, k);
      }
    }
    batch.size = 0;
  }

  double kappa_;
  Cut small_, bigger_;
  std::size_t lanes_a_face_;
  std::array<Batch, face_kinds.size()> batches_;
};

}  // namespace ucvt
