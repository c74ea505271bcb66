#include "mesh/mesh_parts.h"

#include "mesh/disjoint_sets.h"

namespace ucvt {

std::vector<MeshPart> split_into_components(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  DisjointSets sets(vertices);
  std::vector<bool> used(vertices, false);
  for (const Corners& f : mesh.faces) {
    sets.join(f[0], f[1]);
    sets.join(f[0], f[2]);
    for (const std::int32_t v : f) {
      used[static_cast<std::size_t>(v)] = true;
    }
  }
  std::vector<MeshPart> parts;
  std::vector<std::int32_t> part(vertices, -1), number(vertices, -1);
  const auto part_of = [&](std::int32_t v) -> std::int32_t& {
    return part[static_cast<std::size_t>(sets.find(v))];
  };
  for (const Corners& f : mesh.faces) {
    if (std::int32_t& p = part_of(f[0]); p < 0) {
      p = static_cast<std::int32_t>(parts.size());
      parts.emplace_back();
    }
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!used[v]) {
      continue;
    }
    MeshPart& p = parts[static_cast<std::size_t>(part_of(static_cast<std::int32_t>(v)))];
    number[v] = static_cast<std::int32_t>(p.input_vertex.size());
    p.input_vertex.push_back(static_cast<std::int32_t>(v));
    p.mesh.positions.push_back(mesh.positions[v]);
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Corners& c = mesh.faces[f];
    MeshPart& p = parts[static_cast<std::size_t>(part_of(c[0]))];
    const auto at = [&](std::size_t i) { return number[static_cast<std::size_t>(c[i])]; };
    p.mesh.faces.push_back({at(0), at(1), at(2)});
    p.input_face.push_back(static_cast<std::int32_t>(f));
  }
  return parts;
}

}  // namespace ucvt
