// Moments of a density over a convex geodesic polygon: the cells of the bare spaces.
//
// Uniform density has a closed form (Lambert's vector area, in offsets); any other density is
// integrated by adaptive cubature with an error bound. docs/polygon-moments.md derives both.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "space/moments.h"

namespace ucvt {

/// Moments of density 1 over a polygon.
///
/// Takes the corners in a frame (a site's), counterclockwise; returns the moments in that frame.
/// The polygon is convex, on the sphere within a hemisphere; it may lie anywhere in the frame, the
/// sphere's far side included. Fewer than three corners enclose nothing: all moments are zero.
/// Accuracy: 4e-15 of (m, m r, m r, m r^2/2), r the reach of the corners, when the origin lies
/// inside and r is at most about 1 (PolygonMoments.AgreeWithReferenceValues); on the hyperbolic
/// plane the corners' own rounding, about 1e-16 exp(2 r), takes over beyond.
Moments uniform_moments(Space s, std::span<const Offset> corners);

/// `centroid`, on the sphere's far side too. Requires that (x, y, m - kappa h) is not zero.
Offset centroid_anywhere(Space s, const Moments& m);

/// A density as a function of the point in the polygon's frame; finite and not negative.
using OffsetDensity = std::function<double(const Offset&)>;

struct Cubature {
  Moments moments;
  /// Bound on the error of m, x, y, h, relative to m, m r, m r and m r^2/2, r the corners' reach.
  double error = 0;
  std::int64_t evaluations = 0;  ///< of the density
  bool converged = true;         ///< false: the budget of evaluations ran out before the tolerance
};

struct CubatureOptions {
  double relative_tolerance = 1e-10;         ///< of `error`; below 1e-14 it is taken as 1e-14
  std::int64_t max_evaluations = 1'000'000;  ///< of the density; the first pass is always made
};

/// Moments of a density over a polygon as above, until the error bound is below the tolerance.
///
/// Deterministic: the same input gives the same bits. Pieces of the sphere and of the hyperbolic
/// plane are first cut to sides of 1/2; a feature of the density that is narrower than a tenth of
/// such a piece (of the polygon, in the plane) and far from every node can stay unseen. What the
/// density throws passes through. The bound is held by PolygonCubature.ErrorBoundIsHonest.
Cubature density_moments(Space s, std::span<const Offset> corners, const OffsetDensity& density,
                         const CubatureOptions& options = {});

}  // namespace ucvt
