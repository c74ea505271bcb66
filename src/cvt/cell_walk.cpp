#include "cvt/cell_walk.h"

#include <algorithm>
#include <cmath>

namespace ucvt {
namespace {

/// Bits of `outside` that stand for one neighbour; the last one stands for all that are left.
constexpr std::size_t single_bits = 63;
constexpr std::uint64_t single_mask = (std::uint64_t{1} << single_bits) - 1;

}  // namespace

std::uint64_t CellWalk::outside(const Offset& p, const std::vector<Offset>& neighbours) const {
  std::uint64_t mask = 0;
  for (std::size_t j = 0; j < neighbours.size(); ++j) {
    if (beyond_bisector(t_.space(), p, neighbours[j]) > 0) {
      mask |= std::uint64_t{1} << std::min(j, single_bits);
    }
  }
  return mask;
}

CellWalk::Developed& CellWalk::add(Face face) {
  const std::size_t f = face.index();
  const std::int32_t older = stamp_[f] == cell_ ? newest_[f] : -1;
  stamp_[f] = cell_;
  newest_[f] = static_cast<std::int32_t>(developed_.size());
  t_.prefetch(face);
  auto& d = developed_.emplace_back();
  d.place.face = face;
  d.older = older;
  return d;
}

bool CellWalk::is_developed(Halfedge h, const Offset& u, const Offset& v) const {
  const std::size_t g = h.face().index(), j = static_cast<std::size_t>(h.id % 3);
  if (stamp_[g] != cell_) {
    return false;
  }
  // The sphere is its own cover.
  if (t_.space().kappa > 0) {
    return true;
  }
  const double near = same_lift2(t_.chord(h) * t_.chord(h), lift_rounding(t_.space(), u, reach_));
  for (std::int32_t i = newest_[g]; i >= 0; i = developed_[static_cast<std::size_t>(i)].older) {
    const auto& corner = developed_[static_cast<std::size_t>(i)].place.corner;
    if (chord2(t_.space(), corner[j], u) < near &&
        chord2(t_.space(), corner[(j + 1) % 3], v) < near) {
      return true;
    }
  }
  return false;
}

void CellWalk::cross_into(std::size_t from, std::size_t side,
                          const std::vector<Offset>& neighbours) {
  const auto& d = developed_[from];
  const std::size_t next = side == 2 ? 0 : side + 1;
  const Halfedge h = halfedges(d.place.face)[side], twin = t_.connectivity().twin(h);
  const Offset u = d.place.corner[side], v = d.place.corner[next];
  const std::uint64_t u_outside = d.outside[side], v_outside = d.outside[next];
  if (is_developed(twin, v, u)) {
    return;
  }
  const Offset w = t_.develop(h, u, v);
  const std::uint64_t w_outside = outside(w, neighbours);
  if ((u_outside & v_outside & w_outside & single_mask) != 0) {
    return;
  }
  auto& out = add(twin.face());
  const auto j = static_cast<std::size_t>(twin.id % 3);
  out.place.corner[j] = v, out.outside[j] = v_outside;
  out.place.corner[(j + 1) % 3] = u, out.outside[(j + 1) % 3] = u_outside;
  out.place.corner[(j + 2) % 3] = w, out.outside[(j + 2) % 3] = w_outside;
}

const std::vector<CellWalk::Developed>& CellWalk::faces(const Place& place,
                                                        const std::vector<Offset>& neighbours) {
  ++cell_;
  double farthest = 0;
  for (const Offset& n : neighbours) {
    farthest = std::max(farthest, n.h);
  }
  reach_ = std::sqrt(2 * farthest);
  developed_.clear();
  auto& first = add(place.face);
  for (std::size_t i = 0; i < 3; ++i) {
    first.place.corner[i] = place.corner[i];
    first.outside[i] = outside(place.corner[i], neighbours);
  }
  for (std::size_t n = 0; n < developed_.size(); ++n) {
    const std::array<std::uint64_t, 3> mask = developed_[n].outside;
    for (std::size_t side = 0; side < 3; ++side) {
      if ((mask[side] & mask[(side + 1) % 3] & single_mask) == 0) {
        cross_into(n, side, neighbours);
      }
    }
  }
  return developed_;
}

}  // namespace ucvt
