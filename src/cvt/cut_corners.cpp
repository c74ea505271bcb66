#include "cvt/cut_corners.h"

#include <algorithm>

#include "space/quadrature.h"

// Lanes are returned by functions that are always inlined: no call depends on how.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace ucvt {
namespace {

/// The kinds of batches: rule and series that integrate pieces of faces with squared sides below the
/// bound to 1e-11, as in space/moments.cpp.
struct Kind {
  double side2;
  int degree;
};
constexpr std::array<Kind, 3> kinds{{{7.5e-5, 5}, {short_series_side2, 6}, {9.5e-3, 8}}};

[[gnu::always_inline]] inline Lanes model_z(double kappa, const LaneOffset& p) {
  return 1 - kappa * p.h;
}

[[gnu::always_inline]] inline Lanes beyond(double kappa, const LaneOffset& p,
                                           const LaneOffset& neighbour) {
  return neighbour.x * p.x + neighbour.y * p.y - neighbour.h * model_z(kappa, p);
}

[[gnu::always_inline]] inline LaneOffset between(const LaneOffset& p, const LaneOffset& q,
                                                 const Lanes& s) {
  return {p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.h + s * (q.h - p.h)};
}

[[gnu::always_inline]] inline LaneOffset transvect(double kappa, const LaneOffset& a,
                                                   const LaneOffset& p) {
  const Lanes dot = a.x * p.x + a.y * p.y;
  const Lanes f = 1 - kappa * (p.h + dot / (2 - kappa * a.h));
  return {p.x + a.x * f, p.y + a.y * f, a.h + p.h - kappa * a.h * p.h + dot};
}

[[gnu::always_inline]] inline LaneOffset turned(const Lanes& cosine, const Lanes& sine,
                                                const LaneOffset& p) {
  return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y, p.h};
}

/// 1 where the points can be the ends of an edge, as `joins` has it but for rounding; else 0.
[[gnu::always_inline]] inline Lanes are_joined(double kappa, const LaneOffset& p,
                                               const LaneOffset& q, const Lanes& edge2) {
  const Lanes one = Lanes{} + 1, zero{};
  if (kappa > 0) {
    return one;
  }
  const Lanes x = q.x - p.x, y = q.y - p.y, h = q.h - p.h;
  const Lanes gap = x * x + y * y + kappa * h * h - edge2, most = same_chord2 * edge2;
  return (gap < most ? one : zero) * (gap > -most ? one : zero);
}

[[gnu::always_inline]] inline CutShares::Lane moments_of(const Lanes& mass, const Lanes& excess,
                                                         const std::array<Lanes, 3>& mu,
                                                         const LaneOffset& a, const LaneOffset& b,
                                                         const LaneOffset& c) {
  return {mass, mu[0] * a.x + mu[1] * b.x + mu[2] * c.x, mu[0] * a.y + mu[1] * b.y + mu[2] * c.y,
          excess + mu[0] * a.h + mu[1] * b.h + mu[2] * c.h};
}

template <int terms>
[[gnu::always_inline]] inline void cut_faces(const CutFaces& f, double kappa,
                                             const std::vector<QuadratureNode>& rule,
                                             CutShares& out) {
  const LaneOffset next = transvect(kappa, f.to_rest, turned(f.cosine, f.sine, f.next));
  const LaneOffset last = transvect(kappa, f.to_rest, turned(f.cosine, f.sine, f.last));
  const Lanes at_corner = beyond(kappa, f.corner, f.to_rest);
  const Lanes at_next = beyond(kappa, next, f.to_rest), at_last = beyond(kappa, last, f.to_rest);
  const Lanes p = at_corner / (at_corner - at_next), q = at_corner / (at_corner - at_last);
  // The cell's side towards `rest` ends at those towards the neighbours before and after it.
  const LaneOffset on_p = between(f.corner, next, p), on_q = between(f.corner, last, q);
  const Lanes one = Lanes{} + 1, zero{};
  const auto unless_beyond = [&](const LaneOffset& x, const LaneOffset& neighbour) {
    return beyond(kappa, x, neighbour) > 0 ? zero : one;
  };
  out.is_valid = (at_corner < 0 ? one : zero) * (at_next > 0 ? one : zero) *
                 (at_last > 0 ? one : zero) * unless_beyond(on_p, f.before) *
                 unless_beyond(on_q, f.before) * unless_beyond(on_p, f.after) *
                 unless_beyond(on_q, f.after) * are_joined(kappa, f.corner, next, f.chord2[0]) *
                 are_joined(kappa, f.next, f.last, f.chord2[1]) *
                 are_joined(kappa, last, f.corner, f.chord2[2]);
  const Lanes jacobian = f.det / 2 * (p * q);
  LaneWeights w;
  for (const QuadratureNode& node : rule) {
    const Lanes l1 = node.b1 * p, l2 = node.b2 * q;
    add_nodes<terms>(kappa, f.chord2, f.density, {1 - l1 - l2, l1, l2}, node.weight * jacobian, w);
  }
  out.alone = moments_of(w.mass, w.excess, {w.mu0, w.mu1, w.mu2}, f.corner, next, last);
  const LaneOffset back{-f.to_rest.x, -f.to_rest.y, f.to_rest.h};
  const LaneOffset corner = turned(f.cosine, -f.sine, transvect(kappa, back, f.corner));
  out.rest =
      moments_of(f.mass - w.mass, f.excess - w.excess,
                 {f.mu[0] - w.mu0, f.mu[1] - w.mu1, f.mu[2] - w.mu2}, corner, f.next, f.last);
}

