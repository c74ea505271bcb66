// Moving sites to a centroidal Voronoi tessellation: Lloyd's method and L-BFGS.
//
// Both see sites and cells through the moments of the cells in their sites' tangent frames. Frames
// are carried parallel by the moves, so vectors in them need no transport: gradients of different
// iterations are subtracted coordinate by coordinate (docs/optimisation.md).
#pragma once

#include <vector>

#include "cvt/stiffness.h"
#include "space/moments.h"
#include "ucvt/remesh.h"

namespace ucvt {

/// A cell as an optimiser sees it.
struct CellState {
  Moments moments;     ///< in the site's frame
  double spacing = 0;  ///< a length that the site's moves are compared with
};

/// Sites that can be moved and whose cells can be measured.
class SiteSystem {
 public:
  SiteSystem() = default;
  SiteSystem(const SiteSystem&) = default;
  SiteSystem& operator=(const SiteSystem&) = default;
  virtual ~SiteSystem() = default;

  [[nodiscard]] virtual Space space() const = 0;
  [[nodiscard]] virtual std::size_t site_count() const = 0;
  /// Overwrites `out`, one entry a site.
  virtual void measure(std::vector<CellState>& out) const = 0;
  /// Moves site i to target[i] in its own frame, all of them. A site may stop short on the way.
  virtual void move(const std::vector<Offset>& target) = 0;
  /// One for every edge of the sites' Delaunay triangulation; none where they are not known.
  [[nodiscard]] virtual std::vector<Spring> springs() const { return {}; }
  /// Remembers the sites where they are, and goes back there.
  virtual void save() = 0;
  virtual void restore() = 0;
};

/// The centroid in the frame of the moments, on the sphere maybe on the far side; the origin where there
/// is no mass, or where it pulls evenly to all sides. Stays off the hyperbolic plane's rim, where
/// rounding could put it.
Offset centroid_or_site(Space s, const Moments& m);

struct OptimizeOptions {
  Method method = Method::Lbfgs;
  int evaluations = 1000;   ///< of all cells, at most, after that of the sites as they are
  double tolerance = 1e-4;  ///< of the largest move to a centroid, relative to the spacing
  double least_decrease =
      0;                ///< part of the energy; the end as well when 10 steps lower it by less
  bool springs = true;  ///< of L-BFGS: that they are used; they are not worth it where the density
                        ///< changes by powers from one end of a cell to the other
};

/// The limits that a user's options set.
OptimizeOptions until_converged(const RemeshOptions& options);

struct OptimizeResult {
  bool converged = false;
  bool cancelled = false;
  int evaluations = 0;
  std::vector<double> energy;  ///< sum over cells of int rho chord^2, at the start of each step
  std::vector<double>
      max_move;  ///< largest distance from a centroid relative to the spacing, likewise
};

/// Moves the sites until the largest move to a centroid is below the tolerance. The energy never
/// rises. A cancelled run stops after a whole step.
///
/// Lloyd's method moves every site to its cell's centroid. L-BFGS (Nocedal 1980; memory 7) starts
/// from the inverse of the sites' stiffness, made anew now and then; where springs are not known from
/// 1/(2 (m - kappa Mh)), cell by cell, which is Lloyd's step. It backs off by Armijo's rule, drops
/// pairs of negative curvature, and falls back to Lloyd's step, which never raises the energy, when a
/// direction fails. Where the sites can follow no step at all (NumericalError) they stay where they
/// are and that is the end, not converged; at the first step the error passes through.
OptimizeResult optimize(SiteSystem& sites, const OptimizeOptions& options, const Monitor& monitor);

}  // namespace ucvt
