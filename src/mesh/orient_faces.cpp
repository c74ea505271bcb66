#include <utility>

#include "mesh/disjoint_sets.h"
#include "mesh/repair_steps.h"
#include "mesh/topology.h"

namespace ucvt {

bool orient(Repaired& r) {
  const Topology found = analyze_topology(r.mesh);
  if (!found.counts.orientable) {
    return false;
  }
  const EdgeGroups edges(r.mesh);
  DisjointSets part(r.mesh.faces.size());
  for (std::int64_t e = 0; e < edges.size(); ++e) {
    const auto sides = edges.sides(e);
    if (sides.size() == 2) {
      part.join(sides[0].side / 3, sides[1].side / 3);
    }
  }
  const auto part_of = [&](std::size_t f) {
    return static_cast<std::size_t>(part.find(static_cast<std::int32_t>(f)));
  };
  // Of each part: faces turned less faces not turned.
  std::vector<std::int64_t> excess(r.mesh.faces.size(), 0);
  for (std::size_t f = 0; f < excess.size(); ++f) {
    excess[part_of(f)] += found.turned[f] ? 1 : -1;
  }
  for (std::size_t f = 0; f < excess.size(); ++f) {
    if (found.turned[f] != (excess[part_of(f)] > 0)) {
      std::swap(r.mesh.faces[f][1], r.mesh.faces[f][2]);
      ++r.report.reoriented_faces;
    }
  }
  return true;
}

}  // namespace ucvt
