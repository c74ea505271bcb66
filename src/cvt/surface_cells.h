// The Voronoi cells of sites on T, known by which cell each vertex of T lies in.
//
// Every vertex of T carries the site that owns it and its offset in that site's frame, and follows
// the sites as they move. A vertex adds its share of the faces around it to its cell; faces that straddle
// cells are cut, and what their corners gave to the wrong cells is handed over. One sweep over T, no
// search.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cvt/lifts.h"
#include "cvt/surface_mass.h"
#include "triangulation/delaunay.h"

namespace ucvt {

class SurfaceCells {
 public:
  /// Develops T over every cell. Site i's frame in D and in places[i] is one and the same. Keeps a
  /// reference to t.
  SurfaceCells(const UniformSurface& t, const DelaunayTriangulation& d,
               const std::vector<Place>& places);

  /// Follows sites that moved to reached[i] in their own frames; d is Delaunay again.
  void follow(const DelaunayTriangulation& d, std::span<const Offset> reached);

  /// Hands on what the cells of removed sites hold (marked by their old numbers, no two of them
  /// neighbours). `number` has the new numbers by the old ones; d is Delaunay again.
  void follow_removal(const DelaunayTriangulation& d, const std::vector<bool>& removed,
                      const std::vector<Vertex>& number);

  /// Moments of every cell, each in its site's frame, for a density on the same T. In parallel; the
  /// same bits for any number of threads. `places` as in the constructor, where the sites are now.
  ///
  /// With `corner_in`, marks by site, only of faces with a corner in a cell so marked.
  [[nodiscard]] std::vector<Moments> moments(const SurfaceMass& mass,
                                             const std::vector<Place>& places,
                                             const std::vector<bool>* corner_in = nullptr) const;

  /// The site whose cell a vertex of T lies in.
  [[nodiscard]] Vertex owner(Vertex of_t) const {
    return lifts_.owner[static_cast<std::size_t>(t_->vertex_order().rank[of_t.index()])];
  }

 private:
  class Sweep;
  /// Hands the vertex on to nearer neighbours until there is none.
  void settle(Offset& at, Vertex& owner) const;

  const UniformSurface* t_;
  Stars stars_;
  Lifts lifts_;
};

}  // namespace ucvt
