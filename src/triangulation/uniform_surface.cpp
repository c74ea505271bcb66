#include "triangulation/uniform_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "ucvt/error.h"

namespace ucvt {
namespace {

/// An edge keeps its direction to 1e-10 radians while it is longer than this part of its distance
/// from the origin; steps are shortened until all edges that they cross are.
constexpr double least_edge = 1e-6;
constexpr int most_tries = 1000;

/// Walks to the face under the origin; false, with the place anywhere, at an edge that is too short for
/// its distance.
bool walk_to_origin(const UniformSurface& t, Place& place, double shortest) {
  const Space s = t.space();
  const std::size_t limit = 100 + 3 * t.connectivity().face_count();
  const auto is_short = [&](double chord, const Offset& at) {
    return chord * chord < shortest * shortest * (at.x * at.x + at.y * at.y);
  };
  for (std::size_t step = 0; step < limit; ++step) {
    // Leave across the side that the origin is farthest beyond.
    std::size_t exit = 3;
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Offset &u = place.corner[i], &v = place.corner[(i + 1) % 3];
      const double inside = cross(u, v) / std::sqrt(chord2(s, u, v));
      if (inside < worst) {
        worst = inside, exit = i;
      }
    }
    const auto side = halfedges(place.face);
    if (exit == 3) {
      // A face too small and too far to tell has the origin on no side.
      return !is_short(std::max({t.chord(side[0]), t.chord(side[1]), t.chord(side[2])}),
                       place.corner[0]);
    }
    const Halfedge h = side[exit], twin = t.connectivity().twin(h);
    const Offset u = place.corner[exit], v = place.corner[(exit + 1) % 3];
    if (is_short(t.chord(h), u)) {
      return false;
    }
    // Beyond by rounding only: the place is on the edge, and either face will do.
    if (worst > -1e-14 * t.chord(h)) {
      return true;
    }
    const auto j = static_cast<std::size_t>(twin.id % 3);
    place.face = twin.face();
    place.corner[j] = v;
    place.corner[(j + 1) % 3] = u;
    place.corner[(j + 2) % 3] = t.develop(h, u, v);
  }
  throw NumericalError("the walk to a site's new place did not end");
}

}  // namespace

UniformSurface::UniformSurface(Space space, Connectivity connectivity, std::vector<double> chord)
    : space_(space),
      connectivity_(std::move(connectivity)),
      vertex_order_(connectivity_),
      chord_(std::move(chord)) {
  const std::size_t faces = connectivity_.face_count();
  det_.resize(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    det_[f] = triangle_determinant(space_, {chord_[3 * f], chord_[3 * f + 1], chord_[3 * f + 2]});
    if (!(det_[f] > 0)) {
      throw NumericalError("face " + std::to_string(f) + " of the uniformized surface collapsed");
    }
  }
  const double kappa = space_.kappa;
  developing_.resize(3 * faces);
  for (std::size_t i = 0; i < developing_.size(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)}, t = connectivity_.twin(h);
    const double c2 = chord_[i] * chord_[i];
    const double cu = this->chord(t.next()), cv = this->chord(t.prev());
    const double cu2 = cu * cu, cv2 = cv * cv, r = 1 - kappa * c2 / 4;
    developing_[i] = {(c2 + cv2 - cu2 - kappa * c2 * cv2 / 2) / (2 * c2 * r),
                      (c2 + cu2 - cv2 - kappa * c2 * cu2 / 2) / (2 * c2 * r),
                      -det(t.face()) / (c2 * r), (cu2 + cv2 - c2) / (4 * r)};
  }
}

ChordTriangle UniformSurface::triangle(Face f) const {
  ChordTriangle out;
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = chord_[3 * f.index() + i];
    out.chord2[i] = c * c;
  }
  out.det = det(f);
  return out;
}

double UniformSurface::angle(Halfedge h) const {
  const double c = chord(h), d = chord(h.prev()), e = chord(h.next());
  const double hc = c * c / 2, hd = d * d / 2;
  return std::atan2(det(h.face()), hc + hd - e * e / 2 - space_.kappa * hc * hd);
}

