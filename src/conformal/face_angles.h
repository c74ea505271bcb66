// Angles of the faces of a metric of constant curvature from their half chords, four faces at a time.
#pragma once

#include <array>
#include <cstddef>

#include "space/offset.h"

namespace ucvt {

/// Four faces, three numbers each.
using FourFaces = std::array<double, 12>;

/// Angles, in radians, and cot(beta) for each side of each face, beta as in docs/uniformization.md; the k-th
/// angle of a face is the one opposite to its k-th side. `half` are the faces' half chords. False when
/// one of them breaks the triangle inequality, or is none: angles and cotangents are then undefined.
bool face_angles(Space space, const FourFaces& half, FourFaces& angle, FourFaces& cot);

}  // namespace ucvt
