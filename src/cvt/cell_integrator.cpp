#include "cvt/cell_integrator.h"

#include <algorithm>
#include <utility>

namespace ucvt {
namespace {

/// Bits of `outside` that stand for one neighbour; the last one stands for all that are left.
constexpr std::size_t single_bits = 63;
constexpr std::uint64_t single_mask = (std::uint64_t{1} << single_bits) - 1;

/// Positive where p is nearer to the neighbour than to the site (the origin); linear in P.
double beyond_bisector(Space s, const Offset& p, const Offset& neighbour) {
  return neighbour.x * p.x + neighbour.y * p.y - neighbour.h * model_z(s, p);
}

std::array<double, 3> corner_densities(const UniformSurface& t, const std::vector<double>& density,
                                       Face f) {
  std::array<double, 3> rho{};
  for (std::size_t i = 0; i < 3; ++i) {
    rho[i] = density[t.connectivity().origin(halfedges(f)[i]).index()];
  }
  return rho;
}

}  // namespace

CellIntegrator::CellIntegrator(const UniformSurface& t, std::vector<double> density)
    : t_(t), density_(std::move(density)), weights_(t.connectivity().face_count()) {
  for (std::size_t f = 0; f < weights_.size(); ++f) {
    const Face face{static_cast<std::int32_t>(f)};
    weights_[f] =
        ucvt::integrate(t_.space(), t_.triangle(face), corner_densities(t_, density_, face));
  }
}

double CellIntegrator::total_mass() const {
  double sum = 0;
  for (const Weights& w : weights_) {
    sum += w.mass;
  }
  return sum;
}

std::uint64_t CellIntegrator::outside(const Offset& p,
                                      const std::vector<Offset>& neighbours) const {
  std::uint64_t mask = 0;
  for (std::size_t j = 0; j < neighbours.size(); ++j) {
    if (beyond_bisector(t_.space(), p, neighbours[j]) > 0) {
      mask |= std::uint64_t{1} << std::min(j, single_bits);
    }
  }
  return mask;
}

CellIntegrator::Workspace::Developed& CellIntegrator::add(Workspace& work, Face face) const {
  const std::size_t f = face.index();
  const std::int32_t older = work.stamp_[f] == work.cell_ ? work.newest_[f] : -1;
  work.stamp_[f] = work.cell_;
  work.newest_[f] = static_cast<std::int32_t>(work.developed_.size());
  t_.prefetch(face);
  __builtin_prefetch(&weights_[f]);
  auto& d = work.developed_.emplace_back();
  d.place.face = face;
  d.older = older;
  return d;
}

bool CellIntegrator::is_developed(const Workspace& work, Halfedge h, const Offset& u,
                                  const Offset& v) const {
  const std::size_t g = h.face().index(), j = static_cast<std::size_t>(h.id % 3);
  if (work.stamp_[g] != work.cell_) {
    return false;
  }
  // The sphere is its own cover. Elsewhere another lift of the face is far away, beyond rounding.
  if (t_.space().kappa > 0) {
    return true;
  }
  const double near = 1e-6 * t_.chord(h) * t_.chord(h);
  for (std::int32_t i = work.newest_[g]; i >= 0;
       i = work.developed_[static_cast<std::size_t>(i)].older) {
    const auto& corner = work.developed_[static_cast<std::size_t>(i)].place.corner;
    if (chord2(t_.space(), corner[j], u) < near &&
        chord2(t_.space(), corner[(j + 1) % 3], v) < near) {
      return true;
    }
  }
  return false;
}

void CellIntegrator::cross_into(Workspace& work, std::size_t from, std::size_t side,
                                const std::vector<Offset>& neighbours) const {
  const auto& d = work.developed_[from];
  const std::size_t next = side == 2 ? 0 : side + 1;
  const Halfedge h = halfedges(d.place.face)[side], twin = t_.connectivity().twin(h);
  const Offset u = d.place.corner[side], v = d.place.corner[next];
  const std::uint64_t u_outside = d.outside[side], v_outside = d.outside[next];
  if (is_developed(work, twin, v, u)) {
    return;
  }
  const Offset w = t_.develop(h, u, v);
  const std::uint64_t w_outside = outside(w, neighbours);
  if ((u_outside & v_outside & w_outside & single_mask) != 0) {
    return;
  }
  auto& out = add(work, twin.face());
  const auto j = static_cast<std::size_t>(twin.id % 3);
  out.place.corner[j] = v, out.outside[j] = v_outside;
  out.place.corner[(j + 1) % 3] = u, out.outside[(j + 1) % 3] = u_outside;
  out.place.corner[(j + 2) % 3] = w, out.outside[(j + 2) % 3] = w_outside;
}

void CellIntegrator::clip(Workspace& work, const Workspace::Developed& d,
                          const std::vector<Offset>& neighbours) const {
  work.polygon_ = {{0, 0}, {1, 0}, {0, 1}};
  const std::uint64_t straddles = d.outside[0] | d.outside[1] | d.outside[2];
  for (std::size_t j = 0; j < neighbours.size() && !work.polygon_.empty(); ++j) {
    if ((straddles >> std::min(j, single_bits) & 1) == 0) {
      continue;
    }
    std::array<double, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = beyond_bisector(t_.space(), d.place.corner[i], neighbours[j]);
    }
    const auto value = [&](const Barycentric& b) {
      return (1 - b.b1 - b.b2) * at[0] + b.b1 * at[1] + b.b2 * at[2];
    };
    work.clipped_.clear();
    Barycentric p = work.polygon_.back();
    double p_value = value(p);
    for (const Barycentric& q : work.polygon_) {
      const double q_value = value(q);
      if ((p_value > 0) != (q_value > 0)) {
        const double s = p_value / (p_value - q_value);
        work.clipped_.push_back({p.b1 + s * (q.b1 - p.b1), p.b2 + s * (q.b2 - p.b2)});
      }
      if (q_value <= 0) {
        work.clipped_.push_back(q);
      }
      p = q, p_value = q_value;
    }
    work.polygon_.swap(work.clipped_);
  }
}

Moments CellIntegrator::integrate(const Place& place, const std::vector<Offset>& neighbours,
                                  Workspace& work) const {
  ++work.cell_;
  work.developed_.clear();
  auto& first = add(work, place.face);
  for (std::size_t i = 0; i < 3; ++i) {
    first.place.corner[i] = place.corner[i];
    first.outside[i] = outside(place.corner[i], neighbours);
  }
  Moments sum;
  for (std::size_t n = 0; n < work.developed_.size(); ++n) {
    const auto& d = work.developed_[n];
    const Face face = d.place.face;
    const std::array<std::uint64_t, 3> mask = d.outside;
    if ((mask[0] | mask[1] | mask[2]) == 0) {
      sum += moments_of(weights_[face.index()], d.place.corner);
    } else {
      clip(work, d, neighbours);
      if (work.polygon_.size() < 3) {
        continue;
      }
      const auto rho = corner_densities(t_, density_, face);
      const ChordTriangle triangle = t_.triangle(face);
      Weights piece;
      for (std::size_t i = 1; i + 1 < work.polygon_.size(); ++i) {
        piece += integrate_piece(t_.space(), triangle, rho, work.polygon_[0], work.polygon_[i],
                                 work.polygon_[i + 1]);
      }
      sum += moments_of(piece, d.place.corner);
    }
    for (std::size_t side = 0; side < 3; ++side) {
      if ((mask[side] & mask[(side + 1) % 3] & single_mask) == 0) {
        cross_into(work, n, side, neighbours);
      }
    }
  }
  return sum;
}

}  // namespace ucvt
