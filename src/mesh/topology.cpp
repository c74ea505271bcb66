#include "mesh/topology.h"

#include <algorithm>

#include "mesh/disjoint_sets.h"

namespace ucvt {
namespace {

class Analysis {
 public:
  explicit Analysis(const TriangleMesh& mesh) : mesh_(mesh), edges_(mesh) {}
  Topology run();

 private:
  void count_vertices_and_components();
  void count_edges();
  void count_boundary_loops();
  void find_duplicates(std::span<const EdgeSide> sides);
  void count_fans();
  void orient();
  void orient_from(std::size_t first, std::vector<bool>& seen);

  const TriangleMesh& mesh_;
  EdgeGroups edges_;
  Topology result_;
  std::vector<std::int32_t> twin_;  // of each side, -1 unless its edge has two faces
};

void Analysis::count_vertices_and_components() {
  DisjointSets sets(mesh_.positions.size());
  std::vector<bool> used(mesh_.positions.size(), false);
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    const Corners& corners = mesh_.faces[f];
    for (const std::int32_t v : corners) {
      used[static_cast<std::size_t>(v)] = true;
    }
    sets.join(corners[0], corners[1]);
    sets.join(corners[0], corners[2]);
    if (!has_repeated_corner(corners)) {
      continue;
    }
    if (result_.counts.repeated_corner_faces++ == 0) {
      result_.repeated_corner_face = static_cast<std::int32_t>(f);
    }
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    const auto vertex = static_cast<std::int32_t>(v);
    if (!used[v]) {
      ++result_.counts.unused_vertices;
    } else if (sets.find(vertex) == vertex) {
      ++result_.counts.components;
    }
  }
  result_.counts.vertices = static_cast<std::int64_t>(used.size()) - result_.counts.unused_vertices;
}

// Faces with the same three vertices share the edge of the two least, and the vertex opposite.
void Analysis::find_duplicates(std::span<const EdgeSide> sides) {
  std::vector<std::pair<std::int32_t, std::int32_t>> opposite;  // vertex, face
  for (const EdgeSide& s : sides) {
    const std::int32_t apex = side_apex(mesh_, s.side);
    if (apex > s.high) {
      opposite.emplace_back(apex, s.side / 3);
    }
  }
  std::sort(opposite.begin(), opposite.end());
  for (std::size_t i = 1; i < opposite.size(); ++i) {
    if (opposite[i].first != opposite[i - 1].first) {
      continue;
    }
    if (result_.counts.duplicate_faces++ == 0) {
      result_.duplicate_face = opposite[i].second;
      result_.duplicate_of = opposite[i - 1].second;
    }
  }
}

void Analysis::count_edges() {
  twin_.assign(3 * mesh_.faces.size(), -1);
  MeshSurvey& counts = result_.counts;
  for (std::int64_t e = 0; e < edges_.size(); ++e) {
    const auto sides = edges_.sides(e);
    if (sides.size() == 1) {
      if (counts.boundary_edges++ == 0) {
        result_.boundary_side = sides[0].side;
      }
      continue;
    }
    const bool different =
        sides.size() == 2 && side_apex(mesh_, sides[0].side) != side_apex(mesh_, sides[1].side);
    if (!different) {
      find_duplicates(sides);
    }
    if (sides.size() == 2) {
      const std::int32_t a = sides[0].side, b = sides[1].side;
      twin_[static_cast<std::size_t>(a)] = b;
      twin_[static_cast<std::size_t>(b)] = a;
      if (side_tail(mesh_, a) == side_tail(mesh_, b)) {
        ++counts.misoriented_edges;
      }
    } else if (counts.nonmanifold_edges++ == 0) {
      result_.nonmanifold_side = sides[0].side;
      result_.nonmanifold_side_faces = static_cast<std::int64_t>(sides.size());
    }
  }
}

void Analysis::count_boundary_loops() {
  if (result_.counts.boundary_edges == 0) {
    return;
  }
  DisjointSets sets(mesh_.positions.size());
  std::vector<bool> on_boundary(mesh_.positions.size(), false);
  for (std::int64_t e = 0; e < edges_.size(); ++e) {
    const auto sides = edges_.sides(e);
    if (sides.size() != 1) {
      continue;
    }
    const std::int32_t a = side_tail(mesh_, sides[0].side), b = side_head(mesh_, sides[0].side);
    on_boundary[static_cast<std::size_t>(a)] = on_boundary[static_cast<std::size_t>(b)] = true;
    sets.join(a, b);
  }
  for (std::size_t v = 0; v < on_boundary.size(); ++v) {
    const auto vertex = static_cast<std::int32_t>(v);
    if (on_boundary[v] && sets.find(vertex) == vertex) {
      ++result_.counts.boundary_loops;
    }
  }
}

// The corners at a vertex fall into fans, joined through its edges; a manifold vertex has one. An
// edge of three faces or more joins them all: it is a fault of its own.
void Analysis::count_fans() {
  DisjointSets corners(3 * mesh_.faces.size());
  // The corner of a side's face that lies at `vertex`, one of the side's two.
  const auto corner_at = [this](std::int32_t side, std::int32_t vertex) {
    return side_tail(mesh_, side) == vertex ? side : side - side % 3 + (side % 3 + 1) % 3;
  };
  for (std::int64_t e = 0; e < edges_.size(); ++e) {
    const auto sides = edges_.sides(e);
    const std::int32_t ends[2] = {side_tail(mesh_, sides[0].side), side_head(mesh_, sides[0].side)};
    for (std::size_t k = 1; k < sides.size(); ++k) {
      for (const std::int32_t v : ends) {
        corners.join(corner_at(sides[0].side, v), corner_at(sides[k].side, v));
      }
    }
  }
  std::vector<std::int32_t> fans(mesh_.positions.size(), 0);
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    if (has_repeated_corner(mesh_.faces[f])) {
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto corner = static_cast<std::int32_t>(3 * f + i);
      if (corners.find(corner) == corner) {
        ++fans[static_cast<std::size_t>(mesh_.faces[f][i])];
      }
    }
  }
  for (std::size_t v = 0; v < fans.size(); ++v) {
    if (fans[v] < 2) {
      continue;
    }
    if (result_.counts.nonmanifold_vertices++ == 0) {
      result_.nonmanifold_vertex = static_cast<std::int32_t>(v);
      result_.nonmanifold_vertex_fans = fans[v];
    }
  }
}

