#include "triangulation/closed_spaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "ucvt/error.h"

namespace ucvt {
namespace {

using Triangle = std::array<std::int32_t, 3>;

/// A face's corners: which vertices they are, and their frames side by side in the model.
struct Corner {
  std::int32_t vertex = 0;
  Frame frame;
};

/// Connectivity glues edges by their ends, so faces must form a simplicial complex.
DelaunayTriangulation glued(double kappa, std::size_t vertices,
                            const std::vector<std::array<Corner, 3>>& faces) {
  std::vector<Triangle> triangles;
  std::vector<Offset> offsets;
  for (const auto& f : faces) {
    triangles.push_back({f[0].vertex, f[1].vertex, f[2].vertex});
    for (std::size_t i = 0; i < 3; ++i) {
      offsets.push_back(offset_in(f[i].frame, f[(i + 1) % 3].frame.P));
    }
  }
  return {{kappa}, Connectivity(vertices, triangles), std::move(offsets)};
}

/// Leaves the first vertices, as many as there are frames.
SpaceTriangulation reduced(DelaunayTriangulation d, std::vector<Frame> frames) {
  d.make_delaunay();
  for (std::size_t v = frames.size(); v < d.vertex_count(); ++v) {
    d.remove({static_cast<std::int32_t>(v)});
  }
  d.compact();
  return {std::move(d), std::move(frames)};
}

/// By vertex, all that a Delaunay edge from it may lead to.
using Edges = std::array<std::vector<Offset>, 2>;

/// Removals cost digits; the edges that are left are known, so each takes its own again.
DelaunayTriangulation sharpened(const DelaunayTriangulation& d, const Edges& possible) {
  std::vector<Offset> offsets;
  for (std::size_t i = 0; i < d.connectivity().halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    offsets.push_back(*std::ranges::min_element(
        possible[d.connectivity().origin(h).index()], {},
        [&](const Offset& p) { return chord2(d.space(), d.offset(h), p); }));
  }
  return {d.space(), d.connectivity(), std::move(offsets)};
}

SpaceTriangulation octahedron() {
  std::vector<Frame> frames;
  for (const ModelPoint& p :
       {ModelPoint{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}) {
    frames.push_back(frame_at(1, p));
  }
  std::vector<std::array<Corner, 3>> faces;
  const auto corner = [&](std::int32_t v) {
    return Corner{v, frames[static_cast<std::size_t>(v)]};
  };
  for (std::int32_t i = 0; i < 4; ++i) {
    const std::int32_t a = 1 + i, b = 1 + (i + 1) % 4;
    faces.push_back({corner(0), corner(a), corner(b)});
    faces.push_back({corner(5), corner(b), corner(a)});
  }
  return {glued(1, frames.size(), faces), std::move(frames)};
}

/// Shortens a basis of a lattice until no vector is shorter (Lagrange and Gauss).
void reduce(CentralPoint& a, CentralPoint& b) {
  const auto dot = [](const CentralPoint& u, const CentralPoint& v) {
    return u[0] * v[0] + u[1] * v[1];
  };
  while (true) {
    if (dot(b, b) < dot(a, a)) {
      std::swap(a, b);
    }
    const double n = std::round(dot(a, b) / dot(a, a));
    const CentralPoint c{b[0] - n * a[0], b[1] - n * a[1]};
    if (n == 0 || !(dot(c, c) < dot(b, b))) {
      return;
    }
    b = c;
  }
}

SpaceTriangulation torus(const Domain& domain) {
  // Across the sides 1 and 2 lie the translations by the two vectors of the lattice.
  CentralPoint a{domain.across[1][0][2], domain.across[1][1][2]};
  CentralPoint b{domain.across[2][0][2], domain.across[2][1][2]};
  reduce(a, b);
  if (a[0] * b[1] - a[1] * b[0] < 0) {
    b = {-b[0], -b[1]};
  }
  // With 3 x 3 parallelograms no two edges have the same ends.
  const auto corner = [&](int i, int j) {
    const double s = i / 3.0, t = j / 3.0;
    return Corner{3 * (j % 3) + i % 3,
                  {0, {s * a[0] + t * b[0], s * a[1] + t * b[1], 1}, {1, 0, 0}}};
  };
  std::vector<std::array<Corner, 3>> faces;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      faces.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      faces.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  SpaceTriangulation out = reduced(glued(0, 9, faces), {Frame{}});
  Edges shortest;
  for (const int i : {-1, 0, 1}) {
    for (const int j : {-1, 0, 1}) {
      if (i != 0 || j != 0) {
        shortest[0].push_back(from_central({0}, i * a[0] + j * b[0], i * a[1] + j * b[1]));
      }
    }
  }
  out.triangulation = sharpened(out.triangulation, shortest);
  return out;
}

/// The frame at central coordinates whose first axis points to other ones.
Frame frame_towards(const CentralPoint& at, const CentralPoint& to) {
  const auto lift = [](const CentralPoint& k) {
    return model_point(Frame{-1}, from_central({-1}, k[0], k[1]));
  };
  const Frame f = frame_at(-1, lift(at));
  return turned(f, rotation_between({1, 0, 0}, offset_in(f, lift(to))));
}

CentralPoint between(const CentralPoint& a, const CentralPoint& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

/// Three corners to a side, the polygon's own one first, with frames that the gluing respects.
std::vector<Corner> rim(const Domain& domain) {
  const std::size_t sides = domain.polygon.size();
  const auto at = [&](std::size_t i) { return domain.polygon[i % sides]; };
  std::vector<Corner> out(3 * sides);
  std::int32_t vertices = 2;
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t j = glued_side(domain, i);
    for (std::size_t s = 1; s < 3; ++s) {
      const CentralPoint here = between(at(i), at(i + 1), static_cast<double>(s) / 3);
      out[3 * i + s] = i < j ? Corner{vertices++, frame_towards(here, at(i + 1))}
                             : Corner{out[3 * j + 3 - s].vertex, frame_towards(here, at(i))};
    }
  }
  // Round the corner: the polygon beyond side j sees it as its corner after the side glued to j.
  // Each turn is by the angle of the polygon, known better than a product of matrices tells it.
  std::size_t corner = 0;
  for (std::size_t turn = 0; turn < sides; ++turn) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(turn) / static_cast<double>(sides);
    const Frame inward = frame_towards(at(corner), {0, 0});
    out[3 * corner] = {1, turned(inward, {std::cos(angle), std::sin(angle)})};
    corner = (glued_side(domain, corner) + 1) % sides;
  }
  return out;
}

/// All that a Delaunay edge can lead to, as offsets from the centre and from the corner: corners and
/// centres across the sides, centres and neighbouring corners. (Two triangles of centre and side are
/// cocircular with each other: one diagonal is as good as the other.)
Edges possible_edges(const Domain& domain, const std::vector<Corner>& rim) {
  Edges out;
  const Frame centre{-1};
  for (std::size_t i = 0; i < domain.polygon.size(); ++i) {
    const Frame& corner = rim[3 * i].frame;
    const Frame& next = rim[(3 * i + 3) % rim.size()].frame;
    out[0].push_back(offset_in(centre, corner.P));
    out[0].push_back(offset_in(centre, transformed(domain.across[i], centre.P)));
    out[1].push_back(offset_in(corner, centre.P));
    out[1].push_back(offset_in(corner, next.P));
    out[1].push_back(offset_in(next, corner.P));
  }
  return out;
}

SpaceTriangulation surface(const Domain& domain) {
  const std::vector<Corner> outer = rim(domain);
  const Corner centre{0, Frame{-1}};
  std::vector<Corner> inner;
  const auto first = static_cast<std::int32_t>(2 + domain.polygon.size());
  for (const Corner& c : outer) {
    const ModelPoint& p = c.frame.P;
    const Offset half = from_central({-1}, p[0] / p[2] / 2, p[1] / p[2] / 2);
    inner.push_back({first + static_cast<std::int32_t>(inner.size()),
                     frame_at(-1, model_point(centre.frame, half))});
  }
  std::vector<std::array<Corner, 3>> faces;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const std::size_t j = (i + 1) % outer.size();
    faces.push_back({centre, inner[i], inner[j]});
    faces.push_back({inner[i], outer[i], outer[j]});
    faces.push_back({inner[i], outer[j], inner[j]});
  }
  const std::size_t vertices = static_cast<std::size_t>(first) + inner.size();
  SpaceTriangulation out = reduced(glued(-1, vertices, faces), {centre.frame, outer[0].frame});
  out.triangulation = sharpened(out.triangulation, possible_edges(domain, outer));
  return out;
}

}  // namespace

std::size_t glued_side(const Domain& domain, std::size_t i) {
  // The corner before side j comes to lie after side i.
  const std::size_t sides = domain.polygon.size();
  const CentralPoint& after = domain.polygon[(i + 1) % sides];
  std::size_t best = i;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < sides; ++j) {
    const CentralPoint& k = domain.polygon[j];
    const ModelPoint p = transformed(domain.across[i], {k[0], k[1], 1});
    const double distance = std::hypot(p[0] / p[2] - after[0], p[1] / p[2] - after[1]);
    if (distance < least) {
      least = distance, best = j;
    }
  }
  return best;
}

SpaceTriangulation triangulate_closed(const Domain& domain) {
  switch (domain.kind) {
    case DomainKind::Sphere:
      return octahedron();
    case DomainKind::Torus:
      return torus(domain);
    case DomainKind::HyperbolicSurface:
      return surface(domain);
    default:
      throw InvalidInput("a polygon is not a closed space; use the Delaunay triangulation in it");
  }
}

}  // namespace ucvt
