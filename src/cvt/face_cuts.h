// Faces of T that straddle cells, cut by the kernels for four at a time. Each tries the faces that look
// like its own, and what it finds of a third cell sends the others on.
#pragma once

#include <span>
#include <vector>

#include "cvt/cell_bands.h"
#include "cvt/cell_corners.h"
#include "cvt/cut_corners.h"

namespace ucvt {

class FaceCuts {
 public:
  /// Keeps references to all of them; one object for one thread.
  FaceCuts(const SurfaceMass& mass, const Stars& stars, const Lifts& lifts)
      : cut_corners_(mass, stars, lifts),
        bands_(mass, stars, lifts),
        cell_corners_(mass, stars, lifts),
        order_(mass.surface().vertex_order()),
        lifts_(lifts) {}

  /// Adds the parts of the faces to the cells they meet, and takes their corners' shares from their cells.
  /// Faces that are cut in other ways, nothing of which is added, are left in `others`.
  void cut(std::span<const Face> faces, CellShares& out, std::vector<Uncut>& others);

 private:
  CutCorners cut_corners_;
  CellBands bands_;
  CellCorners cell_corners_;
  const VertexOrder& order_;
  const Lifts& lifts_;
  std::vector<Uncut> uncut_, again_;
};

}  // namespace ucvt
