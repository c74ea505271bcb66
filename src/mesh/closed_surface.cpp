#include <algorithm>
#include <string>
#include <utility>

#include "mesh/faults.h"
#include "mesh/invalid.h"
#include "mesh/mesh_parts.h"
#include "mesh/topology.h"
#include "ucvt/components.h"

namespace ucvt {
namespace {

[[noreturn]] void refuse_faults(const std::string& faults, const TriangleMesh& mesh,
                                const Topology& found) {
  if (mesh.faces.empty()) {
    refuse("{}; give a mesh with triangles or polygons", faults);
  }
  if (may_be_repaired(found)) {
    refuse("{}; try --repair", faults);
  }
  refuse("{}; give a surface with two sides", faults);
}

// Turns the fewer faces round; of equal halves, those that disagree with face 0.
std::int64_t turn_faces(std::vector<bool> turned, std::vector<Corners>& faces) {
  auto count = static_cast<std::size_t>(std::count(turned.begin(), turned.end(), true));
  if (2 * count > faces.size()) {
    turned.flip();
    count = faces.size() - count;
  }
  for (std::size_t f = 0; count > 0 && f < faces.size(); ++f) {
    if (turned[f]) {
      std::swap(faces[f][1], faces[f][2]);
    }
  }
  return static_cast<std::int64_t>(count);
}

ClosedSurface make_surface(MeshPart&& part, const Topology& found) {
  ClosedSurface surface;
  surface.genus = static_cast<int>((2 - found.counts.euler_number) / 2);
  surface.mesh = std::move(part.mesh);
  surface.input_vertex = std::move(part.input_vertex);
  surface.reoriented_faces = turn_faces(found.turned, surface.mesh.faces);
  return surface;
}

}  // namespace

std::vector<Component> closed_components(const TriangleMesh& mesh) {
  const Topology found = analyze_topology(mesh);
  if (const std::string faults = describe_faults(mesh, found); !faults.empty()) {
    refuse_faults(faults, mesh, found);
  }
  std::vector<MeshPart> parts = split_into_components(mesh);
  std::vector<Component> components;
  for (MeshPart& part : parts) {
    const Topology own = parts.size() == 1 ? found : analyze_topology(part.mesh);
    std::vector<std::int32_t> input_face = std::move(part.input_face);
    components.push_back({make_surface(std::move(part), own), std::move(input_face)});
  }
  return components;
}

ClosedSurface closed_surface(const TriangleMesh& mesh) {
  std::vector<Component> components = closed_components(mesh);
  if (components.size() > 1) {
    refuse("the surface has {} components; give them one at a time", components.size());
  }
  return std::move(components.front().surface);
}

}  // namespace ucvt
