#include <map>
#include <utility>

#include "mesh/edge_groups.h"
#include "mesh/fans.h"
#include "mesh/repair_steps.h"
#include "mesh/topology.h"

namespace ucvt {
namespace {

/// Fans with an open side, by the least of their corners.
std::vector<bool> open_fans(Fans& fans) {
  std::vector<bool> open(fans.twin.size(), false);
  for (std::size_t i = 0; i < fans.twin.size(); ++i) {
    if (fans.twin[i] < 0) {
      const auto side = static_cast<std::int32_t>(i);
      open[static_cast<std::size_t>(fans.fan.find(side))] = true;
      open[static_cast<std::size_t>(fans.fan.find(Fans::end_corner(side)))] = true;
    }
  }
  return open;
}

}  // namespace

void split_fans(Repaired& r, bool open_ones_too) {
  Fans fans = find_fans(r.mesh);
  const std::vector<bool> open = open_fans(fans);
  r.report.split_edges += fans.crowded_edges;
  // The fan that keeps the vertex' number, and that of its open fans that stay together.
  std::vector<std::int32_t> keeper(r.mesh.positions.size(), -1), together = keeper;
  std::map<std::int32_t, std::int32_t> copy;  // of a fan: its new vertex
  for (std::size_t i = 0; i < fans.twin.size(); ++i) {
    std::int32_t& v = r.mesh.faces[i / 3][i % 3];
    const auto vertex = static_cast<std::size_t>(v);
    std::int32_t fan = fans.fan.find(static_cast<std::int32_t>(i));
    if (open[static_cast<std::size_t>(fan)] && !open_ones_too && !fans.crowded[vertex]) {
      fan = together[vertex] < 0 ? together[vertex] = fan : together[vertex];
    }
    if (keeper[vertex] < 0) {
      keeper[vertex] = fan;
    }
    if (keeper[vertex] == fan) {
      continue;
    }
    const auto [place, is_new] =
        copy.try_emplace(fan, static_cast<std::int32_t>(r.mesh.positions.size()));
    if (is_new) {
      const Position position = r.mesh.positions[vertex];
      const std::int32_t input = r.input_vertex[vertex];
      r.mesh.positions.push_back(position);
      r.input_vertex.push_back(input);
      ++r.report.split_vertices;
    }
    v = place->second;
  }
}

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
