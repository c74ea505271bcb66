#include "ucvt/repair.h"

#include <numeric>

#include <fmt/ranges.h>

#include "mesh/invalid.h"
#include "mesh/repair_steps.h"

namespace ucvt {

bool RepairReport::changed() const {
  return welded_vertices + repeated_corners + duplicate_faces + split_vertices + reoriented_faces +
             added_faces + cut_edges >
         0;
}

Repaired repair(const TriangleMesh& mesh, const RepairOptions& options) {
  Repaired r{mesh,
             std::vector<std::int32_t>(mesh.positions.size()),
             std::vector<std::int32_t>(mesh.faces.size()),
             {}};
  std::iota(r.input_vertex.begin(), r.input_vertex.end(), 0);
  std::iota(r.input_face.begin(), r.input_face.end(), 0);
  drop_repeated_corners(r);
  drop_copies(r);
  weld_open_vertices(r, options.weld * survey(r.mesh).bbox_diagonal);
  drop_repeated_corners(r);
  drop_copies(r);
  split_fans(r, false);
  if (orient(r)) {
    close_holes(r, options);
  }
  split_fans(r, true);
  cut_double_edges(r);
  split_fans(r, true);  // where no two fans share an edge any more, fans may have parted
  return r;
}

std::string summary_of(const RepairReport& report) {
  std::vector<std::string> done;
  const auto add = [&](std::int64_t count, const char* what, const char* one, const char* many) {
    if (count > 0) {
      done.push_back(fmt::format("{} {}", what, counted(count, one, many)));
    }
  };
  add(report.welded_vertices, "welded", "vertex", "vertices");
  add(report.repeated_corners, "dropped", "face with a repeated corner",
      "faces with a repeated corner");
  add(report.duplicate_faces, "dropped", "duplicate face", "duplicate faces");
  add(report.split_edges, "took apart", "non-manifold edge", "non-manifold edges");
  add(report.split_vertices, "added", "copy of a vertex", "copies of vertices");
  add(report.cut_edges, "cut", "double edge", "double edges");
  add(report.reoriented_faces, "turned round", "face", "faces");
  if (report.closed_holes > 0) {
    done.push_back(fmt::format("closed {} with {}", counted(report.closed_holes, "hole", "holes"),
                               counted(report.added_faces, "face", "faces")));
  }
  return done.empty() ? "nothing to repair" : fmt::format("{}", fmt::join(done, ", "));
}

}  // namespace ucvt