double UniformSurface::area(Face f) const {
  // tan(area/2) = det / (1 + sum of the sides' inner products); an angle excess would lose the area
  // of small faces to rounding.
  double sum = 4;
  for (const Halfedge h : halfedges(f)) {
    sum -= space_.kappa * chord(h) * chord(h) / 2;
  }
  return space_.kappa == 0 ? det(f) / 2 : 2 * std::atan2(det(f), sum);
}

std::vector<Offset> UniformSurface::vertex_frames() const {
  std::vector<Offset> out(connectivity_.halfedge_count());
  std::vector<double> until;  // the angle swept before each halfedge
  for (std::size_t v = 0; v < connectivity_.vertex_count(); ++v) {
    const Vertex vertex{static_cast<std::int32_t>(v)};
    until.clear();
    double total = 0;
    connectivity_.for_outgoing(vertex, [&](Halfedge h) {
      until.push_back(total);
      total += angle(h);
    });
    const double scale = 2 * std::numbers::pi / total;
    std::size_t k = 0;
    connectivity_.for_outgoing(vertex, [&](Halfedge h) {
      const double direction = scale * until[k++];
      out[h.index()] = from_chord(space_, chord(h), std::cos(direction), std::sin(direction));
    });
  }
  return out;
}

Offset point_in_frame(const UniformSurface& t, const SurfacePoint& p,
                      const std::array<Offset, 3>& corner) {
  const Space s = t.space();
  const auto& b = p.bary;
  const ChordTriangle tri = t.triangle(p.face);
  const double form =
      b[0] * b[1] * tri.chord2[0] + b[1] * b[2] * tri.chord2[1] + b[2] * b[0] * tri.chord2[2];
  // sum b_v P_v, scaled onto the space.
  const double root = std::sqrt(1 - s.kappa * form), w = 1 / root;
  Offset out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.x += w * b[i] * corner[i].x;
    out.y += w * b[i] * corner[i].y;
    out.h += w * b[i] * corner[i].h;
  }
  out.h -= w * form / (1 + root);
  return on_quadric(s, out);
}

CornerView seen_from_corner(const UniformSurface& t, const std::vector<Offset>& frames,
                            const SurfacePoint& p) {
  const auto nearest =
      static_cast<std::size_t>(std::max_element(p.bary.begin(), p.bary.end()) - p.bary.begin());
  const Halfedge h = halfedges(p.face)[nearest];
  CornerView out;
  out.from = t.connectivity().origin(h);
  out.corner[nearest] = {};
  out.corner[(nearest + 1) % 3] = frames[h.index()];
  out.corner[(nearest + 2) % 3] = frames[t.connectivity().rotate(h).index()];
  out.at = point_in_frame(t, p, out.corner);
  return out;
}

Place place_of(const UniformSurface& t, const SurfacePoint& p) {
  const Space s = t.space();
  const auto side = halfedges(p.face);
  const double turn = t.angle(side[0]);
  const std::array<Offset, 3> corner{
      Offset{}, from_chord(s, t.chord(side[0]), 1, 0),
      from_chord(s, t.chord(side[2]), std::cos(turn), std::sin(turn))};
  const Offset at = point_in_frame(t, p, corner);
  Place out{p.face, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    out.corner[i] = on_quadric(s, transvect_back(s, at, corner[i]));
  }
  return out;
}

SurfacePoint point_of(const Place& place) {
  // The origin is sum l_v P_v with l_v the determinants of the two other corners with it.
  SurfacePoint out{place.face, {}};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    out.bary[i] = std::max(0.0, cross(place.corner[(i + 1) % 3], place.corner[(i + 2) % 3]));
    sum += out.bary[i];
  }
  for (double& b : out.bary) {
    b /= sum;
  }
  return out;
}

void move_place(const UniformSurface& t, Place& place, const Offset& to) {
  const Space s = t.space();
  Offset rest = to, step = to;
  for (int tries = 0;; ++tries) {
    const bool last = tries == most_tries;
    if (last) {
      step = rest;
    }
    Place there = place;
    for (Offset& c : there.corner) {
      c = on_quadric(s, transvect_back(s, step, c));
    }
    if (!walk_to_origin(t, there, last ? 0 : least_edge)) {
      step = half_way(s, step);
      continue;
    }
    place = there;
    if (step.h == rest.h) {
      return;
    }
    rest = on_quadric(s, transvect_back(s, step, rest));
    step = rest;
  }
}

}  // namespace ucvt
