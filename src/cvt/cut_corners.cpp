#include "cvt/cut_corners.h"

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
  const Lanes is_cut = less(at_corner, zero) * less(zero, at_next) * less(zero, at_last) *
                       are_joined(kappa, f.corner, next, chord2[0]) *
                       are_joined(kappa, f.next, f.last, chord2[1]) *
                       are_joined(kappa, last, f.corner, chord2[2]);
  const Lanes before =
      is_cut * (2 - is_within(kappa, on_p, f.before) - is_within(kappa, on_q, f.before));
  const Lanes after =
      is_cut * (2 - is_within(kappa, on_p, f.after) - is_within(kappa, on_q, f.after));
  out.is_valid = is_cut * less(before + after, zero + 1);
  out.third = after - before;
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
      batches_(batches(mass.surface().space().kappa, 1)) {}

FaceBatches<CutCorners::Faces, CutCorners::Shares> CutCorners::batches(double kappa,
                                                                       std::size_t lanes_a_face) {
  return {kappa, cut_small, cut_bigger, lanes_a_face};
}

void CutCorners::Faces::set(std::size_t n, Face f, const FacePieces& pieces, const Stars& stars,
                            const Corner& cut) {
  const auto offsets = stars.offsets(cut.alone);
  const std::size_t size = offsets.size();
  face[n] = f, alone[n] = cut.alone, rest[n] = stars.sites(cut.alone)[cut.across];
  set_lane(whole, n, pieces, {cut.number, (cut.number + 1) % 3, (cut.number + 2) % 3});
  set_lane(share, n, pieces.share(cut.number));
  set_lane(corner, n, cut.at);
  set_lane(next, n, cut.next);
  set_lane(last, n, cut.last);
  set_lane(to_rest, n, stars.frames(cut.alone)[cut.across]);
  set_lane(before, n, offsets[cut.across == 0 ? size - 1 : cut.across - 1]);
  set_lane(after, n, offsets[cut.across + 1 == size ? 0 : cut.across + 1]);
}

void CutCorners::Shares::add_to(CellShares& cells, const Faces& faces, std::size_t n) const {
  cells.of(faces.alone[n]) += lane(alone, n);
  cells.of(faces.rest[n]) -= lane(rest, n);
}

void CutCorners::take(Face f, const std::array<std::size_t, 3>& vertices, std::size_t alone,
                      CellShares& out, std::vector<Uncut>& uncut) {
  const std::size_t next = vertices[(alone + 1) % 3], last = vertices[(alone + 2) % 3];
  const Vertex site = lifts_.owner[vertices[alone]];
  const std::size_t across = stars_.find(site, lifts_.owner[next]);
  const FacePieces& pieces = mass_.pieces(f);
  const std::size_t kind = face_kind(mass_.surface().space(), pieces.triangle);
  if (across == stars_.sites(site).size() || kind == face_kinds.size()) {
    uncut.push_back({f, 0});
    return;
  }
  batches_.faces(kind).set(
      batches_.next_lane(kind), f, pieces, stars_,
      {alone, site, across, lifts_.at[vertices[alone]], lifts_.at[next], lifts_.at[last]});
  batches_.cut_if_full(kind, out, uncut);
}

}  // namespace ucvt
