#include "figure/chart.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "space/offset.h"

namespace ucvt {
namespace {

double dot(const ModelPoint& a, const ModelPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

ModelPoint cross(const ModelPoint& a, const ModelPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

ModelPoint combine(double s, const ModelPoint& a, double t, const ModelPoint& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}

Pixel to_pixel(const Chart& c, double x, double y) {
  return {c.origin.x + c.scale * x, c.origin.y - c.scale * y};
}

/// The part of a polygon, given in view coordinates, on the viewer's side of the horizon plane.
std::vector<ModelPoint> cut_at_horizon(const std::vector<ModelPoint>& corners) {
  std::vector<ModelPoint> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ModelPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if (a[2] >= 0) {
      out.push_back(a);
    }
    if ((a[2] > 0 && b[2] < 0) || (a[2] < 0 && b[2] > 0)) {
      // Where the edge meets the plane z = 0, up to length: no division by the small a_z - b_z.
      const double sign = a[2] > 0 ? 1 : -1;
      const ModelPoint q = combine(sign * a[2], b, -sign * b[2], a);
      const double norm = std::hypot(q[0], q[1]);
      if (norm > 0) {
        out.push_back({q[0] / norm, q[1] / norm, 0});
      }
    }
  }
  return out;
}

/// Two points 0.04 apart: the chord runs 0.0002 below the arc.
constexpr double sample_rad = 0.04;
constexpr double least_sine = 1e-9;  ///< antipodes have no one geodesic between them

Path sphere_outline(const Chart& chart, const std::vector<ModelPoint>& corners) {
  std::vector<ModelPoint> seen;
  for (const ModelPoint& p : corners) {
    seen.push_back(moved(chart.view, p));
  }
  seen = cut_at_horizon(seen);
  Path path;
  if (seen.size() < 3) {
    return path;
  }
  path.move(to_pixel(chart, seen[0][0], seen[0][1]));
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const ModelPoint &a = seen[i], &b = seen[(i + 1) % seen.size()];
    const ModelPoint n = cross(a, b);
    const double sine = std::hypot(n[0], n[1], n[2]), angle = std::atan2(sine, dot(a, b));
    const int pieces = sine < least_sine ? 1 : static_cast<int>(std::ceil(angle / sample_rad));
    for (int k = 1; k < pieces; ++k) {
      const double t = angle * k / pieces;
      const ModelPoint p = combine(std::sin(angle - t) / sine, a, std::sin(t) / sine, b);
      path.line(to_pixel(chart, p[0], p[1]));
    }
    if (i + 1 < seen.size()) {
      path.line(to_pixel(chart, b[0], b[1]));
    }
  }
  return path.close();
}

/// An arc that bulges less than the last decimal written is drawn straight, in pixels.
constexpr double least_bulge = 0.001;

/// The geodesic n.P = 0 is the circle about -(nx, ny)/nz that meets the unit circle at right angles.
void poincare_edge(const Chart& chart, const ModelPoint& a, const ModelPoint& b, Path& path) {
  const ModelPoint n = cross(a, b);
  const Pixel from = pixel(chart, a), to = pixel(chart, b);
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double radius2 = n[0] * n[0] + n[1] * n[1] - n[2] * n[2];
  const double radius = chart.scale * std::sqrt(std::max(radius2, 0.0));
  if (length * length * std::abs(n[2]) < 8 * least_bulge * radius || radius2 <= 0) {
    path.line(to);
    return;
  }
  // The arc bends away from its centre, which lies left of a -> b where n_z < 0.
  path.arc(radius / std::abs(n[2]), n[2] > 0, to);
}

/// (x + i y) of i (1 + w)/(1 - w), multiplied out.
std::array<double, 2> half_plane(const ModelPoint& p) {
  const double gap = p[0] > 0 ? (1 + p[1] * p[1]) / (p[2] + p[0]) : p[2] - p[0];
  return {-p[1] / gap, 1 / gap};
}

/// Geodesics are half circles about points of the rim, and verticals.
void half_plane_edge(const Chart& chart, const ModelPoint& a, const ModelPoint& b, Path& path) {
  const auto [x0, y0] = half_plane(a);
  const auto [x1, y1] = half_plane(b);
  const Pixel to = to_pixel(chart, x1, y1);
  const double wide = chart.scale * (x1 - x0), high = chart.scale * (y1 - y0);
  const double middle = x0 + (x1 - x0) / 2 + (y1 - y0) * (y1 + y0) / (2 * (x1 - x0));
  const double radius = chart.scale * std::hypot(x0 - middle, y0);
  if (!(wide * wide + high * high > 8 * least_bulge * radius)) {
    path.line(to);
  } else {
    path.arc(radius, x1 > x0, to);
  }
}

}  // namespace

ModelPoint moved(const ModelMatrix& m, const ModelPoint& p) {
  return {dot(m[0], p), dot(m[1], p), dot(m[2], p)};
}

std::vector<ModelPoint> moved(const ModelMatrix& m, std::vector<ModelPoint> points) {
  for (ModelPoint& p : points) {
    p = moved(m, p);
  }
  return points;
}

ModelMatrix product(const ModelMatrix& a, const ModelMatrix& b) {
  ModelMatrix out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    }
  }
  return out;
}

