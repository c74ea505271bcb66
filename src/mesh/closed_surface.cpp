#include <algorithm>
#include <string>
#include <utility>

#include "mesh/faults.h"
#include "mesh/invalid.h"
#include "mesh/mesh_parts.h"
#include "mesh/topology.h"
#include "mesh/vertex_welder.h"
#include "ucvt/components.h"

namespace ucvt {
namespace {

[[noreturn]] void refuse_faults(const std::string& faults, const TriangleMesh& mesh,
                                const Topology& found) {
  if (mesh.faces.empty()) {
    refuse("{}; give a mesh with triangles or polygons", faults);
  }
  if (may_be_repaired(found) && found.counts.orientable) {
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

template <class Surface>
Surface make_surface(MeshPart&& part, const Topology& found) {
  Surface surface;
  const std::int64_t loops = found.counts.boundary_loops;
  surface.genus = static_cast<int>((2 - loops - found.counts.euler_number) / 2);
  surface.mesh = std::move(part.mesh);
  surface.input_vertex = std::move(part.input_vertex);
  surface.reoriented_faces = turn_faces(found.turned, surface.mesh.faces);
  return surface;
}

/// Whether the mesh is open only because one place has several vertices.
bool closes_when_welded(const TriangleMesh& mesh) {
  if (survey(mesh).coincident_vertices == 0) {
    return false;
  }
  VertexWelder welder(mesh.positions.size());
  TriangleMesh welded;
  for (const Corners& f : mesh.faces) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = welder.number(mesh.positions[static_cast<std::size_t>(f[i])]);
    }
    welded.faces.push_back(corners);
  }
  welded.positions = std::move(welder.positions());
  return analyze_topology(welded).counts.boundary_edges == 0;
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
    components.push_back(
        {make_surface<ClosedSurface>(std::move(part), own), std::move(input_face)});
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

bool has_boundary(const TriangleMesh& mesh) {
  return analyze_topology(mesh).boundary_side >= 0 && !closes_when_welded(mesh);
}

OpenSurface open_surface(const TriangleMesh& mesh) {
  const Topology found = analyze_topology(mesh);
  if (!describe_faults(mesh, found, false).empty()) {
    refuse_faults(describe_faults(mesh, found), mesh, found);
  }
  if (found.boundary_side < 0) {
    refuse("the surface is closed; treat it as a closed one");
  }
  if (closes_when_welded(mesh)) {
    refuse("the surface is open only because vertices repeat places of others; try --repair");
  }
  std::vector<MeshPart> parts = split_into_components(mesh);
  if (parts.size() > 1) {
    refuse("the open surface has {} components; give them one at a time", parts.size());
  }
  auto surface = make_surface<OpenSurface>(std::move(parts.front()), found);
  surface.boundary_loops = static_cast<int>(found.counts.boundary_loops);
  return surface;
}

}  // namespace ucvt
