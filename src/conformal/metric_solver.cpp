#include "conformal/metric_solver.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "conformal/face_angles.h"
#include "conformal/sparse_solver.h"

namespace ucvt {
namespace {

/// Ptolemy flips happen only past this sum of doubled cosines, relative to its terms.
constexpr double delaunay_tolerance = 1e-12;

/// Flips per edge in one go past which a metric is out of the range of doubles.
constexpr std::int64_t max_flips_per_edge = 100;

/// Bounds of how far Newton's systems are solved.
constexpr double loosest_reduction = 0.001, tightest_reduction = 1e-6;

/// How far below the tolerance a closed surface is solved where rounding allows.
constexpr double margin = 40;

/// Items of one task.
constexpr std::size_t grain = 4096;

constexpr int max_halvings = 40, halvings_before_pins = 6;

/// A link vertex this much farther from the puncture than the pin, in log scale, has left the link.
constexpr double pin_tolerance = 1e-9;

/// In parallel: items must not depend on each other.
template <class Body>
void for_range(std::size_t n, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        body(i);
                      }
                    });
}

}  // namespace

MetricSolver::MetricSolver(Space space, IntrinsicTriangulation& t, std::vector<double>& u,
                           std::vector<VertexRole> role)
    : space_(space), t_(t), u_(u), role_(std::move(role)), half_(t.log_length.size()) {
  has_puncture_ = std::ranges::find(role_, VertexRole::Puncture) != role_.end();
  // Unknowns in the order of the faces, which lie along a space-filling curve.
  constexpr auto none = static_cast<std::size_t>(-1);
  number_.assign(u.size(), none);
  std::size_t count = 0;
  for (std::size_t i = 0; i < half_.size(); ++i) {
    std::size_t& number = number_[t.connectivity.origin({static_cast<std::int32_t>(i)}).index()];
    number = number == none ? count++ : number;
  }
}

bool MetricSolver::has_geometry(Face f) const {
  return std::ranges::none_of(halfedges(f), [&](Halfedge h) {
    return role_[t_.connectivity.origin(h).index()] == VertexRole::Puncture;
  });
}

double MetricSolver::half_chord(Halfedge h) const {
  const double ui = u_[t_.connectivity.origin(h).index()];
  const double uj = u_[t_.connectivity.head(h).index()];
  return std::exp(t_.log_length[h.index()] + (ui + uj) / 2) / 2;
}

bool MetricSolver::beyond_pin(Halfedge from_puncture) const {
  const Vertex v = t_.connectivity.head(from_puncture);
  return 2 * t_.log_length[from_puncture.index()] + u_[v.index()] > pin_ + pin_tolerance;
}

bool MetricSolver::should_flip(Halfedge h) const {
  const Halfedge twin = t_.connectivity.twin(h);
  if (twin.face() == h.face()) {
    return false;
  }
  for (const Halfedge g : {h, twin}) {
    // The puncture sees only the nearest vertices, those at the distance of the pin.
    if (role_[t_.connectivity.origin(g).index()] == VertexRole::Puncture) {
      return beyond_pin(g) && t_.connectivity.degree(t_.connectivity.origin(g)) > 3;
    }
  }
  // Twice the cosine of the angle opposite to the edge, in chords: the Delaunay condition of all
  // three geometries is that the two sum to no less than 0. At an infinitely far puncture it is 2.
  double sum = 0, scale = 0;
  for (const Halfedge g : {h, twin}) {
    if (!has_geometry(g.face())) {
      // Wait until the ends of an edge of the link have left it if they must.
      if (beyond_pin(g.prev()) || beyond_pin(t_.connectivity.twin(g.next()))) {
        return false;
      }
      sum += 2;
      continue;
    }
    const double a = half_[g.next().index()], b = half_[g.prev().index()], c = half_[g.index()];
    const double positive = a / b + b / a, negative = (c / a) * (c / b);
    sum += positive - negative;
    scale += positive + negative;
  }
  return sum < -delaunay_tolerance * scale;
}

