#include "oracle/meshes.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <utility>

namespace ucvt::oracle {
namespace {

constexpr double pi = std::numbers::pi;

Position on_unit_sphere(const Position& p) {
  const double r = std::hypot(p[0], p[1], p[2]);
  return {p[0] / r, p[1] / r, p[2] / r};
}

TriangleMesh inscribed(std::vector<Position> positions, std::vector<Corners> faces) {
  for (Position& p : positions) {
    p = on_unit_sphere(p);
  }
  return {std::move(positions), std::move(faces)};
}

/// Turns a profile of (radius, height), from the south pole up, about the z axis; both ends of the
/// profile lie on the axis.
TriangleMesh revolved(const std::vector<std::array<double, 2>>& profile, int meridians) {
  TriangleMesh out;
  const int rings = static_cast<int>(profile.size()) - 2;
  out.positions.push_back({0, 0, profile.front()[1]});
  for (int r = 1; r <= rings; ++r) {
    for (int m = 0; m < meridians; ++m) {
      const double angle = 2 * pi * m / meridians;
      const auto& [radius, height] = profile[static_cast<std::size_t>(r)];
      out.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
  }
  out.positions.push_back({0, 0, profile.back()[1]});
  const std::int32_t top = 1 + rings * meridians;
  for (int m = 0; m < meridians; ++m) {
    const int n = (m + 1) % meridians;
    const auto at = [&](int ring, int meridian) { return 1 + (ring - 1) * meridians + meridian; };
    out.faces.push_back({0, at(1, n), at(1, m)});
    for (int r = 1; r < rings; ++r) {
      out.faces.push_back({at(r, m), at(r, n), at(r + 1, n)});
      out.faces.push_back({at(r, m), at(r + 1, n), at(r + 1, m)});
    }
    out.faces.push_back({at(rings, m), at(rings, n), top});
  }
  return out;
}

}  // namespace

TriangleMesh tetrahedron() {
  return inscribed({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                   {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

TriangleMesh cube() {
  std::vector<Position> p;
  for (int i = 0; i < 8; ++i) {
    p.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  }
  std::vector<Corners> f;
  for (const std::array<std::int32_t, 4> q : {std::array<std::int32_t, 4>{0, 2, 3, 1},
                                              {4, 5, 7, 6},
                                              {0, 1, 5, 4},
                                              {2, 6, 7, 3},
                                              {0, 4, 6, 2},
                                              {1, 3, 7, 5}}) {
    f.push_back({q[0], q[1], q[2]});
    f.push_back({q[0], q[2], q[3]});
  }
  return inscribed(std::move(p), std::move(f));
}

TriangleMesh octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

TriangleMesh icosahedron() {
  const double g = std::numbers::phi;
  return inscribed(
      {{-1, g, 0},
       {1, g, 0},
       {-1, -g, 0},
       {1, -g, 0},
       {0, -1, g},
       {0, 1, g},
       {0, -1, -g},
       {0, 1, -g},
       {g, 0, -1},
       {g, 0, 1},
       {-g, 0, -1},
       {-g, 0, 1}},
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}});
}

TriangleMesh icosphere(int levels) {
  TriangleMesh mesh = icosahedron();
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middle;
    const auto between = [&](std::int32_t a, std::int32_t b) {
      const auto [at, is_new] = middle.try_emplace(
          {std::min(a, b), std::max(a, b)}, static_cast<std::int32_t>(mesh.positions.size()));
      if (is_new) {
        const Position p = mesh.positions[static_cast<std::size_t>(a)];
        const Position q = mesh.positions[static_cast<std::size_t>(b)];
        mesh.positions.push_back(on_unit_sphere({p[0] + q[0], p[1] + q[1], p[2] + q[2]}));
      }
      return at->second;
    };
    std::vector<Corners> finer;
    for (const auto& [a, b, c] : mesh.faces) {
      const std::int32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.faces = std::move(finer);
  }
  return mesh;
}

TriangleMesh grid_torus(int n, int m, double minor) {
  TriangleMesh out;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double a = 2 * pi * i / n, b = 2 * pi * j / m, r = 1 + minor * std::cos(b);
      out.positions.push_back({r * std::cos(a), r * std::sin(a), minor * std::sin(b)});
      const auto at = [&](int p, int q) { return (p % n) * m + q % m; };
      out.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      out.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return out;
}

TriangleMesh seven_vertex_torus() {
  TriangleMesh out;
  for (std::int32_t i = 0; i < 7; ++i) {
    const double a = i;
    out.positions.push_back({std::cos(2 * a), std::sin(3 * a), std::cos(5 * a + 1)});
    out.faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    out.faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return out;
}

TriangleMesh voxel_frame(int holes) {
  using Cell = std::array<int, 3>;
  std::set<Cell> solid;
  for (int x = 0; x < 2 * holes + 1; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (!(y == 1 && x % 2 == 1)) {
        solid.insert({x, y, 0});
      }
    }
  }
  TriangleMesh out;
  std::map<Cell, std::int32_t> number;
  const auto corner = [&](const Cell& c) {
    const auto [at, is_new] =
        number.try_emplace(c, static_cast<std::int32_t>(out.positions.size()));
    if (is_new) {
      out.positions.push_back(
          {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])});
    }
    return at->second;
  };
  for (const Cell& cell : solid) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell beside = cell;
        beside[axis] += 2 * side - 1;
        if (solid.contains(beside)) {
          continue;
        }
        const std::size_t u = (axis + (side == 1 ? 1 : 2)) % 3,
                          v = (axis + (side == 1 ? 2 : 1)) % 3;
        Cell a = cell;
        a[axis] += side;
        Cell b = a, c = a, d = a;
        ++b[u], ++c[u], ++c[v], ++d[v];
        out.faces.push_back({corner(a), corner(b), corner(c)});
        out.faces.push_back({corner(a), corner(c), corner(d)});
      }
    }
  }
  return out;
}

TriangleMesh latitude_sphere(int rings, int meridians) {
  std::vector<std::array<double, 2>> profile;
  for (int r = 0; r <= rings + 1; ++r) {
    const double a = pi * r / (rings + 1);
    profile.push_back({std::sin(a), -std::cos(a)});
  }
  return revolved(profile, meridians);
}

TriangleMesh finger(double length, double radius, int meridians) {
  std::vector<std::array<double, 2>> profile;
  const double last = pi - std::asin(radius);
  for (int r = 0; r <= 8; ++r) {
    profile.push_back({std::sin(last * r / 8), -std::cos(last * r / 8)});
  }
  const double step = 2 * pi * radius / meridians;
  const int rings = static_cast<int>(std::ceil(length / step));
  for (int r = 1; r <= rings; ++r) {
    profile.push_back({radius, profile[8][1] + length * r / rings});
  }
  profile.push_back({0, profile.back()[1] + radius / 2});
  return revolved(profile, meridians);
}

TriangleMesh bumpy(TriangleMesh mesh, double amplitude, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (Position& p : mesh.positions) {
    for (double& x : p) {
      x += amplitude * (static_cast<double>(random() >> 11) * 0x1.0p-52 - 1);
    }
  }
  return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Position& p : mesh.positions) {
    for (double& x : p) {
      x *= factor;
    }
  }
  return mesh;
}

ClosedSurface closed(const TriangleMesh& mesh) {
  return closed_surface(mesh);
}

}  // namespace ucvt::oracle
