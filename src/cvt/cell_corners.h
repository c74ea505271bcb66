// Faces about the corners of cells, four at a time: three cells, neighbours of one another, have a
// corner each of such a face, and meet within it. What two of them have more than their corners' shares
// is the third one's loss.
#pragma once

#include <vector>

#include "cvt/face_batches.h"

namespace ucvt {

class CellCorners {
 public:
  /// Keeps references to all of them; one object for one thread.
  CellCorners(const SurfaceMass& mass, const Stars& stars, const Lifts& lifts);

  /// Takes a face whose corners lie in three cells; the corners' ranks are given. Adds to the cells once
  /// there are four of a kind. Faces that turn out to be cut in other ways go to `others`.
  void take(Face f, const std::array<std::size_t, 3>& vertices, CellShares& out,
            std::vector<Face>& others);

  /// Adds what was taken and not yet added.
  void finish(CellShares& out, std::vector<Face>& others) { batches_.finish(out, others); }

  /// By lane. Corners are in the frame of site 0 or brought there, unless said.
  struct Faces {
    std::array<Face, 4> face;
    std::array<std::array<Vertex, 4>, 3> site;
    LaneFace whole;
    std::array<LaneShare, 2> share;       ///< of corners 0 and 1
    std::array<LaneOffset, 3> corner;     ///< each in the frame of its own site
    std::array<LaneIsometry, 2> to_site;  ///< from the frames of sites 1 and 2 to that of site 0
    LaneOffset before, after;             ///< the neighbours of site 0 next to sites 1 and 2
    LaneOffset opposite;  ///< in the frame of site 1: its other common neighbour with site 2
    LaneIsometry from_2_to_1;
  };

  /// What sites 0 and 1 get, and site 2 loses.
  struct Shares {
    Lanes is_valid;  ///< 1 where the face is as it should be, else 0
    std::array<LaneMoments, 3> of;
    void add_to(CellShares& cells, const Faces& faces, std::size_t n) const;
  };

 private:
  const SurfaceMass& mass_;
  const Stars& stars_;
  const Lifts& lifts_;
  FaceBatches<Faces, Shares> batches_;
};

}  // namespace ucvt
