#include "paper_method/fundamental_domain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cover/generators.h"
#include "cover/layout.h"
#include "ucvt/error.h"

namespace ucvt::paper {
namespace {

/// Sides crossed on the way back; far more than a centroid or a laid out vertex ever needs.
constexpr int most_crossings = 10000;

/// Steps of the search for the middle; it needs to be found roughly.
constexpr int middle_steps = 1000;

/// A point this far beyond a side, relative to the side's numbers, is on it.
constexpr double on_side = 1e-13;

/// Positive on the domain's side of the geodesic from a to b: det[a, b, p] of the linear model,
/// relative to the size of its terms.
double inside(const ModelPoint& a, const ModelPoint& b, const ModelPoint& p) {
  const ModelPoint n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]};
  const double size = std::hypot(n[0], n[1], n[2]) * std::hypot(p[0], p[1], p[2]);
  return (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) / size;
}

double inside(const FundamentalDomain& d, std::size_t side, const ModelPoint& p) {
  return inside(d.corners[side], d.corners[(side + 1) % d.corners.size()], p);
}

/// The side by which the way from `from`, inside, leaves the domain, and where; all sides: it does not.
std::pair<std::size_t, ModelPoint> exit_of(const FundamentalDomain& d, const ModelPoint& from,
                                           const ModelPoint& to) {
  std::size_t exit = d.corners.size();
  double first = std::numeric_limits<double>::infinity();
  const double scale_from = std::hypot(from[0], from[1], from[2]);
  const double scale_to = std::hypot(to[0], to[1], to[2]);
  for (std::size_t i = 0; i < d.corners.size(); ++i) {
    const double end = scale_to * inside(d, i, to);
    if (end >= -on_side * scale_to) {
      continue;
    }
    const double begin = std::max(0.0, scale_from * inside(d, i, from));
    if (const double t = begin / (begin - end); t < first) {
      first = t, exit = i;
    }
  }
  if (exit == d.corners.size()) {
    return {exit, to};
  }
  ModelPoint at{};
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = (1 - first) * from[k] + first * to[k];
  }
  return {exit, at};
}

/// The point from which the farthest corner is least far, nearly: doubles tell little near the rim of
/// the disk. Badoiu, Clarkson 2003: step k goes 1/(k + 1) of the way to the farthest corner.
ModelPoint middle(double kappa, const std::vector<ModelPoint>& corners) {
  Frame at = frame_at(kappa, corners.front());
  for (int k = 1; k < middle_steps; ++k) {
    Offset farthest;
    for (const ModelPoint& c : corners) {
      const Offset x = offset_in(at, c);
      farthest = x.h > farthest.h ? x : farthest;
    }
    const double length = length_of_chord({kappa}, std::sqrt(2 * farthest.h)) / (k + 1);
    const double r = std::hypot(farthest.x, farthest.y);
    at = carried(
        at, from_chord({kappa}, chord_of_length({kappa}, length), farthest.x / r, farthest.y / r));
  }
  return at.P;
}

/// The map that takes the model's origin to p and carries the axes along.
DeckMap transvection_to(double kappa, const ModelPoint& p) {
  const double r = std::hypot(p[0], p[1]);
  const double half = length_of_chord({kappa}, std::sqrt(2 * offset_in({kappa}, p).h)) / 2;
  const double s = kappa < 0 ? std::sinh(half) : half;
  const double c = kappa < 0 ? std::cosh(half) : 1;
  return r > 0 ? normalized(kappa, {{c, 0}, {s * p[0] / r, s * p[1] / r}}) : DeckMap{};
}

/// The image of the model's own frame.
Frame frame_of(double kappa, const DeckMap& m) {
  const ModelMatrix a = model_matrix(kappa, m);
  return orthonormal({kappa, {a[0][2], a[1][2], a[2][2]}, {a[0][0], a[1][0], a[2][0]}});
}

/// The domain and, with 32 digits, what leads to it from the base's frame and back across its sides.
struct PreciseDomain {
  FundamentalDomain rounded;
  DeckMap to_middle;
  std::vector<DeckMap> back;
};

