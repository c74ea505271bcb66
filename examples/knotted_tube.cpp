// Writes a surface of genus 2 whose sheets nearly touch: a thick ring with a knotted tunnel in it.
//
//   example_knotted_tube OUT.{off,obj,ply,stl} [--gap G]
//
// The tunnel follows a trefoil knot, the curve (2, 3) on a torus of radii 2 and 1, and runs everywhere
// at the same depth G (default 0.08) under the ring's skin, a torus about the same circle. One opening
// joins the tunnel to the outside: skin and tunnel, both of genus 1, become one surface of genus 2.
// Across the wall its points are G apart, along the surface up to the length of the knot.
// Both sheets are grids of quadrilaterals, cut in two; the opening joins a square left out in each.
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iostream>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "ucvt/mesh.h"

namespace {

using ucvt::Position;

constexpr double ring_radius = 2;  ///< of the circle in the middle of the ring
constexpr double knot_radius = 1;  ///< of the torus that the knot lies on
constexpr double tunnel_radius = 0.4;
constexpr int windings = 2, turns = 3;  ///< of the knot, along the ring and round it

constexpr int skin_size[] = {132, 60};    ///< quadrilaterals along the ring and round it
constexpr int tunnel_size[] = {260, 18};  ///< along the knot and round the tunnel
constexpr int opening = 4;                ///< side of the square left out

Position sum(const Position& p, double t, const Position& v) {
  return {p[0] + t * v[0], p[1] + t * v[1], p[2] + t * v[2]};
}

Position cross(const Position& u, const Position& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double norm(const Position& v) {
  return std::hypot(v[0], v[1], v[2]);
}

/// Outward normal of a torus of revolution at longitude u, latitude v.
Position torus_normal(double u, double v) {
  return {std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
}

Position on_torus(double radius, double u, double v) {
  return sum({ring_radius * std::cos(u), ring_radius * std::sin(u), 0}, radius, torus_normal(u, v));
}

/// The tunnel's wall; angle 0 is nearest to the skin.
Position on_tunnel(double along, double angle) {
  const double u = windings * along, v = turns * along;
  const Position normal = torus_normal(u, v);
  const double rho = ring_radius + knot_radius * std::cos(v);
  const Position east{-std::sin(u), std::cos(u), 0};
  const Position north{-std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v)};
  const Position tangent =
      sum({windings * rho * east[0], windings * rho * east[1], 0}, turns * knot_radius, north);
  const Position side = cross(tangent, normal);
  const Position to_axis = on_torus(knot_radius, u, v);
  return sum(sum(to_axis, tunnel_radius * std::cos(angle), normal),
             tunnel_radius * std::sin(angle) / norm(side), side);
}

/// Adds a closed grid without the square about (0, 0); returns the square's rim, counterclockwise.
template <class Point>
std::vector<std::int32_t> add_grid(ucvt::TriangleMesh& mesh, const int (&size)[2], Point point) {
  // Inside the square no vertex is used; `closed_surface` drops those.
  const auto first = static_cast<std::int32_t>(mesh.positions.size());
  const auto at = [&](int i, int j) { return first + (i % size[0]) * size[1] + j % size[1]; };
  for (int i = 0; i < size[0]; ++i) {
    for (int j = 0; j < size[1]; ++j) {
      mesh.positions.push_back(point(2 * std::numbers::pi * (i - opening / 2.0) / size[0],
                                     2 * std::numbers::pi * (j - opening / 2.0) / size[1]));
      if (i >= opening || j >= opening) {
        mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  std::vector<std::int32_t> rim;
  for (int k = 0; k < 4 * opening; ++k) {
    const int step = k % opening;
    const std::array<std::array<int, 2>, 4> corner{
        {{step, 0}, {opening, step}, {opening - step, opening}, {0, opening - step}}};
    const auto& [i, j] = corner[static_cast<std::size_t>(k / opening)];
    rim.push_back(at(i, j));
  }
  return rim;
}

/// Joins two rims by a band, turned so that it is short.
void join(ucvt::TriangleMesh& mesh, const std::vector<std::int32_t>& a,
          const std::vector<std::int32_t>& b) {
  const std::size_t n = a.size();
  const auto opposite = [&](std::size_t i, std::size_t shift) {
    return b[(shift + n - i % n) % n];
  };
  const auto position = [&](std::int32_t v) { return mesh.positions[static_cast<std::size_t>(v)]; };
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t shift = 0; shift < n; ++shift) {
    double length = 0;
    for (std::size_t i = 0; i < n; ++i) {
      length += norm(sum(position(a[i]), -1, position(opposite(i, shift))));
    }
    if (length < least) {
      least = length, best = shift;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::int32_t p = a[i], q = a[(i + 1) % n];
    const std::int32_t r = opposite(i + 1, best), s = opposite(i, best);
    mesh.faces.push_back({p, q, r});
    mesh.faces.push_back({p, r, s});
  }
}

ucvt::TriangleMesh knotted_tube(double gap) {
  ucvt::TriangleMesh mesh;
  const auto skin = add_grid(mesh, skin_size, [&](double u, double v) {
    return on_torus(knot_radius + tunnel_radius + gap, u, v);
  });
  const auto tunnel = add_grid(mesh, tunnel_size, on_tunnel);
  join(mesh, skin, tunnel);
  ucvt::ClosedSurface surface = closed_surface(mesh);
  if (surface.genus != 2) {
    throw std::logic_error("the surface is not of genus 2");
  }
  return surface.mesh;
}

double parse_gap(const std::string& text) {
  double gap = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), gap);
  if (error != std::errc{} || end != text.data() + text.size() || !(gap > 0 && gap <= 0.3)) {
    throw std::invalid_argument("'" + text + "' is not a gap above 0, at most 0.3");
  }
  return gap;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() != 1 && !(words.size() == 3 && words[1] == "--gap")) {
      throw std::invalid_argument("usage: example_knotted_tube OUT.off [--gap G]");
    }
    const double gap = words.size() == 3 ? parse_gap(words[2]) : 0.08;
    const ucvt::TriangleMesh mesh = knotted_tube(gap);
    write_mesh(words[0], mesh);
    std::cout << words[0] << ": " << mesh.positions.size() << " vertices, " << mesh.faces.size()
              << " faces, genus 2\n";
  } catch (const std::invalid_argument& error) {
    std::cerr << "example_knotted_tube: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "example_knotted_tube: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
