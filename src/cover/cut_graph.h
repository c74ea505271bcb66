// A closed surface cut open to a disk along short loops through one vertex.
//
// The greedy system of loops (Erickson, Whittlesey 2005): a tree of shortest paths from the base, a
// spanning tree of the dual that crosses the edges with the longest loops first, and the 2g edges
// that neither uses. Loop i runs down the tree, along edge i, and back. The tree contracted to a
// point, the disk's rim reads as a word of 4g letters in which every loop occurs once in each
// direction. Letters are +-(i + 1).
#pragma once

#include <cstdint>
#include <vector>

#include "triangulation/uniform_surface.h"

namespace ucvt {

using Word = std::vector<std::int32_t>;

struct CutGraph {
  Vertex base;
  std::vector<Halfedge> towards_base;  ///< by vertex: the first step of its path home; base: id -1
  std::vector<Vertex> by_distance;     ///< all vertices, the base first
  std::vector<Halfedge> edge;          ///< loop i crosses the tree's gap along edge[i]
  std::vector<double> length;          ///< of loop i, along the edges
  Word rim;                            ///< the disk's rim, counterclockwise, from the base on
  /// By halfedge, of its face's corner at its origin: how many letters of the rim come before that
  /// corner, less than 4g. The corner lies where the tree, lifted to there, puts its vertex.
  std::vector<std::int32_t> letters_before;
};

/// Cuts the surface along the greedy system of loops at `base`. Requires genus >= 1.
CutGraph cut_graph(const UniformSurface& t, Vertex base);

/// A few vertices far from each other, to try as bases; deterministic.
std::vector<Vertex> spread_vertices(const UniformSurface& t, std::size_t count);

/// The loop's halfedges in order, with steps to and fro left out.
std::vector<Halfedge> loop_path(const CutGraph& cut, const Connectivity& c, const Word& word);

}  // namespace ucvt
