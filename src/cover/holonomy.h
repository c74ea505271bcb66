// Frames carried along the edges of T, with 32 digits: the deck transformations of loops.
//
// The frame at a vertex has its first axis along outgoing(v), as in UniformSurface::vertex_frames.
// A loop from the base takes the base's frame to another lift of it; that map of the model, with the
// base at its origin, is the loop's deck transformation, and the product of two loops, one run after
// the other, is the product of their maps. docs/group.md.
#pragma once

#include "cover/cut_graph.h"
#include "cover/deck_map.h"

namespace ucvt {

struct Holonomy {
  std::vector<DeckMap> frame;  ///< by vertex: from the base's frame along the tree to the vertex'
  std::vector<DeckMap> loop;   ///< the greedy loops
};

/// Cosine and sine of half the angle from outgoing(v) round to every halfedge of v.
std::vector<PreciseComplex> half_directions(const UniformSurface& t);

/// Develops T along the cut. The chords are taken as exact.
Holonomy holonomy(const UniformSurface& t, const std::vector<PreciseComplex>& half_direction,
                  const CutGraph& cut);

/// How a projection to the relation ended.
struct RelationFit {
  double before = 0;  ///< rim's distance from the identity, by numbers of (a, b)
  double after = 0;
  double change = 0;  ///< largest change of a loop, relative to the largest of its numbers
  int iterations = 0;
  bool converged = false;
};

/// Moves the loops' maps by as little as possible, relative to their own sizes, until the rim is the
/// identity: Gauss and Newton's method on Lie(PSU)^2g, least squares of all changes. In the plane the
/// maps become translations, which is all there is to do.
RelationFit project_to_relation(double kappa, const Word& rim, std::vector<DeckMap>& loop);

/// The product of generators along a word.
DeckMap map_of(double kappa, const Word& word, const std::vector<DeckMap>& generator);

}  // namespace ucvt
