// How uniformization distorts the input surface, by vertex of the input.
#pragma once

#include <array>
#include <vector>

#include "conformal/uniformize.h"

namespace ucvt {

/// log10 of the ratio of the star's areas on the input and in T, over that of the whole surface.
std::vector<double> area_distortion(const Uniformized& t);

/// The mean dilatation, largest over smallest stretch, of the flat triangles round the vertex on their
/// way to the chord triangles of T; NaN where Ptolemy flips touched all of them. See surface_picture.
std::vector<double> angle_distortion(const Uniformized& t);

/// Largest over smallest stretch of the linear map between two triangles that are given by the
/// lengths of their sides in order, >= 1; NaN when one of them has no area.
double dilatation(const std::array<double, 3>& from, const std::array<double, 3>& to);

}  // namespace ucvt
