// The record of how the input mesh was turned into T, and the way back.
//
// Every flip and every split is a linear change of homogeneous barycentric coordinates in its
// quadrilateral i, j, k, m (docs/mapping-back.md): with the corners as vectors of R^3 (planar for a
// Euclidean flip, on the light cone for a Ptolemy flip)
//     i v_i + j v_j = k v_k + m v_m,   all four coefficients positive.
// Undoing the record in reverse carries points of T to the input: exact overlay, no search.
#pragma once

#include <array>
#include <vector>

#include "triangulation/connectivity.h"

namespace ucvt {

/// One recorded change. With h from i to j in face (i, j, k) and t its twin in face (j, i, m) before
/// it: a flip as in Connectivity::flip, or a split of the edge in its middle as in
/// Connectivity::split_edge, which added two faces.
struct Change {
  Halfedge h, t;
  std::array<Face, 2> added;          ///< ids -1: a flip
  double i = 0, j = 0, k = 0, m = 0;  ///< of a flip, up to a common factor
};

/// A point in homogeneous barycentric coordinates of a face; only ratios count.
struct HomogeneousPoint {
  Face face;
  std::array<double, 3> weight{};  ///< by the face's round: of the origin of halfedge 3 f + i
};

/// The changes in the order they were made.
class ChangeLog {
 public:
  void add_flip(Halfedge h, Halfedge t, double i, double j, double k, double m) {
    changes_.push_back({h, t, {}, i, j, k, m});
  }
  void add_split(Halfedge h, Halfedge t, std::array<Face, 2> added) {
    changes_.push_back({h, t, added});
  }
  /// Face f is called to[f] from now on, and in the changes so far.
  void renumber(const std::vector<Face>& to);
  [[nodiscard]] std::size_t size() const { return changes_.size(); }
  [[nodiscard]] const std::vector<Change>& changes() const { return changes_; }
  /// What a face was called before it was renumbered; before the first change the input's number.
  [[nodiscard]] Face first_name(Face f) const {
    return first_name_.empty() ? f : first_name_[f.index()];
  }

  /// Carries points from after the last change to before the first one, and to the input's faces.
  void undo(std::vector<HomogeneousPoint>& points) const;

 private:
  std::vector<Change> changes_;
  std::vector<Face> first_name_;  ///< empty: never renumbered
};

}  // namespace ucvt
