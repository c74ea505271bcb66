#include "cvt/domain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "ucvt/error.h"

namespace ucvt {
namespace {

/// A point this far outside a side, relative to the polygon's coordinates, is on it.
constexpr double side_tolerance = 1e-12;

/// A point this far off the model, relative to its z^2, is on it.
constexpr double model_tolerance = 1e-9;

/// Corners that turn the wrong way by less than this sine are straight; lattices flatter than this
/// do not span the plane.
constexpr double flat_sine = 1e-12;

/// Sides crossed on the way to the fundamental polygon before the point is given up.
constexpr int most_crossings = 100000;

CentralPoint minus(const CentralPoint& a, const CentralPoint& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

double cross(const CentralPoint& a, const CentralPoint& b) {
  return a[0] * b[1] - a[1] * b[0];
}

double dot(const CentralPoint& a, const CentralPoint& b) {
  return a[0] * b[0] + a[1] * b[1];
}

double norm(const CentralPoint& a) {
  return std::hypot(a[0], a[1]);
}

double largest_norm(const std::vector<CentralPoint>& polygon) {
  double out = 0;
  for (const CentralPoint& k : polygon) {
    out = std::max(out, norm(k));
  }
  return out;
}

/// The side that k lies farthest outside of, and how far (negative inside).
std::pair<std::size_t, double> worst_side(const std::vector<CentralPoint>& polygon,
                                          const CentralPoint& k) {
  std::pair<std::size_t, double> worst{0, -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const CentralPoint side = minus(polygon[(i + 1) % polygon.size()], polygon[i]);
    const double outside = cross(minus(k, polygon[i]), side) / norm(side);
    if (!(outside <= worst.second)) {
      worst = {i, outside};
    }
  }
  return worst;
}

std::string named(std::size_t i, const CentralPoint& k) {
  return fmt::format("corner {} at ({:g}, {:g})", i, k[0], k[1]);
}

void check_corners(double kappa, const std::vector<CentralPoint>& corners) {
  if (kappa != 0 && kappa != -1) {
    throw InvalidInput(fmt::format(
        "a polygon of curvature {:g}; take 0 for the plane or -1 for the Klein disk", kappa));
  }
  if (corners.size() < 3) {
    throw InvalidInput(
        fmt::format("a polygon of {} corners; it needs three or more", corners.size()));
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const CentralPoint& k = corners[i];
    if (!std::isfinite(k[0]) || !std::isfinite(k[1])) {
      throw InvalidInput(named(i, k) + " is not finite; give numbers");
    }
    if (!(1 + kappa * dot(k, k) > 0)) {
      throw InvalidInput(named(i, k) + " lies outside the Klein disk; keep x^2 + y^2 below 1");
    }
    if (k == corners[(i + 1) % corners.size()]) {
      throw InvalidInput(named(i, k) + " is given twice in a row; drop one of the two");
    }
  }
}

/// Turns the corners counterclockwise, the first staying first, or finds them not convex.
void make_convex(std::vector<CentralPoint>& corners) {
  const std::size_t n = corners.size();
  double twice_area = 0, turn = 0;
  for (std::size_t i = 0; i < n; ++i) {
    twice_area += cross(minus(corners[i], corners[0]), minus(corners[(i + 1) % n], corners[0]));
  }
  if (twice_area < 0) {
    std::reverse(corners.begin() + 1, corners.end());
  }
  for (std::size_t i = 0; i < n; ++i) {
    const CentralPoint& k = corners[i];
    const CentralPoint in = minus(k, corners[(i + n - 1) % n]);
    const CentralPoint out = minus(corners[(i + 1) % n], k);
    if (!(cross(in, out) >= -flat_sine * norm(in) * norm(out)) || !(twice_area != 0)) {
      throw InvalidInput("the polygon is not convex at the " + named(i, k) +
                         " (counterclockwise); take its convex hull or cut it in convex pieces");
    }
    turn += std::atan2(cross(in, out), dot(in, out));
  }
  if (turn > 3 * std::numbers::pi) {
    throw InvalidInput("the polygon winds round more than once; give its corners in order, once");
  }
}

double polygon_area(const Domain& domain) {
  const Frame f = central_frame(domain);
  const auto corners = model_corners(domain);
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += central_triangle_area({domain.kappa}, offset_in(f, corners[i]),
                                 offset_in(f, corners[(i + 1) % corners.size()]));
  }
  return sum;
}

ModelMatrix translation(const CentralPoint& by) {
  return {{{1, 0, by[0]}, {0, 1, by[1]}, {0, 0, 1}}};
}

/// The side that side i of the 4g-gon is glued to.
std::size_t partner(std::size_t i, std::size_t sides, SidePairing pairing) {
  if (pairing == SidePairing::Opposite) {
    return (i + sides / 2) % sides;
  }
  return i % 4 < 2 ? i + 2 : i - 2;
}

/// Uniform in [0, 1) by the top 53 bits: unlike the standard's distributions, the same everywhere.
double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

}  // namespace

Domain sphere_domain() {
  Domain out;
  out.area = 4 * std::numbers::pi;
  return out;
}

Domain torus_domain(const CentralPoint& a, const CentralPoint& b) {
  const double det = cross(a, b);
  if (!std::isfinite(det) || !(std::abs(det) > flat_sine * norm(a) * norm(b))) {
    throw InvalidInput(
        fmt::format("the lattice of ({:g}, {:g}) and ({:g}, {:g}) does not span the plane; give "
                    "two vectors that are not parallel",
                    a[0], a[1], b[0], b[1]));
  }
  // The parallelogram is the same with -b.
  const double x = a[0], y = a[1], s = det < 0 ? -1 : 1, u = s * b[0], v = s * b[1];
  Domain out;
  out.kind = DomainKind::Torus;
  out.kappa = 0;
  out.polygon = {{(-x - u) / 2, (-y - v) / 2},
                 {(x - u) / 2, (y - v) / 2},
                 {(x + u) / 2, (y + v) / 2},
                 {(u - x) / 2, (v - y) / 2}};
  out.across = {translation({-u, -v}), translation({x, y}), translation({u, v}),
                translation({-x, -y})};
  out.genus = 1;
  out.area = std::abs(det);
  return out;
}

Domain polygon_domain(double kappa, std::vector<CentralPoint> corners) {
  check_corners(kappa, corners);
  make_convex(corners);
  Domain out;
  out.kind = kappa < 0 ? DomainKind::HyperbolicPolygon : DomainKind::PlanePolygon;
  out.kappa = kappa;
  out.polygon = std::move(corners);
  out.area = polygon_area(out);
  if (!(out.area > 0 && std::isfinite(out.area))) {
    throw InvalidInput(fmt::format(
        "the polygon's area is {} in doubles; give corners of like size that do not lie on "
        "one line",
        out.area));
  }
  return out;
}

Domain surface_domain(int genus, SidePairing pairing) {
  if (genus < 2) {
    throw InvalidInput(fmt::format(
        "a hyperbolic surface of genus {}; genus 2 or more (the torus is genus 1)", genus));
  }
  // The triangle of centre, corner and middle of a side has the angles pi/4g twice and pi/2:
  // cosh of the apothem is cot(pi/4g), of the radius its square.
  const auto sides = 4 * static_cast<std::size_t>(genus);
  const double step = 2 * std::numbers::pi / static_cast<double>(sides);
  const double tan = std::tan(step / 2), cosh = 1 / tan;
  const double sinh = std::sqrt((1 - tan) * (1 + tan)) / tan;
  const double radius = std::sqrt((1 - tan * tan) * (1 + tan * tan));
  Domain out;
  out.kind = DomainKind::HyperbolicSurface;
  out.kappa = -1;
  std::vector<Frame> along;  // at the middle of each side
  for (std::size_t i = 0; i < sides; ++i) {
    const double middle = step * static_cast<double>(i), corner = middle - step / 2;
    out.polygon.push_back({radius * std::cos(corner), radius * std::sin(corner)});
    const double c = std::cos(middle), s = std::sin(middle);
    along.push_back({-1, {sinh * c, sinh * s, cosh}, {-s, c, 0}});
  }
  for (std::size_t i = 0; i < sides; ++i) {
    const ModelPoint& e = along[i].E1;
    out.across.push_back(
        taking(along[partner(i, sides, pairing)], {-1, along[i].P, {-e[0], -e[1], 0}}));
  }
  out.genus = genus;
  out.area = 4 * std::numbers::pi * (genus - 1);
  return out;
}

bool is_closed(const Domain& domain) {
  return domain.kind != DomainKind::PlanePolygon && domain.kind != DomainKind::HyperbolicPolygon;
}

CentralPoint central_point(const ModelPoint& p) {
  return {p[0] / p[2], p[1] / p[2]};
}

ModelPoint model_point(double kappa, const CentralPoint& k) {
  return model_point(Frame{kappa}, from_central({kappa}, k[0], k[1]));
}

std::vector<ModelPoint> model_corners(const Domain& domain) {
  std::vector<ModelPoint> out;
  for (const CentralPoint& k : domain.polygon) {
    out.push_back(model_point(domain.kappa, k));
  }
  return out;
}

Frame central_frame(const Domain& domain) {
  CentralPoint mean{};
  if (domain.across.empty()) {
    const auto n = static_cast<double>(domain.polygon.size());
    for (const CentralPoint& k : domain.polygon) {
      mean[0] += k[0] / n, mean[1] += k[1] / n;
    }
  }
  return frame_at(domain.kappa, model_point(domain.kappa, mean));
}

bool contains(const Domain& domain, const ModelPoint& p) {
  const double x = p[0], y = p[1], z = p[2];
  const double off = z * z + domain.kappa * (x * x + y * y) - 1;
  if (!(std::abs(off) <= model_tolerance * std::max(1.0, z * z)) || !std::isfinite(x + y)) {
    return false;
  }
  return domain.polygon.empty() || (z > 0 && worst_side(domain.polygon, central_point(p)).second <=
                                                 side_tolerance * largest_norm(domain.polygon));
}

ModelPoint into_polygon(const Domain& domain, const ModelPoint& p) {
  ModelPoint out = p;
  if (domain.across.empty()) {
    return out;
  }
  const double tolerance = side_tolerance * largest_norm(domain.polygon);
  for (int crossing = 0; crossing < most_crossings; ++crossing) {
    const auto [side, outside] = worst_side(domain.polygon, central_point(out));
    if (outside <= tolerance) {
      return out;
    }
    const ModelMatrix back = inverse_isometry(domain.kappa, domain.across[side]);
    out = on_model(domain.kappa, transformed(back, out));
  }
  throw NumericalError(
      fmt::format("the point ({:g}, {:g}, {:g}) is too far from the fundamental polygon; give one "
                  "nearer to it",
                  p[0], p[1], p[2]));
}

PointSampler::PointSampler(const Domain& domain) : frame_(Frame{domain.kappa}) {
  if (domain.polygon.empty()) {
    return;
  }
  frame_ = central_frame(domain);
  for (const ModelPoint& p : model_corners(domain)) {
    corners_.push_back(offset_in(frame_, p));
  }
  double sum = 0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    sum += central_triangle_area({domain.kappa}, corners_[i], corners_[(i + 1) % corners_.size()]);
    until_.push_back(sum);
  }
}

