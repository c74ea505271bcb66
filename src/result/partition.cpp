#include "ucvt/partition.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <unordered_set>

#include "conformal/overlay.h"
#include "conformal/uniformize.h"
#include "mesh/disjoint_sets.h"
#include "result/cell_complex.h"
#include "result/cell_curves.h"
#include "result/colouring.h"
#include "result/half_partition.h"
#include "result/polygon_triangles.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Margins to try: see cell_curves. Most surfaces need the first only.
constexpr double margins[] = {1e-9, 1e-7, 1e-5, 1e-3};

std::size_t index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

Overlay overlay_of(const Uniformized& t, const CellComplex& cells) {
  const Connectivity& c = t.surface.connectivity();
  std::string fault = "the boundaries of the cells do not fit together to rounding";
  for (const double margin : margins) {
    try {
      Overlay out(c, cell_curves(t, cells.delaunay, cells.places, margin));
      if (out.is_embedded(c.euler_number())) {
        return out;
      }
    } catch (const NumericalError& error) {
      fault = error.what();
    }
  }
  throw NumericalError(fault +
                       ", as happens where limbs are much thinner than cells; ask for more");
}

/// Gathers the faces of the cut surface, input face by input face.
class Cutter {
 public:
  Cutter(const Uniformized& t, Overlay& overlay)
      : t_(t), overlay_(overlay), number_(overlay.node_count(), -1) {
    out_.mesh.positions = t.input.positions;
    out_.vertex_cell.assign(t.input.positions.size(), -1);
    out_.face_cell.assign(t.input.faces.size(), -1);
  }

  Partition run() {
    DisjointSets together(t_.input.positions.size());
    std::vector<Overlay::Region> regions;
    for (std::size_t f = 0; f < t_.input.faces.size(); ++f) {
      overlay_.regions_of({static_cast<std::int32_t>(f)}, regions);
      for (const Overlay::Region& region : regions) {
        label_corners(region, together);
        add_piece(f, region);
      }
    }
    cut_pieces();
    name_whole_faces(together);
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool is_vertex(Node n) const { return n.index() < out_.vertex_cell.size(); }

  void label_corners(const Overlay::Region& region, DisjointSets& together) {
    std::int32_t first = -1;
    for (const Overlay::Corner& c : region.corners) {
      if (!is_vertex(c.node)) {
        continue;
      }
      if (region.label >= 0) {
        out_.vertex_cell[c.node.index()] = region.label;
      }
      if (first >= 0) {
        together.join(first, c.node.id);
      }
      first = c.node.id;
    }
  }

  [[nodiscard]] Position place(std::size_t f, const std::array<double, 3>& bary) const {
    Position out{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        out[k] += bary[i] * t_.input.positions[index(t_.input.faces[f][i])][k];
      }
    }
    return out;
  }

  std::int32_t add_vertex(const Position& p) {
    out_.mesh.positions.push_back(p);
    return static_cast<std::int32_t>(out_.mesh.positions.size() - 1);
  }

  std::int32_t vertex(std::size_t f, const Overlay::Corner& c) {
    if (is_vertex(c.node)) {
      return c.node.id;
    }
    std::int32_t& n = number_[c.node.index()];
    return n >= 0 ? n : n = add_vertex(place(f, c.bary));
  }

  /// A region as a polygon of the cut surface.
  struct Piece {
    std::size_t face;
    std::int32_t label;
    std::vector<std::int32_t> vertices;
    std::vector<std::array<double, 3>> bary;
  };

  static std::uint64_t edge(std::int32_t a, std::int32_t b) {
    return std::uint64_t{static_cast<std::uint32_t>(std::min(a, b))} << 32 |
           static_cast<std::uint32_t>(std::max(a, b));
  }

  void add_piece(std::size_t f, const Overlay::Region& region) {
    // A region between two edges is flat: they are one edge of the cut surface.
    if (region.corners.size() < 3) {
      return;
    }
    Piece& piece = pieces_.emplace_back(Piece{f, region.label, {}, {}});
    for (const Overlay::Corner& c : region.corners) {
      piece.bary.push_back(c.bary);
      piece.vertices.push_back(vertex(f, c));
    }
    for (std::size_t n = 0; region.label >= 0 && n < piece.vertices.size(); ++n) {
      edges_.insert(edge(piece.vertices[n], piece.vertices[(n + 1) % piece.vertices.size()]));
    }
  }

