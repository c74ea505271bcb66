// The steps of a repair; each changes the mesh, the numbers that lead back, and the report.
#pragma once

#include "ucvt/repair.h"

namespace ucvt {

/// Gives vertices of open edges within `tolerance` of each other the number of the first of them.
void weld_open_vertices(Repaired& r, double tolerance);

/// Drops faces with a repeated corner.
void drop_repeated_corners(Repaired& r);

/// Of faces with the same three vertices one is left; none, where they are a wall inside: all round
/// them an even number of other faces meets.
void drop_copies(Repaired& r);

/// Gives every fan of faces round a vertex a vertex of its own. Open fans stay together for the time
/// being, unless `open_ones_too`: once holes are closed they may be one.
void split_fans(Repaired& r, bool open_ones_too);

/// Puts a vertex in the middle of all but one of the edges with the same two ends, where fans cannot
/// be told apart: the surface touches itself along them.
void cut_double_edges(Repaired& r);

/// Turns faces round to agree with their neighbours, the fewer ones of each connected part; nothing
/// where that is not possible. Gives whether it was.
bool orient(Repaired& r);

/// Closes small holes. Requires oriented faces.
void close_holes(Repaired& r, const RepairOptions& options);

}  // namespace ucvt
