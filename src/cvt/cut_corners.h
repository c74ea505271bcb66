// The usual faces that straddle cells, four at a time: one corner alone lies in one cell, its part is
// a triangle, and the other corners' cell, a neighbour, has the rest. What that triangle has more than
// the corner's share goes from one cell to the other.
#pragma once

#include <vector>

#include "cvt/face_batches.h"

namespace ucvt {

class CutCorners {
 public:
  /// Keeps references to all of them; one object for one thread.
  CutCorners(const SurfaceMass& mass, const Stars& stars, const Lifts& lifts);

  /// Takes a face whose corner of that number lies in one cell, the others in another's; its corners'
  /// ranks are given. Adds to the cells once there are four of a kind. Faces that turn out to be cut in
  /// other ways go to `others`.
  void take(Face f, const std::array<std::size_t, 3>& vertices, std::size_t alone, CellShares& out,
            std::vector<Face>& others);

  /// Adds what was taken and not yet added.
  void finish(CellShares& out, std::vector<Face>& others) { batches_.finish(out, others); }

  /// Faces whose corner 0 alone lies in one cell, by lane.
  struct Faces {
    std::array<Face, 4> face;
    std::array<Vertex, 4> alone, rest;  ///< the two sites
    LaneFace whole;
    LaneShare share;  ///< of corner 0
    LaneOffset corner, next,
        last;                  ///< corner 0 in the frame of `alone`, the others in that of `rest`
    LaneIsometry to_rest;      ///< from the frame of `rest` to that of `alone`
    LaneOffset before, after;  ///< the neighbours of `alone` round it next to `rest`
  };

  /// What the site `alone` gets, and the other one loses.
  struct Shares {
    Lanes is_valid;  ///< 1 where the face is as it should be, else 0
    LaneMoments alone, rest;
    void add_to(CellShares& cells, const Faces& faces, std::size_t n) const;
  };

 private:
  const SurfaceMass& mass_;
  const Stars& stars_;
  const Lifts& lifts_;
  FaceBatches<Faces, Shares> batches_;
};

}  // namespace ucvt
