// T with fewer vertices: some of its own, evenly spread over the input, with their Delaunay
// triangulation. The surface is the same, exactly; only what is known of its density is coarser.
//
// Few sites need few faces under them, and D of any sites is built from such a triangulation by
// putting them in and taking its vertices away (docs/optimisation.md).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "triangulation/delaunay.h"
#include "triangulation/uniform_surface.h"

namespace ucvt {

class ThinnedSurface {
 public:
  [[nodiscard]] const UniformSurface& surface() const { return surface_; }
  /// The same triangulation by offsets, in T's frames at the vertices that are left.
  [[nodiscard]] const DelaunayTriangulation& delaunay() const { return delaunay_; }

  /// As of T's `vertex_frames`.
  [[nodiscard]] const std::vector<Offset>& frames_of_t() const { return source_->frames; }

  /// Sums of values at the vertices of T, by the vertex that is left near each.
  [[nodiscard]] std::vector<double> summed(const std::vector<double>& of_t) const;
  /// Their means, by T's area round each vertex.
  [[nodiscard]] std::vector<double> averaged(const std::vector<double>& of_t) const;

  /// The same point, by faces of this triangulation and of T.
  [[nodiscard]] SurfacePoint from_t(const SurfacePoint& p) const;
  [[nodiscard]] SurfacePoint to_t(const SurfacePoint& p) const;

  /// Overwrites points in the frame of a vertex of T with the same ones in the frame of the vertex that
  /// is left near it, and returns that.
  [[nodiscard]] Vertex anchor(Vertex of_t, std::span<Offset> points) const;

 private:
  friend std::vector<ThinnedSurface> thin_out(const UniformSurface&, const std::vector<double>&,
                                              const std::vector<std::size_t>&);
  /// What all steps share of T.
  struct Source {
    const UniformSurface& t;
    std::vector<Offset> frames;  ///< at T's vertices
    std::vector<double> area;    ///< of T round each vertex
  };
  ThinnedSurface(std::shared_ptr<const Source> source, DelaunayTriangulation d,
                 std::vector<Vertex> kept, std::vector<Halfedge> towards);

  std::shared_ptr<const Source> source_;
  DelaunayTriangulation delaunay_;
  UniformSurface surface_;
  std::vector<Vertex> kept_;       ///< their numbers in T
  std::vector<Halfedge> towards_;  ///< by vertex of T: to the next on the way; id -1: it is left
  std::vector<Vertex> near_;       ///< by vertex of T: the vertex where the way ends
};

/// Thins T out to about so many vertices (falling numbers, below T's own), each step from the one before.
/// `length` is that of T's edges on the input, by halfedge. Fewer steps than asked for when doubles do
/// not suffice for the next one. Keeps a reference to t.
std::vector<ThinnedSurface> thin_out(const UniformSurface& t, const std::vector<double>& length,
                                     const std::vector<std::size_t>& counts);

}  // namespace ucvt