bool MetricSolver::flip_to_delaunay() {
  const Connectivity& c = t_.connectivity;
  for_range(half_.size(), [&](std::size_t i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (c.is_canonical(h)) {
      half_[i] = half_[c.twin(h).index()] = half_chord(h);
    }
  });
  // Edges that should not flip now are looked at again when one next to them does.
  to_flip_.assign(half_.size(), 0);
  for_range(half_.size(), [&](std::size_t i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    to_flip_[i] = c.is_canonical(h) && should_flip(h) ? 1 : 0;
  });
  const std::int64_t limit =
      t_.ptolemy_flips + max_flips_per_edge * static_cast<std::int64_t>(half_.size());
  for (std::size_t i = 0; i < half_.size(); ++i) {
    if (to_flip_[i] != 0 && !flip_from({{static_cast<std::int32_t>(i)}}, limit)) {
      return false;
    }
  }
  // What an abandoned step left in the puncture's link is pinned there, unless it went by itself.
  std::vector<Halfedge> left;
  for (std::size_t v = 0; v < role_.size(); ++v) {
    if (role_[v] != VertexRole::Puncture) {
      continue;
    }
    c.for_outgoing({static_cast<std::int32_t>(v)}, [&](Halfedge h) {
      if (role_[c.head(h).index()] == VertexRole::Solved) {
        pin(h, left);
      }
    });
  }
  return flip_from(std::move(left), limit);
}

bool MetricSolver::flip_from(std::vector<Halfedge> stack, std::int64_t limit) {
  const Connectivity& c = t_.connectivity;
  while (!stack.empty()) {
    const Halfedge h = stack.back();
    stack.pop_back();
    if (!should_flip(h)) {
      continue;
    }
    if (t_.ptolemy_flips >= limit) {
      return false;
    }
    const Halfedge twin = c.twin(h);
    const double jk = half_[h.next().index()], ki = half_[h.prev().index()];
    const double im = half_[twin.next().index()], mj = half_[twin.prev().index()];
    ptolemy_flip(t_, h);
    half_[h.next().index()] = ki, half_[h.prev().index()] = im;
    half_[twin.next().index()] = mj, half_[twin.prev().index()] = jk;
    half_[h.index()] = half_[twin.index()] = half_chord(h);
    stack.insert(stack.end(), {h.next(), h.prev(), twin.next(), twin.prev()});
    for (const Halfedge out : {h, twin}) {
      if (role_[c.origin(out).index()] == VertexRole::Puncture) {
        pin(out, stack);
      }
    }
  }
  return true;
}

void MetricSolver::pin(Halfedge from_puncture, std::vector<Halfedge>& changed) {
  const Vertex v = t_.connectivity.head(from_puncture);
  if (role_[v.index()] == VertexRole::Puncture) {
    link_is_simple_ = false;
    return;
  }
  if (role_[v.index()] == VertexRole::Solved) {
    role_[v.index()] = VertexRole::Held;
    pinned_.push_back(v);
  }
  u_[v.index()] = std::max(u_[v.index()], pin_ - 2 * t_.log_length[from_puncture.index()]);
  t_.connectivity.for_outgoing(v, [&](Halfedge h) {
    half_[h.index()] = half_[t_.connectivity.twin(h).index()] = half_chord(h);
    changed.push_back(h);
    changed.push_back(h.next());
  });
}

void MetricSolver::unpin() {
  for (const Vertex v : pinned_) {
    role_[v.index()] = VertexRole::Solved;
  }
  link_is_simple_ = true;
}