PreciseDomain domain_of(const DeckSystem& s) {
  PreciseDomain out;
  FundamentalDomain& d = out.rounded;
  const double kappa = d.kappa = s.kappa;
  const DeckGroup group = deck_group(s);
  d.corners = group.polygon;
  out.to_middle = inverse(transvection_to(kappa, middle(kappa, d.corners)));
  const DeckMap from_middle = inverse(out.to_middle);
  const auto centred = [&](const DeckMap& m) {
    return product(kappa, product(kappa, out.to_middle, m), from_middle);
  };
  const auto corner = corner_maps(kappa, group.relator, s.canonical.map);
  const std::size_t sides = group.relator.size();
  for (std::size_t i = 0; i < sides; ++i) {
    d.corners[i] = frame_of(kappa, product(kappa, out.to_middle, corner[i])).P;
    // The domain across has the end of the paired side at corner i.
    const auto paired = static_cast<std::size_t>(group.paired_side[i]);
    const DeckMap across = product(kappa, corner[i], inverse(corner[(paired + 1) % sides]));
    out.back.push_back(normalized(kappa, centred(inverse(across))));
    d.back.push_back(model_matrix(kappa, out.back.back()));
  }
  for (const Word& word : neighbour_words(group.genus)) {
    d.neighbour.push_back(model_matrix(kappa, centred(map_of(kappa, word, s.canonical.map))));
  }
  return out;
}

/// The map followed by those that bring its origin into the domain.
DeckMap brought_back(const PreciseDomain& d, DeckMap m) {
  const double kappa = d.rounded.kappa;
  ModelPoint from{0, 0, 1};
  for (int step = 0; step < most_crossings; ++step) {
    const auto [side, at] = exit_of(d.rounded, from, frame_of(kappa, m).P);
    if (side == d.back.size()) {
      return m;
    }
    from = on_model(kappa, transformed(d.rounded.back[side], at));
    m = normalized(kappa, product(kappa, d.back[side], m));
  }
  throw NumericalError("a vertex of the layout was not brought into the fundamental domain");
}

PlacedSite placed(const UniformSurface& t, const SurfacePoint& p, const Frame& corner) {
  const Place place = place_of(t, p);
  const Offset& back = place.corner[0];
  return {carried(corner, {-back.x, -back.y, back.h}), place};
}

}  // namespace

bool contains(const FundamentalDomain& d, const ModelPoint& p) {
  for (std::size_t i = 0; i < d.corners.size(); ++i) {
    if (inside(d, i, p) < -on_side) {
      return false;
    }
  }
  return true;
}

void bring_back(const FundamentalDomain& d, Frame& site) {
  ModelPoint from{0, 0, 1};
  for (int step = 0; step < most_crossings; ++step) {
    const auto [side, at] = exit_of(d, from, site.P);
    if (side == d.back.size()) {
      return;
    }
    from = on_model(d.kappa, transformed(d.back[side], at));
    site = orthonormal(
        {d.kappa, transformed(d.back[side], site.P), transformed(d.back[side], site.E1)});
  }
  throw NumericalError("a site was not brought back into the fundamental domain");
}

LaidOut laid_out_domain(const UniformSurface& t, const std::vector<SurfacePoint>& sites) {
  LaidOut out;
  if (t.space().kappa > 0) {
    const auto corner = fundamental_domain(t, {0});
    for (const SurfacePoint& p : sites) {
      const auto& face = corner[p.face.index()];
      const Frame at = frame_at(1, model_point({1}, face[0]));
      const Rotation turn = rotation_between({1, 0, 0}, offset_in(at, model_point({1}, face[1])));
      out.sites.push_back(placed(t, p, turned(at, turn)));
    }
    return out;
  }
  const DeckSystem system = deck_system(t);
  const PreciseDomain domain = domain_of(system);
  out.domain = domain.rounded;
  const std::vector<DeckMap> layout = laid_out(t, system);
  const std::vector<Offset> direction = t.vertex_frames();
  for (const SurfacePoint& p : sites) {
    const std::size_t side = halfedges(p.face)[0].index();
    const DeckMap vertex =
        brought_back(domain, product(system.kappa, domain.to_middle, layout[side]));
    const Rotation turn = rotation_between({1, 0, 0}, direction[side]);
    out.sites.push_back(placed(t, p, turned(frame_of(system.kappa, vertex), turn)));
    bring_back(out.domain, out.sites.back().frame);
  }
  return out;
}

}  // namespace ucvt::paper
