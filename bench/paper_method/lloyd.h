// Lloyd's method in the universal cover as the paper describes it (its sections 5.2 and 6.2): the
// baseline of the benchmark, and an oracle for tests. Sites and copies, their Voronoi diagram, centroids
// by sums over a grid, sites that leave the domain brought back. One thread.
//
// The sum over a uniform grid on the plane z = 0 is kept as the paper has it. It is inexact beyond the
// grid's coarseness: it converges to the centroid of z rho, for each sample needs the factor 1/z
// (docs/paper.md). The paper does not say how fine its grid is, nor how it finds the triangle under a
// sample: here the grid spans each cell in a given number of steps, and triangles are walked to
// from one sample to the next.
#pragma once

#include <vector>

#include "conformal/uniformize.h"
#include "paper_method/diagram.h"

namespace ucvt::paper {

/// In processor seconds.
struct Timing {
  int iterations = 0;
  double diagrams = 0;  ///< copies included
  double centroids = 0;
};

class Lloyd {
 public:
  /// Keeps a reference to t. `grid` is the number of samples across a cell's circumscribed circle.
  Lloyd(const Uniformized& t, const std::vector<SurfacePoint>& sites, int grid = 40);

  /// Moves every site to its centroid, `iterations` times. A site whose cell is open, or in the
  /// diagram is none, stays.
  void run(int iterations);

  [[nodiscard]] Diagram current_diagram() const { return diagram(domain_, sites_); }
  [[nodiscard]] std::vector<SurfacePoint> sites() const;
  [[nodiscard]] const FundamentalDomain& domain() const { return domain_; }
  [[nodiscard]] const Timing& timing() const { return timing_; }

 private:
  [[nodiscard]] Offset centroid_of(const PlacedSite& site, const Diagram& d,
                                   const std::vector<std::int32_t>& neighbours) const;

  const UniformSurface& t_;
  std::vector<double> conformal_factor_;
  FundamentalDomain domain_;
  std::vector<PlacedSite> sites_;
  int grid_;
  Timing timing_;
};

}  // namespace ucvt::paper