bool MetricSolver::measure_angles(std::size_t first) {
  const std::size_t last = std::min(first + 4, t_.connectivity.face_count());
  FourFaces half, angle, cot;
  half.fill(0.5);  // a triangle in all three geometries
  for (std::size_t f = first; f < last; ++f) {
    if (has_geometry({static_cast<std::int32_t>(f)})) {
      std::copy_n(half_.begin() + static_cast<std::ptrdiff_t>(3 * f), 3,
                  half.begin() + static_cast<std::ptrdiff_t>(3 * (f - first)));
    }
  }
  const bool valid = face_angles(space_, half, angle, cot);
  for (std::size_t f = first; f < last; ++f) {
    const bool has = has_geometry({static_cast<std::int32_t>(f)});
    for (std::size_t i = 0; i < 3; ++i) {
      // The angle opposite to a side is at the origin of the side before it.
      angle_[3 * f + (i + 2) % 3] = has ? angle[3 * (f - first) + i] : 0;
      cot_[3 * f + i] = has ? cot[3 * (f - first) + i] : 0;
    }
  }
  return valid;
}

bool MetricSolver::evaluate() {
  if (!std::ranges::all_of(u_, [](double x) { return std::isfinite(x); })) {
    return false;
  }
  pinned_.clear();
  if (!flip_to_delaunay() || !link_is_simple_) {
    return false;
  }
  angle_.resize(half_.size());
  cot_.resize(half_.size());
  std::atomic<bool> collapsed{false};
  for_range((t_.connectivity.face_count() + 3) / 4, [&](std::size_t k) {
    if (!measure_angles(4 * k)) {
      collapsed = true;
    }
  });
  angle_sum_.assign(u_.size(), 0);
  for (std::size_t i = 0; i < half_.size(); ++i) {
    angle_sum_[t_.connectivity.origin({static_cast<std::int32_t>(i)}).index()] += angle_[i];
  }
  if (collapsed) {
    return false;
  }
  gradient_.assign(u_.size(), 0);
  for (std::size_t v = 0; v < u_.size(); ++v) {
    if (role_[v] == VertexRole::Solved) {
      gradient_[v] = 2 * std::numbers::pi - angle_sum_[v];
    }
  }
  return true;
}

const std::vector<double>& MetricSolver::angle_sums() {
  evaluate();
  return angle_sum_;
}

SymmetricMatrix MetricSolver::hessian() const {
  // All vertices are unknowns, those not solved for without a tie to others: the system keeps its
  // size and order when vertices are held or let go.
  const Connectivity& c = t_.connectivity;
  const auto is_solved = [&](Vertex v) { return role_[v.index()] == VertexRole::Solved; };
  const auto for_ties = [&](auto visit) {
    for (std::size_t i = 0; i < half_.size(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)};
      if (is_solved(c.origin(h))) {
        visit(h, number_[c.origin(h).index()], c.origin(h), c.head(h));
      }
    }
  };
  SymmetricMatrix out;
  out.begin.assign(u_.size() + 1, 0);
  out.diagonal.assign(u_.size(), 0);
  for_ties([&](Halfedge, std::size_t row, Vertex v, Vertex w) {
    out.begin[row + 1] += v != w && is_solved(w) ? 1 : 0;
  });
  std::partial_sum(out.begin.begin(), out.begin.end(), out.begin.begin());
  out.column.resize(static_cast<std::size_t>(out.begin.back()));
  out.value.resize(out.column.size());
  std::vector<std::int32_t> next(out.begin.begin(), out.begin.end() - 1);
  for_ties([&](Halfedge h, std::size_t row, Vertex v, Vertex w) {
    const double half_cot = (cot_[h.index()] + cot_[c.twin(h).index()]) / 2;
    const double c2 = half_[h.index()] * half_[h.index()];
    const double t2 = -space_.kappa * c2 / (1 - space_.kappa * c2);
    // A loop's two ends are one unknown: what would be off the diagonal falls on it.
    out.diagonal[row] += half_cot * (1 + t2 + (v == w ? t2 - 1 : 0));
    if (v != w && is_solved(w)) {
      const auto k = static_cast<std::size_t>(next[row]++);
      out.column[k] = static_cast<std::int32_t>(number_[w.index()]);
      out.value[k] = half_cot * (t2 - 1);
    }
  });
  for (std::size_t v = 0; v < u_.size(); ++v) {
    if (role_[v] != VertexRole::Solved) {
      out.diagonal[number_[v]] = 1;
    }
  }
  return out;
}

