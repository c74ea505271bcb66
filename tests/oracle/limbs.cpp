#include "oracle/limbs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace ucvt::oracle {
namespace {

/// Radius of a tube of girth 1, and of the body that arms grow from.
constexpr double tube_radius = 0.5 * std::numbers::inv_pi, body_radius = 2.5 * tube_radius;

Position operator+(const Position& p, const Position& q) {
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}

Position operator*(double s, const Position& p) {
  return {s * p[0], s * p[1], s * p[2]};
}

double dot(const Position& p, const Position& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

Position unit(const Position& p) {
  return (1 / std::sqrt(dot(p, p))) * p;
}

/// Closes a ring of vertices, counterclockwise as seen from outside, by a tube along `axis` that starts
/// from the plane through `centre` and ends in a hemisphere.
void grow_tube(TriangleMesh& mesh, std::vector<std::int32_t> ring, const Position& centre,
               const Position& axis, double length) {
  const std::size_t n = ring.size();
  std::vector<Position> outward;
  for (const std::int32_t v : ring) {
    const Position p = mesh.positions[static_cast<std::size_t>(v)] + -1.0 * centre;
    outward.push_back(unit(p + -dot(p, axis) * axis));
  }
  const auto new_ring = [&](double height, double radius) {
    std::vector<std::int32_t> next;
    for (std::size_t i = 0; i < n; ++i) {
      next.push_back(static_cast<std::int32_t>(mesh.positions.size()));
      mesh.positions.push_back(centre + height * axis + radius * outward[i]);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      mesh.faces.push_back({ring[i], ring[j], next[j]});
      mesh.faces.push_back({ring[i], next[j], next[i]});
    }
    ring = std::move(next);
  };
  const int rings = static_cast<int>(std::ceil(length * static_cast<double>(n)));
  for (int r = 1; r <= rings; ++r) {
    new_ring(length * r / rings, tube_radius);
  }
  const int caps = static_cast<int>(n) / 4;
  for (int r = 1; r < caps; ++r) {
    const double a = std::numbers::pi / 2 * r / caps;
    new_ring(length + tube_radius * std::sin(a), tube_radius * std::cos(a));
  }
  const auto top = static_cast<std::int32_t>(mesh.positions.size());
  mesh.positions.push_back(centre + (length + tube_radius) * axis);
  for (std::size_t i = 0; i < n; ++i) {
    mesh.faces.push_back({ring[i], ring[(i + 1) % n], top});
  }
}

/// Splits every face in four, and says of which face each new one is a part.
void split_in_four(TriangleMesh& mesh, std::vector<std::size_t>& part_of) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middle;
  const auto middle_of = [&](std::int32_t a, std::int32_t b) {
    const auto [at, is_new] = middle.try_emplace(std::pair(std::minmax(a, b)),
                                                 static_cast<std::int32_t>(mesh.positions.size()));
    if (is_new) {
      mesh.positions.push_back(mesh.positions[static_cast<std::size_t>(a)] +
                               mesh.positions[static_cast<std::size_t>(b)]);
      mesh.positions.back() = 0.5 * mesh.positions.back();
    }
    return at->second;
  };
  std::vector<Corners> faces;
  std::vector<std::size_t> parts;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto [a, b, c] = mesh.faces[f];
    const std::int32_t ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
    for (const Corners& part : {Corners{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      faces.push_back(part);
    }
    parts.insert(parts.end(), 4, part_of[f]);
  }
  mesh.faces = std::move(faces);
  part_of = std::move(parts);
}

/// The boundary of some faces that form a disk, in its faces' sense.
std::vector<std::int32_t> rim(const std::vector<Corners>& disk) {
  std::set<std::pair<std::int32_t, std::int32_t>> sides;
  for (const Corners& f : disk) {
    for (std::size_t i = 0; i < 3; ++i) {
      sides.insert({f[i], f[(i + 1) % 3]});
    }
  }
  std::map<std::int32_t, std::int32_t> next;
  for (const auto& [a, b] : sides) {
    if (!sides.contains({b, a})) {
      next[a] = b;
    }
  }
  std::vector<std::int32_t> out{next.begin()->first};
  while (next[out.back()] != out.front()) {
    out.push_back(next[out.back()]);
  }
  return out;
}

/// Drops vertices that no face uses.
TriangleMesh compact(const TriangleMesh& mesh) {
  TriangleMesh out;
  std::map<std::int32_t, std::int32_t> number;
  for (Corners f : mesh.faces) {
    for (std::int32_t& v : f) {
      const auto [at, is_new] =
          number.try_emplace(v, static_cast<std::int32_t>(out.positions.size()));
      if (is_new) {
        out.positions.push_back(mesh.positions[static_cast<std::size_t>(v)]);
      }
      v = at->second;
    }
    out.faces.push_back(f);
  }
  return out;
}

}  // namespace

TriangleMesh capped_cylinder(double length, int meridians) {
  TriangleMesh out;
  std::vector<std::int32_t> upwards;
  for (int m = 0; m < meridians; ++m) {
    const double a = 2 * std::numbers::pi * m / meridians;
    out.positions.push_back({tube_radius * std::cos(a), tube_radius * std::sin(a), 0});
    upwards.push_back(m);
  }
  const std::vector<std::int32_t> downwards(upwards.rbegin(), upwards.rend());
  grow_tube(out, upwards, {0, 0, 0}, {0, 0, 1}, length / 2);
  grow_tube(out, downwards, {0, 0, 0}, {0, 0, -1}, length / 2);
  return out;
}

TriangleMesh octopus(double arm_length, int levels) {
  TriangleMesh out{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  for (const std::int32_t x : {0, 1}) {
    for (const std::int32_t y : {2, 3}) {
      for (const std::int32_t z : {4, 5}) {
        const bool even = (x + y + z) % 2 == 0;
        out.faces.push_back({x, even ? y : z, even ? z : y});
      }
    }
  }
  std::vector<std::size_t> part_of(out.faces.size());
  split_in_four(out, part_of);
  for (std::size_t f = 0; f < out.faces.size(); ++f) {
    part_of[f] = f % 4 == 3 ? f / 4 : 8;
  }
  for (int l = 1; l < levels; ++l) {
    split_in_four(out, part_of);
  }
  for (Position& p : out.positions) {
    p = body_radius * unit(p);
  }
  std::array<std::vector<Corners>, 9> parts;
  for (std::size_t f = 0; f < out.faces.size(); ++f) {
    parts[part_of[f]].push_back(out.faces[f]);
  }
  out.faces = parts[8];
  for (std::size_t arm = 0; arm < 8; ++arm) {
    Position centre{};
    const std::vector<std::int32_t> base = rim(parts[arm]);
    for (const std::int32_t v : base) {
      centre = centre + out.positions[static_cast<std::size_t>(v)];
    }
    const Position axis = unit(centre);
    grow_tube(out, base, body_radius * axis, axis, arm_length);
  }
  return compact(out);
}

}  // namespace ucvt::oracle
