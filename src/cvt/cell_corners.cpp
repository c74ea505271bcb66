#include "cvt/cell_corners.h"

namespace ucvt {
namespace {

/// A point of a face by its corners.
[[gnu::always_inline]] inline LaneOffset point_at(const std::array<LaneOffset, 3>& x,
                                                  const LanePoint& p) {
  return {x[0].x + p.b1 * (x[1].x - x[0].x) + p.b2 * (x[2].x - x[0].x),
          x[0].y + p.b1 * (x[1].y - x[0].y) + p.b2 * (x[2].y - x[0].y),
          x[0].h + p.b1 * (x[1].h - x[0].h) + p.b2 * (x[2].h - x[0].h)};
}

/// g and h are how far the corners are beyond the bisectors of site 0 with sites 1 and 2: linear over
/// the face, as is g - h, beyond that of 2 with 1. All three vanish where the cells meet. A corner 0 or 1
/// beyond the bisector with site 2 lies in cell 2, which then ends on side 01: the second piece takes from
/// the first what lies beyond.
template <int terms>
[[gnu::always_inline]] inline void cut_faces(const CellCorners::Faces& f, double kappa,
                                             const std::vector<QuadratureNode>& rule,
                                             CellCorners::Shares& out) {
  const std::array<LaneOffset, 3> x{f.corner[0], apply(kappa, f.to_site[0], f.corner[1]),
                                    apply(kappa, f.to_site[1], f.corner[2])};
  std::array<Lanes, 3> g, h, g_h;
  for (std::size_t i = 0; i < 3; ++i) {
    g[i] = beyond(kappa, x[i], f.to_site[0].translation);
    h[i] = beyond(kappa, x[i], f.to_site[1].translation);
    g_h[i] = g[i] - h[i];
  }
  const Lanes zero{}, one = zero + 1;
  const auto is_guest0 = h[0] > zero, is_guest1 = g_h[1] < zero;
  const Lanes h_end = is_guest0 ? h[1] : h[2], g_h_end = is_guest1 ? g_h[0] : g_h[2];
  const Lanes s01 = g[0] / (g[0] - g[1]), s02 = h[0] / (h[0] - h_end);
  const Lanes s12 = g_h[1] / (g_h[1] - g_h_end);
  const Lanes l0 = g[1] * h[2] - g[2] * h[1], l1 = g[2] * h[0] - g[0] * h[2];
  const Lanes l2 = g[0] * h[1] - g[1] * h[0], sum = l0 + l1 + l2;
  const LanePoint at0{zero, zero}, at1{one, zero}, meeting{l1 / sum, l2 / sum}, on01{s01, zero};
  const LanePoint on02{is_guest0 ? s02 : zero, is_guest0 ? zero : s02};
  const LanePoint on12{1 - s12, is_guest1 ? zero : s12};

  // With l2 > 0 too, a guest's h or g - h has the other sign at the other end of side 01.
  Lanes is_cut = less(g[0], zero) * less(zero, g[1]) * less(zero, h[2]) * less(g_h[2], zero);
  for (std::size_t i = 0; i < 3; ++i) {
    is_cut *= are_joined(kappa, x[i], x[(i + 1) % 3], f.whole.chord2[i]);
  }
  // A cell's side beyond the point where the three meet ends at the next cell's.
  const LaneOffset end12 = point_at(x, on12);
  const LaneMoments end12_in_1 =
      apply_inverse(kappa, f.to_site[0], {one, end12.x, end12.y, end12.h});
  out.is_valid = is_cut * less(zero, l0) * less(zero, l1) * less(zero, l2) *
                 is_within(kappa, point_at(x, on01), f.before) *
                 is_within(kappa, point_at(x, on02), f.after) *
                 is_within(kappa, {end12_in_1.x, end12_in_1.y, end12_in_1.h}, f.opposite);
  out.third = is_cut * (l0 < zero ? one : l1 < zero ? one + 1 : l2 < zero ? one + 2 : zero);

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
/// is none, or more than one.
std::size_t find_pair(std::span<const Vertex> star, Vertex a, Vertex b) {
  std::size_t place = star.size();
  for (std::size_t i = 0; i < star.size(); ++i) {
    if (star[i] == a && star[(i + 1) % star.size()] == b) {
      if (place < star.size()) {
        return star.size();
      }
      place = i;
    }
  }
  return place;
}

/// 1, 2 or 3 where the other two sites are neighbours of site 0, 1 or 2, but not of each other; else 0.
int site_between(const Stars& stars, const std::array<Vertex, 3>& site) {
  std::array<bool, 3> is_next{};
  for (std::size_t i = 0; i < 3; ++i) {
    is_next[i] = stars.find(site[i], site[(i + 1) % 3]) < stars.sites(site[i]).size();
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_next[i] && is_next[(i + 2) % 3] && !is_next[(i + 1) % 3]) {
      return static_cast<int>(i + 1);
    }
  }
  return 0;
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
                       std::vector<Uncut>& uncut) {
  const auto& owner = lifts_.owner;
  gather(f, vertices,
         {{0, 1, 2}, {owner[vertices[0]], owner[vertices[1]], owner[vertices[2]]}, no_guest}, out,
         uncut);
}

void CellCorners::take_tip(Face f, const std::array<std::size_t, 3>& vertices, std::size_t alone,
                           bool is_after, CellShares& out, std::vector<Uncut>& uncut) {
  const std::size_t next = (alone + 1) % 3, last = (alone + 2) % 3;
  const Vertex site = lifts_.owner[vertices[alone]], rest = lifts_.owner[vertices[next]];
  const auto star = stars_.sites(site);
  const std::size_t place = stars_.find(site, rest), n = star.size();
  if (is_after) {
    gather(f, vertices, {{last, alone, next}, {star[(place + 1) % n], site, rest}, 0}, out, uncut);
  } else {
    gather(f, vertices, {{alone, next, last}, {site, star[(place + n - 1) % n], rest}, 1}, out,
           uncut);
  }
}

void CellCorners::gather(Face f, const std::array<std::size_t, 3>& vertices, const Meeting& m,
                         CellShares& out, std::vector<Uncut>& uncut) {
  const auto star0 = stars_.sites(m.site[0]), star1 = stars_.sites(m.site[1]);
  const std::size_t n0 = star0.size(), n1 = star1.size();
  const std::size_t to1 = find_pair(star0, m.site[1], m.site[2]);
  const std::size_t to2 = find_pair(star1, m.site[2], m.site[0]);
  const FacePieces& pieces = mass_.pieces(f);
  const Space space = mass_.surface().space();
  const std::size_t kind = face_kind(space, pieces.triangle);
  if (to1 == n0 || to2 == n1 || kind == face_kinds.size()) {
    uncut.push_back({f, m.guest == no_guest ? site_between(stars_, m.site) : 0});
    return;
  }
  Faces& to = batches_.faces(kind);
  const std::size_t n = batches_.next_lane(kind);
  const std::array<Isometry, 2> to_site{stars_.frames(m.site[0])[to1],
                                        stars_.frames(m.site[0])[(to1 + 1) % n0]};
  to.face[n] = f;
  set_lane(to.whole, n, pieces, m.corner);
  for (std::size_t i = 0; i < 3; ++i) {
    const Offset& at = lifts_.at[vertices[m.corner[i]]];
    const bool is_guest = i == m.guest;
    to.site[i][n] = m.site[i];
    set_lane(to.corner[i], n,
             !is_guest ? at
             : i == 0  ? to_site[1].apply(space, at)
                       : stars_.frames(m.site[1])[to2].apply(space, at));
    if (i < 2) {
      set_lane(to.share[i], n, is_guest ? CornerShare{} : pieces.share(m.corner[i]));
      set_lane(to.to_site[i], n, to_site[i]);
    }
  }
  const auto offsets0 = stars_.offsets(m.site[0]);
  set_lane(to.before, n, offsets0[(to1 + n0 - 1) % n0]);
  set_lane(to.after, n, offsets0[(to1 + 2) % n0]);
  set_lane(to.opposite, n, stars_.offsets(m.site[1])[(to2 + n1 - 1) % n1]);
  batches_.cut_if_full(kind, out, uncut);
}

}  // namespace ucvt
