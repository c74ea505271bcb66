// Sites on a surface with a density, their Voronoi cells, and Lloyd's method.
#pragma once

#include <vector>

#include "cvt/surface_cells.h"
#include "triangulation/delaunay.h"
#include "ucvt/uniformize.h"

namespace ucvt {

/// Sites on T with their Delaunay triangulation D. Site i is vertex i of D; its frame there and in
/// its place on T is one and the same.
class Tessellation {
 public:
  /// Builds D from T by inserting the sites and removing T's vertices. Keeps a reference to the
  /// mass. Requires at least one site, four on the sphere. Throws InvalidInput when two sites
  /// coincide.
  Tessellation(const SurfaceMass& mass, const std::vector<SurfacePoint>& sites);

  [[nodiscard]] const DelaunayTriangulation& delaunay() const { return d_; }
  [[nodiscard]] std::size_t site_count() const { return places_.size(); }
  [[nodiscard]] const Place& place(Vertex site) const { return places_[site.index()]; }
  [[nodiscard]] std::vector<SurfacePoint> sites() const;

  /// Moments of every cell, each in its site's frame, under the surface's density or another one on
  /// the same T. In parallel; the same bits for any number of threads.
  [[nodiscard]] std::vector<Moments> cell_moments(const SurfaceMass& mass) const {
    return cells_.moments(mass, places_);
  }
  [[nodiscard]] std::vector<Moments> cell_moments() const { return cell_moments(mass_); }

  /// Moves site i to target[i] in its own frame, all of them, and restores Delaunay.
  void move(const std::vector<Offset>& target);

  /// Mean chord from a site to its neighbours in D.
  [[nodiscard]] double spacing(Vertex site) const;

 private:
  const SurfaceMass& mass_;
  std::vector<Place> places_;  // filled while d_ is built
  DelaunayTriangulation d_;
  SurfaceCells cells_;
};

struct LloydOptions {
  int iterations = 1000;    ///< at most
  double tolerance = 1e-4;  ///< of the largest move relative to the site's spacing
};

struct LloydResult {
  bool converged = false;
  bool cancelled = false;
  std::vector<double> energy;    ///< sum over cells of int rho chord^2, before each iteration
  std::vector<double> max_move;  ///< relative to the spacing, of each iteration
};

/// Lloyd's method: moves every site to its cell's centroid until the largest move is below the
/// tolerance. The energy never rises. A cancelled run stops after a whole iteration.
LloydResult lloyd(Tessellation& sites, const LloydOptions& options, const Monitor& monitor);

}  // namespace ucvt
