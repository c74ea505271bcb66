#include "cvt/cell_corners.h"

namespace ucvt {
namespace {

[[gnu::always_inline]] inline LanePoint on_side(const LanePoint& p, const LanePoint& q,
                                                const Lanes& s) {
  return {p.b1 + s * (q.b1 - p.b1), p.b2 + s * (q.b2 - p.b2)};
}

/// g and h are how far the corners are beyond the bisectors of site 0 with sites 1 and 2: linear over
/// the face, as is g - h, beyond that of 2 with 1. All three vanish where the cells meet.
template <int terms>
[[gnu::always_inline]] inline void cut_faces(const CellCorners::Faces& f, double kappa,
                                             const std::vector<QuadratureNode>& rule,
                                             CellCorners::Shares& out) {
  const std::array<LaneOffset, 3> x{f.corner[0], apply(kappa, f.to_site[0], f.corner[1]),
                                    apply(kappa, f.to_site[1], f.corner[2])};
  std::array<Lanes, 3> g, h;
  for (std::size_t i = 0; i < 3; ++i) {
    g[i] = beyond(kappa, x[i], f.to_site[0].translation);
    h[i] = beyond(kappa, x[i], f.to_site[1].translation);
  }
  const Lanes g_h1 = g[1] - h[1], g_h2 = g[2] - h[2];
  const Lanes s01 = g[0] / (g[0] - g[1]), s02 = h[0] / (h[0] - h[2]), s12 = g_h1 / (g_h1 - g_h2);
  const Lanes l0 = g[1] * h[2] - g[2] * h[1], l1 = g[2] * h[0] - g[0] * h[2];
  const Lanes l2 = g[0] * h[1] - g[1] * h[0], sum = l0 + l1 + l2;

  // A cell's side beyond the point where the three meet ends at the next cell's.
  const Lanes zero{}, one = zero + 1;
  const LaneOffset corner2_in_1 = apply(kappa, f.from_2_to_1, f.corner[2]);
  out.is_valid = less(g[0], zero) * less(h[0], zero) * less(zero, g[1]) * less(zero, g_h1) *
                 less(zero, h[2]) * less(g_h2, zero) * less(zero, l0) * less(zero, l1) *
                 less(zero, l2) * is_within(kappa, between(x[0], x[1], s01), f.before) *
                 is_within(kappa, between(x[0], x[2], s02), f.after) *
                 is_within(kappa, between(f.corner[1], corner2_in_1, s12), f.opposite);
  for (std::size_t i = 0; i < 3; ++i) {
    out.is_valid *= are_joined(kappa, x[i], x[(i + 1) % 3], f.whole.chord2[i]);
  }

  const LanePoint at0{zero, zero}, at1{one, zero}, at2{zero, one}, meeting{l1 / sum, l2 / sum};
  const LanePoint on01 = on_side(at0, at1, s01), on02 = on_side(at0, at2, s02);
  const LanePoint on12 = on_side(at1, at2, s12);
  LaneWeights part0, part1;
  add_piece<terms>(kappa, f.whole, rule, {at0, on01, meeting}, part0);
  add_piece<terms>(kappa, f.whole, rule, {at0, meeting, on02}, part0);
  add_piece<terms>(kappa, f.whole, rule, {at1, on12, meeting}, part1);
  add_piece<terms>(kappa, f.whole, rule, {at1, meeting, on01}, part1);
  const auto& share = f.share;
  part0.mu0 -= share[0].mu, part0.excess -= share[0].excess;
  part1.mu1 -= share[1].mu, part1.excess -= share[1].excess;
  const LaneMoments m0 = moments_of(kappa, part0, x[0], x[1], x[2]);
  const LaneMoments m1 = moments_of(kappa, part1, x[0], x[1], x[2]);
  out.of[0] = m0;
  out.of[1] = apply_inverse(kappa, f.to_site[0], m1);
  out.of[2] =
      apply_inverse(kappa, f.to_site[1], {m0.m + m1.m, m0.x + m1.x, m0.y + m1.y, m0.h + m1.h});
}

UCVT_WIDE void cut_small(const CellCorners::Faces& f, double kappa,
                         const std::vector<QuadratureNode>& rule, CellCorners::Shares& out) {
  cut_faces<short_series>(f, kappa, rule, out);
}

UCVT_WIDE void cut_bigger(const CellCorners::Faces& f, double kappa,
                          const std::vector<QuadratureNode>& rule, CellCorners::Shares& out) {
  cut_faces<long_series>(f, kappa, rule, out);
}

/// The place in a star of the neighbour a that is followed by the neighbour b; the star's size where there
/// is none.
std::size_t find_pair(std::span<const Vertex> star, Vertex a, Vertex b) {
  for (std::size_t i = 0; i < star.size(); ++i) {
    if (star[i] == a && star[(i + 1) % star.size()] == b) {
      return i;
    }
  }
  return star.size();
}

}  // namespace

CellCorners::CellCorners(const SurfaceMass& mass, const Stars& stars, const Lifts& lifts)
    : mass_(mass),
      stars_(stars),
      lifts_(lifts),
      batches_(mass.surface().space().kappa, cut_small, cut_bigger) {}

void CellCorners::Shares::add_to(CellShares& cells, const Faces& faces, std::size_t n) const {
  cells.of(faces.site[0][n]) += lane(of[0], n);
  cells.of(faces.site[1][n]) += lane(of[1], n);
  cells.of(faces.site[2][n]) -= lane(of[2], n);
}

void CellCorners::take(Face f, const std::array<std::size_t, 3>& vertices, CellShares& out,
                       std::vector<Face>& others) {
  const std::array<Vertex, 3> site{lifts_.owner[vertices[0]], lifts_.owner[vertices[1]],
                                   lifts_.owner[vertices[2]]};
  const auto star0 = stars_.sites(site[0]), star1 = stars_.sites(site[1]);
  const std::size_t n0 = star0.size(), n1 = star1.size();
  const std::size_t to1 = find_pair(star0, site[1], site[2]);
  const std::size_t to2 = find_pair(star1, site[2], site[0]);
  const FacePieces& pieces = mass_.pieces(f);
  const std::size_t kind = face_kind(mass_.surface().space(), pieces.triangle);
  if (to1 == n0 || to2 == n1 || kind == face_kinds.size()) {
    others.push_back(f);
    return;
  }
  Faces& to = batches_.faces(kind);
  const std::size_t n = batches_.next_lane(kind);
  to.face[n] = f;
  set_lane(to.whole, n, pieces, {0, 1, 2});
  set_lane(to.share[0], n, pieces.share(0));
  set_lane(to.share[1], n, pieces.share(1));
  for (std::size_t i = 0; i < 3; ++i) {
    to.site[i][n] = site[i];
    set_lane(to.corner[i], n, lifts_.at[vertices[i]]);
  }
  const auto offsets0 = stars_.offsets(site[0]);
  set_lane(to.to_site[0], n, stars_.frames(site[0])[to1]);
  set_lane(to.to_site[1], n, stars_.frames(site[0])[(to1 + 1) % n0]);
  set_lane(to.before, n, offsets0[(to1 + n0 - 1) % n0]);
  set_lane(to.after, n, offsets0[(to1 + 2) % n0]);
  set_lane(to.opposite, n, stars_.offsets(site[1])[(to2 + n1 - 1) % n1]);
  set_lane(to.from_2_to_1, n, stars_.frames(site[1])[to2]);
  batches_.cut_if_full(kind, out, others);
}

}  // namespace ucvt
