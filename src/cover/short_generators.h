// Canonical generators made short, without leaving the canonical form.
//
// Lickorish' twists, each along a curve in one handle or between two neighbouring ones, generate all
// changes from one canonical system to another; with the exchange of neighbouring handles and the
// conjugation by a generator they are the moves of a descent. docs/group.md.
#pragma once

#include <vector>

#include "cover/canonical_system.h"

namespace ucvt {

/// Descends by moves, and by turning the handles' order round, until none lowers `total_length`.
CanonicalSystem shortened(double kappa, CanonicalSystem start, const WordReducer& reduce,
                          const std::vector<DeckMap>& loop);

/// The sum that the descent lowers: the polygon's sides, and the distances of its corners from the
/// first one. `corner` is the map to where the given handles begin.
double total_length(double kappa, const std::vector<DeckMap>& generator, DeckMap corner = {});

}  // namespace ucvt
