#include "mesh/faults.h"

#include <algorithm>
#include <vector>

#include <fmt/ranges.h>

#include "mesh/invalid.h"
#include "mesh/mesh_parts.h"
#include "ucvt/repair.h"

namespace ucvt {
namespace {

std::string edge_name(const TriangleMesh& mesh, std::int32_t side) {
  const std::int32_t tail = side_tail(mesh, side), head = side_head(mesh, side);
  return fmt::format("{}-{}", std::min(tail, head), std::max(tail, head));
}

bool has_nonmanifold_element(const Topology& found) {
  return found.repeated_corner_face >= 0 || found.duplicate_face >= 0 ||
         found.nonmanifold_side >= 0 || found.nonmanifold_vertex >= 0;
}

/// A manifold with one side: a sphere with cross-caps, with or without boundary.
std::string name_one_sided(const MeshSurvey& counts) {
  const std::int64_t loops = counts.boundary_loops;
  const std::int64_t crosscaps = 2 - counts.euler_number - loops;
  std::string name = crosscaps == 1   ? "a projective plane"
                     : crosscaps == 2 ? "a Klein bottle"
                                      : fmt::format("a sphere with {} cross-caps", crosscaps);
  if (crosscaps == 1 && loops == 1) {
    name = "a Moebius band";
  } else if (loops > 0) {
    name += fmt::format(" with {}", counted(loops, "hole", "holes"));
  }
  return fmt::format("{}, Euler number {}", name, counts.euler_number);
}

/// The one-sided components by name; how many there are when some are no manifolds.
void add_one_sided(const TriangleMesh& mesh, const Topology& found, std::vector<std::string>& out) {
  if (has_nonmanifold_element(found)) {
    out.emplace_back("a part has one side only");
    return;
  }
  if (found.counts.components == 1) {
    out.push_back(fmt::format("it is {}", name_one_sided(found.counts)));
    return;
  }
  std::int64_t more = -1;
  for (const MeshPart& part : split_into_components(mesh)) {
    const MeshSurvey counts = analyze_topology(part.mesh).counts;
    if (counts.orientable || ++more > 0) {
      continue;
    }
    out.push_back(fmt::format("the component of face {} is {}", part.input_face.front(),
                              name_one_sided(counts)));
  }
  if (more > 0) {
    out.push_back(counted(more, "more component has one side", "more components have one side"));
  }
}

void add_nonmanifold(const TriangleMesh& mesh, const Topology& found,
                     std::vector<std::string>& out) {
  const MeshSurvey& counts = found.counts;
  if (found.repeated_corner_face >= 0) {
    const Corners& f = mesh.faces[static_cast<std::size_t>(found.repeated_corner_face)];
    out.push_back(fmt::format("{} (first face {}: {} {} {})",
                              counted(counts.repeated_corner_faces, "face has a repeated corner",
                                      "faces have a repeated corner"),
                              found.repeated_corner_face, f[0], f[1], f[2]));
  }
  if (found.duplicate_face >= 0) {
    out.push_back(fmt::format("{} (first face {}, of face {})",
                              counted(counts.duplicate_faces, "duplicate face", "duplicate faces"),
                              found.duplicate_face, found.duplicate_of));
  }
  if (found.nonmanifold_side >= 0) {
    out.push_back(
        fmt::format("{} (first {}, of {} faces)",
                    counted(counts.nonmanifold_edges, "non-manifold edge", "non-manifold edges"),
                    edge_name(mesh, found.nonmanifold_side), found.nonmanifold_side_faces));
  }
  if (found.nonmanifold_vertex >= 0) {
    out.push_back(fmt::format(
        "{} (first {}, of {} fans)",
        counted(counts.nonmanifold_vertices, "non-manifold vertex", "non-manifold vertices"),
        found.nonmanifold_vertex, found.nonmanifold_vertex_fans));
  }
}

void add_boundary(const TriangleMesh& mesh, const Topology& found, std::vector<std::string>& out) {
  out.push_back(fmt::format("{} of {} (first {})",
                            counted(found.counts.boundary_loops, "boundary loop", "boundary loops"),
                            counted(found.counts.boundary_edges, "edge", "edges"),
                            edge_name(mesh, found.boundary_side)));
  if (const std::int64_t coincident = survey(mesh).coincident_vertices; coincident > 0) {
    out.push_back(counted(coincident, "vertex repeats the place of another one",
                          "vertices repeat the place of another one"));
  }
}

}  // namespace

std::string describe_faults(const TriangleMesh& mesh, const Topology& found, bool closed) {
  if (mesh.faces.empty()) {
    return "there are no faces";
  }
  std::vector<std::string> kinds, list;
  if (closed && found.boundary_side >= 0) {
    kinds.emplace_back("open");
    add_boundary(mesh, found, list);
  }
  if (has_nonmanifold_element(found)) {
    kinds.emplace_back("not manifold");
    add_nonmanifold(mesh, found, list);
  }
  if (!found.counts.orientable) {
    kinds.emplace_back("not orientable");
    add_one_sided(mesh, found, list);
  }
  if (list.empty()) {
    return "";
  }
  return fmt::format("the surface is {}: {}", fmt::join(kinds, " and "), fmt::join(list, ", "));
}

bool may_be_repaired(const Topology& found) {
  return found.boundary_side >= 0 || has_nonmanifold_element(found);
}

std::string faults_of(const TriangleMesh& mesh) {
  return describe_faults(mesh, analyze_topology(mesh));
}

}  // namespace ucvt
