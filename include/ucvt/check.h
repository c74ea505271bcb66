// Self-check: a finished run judged once more, by other ways than those that led to it.
#pragma once

#include "ucvt/remesh.h"

namespace ucvt {

/// What `measure_errors` finds; all of it is rounding in a sound result.
struct SelfCheck {
  double surface_angle_rad = 0;  ///< T: largest difference of an angle sum from 2 pi
  double site_angle_rad = 0;     ///< D: largest difference of the angles round a site from 2 pi
  double area = 0;               ///< of D's faces against T's, relative
  double mass = 0;               ///< of the cells against that of T's faces, relative
  double circle = 0;             ///< largest relative depth of a site inside a circle of D
  double place =
      0;  ///< largest distance of a site from where D's offsets lead on T, over the offset
  double mirror = 0;  ///< of an open surface: a cell's area against its mirror image's, relative
};

/// Measures a result of `remesh`.
SelfCheck measure_errors(const RemeshResult& result);

/// Throws NumericalError, naming the property, its value and its bound, when a result of `remesh` is
/// not what it must be: a dual mesh of the input's Euler number and boundary loops, oriented; angle sums of
/// 2 pi on T (1e-9) and round the sites (1e-6); D's area (1e-6) and the cells' mass (1e-6) those of
/// the surface; D Delaunay (1e-6) and where the sites are (1e-5); of an open surface, cells and their
/// mirror images alike (1e-6). What the numbers are in sound runs
/// is in docs/robustness.md; requires a result with its cells.
void check(const RemeshResult& result);

}  // namespace ucvt