bool MetricSolver::newton_direction(double reduction, std::vector<double>& direction) {
  std::vector<double> right(u_.size()), solution;
  for (std::size_t v = 0; v < u_.size(); ++v) {
    right[number_[v]] = -gradient_[v];
  }
  // Only on the sphere is the energy not convex.
  const bool solved = space_.kappa <= 0
                          ? linear_.solve_positive_definite(hessian(), right, reduction, solution)
                          : linear_.solve(hessian(), right, reduction, solution);
  direction.assign(u_.size(), 0);
  for (std::size_t v = 0; v < u_.size() && solved; ++v) {
    // The factors of a matrix with other vertices held leave a trace of them.
    direction[v] = role_[v] == VertexRole::Solved ? solution[number_[v]] : 0;
  }
  return solved;
}

double MetricSolver::slope(const std::vector<double>& direction) const {
  double sum = 0;
  for (std::size_t v = 0; v < direction.size(); ++v) {
    sum += direction[v] * gradient_[v];
  }
  return sum;
}

double MetricSolver::gradient_max() const {
  double worst = 0;
  for (std::size_t v = 0; v < role_.size(); ++v) {
    // Vertices that are held only to fix an isometry end with the angle sum of the others.
    const bool counts = !has_puncture_ || role_[v] == VertexRole::Solved;
    worst = counts ? std::max(worst, std::abs(2 * std::numbers::pi - angle_sum_[v])) : worst;
  }
  return worst;
}

double MetricSolver::gradient_norm2() const {
  double sum = 0;
  for (const double g : gradient_) {
    sum += g * g;
  }
  return sum;
}

MetricSolver::Result MetricSolver::solve(double tolerance, int limit, const Watch& watch) {
  Result out;
  if (!evaluate()) {
    return out;
  }
  out.max_angle_error = gradient_max();
  std::vector<double> direction;
  const double target = has_puncture_ ? tolerance : tolerance / margin;
  while (out.max_angle_error > target && out.iterations < limit) {
    // Newton leaves about the square of the error, in radians.
    const double reduction =
        std::clamp(std::max(out.max_angle_error, target / out.max_angle_error / 1000),
                   tightest_reduction, loosest_reduction);
    if (!newton_direction(reduction, direction)) {
      break;
    }
    const std::vector<double> start = u_;
    const double slope0 = std::abs(slope(direction)), norm0 = gradient_norm2();
    const double error0 = out.max_angle_error;
    bool accepted = false;
    for (int halving = 0; halving < max_halvings && !accepted; ++halving) {
      const double step = std::ldexp(1.0, -halving);
      for (std::size_t v = 0; v < u_.size(); ++v) {
        u_[v] = start[v] + step * direction[v];
      }
      const bool in_range = evaluate();
      // A vertex that comes to the puncture's link changes the problem. A long step brings it there
      // by mistake as well, so that is believed of short ones only.
      const bool believed = pinned_.empty() || halving >= halvings_before_pins;
      if (in_range && believed) {
        const double s = slope(direction);
        accepted = !pinned_.empty() || (s <= slope0 / 2 && (s <= 0 || gradient_norm2() < norm0));
      }
      if (!accepted) {
        unpin();
      }
    }
    if (!accepted || (pinned_.empty() && error0 < tolerance && gradient_max() >= error0)) {
      // Rounding has the last word: keep the better of the two.
      u_ = start;
      evaluate();
      out.max_angle_error = gradient_max();
      break;
    }
    out.max_angle_error = gradient_max();
    ++out.iterations;
    if (watch && !watch(out.iterations, out.max_angle_error)) {
      break;
    }
  }
  out.converged = out.max_angle_error <= tolerance;
  return out;
}

}  // namespace ucvt
