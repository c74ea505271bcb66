// Faces about the corners of cells, four at a time: three cells, neighbours of one another, meet within
// such a face. Two or all of them have corners of it. What two of them have more than their corners'
// shares is the third one's loss.
#pragma once

#include <vector>

#include "cvt/face_batches.h"

namespace ucvt {

class CellCorners {
 public:
  /// Keeps references to all of them; one object for one thread.
  CellCorners(const SurfaceMass& mass, const Stars& stars, const Lifts& lifts);

  /// Takes a face whose corners lie in three cells; the corners' ranks are given. Adds to the cells once
  /// there are four of a kind. Faces that turn out to be cut in other ways go to `uncut`; `third` is 1,
  /// 2 or 3 where the cell of corner 0, 1 or 2 crosses the opposite side.
  void take(Face f, const std::array<std::size_t, 3>& vertices, CellShares& out,
            std::vector<Uncut>& uncut);

  /// Takes a face whose corner `alone` lies in one cell, the others in another's, and that a third cell
  /// reaches into: that after (or before) the other corners' cell round the corner's.
  void take_tip(Face f, const std::array<std::size_t, 3>& vertices, std::size_t alone,
                bool is_after, CellShares& out, std::vector<Uncut>& uncut);

  /// Adds what was taken and not yet added.
  void finish(CellShares& out, std::vector<Uncut>& uncut) { batches_.finish(out, uncut); }

  /// By lane, the sites counterclockwise as their cells lie about the point where they meet. Corner i
  /// lies in cell i, but one of corners 0 and 1 may lie in cell 2, whose other part then ends on side
  /// 01. Corners are in the frame of site 0 or brought there, unless said.
  struct Faces {
    std::array<Face, 4> face;
    std::array<std::array<Vertex, 4>, 3> site;
    LaneFace whole;
    std::array<LaneShare, 2> share;       ///< what cells 0 and 1 were given of corners 0 and 1
    std::array<LaneOffset, 3> corner;     ///< each in the frame of the site of its number
    std::array<LaneIsometry, 2> to_site;  ///< from the frames of sites 1 and 2 to that of site 0
    LaneOffset before, after;             ///< the neighbours of site 0 next to sites 1 and 2
    LaneOffset opposite;  ///< in the frame of site 1: its other common neighbour with site 2
  };

  /// What sites 0 and 1 get, and site 2 loses.
  struct Shares {
    Lanes is_valid;  ///< 1 where the face is as it should be, else 0
    Lanes third;     ///< as `take` has it
    std::array<LaneMoments, 3> of;
    void add_to(CellShares& cells, const Faces& faces, std::size_t n) const;
  };

 private:
  /// Three cells that may meet in a face, and the numbers of its corners, as `Faces` has them.
  struct Meeting {
    std::array<std::size_t, 3> corner;
    std::array<Vertex, 3> site;
    std::size_t guest;  ///< 0 or 1 where that corner lies in cell 2
  };
  static constexpr std::size_t no_guest = 3;
  void gather(Face f, const std::array<std::size_t, 3>& vertices, const Meeting& m, CellShares& out,
              std::vector<Uncut>& uncut);

  const SurfaceMass& mass_;
  const Stars& stars_;
  const Lifts& lifts_;
  FaceBatches<Faces, Shares> batches_;
};

}  // namespace ucvt
