#include "oracle/surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ucvt::oracle {

UniformSurface flat_torus(int n, int m, double shear, double height) {
  TriangleMesh mesh = grid_torus(n, m);
  Connectivity c(mesh.positions.size(), mesh.faces);
  const double s = std::sqrt(height);
  const double ux = 1 / (s * n), vx = shear / (s * m), vy = height / (s * m);
  const double u = ux, v = std::hypot(vx, vy), w = std::hypot(ux + vx, vy);
  std::vector<double> chord(c.halfedge_count());
  for (std::size_t f = 0; f < c.face_count(); f += 2) {
    chord[3 * f] = u, chord[3 * f + 1] = v, chord[3 * f + 2] = w;
    chord[3 * f + 3] = w, chord[3 * f + 4] = u, chord[3 * f + 5] = v;
  }
  return {Space{0}, std::move(c), std::move(chord)};
}

UniformSurface sphere(const TriangleMesh& mesh) {
  Connectivity c(mesh.positions.size(), mesh.faces);
  std::vector<double> chord;
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const Position& p = mesh.positions[std::min(c.origin(h), c.head(h)).index()];
    const Position& q = mesh.positions[std::max(c.origin(h), c.head(h)).index()];
    chord.push_back(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return {Space{1}, std::move(c), std::move(chord)};
}

const Uniformized& double_torus() {
  static const Uniformized t = uniformize_surface(closed(voxel_frame(2)), {});
  return t;
}

const UniformSurface& surface_of(double kappa) {
  static const UniformSurface ball = sphere(icosphere(1)), torus = flat_torus(6, 5);
  return kappa > 0 ? ball : kappa < 0 ? double_torus().surface : torus;
}

const UniformSurface& fine_surface_of(double kappa) {
  static const UniformSurface ball = sphere(icosphere(4)), torus = flat_torus(40, 30);
  static const UniformizedSurface genus2 = uniformize(closed(voxel_frame(2)), {0.2, {}});
  return kappa > 0 ? ball : kappa < 0 ? genus2.value().surface : torus;
}

DelaunayTriangulation delaunay_of(const UniformSurface& t) {
  DelaunayTriangulation d(t.space(), t.connectivity(), t.vertex_frames());
  d.make_delaunay();
  return d;
}

UniformSurface fewest_vertices(const UniformSurface& t) {
  DelaunayTriangulation d = delaunay_of(t);
  const std::size_t keep = t.space().kappa > 0 ? 12 : 1;
  for (std::size_t v = t.connectivity().vertex_count(); v-- > keep;) {
    d.remove({static_cast<std::int32_t>(v)});
  }
  d.compact();
  std::vector<double> chord;
  for (std::size_t i = 0; i < d.connectivity().halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    chord.push_back(std::sqrt(2 * d.offset(std::min(h, d.connectivity().twin(h))).h));
  }
  return {t.space(), d.connectivity(), std::move(chord)};
}

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

SurfacePoint random_point(const UniformSurface& t, std::mt19937_64& random) {
  const auto faces = t.connectivity().face_count();
  const Face f{static_cast<std::int32_t>(uniform(random) * static_cast<double>(faces))};
  const double r = std::sqrt(uniform(random)), s = uniform(random);
  return {f, {1 - r, r * (1 - s), r * s}};
}

std::vector<SurfacePoint> random_points(const UniformSurface& t, std::size_t n,
                                        std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> out;
  while (out.size() < n) {
    out.push_back(random_point(t, random));
  }
  return out;
}

double gauss_bonnet_area(const UniformSurface& t) {
  const auto chi = static_cast<double>(t.connectivity().euler_number());
  return t.space().kappa == 0 ? 1 : 2 * std::numbers::pi * std::abs(chi);
}

double worst_angle_error(const UniformSurface& t) {
  double worst = 0;
  for (std::size_t v = 0; v < t.connectivity().vertex_count(); ++v) {
    double sum = 0;
    t.connectivity().for_outgoing({static_cast<std::int32_t>(v)},
                                  [&](Halfedge h) { sum += t.angle(h); });
    worst = std::max(worst, std::abs(sum - 2 * std::numbers::pi));
  }
  return worst;
}

}  // namespace ucvt::oracle
