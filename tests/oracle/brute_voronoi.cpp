#include "oracle/brute_voronoi.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ucvt::oracle {
namespace {

struct Point {
  double x, y;
};

double distance_to_segment(Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = std::clamp(-(a.x * dx + a.y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(a.x + t * dx, a.y + t * dy);
}

Point central(Space s, const Offset& p) {
  return {p.x / model_z(s, p), p.y / model_z(s, p)};
}

/// The faces of T that come within reach of the origin, each lift once.
std::vector<Place> faces_about(const UniformSurface& t, const Place& start, double reach) {
  const Space s = t.space();
  const Connectivity& c = t.connectivity();
  std::vector<Place> out{start};
  std::vector<std::vector<std::size_t>> lifts(c.face_count());
  lifts[start.face.index()].push_back(0);
  for (std::size_t n = 0; n < out.size(); ++n) {
    const Place here = out[n];
    for (std::size_t i = 0; i < 3; ++i) {
      const Offset u = here.corner[i], v = here.corner[(i + 1) % 3];
      if (s.kappa <= 0 && distance_to_segment(central(s, u), central(s, v)) > reach) {
        continue;
      }
      const Halfedge h = halfedges(here.face)[i], twin = c.twin(h);
      const auto j = static_cast<std::size_t>(twin.id % 3);
      const double near = 1e-6 * t.chord(h) * t.chord(h);
      const bool known = std::ranges::any_of(lifts[twin.face().index()], [&](std::size_t m) {
        const auto& x = out[m].corner;
        return s.kappa > 0 || (chord2(s, x[j], v) < near && chord2(s, x[(j + 1) % 3], u) < near);
      });
      if (known) {
        continue;
      }
      Place next{twin.face(), {}};
      next.corner[j] = v, next.corner[(j + 1) % 3] = u;
      next.corner[(j + 2) % 3] = t.develop(h, u, v);
      lifts[next.face.index()].push_back(out.size());
      out.push_back(next);
      if (out.size() > 2000000) {
        throw std::runtime_error("the layout of the cover does not end");
      }
    }
  }
  return out;
}

struct Corner {
  Point at;
  std::int32_t edge;  ///< lift whose bisector runs from this corner to the next; -1: the frame
};

/// What the bisector of the origin and a lift leaves of a polygon.
std::vector<Corner> clipped(const std::vector<Corner>& polygon, const Offset& a,
                            std::int32_t label) {
  std::vector<Corner> out;
  const auto beyond = [&](Point k) { return a.x * k.x + a.y * k.y - a.h; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double fp = beyond(p.at), fq = beyond(q.at);
    if (fp <= 0) {
      out.push_back(p);
    }
    if ((fp > 0) != (fq > 0)) {
      const double w = fp / (fp - fq);
      const Point cut{p.at.x + w * (q.at.x - p.at.x), p.at.y + w * (q.at.y - p.at.y)};
      out.push_back({cut, fp <= 0 ? label : p.edge});
    }
  }
  return out;
}

}  // namespace

std::vector<Lift> lifts_about(const UniformSurface& t, const Place& place,
                              const std::vector<SurfacePoint>& sites, double reach) {
  std::vector<std::vector<std::size_t>> in_face(t.connectivity().face_count());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    in_face[sites[i].face.index()].push_back(i);
  }
  std::vector<Lift> out;
  for (const Place& p : faces_about(t, place, reach)) {
    for (const std::size_t i : in_face[p.face.index()]) {
      out.push_back({static_cast<std::int32_t>(i), point_in_frame(t, sites[i], p.corner)});
    }
  }
  std::ranges::sort(out, {}, [](const Lift& l) { return l.at.h; });
  out.erase(out.begin());  // the site itself
  return out;
}

BruteCell brute_cell(const UniformSurface& t, const Place& place,
                     const std::vector<SurfacePoint>& sites) {
  const Space s = t.space();
  double reach = s.kappa < 0 ? 0.9 : 0.5;
  while (true) {
    const auto lifts = lifts_about(t, place, sites, reach);
    const double far = s.kappa < 0 ? 1 : 1e4;
    std::vector<Corner> cell{
        {{-far, -far}, -1}, {{far, -far}, -1}, {{far, far}, -1}, {{-far, far}, -1}};
    for (std::size_t i = 0; i < lifts.size(); ++i) {
      cell = clipped(cell, lifts[i].at, static_cast<std::int32_t>(i));
    }
    BruteCell out;
    bool closed = true;
    for (const Corner& c : cell) {
      closed = closed && c.edge >= 0;
      out.radius = std::max(out.radius, std::hypot(c.at.x, c.at.y));
    }
    const double r = out.radius;
    closed = closed && (s.kappa >= 0 || r < 1);
    // A neighbour is at most twice the radius away; tan_kappa of the double.
    const double needed = !closed ? HUGE_VAL : s.kappa < 0 ? 2 * r / (1 + r * r) : 2 * r;
    if (s.kappa <= 0 && needed > reach) {
      reach = closed        ? needed * (s.kappa < 0 ? 1 : 1.01)
              : s.kappa < 0 ? (1 + reach) / 2
                            : 2 * reach;
      continue;
    }
    if (!closed) {
      throw std::runtime_error("the cell is not bounded");
    }
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Point a = cell[i].at, b = cell[(i + 1) % cell.size()].at;
      out.corners.push_back(from_central(s, a.x, a.y));
      out.area += central_triangle_area(s, from_central(s, a.x, a.y), from_central(s, b.x, b.y));
      if (std::hypot(b.x - a.x, b.y - a.y) > 1e-7 * r) {
        out.neighbours.push_back(lifts[static_cast<std::size_t>(cell[i].edge)]);
      }
    }
    return out;
  }
}

}  // namespace ucvt::oracle
