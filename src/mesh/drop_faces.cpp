#include <algorithm>
#include <numeric>

#include "mesh/disjoint_sets.h"
#include "mesh/edge_groups.h"
#include "mesh/repair_steps.h"

namespace ucvt {
namespace {

/// Drops the faces that are marked; gives how many.
std::int64_t drop(Repaired& r, const std::vector<bool>& marked) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < marked.size(); ++f) {
    if (!marked[f]) {
      r.mesh.faces[kept] = r.mesh.faces[f];
      r.input_face[kept++] = r.input_face[f];
    }
  }
  r.mesh.faces.resize(kept);
  r.input_face.resize(kept);
  return static_cast<std::int64_t>(marked.size() - kept);
}

/// Marks all faces but the first of those with the same vertices; in `copied` those firsts.
std::vector<bool> mark_copies(const TriangleMesh& mesh, std::vector<bool>& copied) {
  std::vector<std::pair<Corners, std::size_t>> sorted;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    Corners c = mesh.faces[f];
    std::sort(c.begin(), c.end());
    sorted.emplace_back(c, f);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> marked(mesh.faces.size(), false);
  copied.assign(mesh.faces.size(), false);
  for (std::size_t i = 1, first = 0; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[first].first) {
      first = i;
      continue;
    }
    marked[sorted[i].second] = true;
    copied[sorted[first].second] = true;
  }
  return marked;
}

/// Of the faces that had copies, those in patches that are walls: joined where no other face meets
/// them, and with an even number of others all round.
std::vector<bool> mark_walls(const TriangleMesh& mesh, const std::vector<bool>& copied) {
  const EdgeGroups edges(mesh);
  DisjointSets patch(mesh.faces.size());
  std::vector<bool> has_rim(mesh.faces.size(), false), open(mesh.faces.size(), false);
  const auto each_edge = [&](const auto& visit) {
    for (std::int64_t e = 0; e < edges.size(); ++e) {
      const auto sides = edges.sides(e);
      const auto others = std::count_if(
          sides.begin(), sides.end(), [&](const EdgeSide& s) { return !copied[face_of(s.side)]; });
      for (const EdgeSide& s : sides) {
        if (copied[face_of(s.side)]) {
          visit(s.side / 3, sides, others);
        }
      }
    }
  };
  each_edge([&](std::int32_t face, const auto& sides, std::ptrdiff_t others) {
    if (others == 0) {
      patch.join(face, sides[0].side / 3);
    }
  });
  each_edge([&](std::int32_t face, const auto&, std::ptrdiff_t others) {
    const auto p = static_cast<std::size_t>(patch.find(face));
    has_rim[p] = has_rim[p] || others > 0;
    open[p] = open[p] || others % 2 == 1;
  });
  std::vector<bool> marked(mesh.faces.size(), false);
  for (std::size_t f = 0; f < marked.size(); ++f) {
    const auto p = static_cast<std::size_t>(patch.find(static_cast<std::int32_t>(f)));
    marked[f] = copied[f] && has_rim[p] && !open[p];
  }
  return marked;
}

}  // namespace

void drop_repeated_corners(Repaired& r) {
  std::vector<bool> marked;
  for (const Corners& f : r.mesh.faces) {
    marked.push_back(has_repeated_corner(f));
  }
  r.report.repeated_corners += drop(r, marked);
}

void drop_copies(Repaired& r) {
  std::vector<bool> copied;
  const std::vector<bool> copies = mark_copies(r.mesh, copied);
  if (std::find(copies.begin(), copies.end(), true) == copies.end()) {
    return;
  }
  std::vector<bool> firsts;
  for (std::size_t f = 0; f < copies.size(); ++f) {
    if (!copies[f]) {
      firsts.push_back(copied[f]);
    }
  }
  r.report.duplicate_faces += drop(r, copies);
  r.report.duplicate_faces += drop(r, mark_walls(r.mesh, firsts));
}

}  // namespace ucvt
