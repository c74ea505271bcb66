// One half of a symmetric tessellation: D cut along the mirror line.
#pragma once

#include <optional>
#include <vector>

#include "conformal/uniformize.h"
#include "cvt/mirror_sites.h"

namespace ucvt {

/// For every pair which of its two sites, 0 or 1, lies in the half of the double that has the first
/// `half_faces` faces.
std::vector<std::size_t> sides_in_half(const Uniformized& t, const MirrorSites& sites,
                                       std::size_t half_faces);

/// The half's part of D: sites by number in D, faces by position in `sites`.
struct HalfMesh {
  std::vector<Vertex> sites;
  std::vector<Corners> faces;
};

/// What a finished run keeps of the half: where the cells on it come from.
struct HalfOfDouble {
  std::vector<Vertex> sites;             ///< in the half, by vertex of the mesh
  std::size_t on_line = 0;               ///< so many sites, the first ones, lie on the boundary
  std::vector<std::int32_t> input_face;  ///< of the half's faces, the double's first ones
  std::size_t input_vertices =
      0;  ///< of the double's vertices so many, the first ones, are the input's
};

class HalfView {
 public:
  /// `loops`: the sites on the line in order, the half on the left. Keeps references to both.
  HalfView(const MirrorSites& sites, const std::vector<std::vector<std::size_t>>& loops,
           std::vector<std::size_t> side);

  /// A piece of the line, from one site on it to the next, that is no edge of D; the pair whose edge
  /// crosses it and where.
  struct Gap {
    std::size_t from = 0;
    std::optional<std::size_t> pair;
    SurfacePoint foot;
  };
  [[nodiscard]] std::vector<Gap> gaps() const;

  /// Edges of the half that are loops, and of several between the same sites all but one.
  [[nodiscard]] std::vector<Halfedge> edges_not_simplicial() const;
  /// Edges of the half that do not run along the line, the longest for their surroundings first.
  [[nodiscard]] std::vector<Halfedge> inner_edges() const;
  /// The middle of an edge of the half and its mirror image.
  [[nodiscard]] std::array<SurfacePoint, 2> middle(Halfedge h) const;

  /// Requires no gaps. Throws NumericalError when the line does not separate the halves.
  [[nodiscard]] HalfMesh mesh() const;

 private:
  [[nodiscard]] bool in_half(Vertex site) const;
  /// The direction of the line at p that has the half on its left.
  [[nodiscard]] int forward(Vertex p) const;
  [[nodiscard]] Gap gap_at(std::size_t p, const MirrorSites::Ahead& ahead, int direction) const;
  /// Faces of D in the half.
  [[nodiscard]] std::vector<Face> faces() const;

  const MirrorSites& sites_;
  const DelaunayTriangulation& d_;
  const std::vector<std::vector<std::size_t>>& loops_;
  std::vector<std::size_t> side_;
  std::vector<bool> wall_;  ///< by halfedge: runs along the line
  std::vector<Gap> gaps_;
};

}  // namespace ucvt
