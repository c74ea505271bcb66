// The faces of T that meet one Voronoi cell, developed into the frame of its site.
//
// A cell is the convex set of points no farther from its site than from the site's neighbours in D.
// T is developed face by face over it from the face under the site.
#pragma once

#include <cstdint>
#include <vector>

#include "triangulation/uniform_surface.h"

namespace ucvt {

/// Positive where p is nearer to the neighbour than to the site (the origin); linear in P.
inline double beyond_bisector(Space s, const Offset& p, const Offset& neighbour) {
  return neighbour.x * p.x + neighbour.y * p.y - neighbour.h * model_z(s, p);
}

/// Rounding of a point that was carried along in the frame of a site, at the offsets that its cell
/// spans: `reach` is the chord to the farthest neighbour.
inline double lift_rounding(Space s, const Offset& p, double reach) {
  constexpr double rounding = 1e-13;
  return rounding * (reach + std::abs(p.x) + std::abs(p.y)) * std::abs(model_z(s, p));
}

/// Bound on the squared chord between what are two computations of one lift of a point, at the end of
/// an edge of the given squared chord; other lifts are farther apart.
inline double same_lift2(double edge2, double rounding) {
  constexpr double edge_part = 1e-3;
  return edge_part * edge2 + rounding * rounding;
}

class CellWalk {
 public:
  /// A face of T where it lies in the site's frame; lifts of one face are chained.
  struct Developed {
    Place place;
    std::array<std::uint64_t, 3> outside;  ///< per corner, bit j: nearer to neighbour j
    std::int32_t older;
  };

  /// Keeps a reference to t, and 8 bytes per face of it.
  explicit CellWalk(const UniformSurface& t)
      : t_(t), stamp_(t.connectivity().face_count(), 0), newest_(stamp_.size(), -1) {}

  /// The faces that meet the cell of the site at the origin of `place`'s frame, whose neighbours in
  /// D lie at `neighbours` in that frame; some that come near it too. Valid until the next call.
  const std::vector<Developed>& faces(const Place& place, const std::vector<Offset>& neighbours);

 private:
  Developed& add(Face face);
  /// True when the face of h was developed with h's ends at u and v.
  [[nodiscard]] bool is_developed(Halfedge h, const Offset& u, const Offset& v) const;
  void cross_into(std::size_t from, std::size_t side, const std::vector<Offset>& neighbours);
  [[nodiscard]] std::uint64_t outside(const Offset& p, const std::vector<Offset>& neighbours) const;

  const UniformSurface& t_;
  std::vector<std::uint32_t> stamp_;
  std::vector<std::int32_t> newest_;
  std::uint32_t cell_ = 0;
  double reach_ = 0;  // chord to the farthest neighbour of the site at hand
  std::vector<Developed> developed_;
};

}  // namespace ucvt
