// The deck group of T: canonical generators, their maps, the 4g-gon and the copies round it.
//
// docs/group.md derives what this computes and says what the numbers are good for.
#pragma once

#include <vector>

#include "cover/canonical_system.h"
#include "cover/cut_graph.h"
#include "cover/holonomy.h"
#include "ucvt/cover.h"

namespace ucvt {

/// Everything about the deck group, with 32 digits; maps are relative to the base's frame.
struct DeckSystem {
  double kappa = 0;
  CutGraph cut;                ///< the greedy loops; words are in their letters
  std::vector<DeckMap> frame;  ///< of every vertex, along the tree
  std::vector<DeckMap> loop;   ///< of the greedy loops, after the projection
  RelationFit projection;
  CanonicalSystem canonical;
};

/// Finds short canonical generators of a surface of genus >= 1, trying several base vertices.
///
/// Throws InvalidInput for a sphere, NumericalError when no base gives a group whose relation holds.
DeckSystem deck_system(const UniformSurface& t);

/// The maps to the corners of the polygon with the given sides, first to last, and the first again.
std::vector<DeckMap> corner_maps(double kappa, const Word& sides,
                                 const std::vector<DeckMap>& generator);

/// The group in doubles, with its certificate.
DeckGroup deck_group(const DeckSystem& system);

/// The words, in canonical letters, of the copies of the 4g-gon that share a side or a corner with
/// it: clockwise round corner after corner, 16 g^2 - 8 g of them.
std::vector<Word> neighbour_words(int genus);

}  // namespace ucvt
