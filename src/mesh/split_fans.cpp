#include <map>

#include "mesh/edge_groups.h"
#include "mesh/fans.h"
#include "mesh/repair_steps.h"

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

/// Cuts the face in two at the vertex on its side.
void cut_face(Repaired& r, std::int32_t side, std::int32_t vertex) {
  const std::size_t face = face_of(side), i = static_cast<std::size_t>(side % 3);
  Corners half = r.mesh.faces[face];
  half[i] = vertex;
  r.mesh.faces[face][(i + 1) % 3] = vertex;
  r.mesh.faces.push_back(half);
  const std::int32_t input = r.input_face[face];
  r.input_face.push_back(input);
}

/// Cuts the faces of both sides, the second of which may be -1, at the middle, and marks them.
void cut_edge(Repaired& r, std::int32_t side, std::int32_t twin, std::vector<bool>& cut) {
  const Position a = r.mesh.positions[static_cast<std::size_t>(side_tail(r.mesh, side))];
  const Position b = r.mesh.positions[static_cast<std::size_t>(side_head(r.mesh, side))];
  const auto middle = static_cast<std::int32_t>(r.mesh.positions.size());
  r.mesh.positions.push_back({a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2});
  r.input_vertex.push_back(-1);
  ++r.report.cut_edges;
  for (const std::int32_t s : {side, twin}) {
    if (s >= 0) {
      cut[face_of(s)] = true;
      cut_face(r, s, middle);
    }
  }
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

void cut_double_edges(Repaired& r) {
  // A face is cut once a round; every round cuts one edge at least.
  for (bool again = true; again;) {
    again = false;
    const Fans fans = find_fans(r.mesh);
    const EdgeGroups edges(r.mesh);
    std::vector<bool> cut(r.mesh.faces.size(), false);
    for (std::int64_t e = 0; e < edges.size(); ++e) {
      const auto sides = edges.sides(e);
      for (std::size_t k = 1; sides.size() > 2 && k < sides.size(); ++k) {
        const std::int32_t side = sides[k].side, twin = fans.twin[static_cast<std::size_t>(side)];
        // The first face and its twin keep the edge; each other pair comes up at its lower side.
        if (twin == sides[0].side || (twin >= 0 && twin < side)) {
          continue;
        }
        again = true;
        if (!cut[face_of(side)] && (twin < 0 || !cut[face_of(twin)])) {
          cut_edge(r, side, twin, cut);
        }
      }
    }
  }
}

}  // namespace ucvt
