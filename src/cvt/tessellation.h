// Sites on a surface with a density, and their Voronoi cells.
#pragma once

#include <optional>
#include <vector>

#include "cvt/optimize.h"
#include "cvt/surface_cells.h"
#include "cvt/thinned_surface.h"
#include "triangulation/delaunay.h"
#include "ucvt/uniformize.h"

namespace ucvt {

/// Sites on T with their Delaunay triangulation D. Site i is vertex i of D; its frame there and in
/// its place on T is one and the same.
class Tessellation : public SiteSystem {
 public:
  /// Builds D from T, or from a thinned T where there is one, by inserting the sites and removing the
  /// vertices. Keeps a reference to the mass, not to the thinned T. Requires at least one site, four on
  /// the sphere. Throws InvalidInput when two sites coincide.
  Tessellation(const SurfaceMass& mass, const std::vector<SurfacePoint>& sites,
               const ThinnedSurface* base = nullptr);

  [[nodiscard]] const DelaunayTriangulation& delaunay() const { return d_; }
  [[nodiscard]] Space space() const override { return d_.space(); }
  [[nodiscard]] std::size_t site_count() const override { return places_.size(); }
  [[nodiscard]] const Place& place(Vertex site) const { return places_[site.index()]; }
  [[nodiscard]] std::vector<SurfacePoint> sites() const;

  /// Moments of every cell, each in its site's frame, under the surface's density or another one on
  /// the same T. In parallel; the same bits for any number of threads.
  [[nodiscard]] std::vector<Moments> cell_moments(const SurfaceMass& mass) const {
    return cells_.moments(mass, places_);
  }
  [[nodiscard]] std::vector<Moments> cell_moments() const { return cell_moments(mass_); }

  /// The site whose cell a vertex of T lies in.
  [[nodiscard]] Vertex owner(Vertex of_t) const { return cells_.owner(of_t); }

  void measure(std::vector<CellState>& out) const override;
  /// Of some sites, in their order: what faces hold that have a corner in a cell marked in `near`, by
  /// site. That is all when also the neighbours' cells are marked, and edges of T are shorter than cells.
  void measure(const std::vector<Vertex>& sites, const std::vector<bool>& near,
               std::vector<CellState>& out) const;
  /// Moves the sites and restores Delaunay.
  void move(const std::vector<Offset>& target) override;
  [[nodiscard]] std::vector<Spring> springs() const override;
  void save() override;
  void restore() override;

  /// The middle of an edge of D.
  struct Middle {
    Vertex from;    ///< the origin of the halfedge
    Offset offset;  ///< of the middle, in that site's frame
    Place place;    ///< the same on T, in a frame carried there
  };
  [[nodiscard]] Middle middle(Halfedge h) const;

  /// Adds sites at the middles of edges of D, one of each edge's halfedges being given. The sites
  /// before keep their numbers.
  void split_edges(const std::vector<Halfedge>& edges);

  /// Takes sites away, no two of them neighbours. Returns the new numbers by the old ones.
  std::vector<Vertex> remove_sites(const std::vector<Vertex>& sites);

 private:
  /// The edge of h; its ends differ.
  [[nodiscard]] Spring spring(Halfedge h) const;

  struct Saved {
    std::vector<Place> places;
    DelaunayTriangulation d;
    SurfaceCells cells;
  };

  const SurfaceMass& mass_;
  std::vector<Place> places_;  // filled while d_ is built
  DelaunayTriangulation d_;
  SurfaceCells cells_;
  std::optional<Saved> saved_;
};

}  // namespace ucvt
