// Faces of T that straddle cells, cut and shared out.
//
// A face is clipped, cell by cell from neighbour to neighbour, in its own barycentric coordinates
// (geodesics are straight there).
#pragma once

#include <optional>
#include <vector>

#include "cvt/cell_shares.h"
#include "cvt/lifts.h"
#include "cvt/surface_mass.h"

namespace ucvt {

class StraddlingFaces {
 public:
  /// Keeps references to all of them; one object for one thread. `places` of the sites on T.
  StraddlingFaces(const SurfaceMass& mass, const Stars& stars, const Lifts& lifts,
                  const std::vector<Place>& places)
      : mass_(mass),
        t_(mass.surface()),
        space_(t_.space()),
        stars_(stars),
        lifts_(lifts),
        places_(places) {}

  /// Adds the parts of the face to the cells it meets, and takes its corners' shares from their cells.
  void add(Face f, CellShares& out);

 private:
  using Triangle = std::array<Offset, 3>;

  /// A cell that may meet the face at hand, with the face's corners in its site's frame.
  struct Visit {
    Vertex site;
    Triangle corner;
    std::size_t first = 0, size = 0;  ///< of its part of the face, in points_
  };

  /// A corner of the face at hand: a vertex of T where it lies.
  struct Lift {
    Offset at;
    Vertex owner;
  };

  [[nodiscard]] bool is_edge(Halfedge h, Vertex site, const Offset& p, const Offset& q) const {
    return joins(t_, stars_, h, site, p, q);
  }
  [[nodiscard]] std::optional<Offset> other_end(Halfedge h, const Lift& from,
                                                const Lift& other) const;
  [[nodiscard]] std::optional<Triangle> corners_about(Face f, std::size_t i) const;
  [[nodiscard]] std::optional<Triangle> corners_by_walk(Face f, std::size_t i);
  [[nodiscard]] Visit first_visit(Face f);
  void visit_cells(Face f);
  [[nodiscard]] bool was_visited(Face f, Vertex site, const Offset& first) const;
  void clip(const Visit& visit);
  bool cut(const double (&at)[3]);
  void share_out(Face f, CellShares& out);

  const SurfaceMass& mass_;
  const UniformSurface& t_;
  const Space space_;
  const Stars& stars_;
  const Lifts& lifts_;
  const std::vector<Place>& places_;
  std::array<Lift, 3> lift_;  // of the corners of the face at hand
  std::vector<Visit> visits_;
  std::vector<Barycentric> points_, polygon_, clipped_;
  std::vector<std::size_t> cutting_;
  std::optional<CellWalk> walk_;
  std::vector<Offset> neighbours_;
};

}  // namespace ucvt