void Analysis::orient_from(std::size_t first, std::vector<bool>& seen) {
  seen[first] = true;
  std::vector<std::size_t> stack{first};
  while (!stack.empty()) {
    const std::size_t face = stack.back();
    stack.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t twin = twin_[3 * face + i];
      if (twin < 0) {
        continue;
      }
      const std::size_t other = face_of(twin);
      const bool along = side_tail(mesh_, twin) == mesh_.faces[face][i];
      const bool turned = result_.turned[face] != along;
      if (seen[other]) {
        result_.counts.orientable = result_.counts.orientable && result_.turned[other] == turned;
        continue;
      }
      seen[other] = true;
      result_.turned[other] = turned;
      stack.push_back(other);
    }
  }
}

void Analysis::orient() {
  const std::size_t faces = mesh_.faces.size();
  result_.turned.assign(faces, false);
  std::vector<bool> seen(faces, false);
  for (std::size_t first = 0; first < faces; ++first) {
    if (!seen[first]) {
      orient_from(first, seen);
    }
  }
}

Topology Analysis::run() {
  result_.counts.faces = static_cast<std::int64_t>(mesh_.faces.size());
  result_.counts.edges = edges_.size();
  count_vertices_and_components();
  result_.counts.euler_number =
      result_.counts.vertices - result_.counts.edges + result_.counts.faces;
  count_edges();
  count_boundary_loops();
  count_fans();
  orient();
  return std::move(result_);
}

}  // namespace

Topology analyze_topology(const TriangleMesh& mesh) {
  return Analysis(mesh).run();
}

}  // namespace ucvt
