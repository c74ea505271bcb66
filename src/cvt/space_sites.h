// Sites in a domain of one of the three spaces, with their Voronoi cells.
//
// Closed domains hold their Delaunay triangulation and move it along; polygons find it anew from
// their sites; two or three sites on the sphere, which no triangulation by geodesic triangles
// connects, have lunes for cells.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "triangulation/frame.h"
#include "ucvt/spaces.h"

namespace ucvt {

/// A site's cell in its own frame.
struct SiteCell {
  std::vector<Offset> corner;  ///< counterclockwise; sides are shorter than half a great circle
  int degree = 0;              ///< neighbouring cells across sides
  double nearest = 0;          ///< distance to the nearest other site or lift; 0: there is none
};

class SpaceSites {
 public:
  SpaceSites() = default;
  SpaceSites(const SpaceSites&) = delete;
  SpaceSites& operator=(const SpaceSites&) = delete;
  virtual ~SpaceSites() = default;

  [[nodiscard]] std::size_t count() const { return frames_.size(); }
  /// Where the frame of site i lies in the model; its origin is the site.
  [[nodiscard]] const Frame& frame(std::size_t i) const { return frames_[i]; }
  [[nodiscard]] std::vector<ModelPoint> points() const;

  /// Overwrites `out`, whose memory is used again. May be called from several threads at once.
  virtual void cell(std::size_t i, SiteCell& out) const = 0;
  /// Moves site i to target[i] in its own frame, all of them. A site may stop short where its
  /// triangulation asks for that.
  virtual void move(const std::vector<Offset>& target) = 0;
  /// Remembers the sites where they are, and goes back there.
  virtual void save() { saved_frames_ = frames_; }
  virtual void restore() { frames_ = saved_frames_; }
  /// The middles of so many Delaunay edges, or all, those longest for their surroundings first; none
  /// where nothing is triangulated on a closed domain.
  [[nodiscard]] virtual std::vector<ModelPoint> middles(std::size_t /*most*/) const { return {}; }
  /// Delaunay triangles, counterclockwise.
  [[nodiscard]] virtual std::vector<std::array<std::int32_t, 3>> triangles() const = 0;

 protected:
  std::vector<Frame> frames_, saved_frames_;
};

/// Throws NumericalError when four or more sites on a sphere lie in one hemisphere; InvalidInput
/// when two sites coincide.
std::unique_ptr<SpaceSites> make_sites(const Domain& domain, const std::vector<ModelPoint>& sites);

/// Points in the order of a space-filling curve, so that near ones come near each other.
void sort_along_curve(std::vector<ModelPoint>& points);

}  // namespace ucvt
