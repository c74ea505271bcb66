// The Voronoi cells of sites on T, known by which cell each vertex of T lies in.
//
// Every vertex of T carries the site that owns it and its offset in that site's frame, and follows
// the sites as they move. A face whose three corners lie in one cell adds its precomputed weights to
// it; a face that straddles cells is clipped, cell by cell from neighbour to neighbour, in its own
// barycentric coordinates (geodesics are straight there). One sweep over T, no search.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cvt/surface_mass.h"
#include "triangulation/delaunay.h"

namespace ucvt {

/// The neighbours of every site, in D's order round it, in memory one after the other.
class Stars {
 public:
  struct Neighbour {
    Isometry frame;  ///< from the neighbour's frame to the site's
    Vertex site;
  };

  explicit Stars(const DelaunayTriangulation& d);

  [[nodiscard]] std::span<const Offset> offsets(Vertex site) const {
    return {offset_.data() + first_[site.index()], size(site)};
  }
  [[nodiscard]] std::span<const Neighbour> neighbours(Vertex site) const {
    return {neighbour_.data() + first_[site.index()], size(site)};
  }
  /// h of the points at the radius of the circle about the site that touches its cell's boundary.
  [[nodiscard]] double inner_h(Vertex site) const { return inner_h_[site.index()]; }
  /// The chord to the farthest neighbour.
  [[nodiscard]] double reach(Vertex site) const { return reach_[site.index()]; }
  [[nodiscard]] std::size_t site_count() const { return inner_h_.size(); }

 private:
  [[nodiscard]] std::size_t size(Vertex site) const {
    return first_[site.index() + 1] - first_[site.index()];
  }
  std::vector<std::size_t> first_;
  std::vector<Offset> offset_;
  std::vector<Neighbour> neighbour_;
  std::vector<double> inner_h_, reach_;
};

class SurfaceCells {
 public:
  /// A vertex of T: the site whose cell it lies in, and where in that site's frame.
  struct Lift {
    Offset at;
    Vertex owner;
  };

  /// Develops T over every cell. Site i's frame in D and in places[i] is one and the same. Keeps a
  /// reference to t.
  SurfaceCells(const UniformSurface& t, const DelaunayTriangulation& d,
               const std::vector<Place>& places);

  /// Follows sites that moved to reached[i] in their own frames; d is Delaunay again.
  void follow(const DelaunayTriangulation& d, std::span<const Offset> reached);

  /// Moments of every cell, each in its site's frame, for a density on the same T. In parallel; the
  /// same bits for any number of threads. `places` as in the constructor, where the sites are now.
  [[nodiscard]] std::vector<Moments> moments(const SurfaceMass& mass,
                                             const std::vector<Place>& places) const;

  /// By vertex of T.
  [[nodiscard]] const std::vector<Lift>& lifts() const { return lifts_; }

 private:
  class Sweep;
  /// Hands the vertex on to nearer neighbours until there is none.
  void settle(Lift& lift) const;

  const UniformSurface* t_;
  Stars stars_;
  std::vector<Lift> lifts_;
};

}  // namespace ucvt
