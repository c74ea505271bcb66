// From a polygon glued by any word to one glued by a1 b1 a1^-1 b1^-1 ....
//
// The classical proof of the classification of surfaces as an algorithm on words (Brahana 1921;
// Lazarus, Pocchiola, Vegter, Verroust 2001): one handle after the other is collected, here the one
// with the shortest loops first. docs/group.md.
#pragma once

#include <vector>

#include "cover/deck_map.h"
#include "cover/words.h"

namespace ucvt {

/// a1, b1, a2, b2, ... as words in the greedy loops and as maps; [a1, b1] [a2, b2] ... = 1.
struct CanonicalSystem {
  std::vector<Word> word;
  std::vector<DeckMap> map;
};

/// Collects the handles of a rim of one vertex in which every letter occurs once in each direction
/// and which is the identity. `loop` holds the letters' maps.
CanonicalSystem collect_handles(double kappa, const Word& rim, const std::vector<DeckMap>& loop);

}  // namespace ucvt
