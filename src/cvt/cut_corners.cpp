#include "cvt/cut_corners.h"

#include <algorithm>

namespace ucvt {
namespace {

template <int terms>
[[gnu::always_inline]] inline void cut_faces(const CutCorners::Faces& f, double kappa,
                                             const std::vector<QuadratureNode>& rule,
                                             CutCorners::Shares& out) {
  const LaneOffset next = apply(kappa, f.to_rest, f.next), last = apply(kappa, f.to_rest, f.last);
  const LaneOffset& site = f.to_rest.translation;
  const Lanes at_corner = beyond(kappa, f.corner, site);
  const Lanes at_next = beyond(kappa, next, site), at_last = beyond(kappa, last, site);
  const Lanes p = at_corner / (at_corner - at_next), q = at_corner / (at_corner - at_last);
  // The cell's side towards `rest` ends at those towards the neighbours before and after it.
  const LaneOffset on_p = between(f.corner, next, p), on_q = between(f.corner, last, q);
  const Lanes zero{};
  const auto& chord2 = f.whole.chord2;
  out.is_valid = less(at_corner, zero) * less(zero, at_next) * less(zero, at_last) *
                 is_within(kappa, on_p, f.before) * is_within(kappa, on_q, f.before) *
                 is_within(kappa, on_p, f.after) * is_within(kappa, on_q, f.after) *
                 are_joined(kappa, f.corner, next, chord2[0]) *
                 are_joined(kappa, f.next, f.last, chord2[1]) *
                 are_joined(kappa, last, f.corner, chord2[2]);
  LaneWeights w;
  const Lanes jacobian = f.whole.det / 2 * (p * q);
  for (const QuadratureNode& node : rule) {
    const Lanes l1 = node.b1 * p, l2 = node.b2 * q;
    add_nodes<terms>(kappa, chord2, f.whole.density, {1 - l1 - l2, l1, l2}, node.weight * jacobian,
                     w);
  }
  w.mu0 -= f.share.mu, w.excess -= f.share.excess;
  out.alone = moments_of(kappa, w, f.corner, next, last);
  out.rest = apply_inverse(kappa, f.to_rest, out.alone);
}

UCVT_WIDE void cut_small(const CutCorners::Faces& f, double kappa,
                         const std::vector<QuadratureNode>& rule, CutCorners::Shares& out) {
  cut_faces<short_series>(f, kappa, rule, out);
}

UCVT_WIDE void cut_bigger(const CutCorners::Faces& f, double kappa,
                          const std::vector<QuadratureNode>& rule, CutCorners::Shares& out) {
  cut_faces<long_series>(f, kappa, rule, out);
}

}  // namespace

CutCorners::CutCorners(const SurfaceMass& mass, const Stars& stars, const Lifts& lifts)
    : mass_(mass),
      stars_(stars),
      lifts_(lifts),
      batches_(mass.surface().space().kappa, cut_small, cut_bigger) {}

void CutCorners::Shares::add_to(CellShares& cells, const Faces& faces, std::size_t n) const {
  cells.of(faces.alone[n]) += lane(alone, n);
  cells.of(faces.rest[n]) -= lane(rest, n);
}

void CutCorners::take(Face f, const std::array<std::size_t, 3>& vertices, std::size_t alone,
                      CellShares& out, std::vector<Face>& others) {
  const std::array<std::size_t, 3> corner{alone, (alone + 1) % 3, (alone + 2) % 3};
  const Vertex site = lifts_.owner[vertices[corner[0]]], rest = lifts_.owner[vertices[corner[1]]];
  const auto sites = stars_.sites(site);
  const auto found = std::find(sites.begin(), sites.end(), rest);
  const FacePieces& pieces = mass_.pieces(f);
  const std::size_t kind = face_kind(mass_.surface().space(), pieces.triangle);
  if (found == sites.end() || kind == face_kinds.size()) {
    others.push_back(f);
    return;
  }
  Faces& to = batches_.faces(kind);
  const std::size_t n = batches_.next_lane(kind),
                    across = static_cast<std::size_t>(found - sites.begin());
  const auto offsets = stars_.offsets(site);
  to.face[n] = f, to.alone[n] = site, to.rest[n] = rest;
  set_lane(to.whole, n, pieces, corner);
  set_lane(to.share, n, pieces.share(alone));
  set_lane(to.corner, n, lifts_.at[vertices[corner[0]]]);
  set_lane(to.next, n, lifts_.at[vertices[corner[1]]]);
  set_lane(to.last, n, lifts_.at[vertices[corner[2]]]);
  set_lane(to.to_rest, n, stars_.frames(site)[across]);
  set_lane(to.before, n, offsets[across == 0 ? sites.size() - 1 : across - 1]);
  set_lane(to.after, n, offsets[across + 1 == sites.size() ? 0 : across + 1]);
  batches_.cut_if_full(kind, out, others);
}

}  // namespace ucvt