  /// True when no diagonal of the triangles is an edge elsewhere; they are edges from now on.
  bool draw_diagonals(const Piece& piece, const std::vector<Corners>& triangles) {
    const std::size_t n = piece.vertices.size();
    std::vector<std::uint64_t> diagonals;
    for (const Corners& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        // Each diagonal is met twice, once in either direction.
        const std::size_t a = index(t[k]), b = index(t[(k + 1) % 3]);
        if (a < b && b < n && b != a + 1 && !(a == 0 && b == n - 1)) {
          diagonals.push_back(edge(piece.vertices[a], piece.vertices[b]));
        }
      }
    }
    for (std::size_t i = 0; i < diagonals.size(); ++i) {
      if (!edges_.insert(diagonals[i]).second) {
        for (std::size_t j = 0; j < i; ++j) {
          edges_.erase(diagonals[j]);
        }
        return false;
      }
    }
    return true;
  }

  void cut(Piece& piece, std::map<std::int32_t, double>& share) {
    PolygonTriangles cut = triangulate_polygon(piece.bary);
    if (!draw_diagonals(piece, cut.triangles)) {
      cut = fan_of_polygon(piece.bary);
    }
    for (const auto& bary : cut.added) {
      piece.vertices.push_back(add_vertex(place(piece.face, bary)));
    }
    for (const Corners& t : cut.triangles) {
      const auto at = [&](std::size_t i) { return piece.vertices[index(t[i])]; };
      const Corners face{at(0), at(1), at(2)};
      out_.mesh.faces.push_back(face);
      out_.cell.push_back(piece.label);
      out_.input_face.push_back(t_.input_face[piece.face]);
      share[piece.label] += face_area(out_.mesh, face);
    }
  }

  /// The pieces of one face after the other; the largest names it.
  void cut_pieces() {
    std::map<std::int32_t, double> share;
    for (std::size_t n = 0; n < pieces_.size(); ++n) {
      cut(pieces_[n], share);
      if (n + 1 < pieces_.size() && pieces_[n + 1].face == pieces_[n].face) {
        continue;
      }
      const auto largest =
          std::max_element(share.begin(), share.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
      out_.face_cell[index(t_.input_face[pieces_[n].face])] = largest->first;
      share.clear();
    }
  }

  /// A face that no boundary crosses lies in the cell of its corners, one of which has a name.
  void name_whole_faces(DisjointSets& together) {
    std::vector<std::int32_t> name(out_.vertex_cell.size(), -1);
    for (std::size_t v = 0; v < name.size(); ++v) {
      if (out_.vertex_cell[v] >= 0) {
        name[index(together.find(static_cast<std::int32_t>(v)))] = out_.vertex_cell[v];
      }
    }
    for (std::size_t v = 0; v < name.size(); ++v) {
      out_.vertex_cell[v] = name[index(together.find(static_cast<std::int32_t>(v)))];
    }
    for (std::size_t f = 0; f < out_.cell.size(); ++f) {
      if (out_.cell[f] < 0) {
        out_.cell[f] = out_.vertex_cell[index(out_.mesh.faces[f][0])];
        out_.face_cell[index(out_.input_face[f])] = out_.cell[f];
      }
    }
  }

  const Uniformized& t_;
  Overlay& overlay_;
  std::vector<std::int32_t> number_;  // by node: its vertex in the cut surface, or -1
  Partition out_;
  std::vector<Piece> pieces_;
  std::unordered_set<std::uint64_t> edges_;  ///< of the pieces that boundaries pass
};

/// The cell's measures that D knows.
PartitionCell measure_cell(const DelaunayTriangulation& d, Vertex site) {
  const Connectivity& c = d.connectivity();
  const Space s = d.space();
  PartitionCell out;
  std::vector<Offset> corner;
  out.nearest = HUGE_VAL;
  c.for_outgoing(site, [&](Halfedge h) {
    const Central k = circumcentre(d.offset(h), d.offset(c.rotate(h)));
    corner.push_back(from_central(s, k.x, k.y));
    out.radius = std::max(out.radius, length_of_chord(s, std::sqrt(2 * corner.back().h)));
    out.nearest = std::min(out.nearest, length_of_chord(s, std::sqrt(2 * d.offset(h).h)));
    ++out.degree;
    if (c.head(h) != site) {
      out.neighbours.push_back(c.head(h).id);
    }
  });
  for (std::size_t i = 0; i < corner.size(); ++i) {
    out.area += central_triangle_area(s, corner[i], corner[(i + 1) % corner.size()]);
  }
  std::sort(out.neighbours.begin(), out.neighbours.end());
  out.neighbours.erase(std::unique(out.neighbours.begin(), out.neighbours.end()),
                       out.neighbours.end());
  return out;
}

/// Positions, areas and colours of the cells.
void finish_cells(const std::vector<Position>& sites, Partition& out) {
  for (std::size_t f = 0; f < out.mesh.faces.size(); ++f) {
    out.cells[index(out.cell[f])].area_3d += face_area(out.mesh, out.mesh.faces[f]);
  }
  std::vector<std::vector<std::int32_t>> neighbours;
  for (const PartitionCell& cell : out.cells) {
    neighbours.push_back(cell.neighbours);
  }
  const std::vector<std::int32_t> colour = colour_graph(neighbours);
  for (std::size_t i = 0; i < colour.size(); ++i) {
    out.cells[i].site = sites[i];
    out.cells[i].colour = colour[i];
    out.colours = std::max(out.colours, colour[i] + 1);
  }
}

}  // namespace

Partition partition(const RemeshResult& result) {
  if (!result.cells) {
    throw InvalidInput("there are no cells to be cut out; take them from remesh");
  }
  const Uniformized& t = result.surface.value();
  const CellComplex& complex = *result.cells;
  Overlay overlay = overlay_of(t, complex);
  overlay.undo(t.intrinsic.log,
               static_cast<std::size_t>(t.intrinsic.euclidean_flips + t.intrinsic.splits));
  Partition out = Cutter(t, overlay).run();
  for (std::size_t i = 0; i < complex.places.size(); ++i) {
    out.cells.push_back(measure_cell(complex.delaunay, {static_cast<std::int32_t>(i)}));
  }
  if (result.half) {
    out = half_partition(out, *result.half);
  }
  finish_cells(result.mesh.positions, out);
  return out;
}

}  // namespace ucvt
