// The usual faces that straddle cells, four at a time: one corner alone lies in one cell, its part is
// a triangle, and the other corners' cell, a neighbour, has the rest.
#pragma once

#include <vector>

#include "cvt/cell_shares.h"
#include "cvt/lifts.h"
#include "cvt/surface_mass.h"
#include "space/lane_moments.h"

namespace ucvt {

/// By lane.
struct LaneOffset {
  Lanes x, y, h;
};

/// Faces whose corner 0 alone lies in one cell, by lane; corners, sides and weights are counted from
/// that one.
struct CutFaces {
  std::array<Face, 4> face;
  std::array<Vertex, 4> alone, rest;  ///< the two sites
  LaneOffset corner, next,
      last;                  ///< corner 0 in the frame of `alone`, the others in that of `rest`
  LaneOffset to_rest;        ///< the site `rest` in the frame of `alone`
  Lanes cosine, sine;        ///< of the turn from the frame of `rest` to that of `alone`
  LaneOffset before, after;  ///< the neighbours of `alone` round it next to `rest`
  std::array<Lanes, 3> chord2, density, mu;  ///< of the whole face
  Lanes det, mass, excess;
};

/// What the two sites get.
struct CutShares {
  struct Lane {
    Lanes m, x, y, h;
  };
  Lanes is_valid;  ///< 1 where the face is as it should be, else 0
  Lane alone, rest;
};

class CutCorners {
 public:
  /// Keeps references to all of them; one object for one thread.
  CutCorners(const SurfaceMass& mass, const Stars& stars, const Lifts& lifts)
      : mass_(mass), t_(mass.surface()), stars_(stars), lifts_(lifts) {}

  /// Takes a face with its corners' ranks, and adds to the cells once there are four of a kind.
  /// Faces that turn out to be cut in other ways go to `others`.
  void take(Face f, const std::array<std::size_t, 3>& vertices, CellShares& out,
            std::vector<Face>& others);

  /// Adds what was taken and not yet added.
  void finish(CellShares& out, std::vector<Face>& others);

 private:
  /// Faces of similar size, for which one rule does.
  struct Batch {
    CutFaces faces;
    std::size_t size = 0;
  };

  void add(std::size_t kind, CellShares& out, std::vector<Face>& others);

  const SurfaceMass& mass_;
  const UniformSurface& t_;
  const Stars& stars_;
  const Lifts& lifts_;
  std::array<Batch, 3> batches_;
};

}  // namespace ucvt
