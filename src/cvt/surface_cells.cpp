#include "cvt/surface_cells.h"

#include <algorithm>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "cvt/cell_shares.h"
#include "cvt/cell_walk.h"
#include "cvt/face_cuts.h"
#include "cvt/straddling_faces.h"
#include "space/lane_moments.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// A neighbour is nearer only when it is by more than this part of its own height: ties stay where
/// they are, and handing a vertex on ends.
constexpr double least_gain = 1e-14;

/// Vertices of one task; twice as many faces. Fixed, so that sums do not depend on the number of threads.
constexpr std::size_t chunk_size = 1024;

/// `transvect_back` by what their sites reached, of n points, four at a time. Back on the quadric by a step
/// of Newton's method for h, which rounding has moved it from: no root. Near and past the sphere's horizon h
/// carries the information and is kept.
UCVT_WIDE void carry(Space s, const Offset* reached, const Vertex* owner, Offset* at,
                     std::size_t n) {
  const double kappa = s.kappa;
  for (std::size_t first = 0; first < n; first += 4) {
    const std::size_t lanes = std::min<std::size_t>(4, n - first);
    Lanes x{}, y{}, h{}, ax{}, ay{}, ah{};
    for (std::size_t k = 0; k < lanes; ++k) {
      const Offset &p = at[first + k], &a = reached[owner[first + k].index()];
      x[k] = p.x, y[k] = p.y, h[k] = p.h;
      ax[k] = -a.x, ay[k] = -a.y, ah[k] = a.h;
    }
    const Lanes dot = ax * x + ay * y;
    const Lanes f = 1 - kappa * (h + dot / (2 - kappa * ah));
    x += ax * f, y += ay * f;
    h = ah + h - kappa * ah * h + dot;
    const Lanes step = (x * x + y * y + kappa * h * h - 2 * h) / (2 * (1 - kappa * h));
    h += kappa * h > 0.5 ? Lanes{} : step;
    for (std::size_t k = 0; k < lanes; ++k) {
      at[first + k] = {x[k], y[k], h[k]};
    }
  }
}

}  // namespace

void SurfaceCells::settle(Offset& at, Vertex& owner) const {
  const Space s = t_->space();
  for (std::size_t step = 0; step <= lifts_.at.size() + stars_.site_count(); ++step) {
    if (at.h < stars_.inner_h(owner)) {
      return;
    }
    const auto offsets = stars_.offsets(owner);
    std::size_t best = offsets.size();
    double most = 0;
    for (std::size_t j = 0; j < offsets.size(); ++j) {
      const double beyond = beyond_bisector(s, at, offsets[j]);
      if (beyond > most && beyond > least_gain * offsets[j].h) {
        most = beyond, best = j;
      }
    }
    if (best == offsets.size()) {
      return;
    }
    at = on_quadric(s, stars_.frames(owner)[best].apply_inverse(s, at));
    owner = stars_.sites(owner)[best];
  }
  throw NumericalError("the cell that holds a vertex of the surface was not found");
}

SurfaceCells::SurfaceCells(const UniformSurface& t, const DelaunayTriangulation& d,
                           const std::vector<Place>& places)
    : t_(&t), stars_(d) {
  lifts_.at.resize(t.connectivity().vertex_count());
  lifts_.owner.resize(t.connectivity().vertex_count());
  CellWalk walk(t);
  std::vector<Offset> neighbours;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vertex site{static_cast<std::int32_t>(i)};
    const auto offsets = stars_.offsets(site);
    neighbours.assign(offsets.begin(), offsets.end());
    for (const auto& face : walk.faces(places[i], neighbours)) {
      const auto corners = t.vertex_order().corners(face.place.face);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t v = corners[k];
        if (face.outside[k] == 0 || lifts_.owner[v].id < 0) {
          lifts_.at[v] = face.place.corner[k], lifts_.owner[v] = site;
        }
      }
    }
  }
  if (std::any_of(lifts_.owner.begin(), lifts_.owner.end(),
                  [](Vertex owner) { return owner.id < 0; })) {
    throw NumericalError("a vertex of the surface lies in no cell");
  }
  follow(d, std::vector<Offset>(places.size()));
}

void SurfaceCells::follow(const DelaunayTriangulation& d, std::span<const Offset> reached) {
  stars_ = Stars(d);
  const std::size_t n = lifts_.at.size();
  tbb::parallel_for(std::size_t{0}, (n + chunk_size - 1) / chunk_size, [&](std::size_t k) {
    const std::size_t first = k * chunk_size, last = std::min(n, first + chunk_size);
    carry(t_->space(), reached.data(), lifts_.owner.data() + first, lifts_.at.data() + first,
          last - first);
    for (std::size_t v = first; v < last; ++v) {
      if (!(lifts_.at[v].h < stars_.inner_h(lifts_.owner[v]))) {
        settle(lifts_.at[v], lifts_.owner[v]);
      }
    }
  });
}