ModelPoint PointSampler::operator()(std::mt19937_64& random) const {
  // Archimedes: the area of an angle's sector is proportional to h, in each of the three spaces.
  const double a = uniform(random), b = uniform(random);
  if (corners_.empty()) {
    const double angle = 2 * std::numbers::pi * a, h = 2 * b, r = std::sqrt(h * (2 - h));
    return model_point(frame_, {r * std::cos(angle), r * std::sin(angle), h});
  }
  const double area = a * until_.back();
  const auto at = std::upper_bound(until_.begin(), until_.end() - 1, area) - until_.begin();
  const auto i = static_cast<std::size_t>(at);
  return in_triangle(i, area - (i == 0 ? 0 : until_[i - 1]), b);
}

ModelPoint PointSampler::in_triangle(std::size_t i, double area, double height) const {
  // Bisection for the place on the side up to which the triangle has the area; then the height.
  const Space s{frame_.kappa};
  const Offset &u = corners_[i], &v = corners_[(i + 1) % corners_.size()];
  const double uz = model_z(s, u), vz = model_z(s, v);
  const auto on_side = [&](double t) {
    return from_central(s, (1 - t) * u.x / uz + t * v.x / vz, (1 - t) * u.y / uz + t * v.y / vz);
  };
  double low = 0, high = 1;
  for (int bit = 0; bit < 52; ++bit) {
    const double middle = (low + high) / 2;
    (central_triangle_area(s, u, on_side(middle)) < area ? low : high) = middle;
  }
  const Offset end = on_side(low);
  const double h = height * end.h, r = std::hypot(end.x, end.y);
  const double scale = std::sqrt(h * (2 - s.kappa * h)) / r;
  return model_point(frame_, {scale * end.x, scale * end.y, h});
}

std::vector<ModelPoint> random_points(const Domain& domain, std::size_t n, std::uint64_t seed) {
  const PointSampler sample(domain);
  std::mt19937_64 random(seed);
  std::vector<ModelPoint> out;
  while (out.size() < n) {
    out.push_back(sample(random));
  }
  return out;
}

}  // namespace ucvt