UCVT_WIDE void cut_small(const CutFaces& f, double kappa, const std::vector<QuadratureNode>& rule,
                         CutShares& out) {
  cut_faces<short_series>(f, kappa, rule, out);
}

UCVT_WIDE void cut_bigger(const CutFaces& f, double kappa, const std::vector<QuadratureNode>& rule,
                          CutShares& out) {
  cut_faces<long_series>(f, kappa, rule, out);
}

void set(LaneOffset& lanes, std::size_t k, const Offset& p) {
  lanes.x[k] = p.x, lanes.y[k] = p.y, lanes.h[k] = p.h;
}

Moments lane(const CutShares::Lane& lanes, std::size_t k) {
  return {lanes.m[k], lanes.x[k], lanes.y[k], lanes.h[k]};
}

}  // namespace

void CutCorners::take(Face f, const std::array<std::size_t, 3>& vertices, CellShares& out,
                      std::vector<Face>& others) {
  const std::array<Vertex, 3> owner{lifts_.owner[vertices[0]], lifts_.owner[vertices[1]],
                                    lifts_.owner[vertices[2]]};
  const std::size_t i = owner[1] == owner[2] ? 0 : owner[2] == owner[0] ? 1 : 2;
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  const auto sites = stars_.sites(owner[i]);
  const auto found = std::find(sites.begin(), sites.end(), owner[j]);
  const FacePieces& pieces = mass_.pieces(f);
  const auto& chord2 = pieces.triangle.chord2;
  const double side2 = std::max({chord2[0], chord2[1], chord2[2]});
  std::size_t kind = 0;
  while (kind < kinds.size() && !(side2 < kinds[kind].side2)) {
    ++kind;
  }
  if (owner[j] != owner[k] || owner[i] == owner[j] || found == sites.end() ||
      kind == kinds.size()) {
    others.push_back(f);
    return;
  }
  Batch& batch = batches_[kind];
  CutFaces& to = batch.faces;
  const std::size_t n = batch.size++, across = static_cast<std::size_t>(found - sites.begin());
  const auto offsets = stars_.offsets(owner[i]);
  const Isometry& frame = stars_.frames(owner[i])[across];
  to.face[n] = f, to.alone[n] = owner[i], to.rest[n] = owner[j];
  set(to.corner, n, lifts_.at[vertices[i]]);
  set(to.next, n, lifts_.at[vertices[j]]);
  set(to.last, n, lifts_.at[vertices[k]]);
  set(to.to_rest, n, offsets[across]);
  to.cosine[n] = frame.rotation.cosine, to.sine[n] = frame.rotation.sine;
  set(to.before, n, offsets[across == 0 ? sites.size() - 1 : across - 1]);
  set(to.after, n, offsets[across + 1 == sites.size() ? 0 : across + 1]);
  const Weights& weights = mass_.weights(f);
  const std::array<std::size_t, 3> from{i, j, k};
  for (std::size_t c = 0; c < 3; ++c) {
    to.chord2[c][n] = chord2[from[c]];
    to.density[c][n] = pieces.density[from[c]];
    to.mu[c][n] = weights.mu[from[c]];
  }
  to.det[n] = pieces.triangle.det, to.mass[n] = weights.mass, to.excess[n] = weights.excess;
  if (batch.size == 4) {
    add(kind, out, others);
  }
}

void CutCorners::finish(CellShares& out, std::vector<Face>& others) {
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    add(kind, out, others);
  }
}

void CutCorners::add(std::size_t kind, CellShares& out, std::vector<Face>& others) {
  Batch& batch = batches_[kind];
  const CutFaces& f = batch.faces;
  const auto& rule = triangle_rule(kinds[kind].degree);
  CutShares shares;
  if (kinds[kind].side2 <= short_series_side2) {
    cut_small(f, t_.space().kappa, rule, shares);
  } else {
    cut_bigger(f, t_.space().kappa, rule, shares);
  }
  for (std::size_t n = 0; n < batch.size; ++n) {
    if (shares.is_valid[n] > 0) {
      out.of(f.alone[n]) += lane(shares.alone, n);
      out.of(f.rest[n]) += lane(shares.rest, n);
    } else {
      others.push_back(f.face[n]);
    }
  }
  batch.size = 0;
}

}  // namespace ucvt