ModelPoint lifted(double kappa, const CentralPoint& k) {
  const Offset p = from_central({kappa}, k[0], k[1]);
  return {p.x, p.y, model_z({kappa}, p)};
}

ModelMatrix sphere_view(double lon_deg, double lat_deg) {
  const double lon = lon_deg * std::numbers::pi / 180, lat = lat_deg * std::numbers::pi / 180;
  const double cx = std::cos(lon), sx = std::sin(lon), cy = std::cos(lat), sy = std::sin(lat);
  return {{{-sx, cx, 0}, {-sy * cx, -sy * sx, cy}, {cy * cx, cy * sx, sy}}};
}

ModelMatrix from_behind(const ModelMatrix& view) {
  return {{combine(-1, view[0], 0, view[0]), view[1], combine(-1, view[2], 0, view[2])}};
}

bool visible(const Chart& chart, const ModelPoint& p) {
  return chart.projection != Projection::Orthographic || dot(chart.view[2], p) > 0;
}

Pixel pixel(const Chart& chart, const ModelPoint& p) {
  switch (chart.projection) {
    case Projection::Orthographic:
      return to_pixel(chart, dot(chart.view[0], p), dot(chart.view[1], p));
    case Projection::Poincare:
      return to_pixel(chart, p[0] / (1 + p[2]), p[1] / (1 + p[2]));
    case Projection::HalfPlane: {
      const auto [x, y] = half_plane(p);
      return to_pixel(chart, x, y);
    }
    default:
      return to_pixel(chart, p[0] / p[2], p[1] / p[2]);
  }
}

void add_geodesic(const Chart& chart, const ModelPoint& a, const ModelPoint& b, Path& path) {
  if (chart.projection == Projection::Poincare) {
    poincare_edge(chart, a, b, path);
  } else if (chart.projection == Projection::HalfPlane) {
    half_plane_edge(chart, a, b, path);
  } else {
    path.line(pixel(chart, b));
  }
}

Path outline(const Chart& chart, const std::vector<ModelPoint>& corners) {
  if (chart.projection == Projection::Orthographic) {
    return sphere_outline(chart, corners);
  }
  Path path;
  if (corners.size() < 3) {
    return path;
  }
  path.move(pixel(chart, corners[0]));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ModelPoint& next = corners[(i + 1) % corners.size()];
    const bool straight =
        chart.projection == Projection::Klein || chart.projection == Projection::Plane;
    if (!straight || i + 1 < corners.size()) {
      add_geodesic(chart, corners[i], next, path);
    }
  }
  return path.close();
}

double drawn_area(const Chart& chart, const std::vector<ModelPoint>& corners) {
  std::vector<Pixel> seen;
  for (const ModelPoint& p : corners) {
    if (visible(chart, p)) {
      seen.push_back(pixel(chart, p));
    }
  }
  double twice = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Pixel &a = seen[i], &b = seen[(i + 1) % seen.size()];
    twice += (a.x - seen[0].x) * (b.y - seen[0].y) - (a.y - seen[0].y) * (b.x - seen[0].x);
  }
  return std::abs(twice) / 2;
}

}  // namespace ucvt
