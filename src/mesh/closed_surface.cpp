#include <algorithm>
#include <string>
#include <utility>

#include "mesh/invalid.h"
#include "mesh/topology.h"
#include "mesh/vertex_welder.h"
#include "ucvt/mesh.h"

namespace ucvt {
namespace {

std::string edge_name(const TriangleMesh& mesh, std::int32_t side) {
  const std::int32_t tail = side_tail(mesh, side), head = side_head(mesh, side);
  return fmt::format("edge {}-{}", std::min(tail, head), std::max(tail, head));
}

// Whether the mesh is open only because one place has several vertices; sets how many too many.
bool closes_when_welded(const TriangleMesh& mesh, std::int64_t& coincident) {
  const MeshSurvey counts = survey(mesh);
  coincident = counts.coincident_vertices;
  if (coincident == 0) {
    return false;
  }
  VertexWelder welder(mesh.positions.size());
  TriangleMesh welded;
  welded.faces.reserve(mesh.faces.size());
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

void refuse_unwelded(const TriangleMesh& mesh, const Topology& found) {
  std::int64_t coincident = 0;
  if (closes_when_welded(mesh, coincident)) {
    refuse(
        "the surface is open only because {} (such as {} on a boundary); weld coincident "
        "vertices",
        counted(coincident, "vertex repeats the place of another one",
                "vertices repeat the place of another one"),
        edge_name(mesh, found.boundary_side));
  }
}

[[noreturn]] void refuse_boundary(const TriangleMesh& mesh, const Topology& found) {
  refuse_unwelded(mesh, found);
  refuse(
      "the surface is open: {} has one face (boundary of {} in {}); close the holes, or weld "
      "vertices that should be one (only remesh takes open surfaces)",
      edge_name(mesh, found.boundary_side), counted(found.counts.boundary_edges, "edge", "edges"),
      counted(found.counts.boundary_loops, "loop", "loops"));
}

[[noreturn]] void refuse_not_orientable(const Topology& found) {
  const std::int64_t euler = found.counts.euler_number;
  const std::string name = euler == 1 ? "a projective plane, Euler number 1"
                           : euler == 0
                               ? "a Klein bottle, Euler number 0"
                               : fmt::format("a non-orientable surface of Euler number {}", euler);
  refuse("the surface is not orientable: it is {}; give a surface with two sides", name);
}

enum class Boundary : char { Refused, Required };

void refuse_faults(const TriangleMesh& mesh, const Topology& found, Boundary boundary) {
  if (mesh.faces.empty()) {
    refuse("there are no faces; give a mesh with triangles or polygons");
  }
  if (found.repeated_corner_face >= 0) {
    const Corners& f = mesh.faces[static_cast<std::size_t>(found.repeated_corner_face)];
    refuse("face {} has a repeated corner: {} {} {}; remove such faces ({} in all)",
           found.repeated_corner_face, f[0], f[1], f[2], found.counts.repeated_corner_faces);
  }
  if (found.duplicate_face >= 0) {
    const Corners& f = mesh.faces[static_cast<std::size_t>(found.duplicate_face)];
    refuse("face {} is a duplicate of face {}: {} {} {}; remove such faces ({} in all)",
           found.duplicate_face, found.duplicate_of, f[0], f[1], f[2],
           found.counts.duplicate_faces);
  }
  if (found.nonmanifold_side >= 0) {
    refuse(
        "{} is not manifold: {} faces meet there ({} in all); split the mesh at such edges or "
        "remove the extra faces",
        edge_name(mesh, found.nonmanifold_side), found.nonmanifold_side_faces,
        counted(found.counts.nonmanifold_edges, "such edge", "such edges"));
  }
  if (found.boundary_side >= 0 && boundary == Boundary::Refused) {
    refuse_boundary(mesh, found);
  }
  if (found.nonmanifold_vertex >= 0) {
    refuse(
        "vertex {} is not manifold: {} fans of faces meet there ({} in all); give each fan its "
        "own vertex",
        found.nonmanifold_vertex, found.nonmanifold_vertex_fans,
        counted(found.counts.nonmanifold_vertices, "such vertex", "such vertices"));
  }
  if (found.counts.components > 1) {
    refuse("the surface has {} components; give them one at a time", found.counts.components);
  }
  if (!found.counts.orientable) {
    refuse_not_orientable(found);
  }
  if (boundary == Boundary::Required) {
    refuse_unwelded(mesh, found);
    if (found.boundary_side < 0) {
      refuse("the surface is closed; treat it as a closed one");
    }
  }
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

/// What closed and open surfaces have in common: used vertices and turned faces.
template <class Surface>
Surface taken_over(const TriangleMesh& mesh, const Topology& found) {
  Surface surface;
  std::vector<std::int32_t> number(mesh.positions.size(), -1);
  for (const Corners& f : mesh.faces) {
    for (const std::int32_t v : f) {
      number[static_cast<std::size_t>(v)] = 0;
    }
  }
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) {
      continue;
    }
    number[v] = static_cast<std::int32_t>(surface.input_vertex.size());
    surface.input_vertex.push_back(static_cast<std::int32_t>(v));
    surface.mesh.positions.push_back(mesh.positions[v]);
  }
  surface.mesh.faces = mesh.faces;
  for (Corners& f : surface.mesh.faces) {
    for (std::int32_t& v : f) {
      v = number[static_cast<std::size_t>(v)];
    }
  }
  surface.reoriented_faces = turn_faces(found.turned, surface.mesh.faces);
  return surface;
}

}  // namespace

ClosedSurface closed_surface(const TriangleMesh& mesh) {
  const Topology found = analyze_topology(mesh);
  refuse_faults(mesh, found, Boundary::Refused);
  auto surface = taken_over<ClosedSurface>(mesh, found);
  surface.genus = static_cast<int>((2 - found.counts.euler_number) / 2);
  return surface;
}

bool has_boundary(const TriangleMesh& mesh) {
  std::int64_t coincident = 0;
  return analyze_topology(mesh).boundary_side >= 0 && !closes_when_welded(mesh, coincident);
}

OpenSurface open_surface(const TriangleMesh& mesh) {
  const Topology found = analyze_topology(mesh);
  refuse_faults(mesh, found, Boundary::Required);
  auto surface = taken_over<OpenSurface>(mesh, found);
  const std::int64_t loops = found.counts.boundary_loops;
  surface.genus = static_cast<int>((2 - loops - found.counts.euler_number) / 2);
  surface.boundary_loops = static_cast<int>(loops);
  return surface;
}

}  // namespace ucvt