void SurfaceCells::follow_removal(const DelaunayTriangulation& d, const std::vector<bool>& removed,
                                  const std::vector<Vertex>& number) {
  for (std::size_t v = 0; v < lifts_.at.size(); ++v) {
    Vertex& owner = lifts_.owner[v];
    if (removed[owner.index()]) {
      const auto offsets = stars_.offsets(owner);
      const auto nearest = static_cast<std::size_t>(
          std::min_element(offsets.begin(), offsets.end(),
                           [](const Offset& a, const Offset& b) { return a.h < b.h; }) -
          offsets.begin());
      lifts_.at[v] = on_quadric(
          t_->space(), stars_.frames(owner)[nearest].apply_inverse(t_->space(), lifts_.at[v]));
      owner = stars_.sites(owner)[nearest];
    }
    owner = number[owner.index()];
  }
  follow(d, std::vector<Offset>(d.vertex_count()));
}

/// One thread's pass over vertices and faces; gathers what they add to the cells they meet.
class SurfaceCells::Sweep {
 public:
  Sweep(const SurfaceCells& cells, const SurfaceMass& mass, const std::vector<Place>& places,
        const std::vector<bool>* corner_in)
      : cuts_(mass, cells.stars_, cells.lifts_),
        t_(*cells.t_),
        order_(t_.vertex_order()),
        stars_(cells.stars_),
        lifts_(cells.lifts_),
        mass_(mass),
        corner_in_(corner_in),
        cut_others_(mass, stars_, lifts_, places),
        shares_(places.size()) {}

  /// The k-th of some tasks: vertices and faces.
  std::vector<CellShares::Share> run(std::size_t k) {
    add_vertices(k * chunk_size, std::min(lifts_.at.size(), (k + 1) * chunk_size));
    const std::size_t faces = t_.connectivity().face_count();
    add_faces(2 * k * chunk_size, std::min(faces, 2 * (k + 1) * chunk_size));
    return shares_.take();
  }

 private:
  void add_vertices(std::size_t first, std::size_t last) {
    // Vertices of one cell come in runs.
    while (first < last) {
      const Vertex cell = lifts_.owner[first];
      Moments sum;
      for (; first < last && lifts_.owner[first] == cell; ++first) {
        sum += mass_.share(first).moments(t_.space(), lifts_.at[first]);
      }
      if (!corner_in_ || (*corner_in_)[cell.index()]) {
        shares_.of(cell) += sum;
      }
    }
  }

  void add_faces(std::size_t first, std::size_t last) {
    straddling_.clear();
    for (std::size_t i = first; i < last; ++i) {
      const Face f{static_cast<std::int32_t>(i)};
      const auto v = order_.corners(f);
      if ((!corner_in_ || has_corner_in(v)) && !lies_in_one_cell(f, v)) {
        mass_.prefetch(f);
        straddling_.push_back(f);
      }
    }
    cuts_.cut(straddling_, shares_, others_);
    for (const Uncut& other : others_) {
      cut_others_.add(other.face, shares_);
    }
  }

  [[nodiscard]] bool has_corner_in(const std::array<std::size_t, 3>& v) const {
    return std::any_of(v.begin(), v.end(),
                       [&](std::size_t i) { return (*corner_in_)[lifts_.owner[i].index()]; });
  }

  [[nodiscard]] bool lies_in_one_cell(Face f, const std::array<std::size_t, 3>& v) const {
    const Vertex owner = lifts_.owner[v[0]];
    if (owner != lifts_.owner[v[1]] || owner != lifts_.owner[v[2]]) {
      return false;
    }
    if (t_.space().kappa > 0) {
      return true;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (!joins(t_, stars_, halfedges(f)[i], owner, lifts_.at[v[i]], lifts_.at[v[(i + 1) % 3]])) {
        return false;
      }
    }
    return true;
  }

  FaceCuts cuts_;
  const UniformSurface& t_;
  const VertexOrder& order_;
  const Stars& stars_;
  const Lifts& lifts_;
  const SurfaceMass& mass_;
  const std::vector<bool>* corner_in_;
  StraddlingFaces cut_others_;
  CellShares shares_;
  std::vector<Face> straddling_;  // of the chunk at hand
  std::vector<Uncut> others_;
};

std::vector<Moments> SurfaceCells::moments(const SurfaceMass& mass,
                                           const std::vector<Place>& places,
                                           const std::vector<bool>* corner_in) const {
  const Connectivity& c = t_->connectivity();
  const std::size_t chunks =
      std::max(c.vertex_count() / chunk_size, c.face_count() / (2 * chunk_size)) + 1;
  std::vector<std::vector<CellShares::Share>> shares(chunks);
  tbb::enumerable_thread_specific<Sweep> sweeps(
      [&] { return Sweep(*this, mass, places, corner_in); });
  tbb::parallel_for(std::size_t{0}, chunks,
                    [&](std::size_t k) { shares[k] = sweeps.local().run(k); });
  std::vector<Moments> out(places.size());
  for (const auto& chunk : shares) {
    for (const CellShares::Share& s : chunk) {
      out[s.site.index()] += s.moments;
    }
  }
  return out;
}

}  // namespace ucvt
