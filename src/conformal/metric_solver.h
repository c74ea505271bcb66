// Newton's method for the discrete uniformization energy, with Ptolemy flips on the way.
//
// Unknowns are log scale factors u at the vertices: chords are l_ij exp((u_i + u_j)/2) with fixed
// Penner coordinates l. The energy whose gradient is 2 pi - (angle sum) is convex and twice
// continuously differentiable once every metric is looked at in its Delaunay triangulation
// (Bobenko, Pinkall, Springborn 2015; Gu, Guo, Luo, Sun, Wu 2018; Springborn 2019).
// docs/uniformization.md has the formulas. Flat and hyperbolic metrics share one code path.
#pragma once

#include <functional>
#include <vector>

#include "conformal/intrinsic_triangulation.h"
#include "conformal/sparse_solver.h"
#include "space/offset.h"

namespace ucvt {

/// What a face or vertex means to the solver: a vertex can be solved for, held, or be the puncture,
/// whose star has no geometry.
enum class VertexRole : char { Solved, Held, Puncture };

class MetricSolver {
 public:
  /// Solves on `t` (Delaunay already), starting from `u`; both are changed in place. On the sphere the
  /// energy is not convex: u must be close to a solution, and three vertices be held.
  MetricSolver(Space space, IntrinsicTriangulation& t, std::vector<double>& u,
               std::vector<VertexRole> role);

  struct Result {
    int iterations = 0;
    double max_angle_error = 0;  ///< radians; without a puncture held vertices count too
    bool converged = false;
  };

  /// Called after each step with the iteration and the angle error; returning false stops.
  using Watch = std::function<bool(int, double)>;

  /// Whether log scales that are known roughly are all that is needed.
  using Enough = std::function<bool(const std::vector<double>&)>;

  /// Newton steps until the angle error is below `tolerance`, well below on a closed surface unless it
  /// falls no longer, or `limit` steps.
  Result solve(double tolerance, int limit, const Watch& watch);

  /// Flips every edge that is not Delaunay at the present u; edges at the puncture stay, edges
  /// opposite to it flip when the face behind them would break the triangle inequality. False when
  /// flips do not end: the metric is out of the range of doubles.
  bool flip_to_delaunay();

  /// Angle sums at the present u over the faces that have geometry, in radians.
  [[nodiscard]] const std::vector<double>& angle_sums();

  /// The punctured plane's form of the problem: log scales at the puncture's link are held at
  /// `pin` - 2 log l, l the length from the puncture. A vertex that flips bring into the link is
  /// pinned there and then.
  void set_pin(double pin) { pin_ = pin; }
  void set_role(Vertex v, VertexRole role) { role_[v.index()] = role; }
  /// False once some vertex has two edges to the puncture: the caller must try another puncture.
  [[nodiscard]] bool link_is_simple() const { return link_is_simple_; }

 private:
  [[nodiscard]] bool has_geometry(Face f) const;
  [[nodiscard]] double half_chord(Halfedge h) const;
  [[nodiscard]] bool beyond_pin(Halfedge from_puncture) const;
  [[nodiscard]] bool should_flip(Halfedge h) const;
  bool flip_from(std::vector<Halfedge> stack, std::int64_t limit);
  void unpin();
  void pin(Halfedge from_puncture, std::vector<Halfedge>& changed);
  /// Angles of four faces, from the first one's number on; false when one of them has collapsed.
  bool measure_angles(std::size_t first);
  /// Refreshes chords, flips, angles and the gradient at the present u; false when out of range.
  bool evaluate();
  [[nodiscard]] SymmetricMatrix hessian() const;
  bool newton_direction(double reduction, std::vector<double>& direction);
  [[nodiscard]] double slope(const std::vector<double>& direction) const;
  [[nodiscard]] double gradient_max() const;
  [[nodiscard]] double gradient_norm2() const;

  Space space_;
  IntrinsicTriangulation& t_;
  std::vector<double>& u_;
  std::vector<VertexRole> role_;
  std::vector<std::size_t> number_;  ///< of each vertex among the unknowns
  std::vector<double> half_;         ///< half chords by halfedge, at the present u
  std::vector<double> cot_;    ///< of beta, by the halfedge it is opposite to; 0 without geometry
  std::vector<double> angle_;  ///< at the origin, by halfedge; 0 without geometry
  std::vector<char> to_flip_;  ///< by halfedge, when it was last looked at
  std::vector<double> gradient_;  ///< 2 pi - angle sum of solved vertices, 0 elsewhere
  std::vector<double> angle_sum_;
  double pin_ = 0;
  std::vector<Vertex> pinned_;  ///< by the last evaluation
  bool link_is_simple_ = true, has_puncture_ = false;
  SymmetricSolver linear_;
};

}  // namespace ucvt
