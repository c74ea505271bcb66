// The cells of a finished run in the universal cover, each in the lift that lies in the fundamental
// polygon.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cover/deck_map.h"
#include "ucvt/cover.h"
#include "ucvt/remesh.h"
#include "ucvt/spaces.h"

namespace ucvt {

/// The fundamental polygon moved so that the normalized sum of its corners is the model's origin, and
/// turned: the longest side of a torus runs along x; on a hyperbolic surface the widest angle between
/// two corners has the x axis in its middle, so that the half plane shows the polygon below an arc.
class CentredPolygon {
 public:
  explicit CentredPolygon(const Cover& cover);

  [[nodiscard]] double kappa() const { return kappa_; }
  [[nodiscard]] const std::vector<ModelPoint>& corners() const { return corners_; }
  /// From the base's frame to the picture's.
  [[nodiscard]] const DeckMap& centring() const { return centring_; }
  /// The copies round the polygon, in the picture's frame.
  [[nodiscard]] std::vector<ModelMatrix> neighbours() const;

  /// The deck transformation, in the picture's frame, that brings a point into the polygon: the
  /// straight way there from a point inside is followed from copy to copy.
  [[nodiscard]] DeckMap bringing(const ModelPoint& p) const;

 private:
  double kappa_;
  Cover cover_;
  DeckMap centring_;
  std::vector<ModelPoint> corners_;
  std::vector<DeckMap> across_;      ///< by side: takes what lies across to inside
  std::vector<std::size_t> paired_;  ///< by side
  CentralPoint inside_{};
};

/// Cells as those of the spaces: sites, corners, centroids, degrees, and no other measures.
struct CoverCells {
  std::vector<ModelPoint> sites;
  std::vector<SpaceCell> cells;
};

/// The cells in the picture's frame. Requires the cover of the result's own surface; without one,
/// genus 0: on the sphere. Throws InvalidInput when the result keeps no cells.
CoverCells cover_cells(const RemeshResult& result, const CentredPolygon* polygon,
                       const Cover* cover);

}  // namespace ucvt
