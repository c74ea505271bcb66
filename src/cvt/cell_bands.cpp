#include "cvt/cell_bands.h"

namespace ucvt {

void CellBands::take_crossed(Face f, const std::array<std::size_t, 3>& vertices, std::size_t first,
                             CellShares& out, std::vector<Uncut>& uncut) {
  const Space space = mass_.surface().space();
  const std::size_t next = (first + 1) % 3, last = (first + 2) % 3;
  const Offset &at = lifts_.at[vertices[first]], &at_next = lifts_.at[vertices[next]],
               &at_last = lifts_.at[vertices[last]];
  const Vertex band = lifts_.owner[vertices[first]], a = lifts_.owner[vertices[next]],
               b = lifts_.owner[vertices[last]];
  const std::size_t to_a = stars_.find(band, a), to_b = stars_.find(band, b);
  const std::size_t size = stars_.sites(band).size();
  if (to_a == size || to_b == size) {
    uncut.push_back({f, 0});
    return;
  }
  const auto frames = stars_.frames(band);
  gather(f,
         {{{next, a, stars_.find(a, band), at_next, frames[to_b].apply(space, at_last), at},
           {last, b, stars_.find(b, band), at_last, at, frames[to_a].apply(space, at_next)}}},
         out, uncut);
}

void CellBands::take_parted(Face f, const std::array<std::size_t, 3>& vertices, std::size_t alone,
                            bool is_after, CellShares& out, std::vector<Uncut>& uncut) {
  const Space space = mass_.surface().space();
  const Offset &at = lifts_.at[vertices[alone]], &next = lifts_.at[vertices[(alone + 1) % 3]],
               &last = lifts_.at[vertices[(alone + 2) % 3]];
  const Vertex site = lifts_.owner[vertices[alone]], rest = lifts_.owner[vertices[(alone + 1) % 3]];
  const auto star = stars_.sites(site);
  const std::size_t across =
      (stars_.find(site, rest) + (is_after ? 1 : star.size() - 1)) % star.size();
  const Vertex band = star[across];
  const std::size_t to_site = stars_.find(band, site), to_rest = stars_.find(band, rest);
  const auto frames = stars_.frames(band);
  if (to_rest == frames.size()) {
    uncut.push_back({f, 0});
    return;
  }
  gather(f,
         {{{alone, band, to_rest, frames[to_site].apply(space, at), next, last},
           {alone, site, across, at, frames[to_rest].apply(space, next),
            frames[to_rest].apply(space, last)}}},
         out, uncut);
}

void CellBands::gather(Face f, const std::array<CutCorners::Corner, 2>& cuts, CellShares& out,
                       std::vector<Uncut>& uncut) {
  const FacePieces& pieces = mass_.pieces(f);
  const std::size_t kind = face_kind(mass_.surface().space(), pieces.triangle);
  if (kind == face_kinds.size()) {
    uncut.push_back({f, 0});
    return;
  }
  for (const CutCorners::Corner& cut : cuts) {
    batches_.faces(kind).set(batches_.next_lane(kind), f, pieces, stars_, cut);
  }
  batches_.cut_if_full(kind, out, uncut);
}

}  // namespace ucvt
