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
  /// other ways go to `uncut`; `third` says which.
  void take(Face f, const std::array<std::size_t, 3>& vertices, std::size_t alone, CellShares& out,
            std::vector<Uncut>& uncut);

  /// Adds what was taken and not yet added.
  void finish(CellShares& out, std::vector<Uncut>& uncut) { batches_.finish(out, uncut); }

  /// A corner cut off from the rest of a face by the bisector of a site and of a neighbour of it.
  struct Corner {
    std::size_t number;
    Vertex alone;
    std::size_t across;  ///< the neighbour's place in the star of `alone`
    /// This corner in the frame of `alone`, the next and the last one in the neighbour's.
    Offset at, next, last;
  };

  /// Faces whose corner 0 is cut off, by lane.
  struct Faces {
    std::array<Face, 4> face;
    std::array<Vertex, 4> alone, rest;  ///< the two sites
    LaneFace whole;
    LaneShare share;  ///< of corner 0
    LaneOffset corner, next,
        last;                  ///< corner 0 in the frame of `alone`, the others in that of `rest`
    LaneIsometry to_rest;      ///< from the frame of `rest` to that of `alone`
    LaneOffset before, after;  ///< the neighbours of `alone` round it next to `rest`

    void set(std::size_t n, Face f, const FacePieces& pieces, const Stars& stars,
             const Corner& cut);
  };

  /// What the site `alone` gets, and the other one loses.
  struct Shares {
    Lanes is_valid;  ///< 1 where the face is as it should be, else 0
    /// Where the cell of the neighbour `after` has one end of the cut 1, where it has both 2; negative
    /// for the neighbour `before`.
    Lanes third;
    LaneMoments alone, rest;
    void add_to(CellShares& cells, const Faces& faces, std::size_t n) const;
  };

  static FaceBatches<Faces, Shares> batches(double kappa, std::size_t lanes_a_face);

 private:
  const SurfaceMass& mass_;
  const Stars& stars_;
  const Lifts& lifts_;
  FaceBatches<Faces, Shares> batches_;
};

}  // namespace ucvt
