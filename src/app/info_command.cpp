#include "app/info_command.h"

#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "app/outputs.h"
#include "app/report.h"
#include "app/signals.h"
#include "app/supervisor.h"
#include "ucvt/components.h"
#include "ucvt/error.h"
#include "ucvt/mesh.h"
#include "ucvt/repair.h"

namespace ucvt {
namespace {

struct Findings {
  MeshSurvey counts;
  MeshQuality quality;
  std::string refusal;  ///< empty: remesh takes the mesh
  std::int64_t reoriented_faces = 0;
  std::optional<RepairReport> repair;
  std::string refusal_after_repair;
};

void examine_repair(const TriangleMesh& mesh, const RepairOptions& options, Findings& found) {
  const Repaired repaired = repair(mesh, options);
  found.repair = repaired.report;
  found.refusal_after_repair = faults_of(repaired.mesh);
}

Findings examine(const TriangleMesh& mesh, const SharedArguments& shared) {
  Findings found;
  found.counts = survey(mesh);
  found.quality = measure_quality(mesh);
  try {
    if (has_boundary(mesh)) {
      found.reoriented_faces = open_surface(mesh).reoriented_faces;
    } else {
      for (const Component& c : closed_components(mesh)) {
        found.reoriented_faces += c.surface.reoriented_faces;
      }
    }
  } catch (const InvalidInput& error) {
    found.refusal = error.what();
  }
  if (shared.repair) {
    examine_repair(mesh, shared.repair_options, found);
  }
  return found;
}

std::string genus_text(const MeshSurvey& counts) {
  if (!has_genus(counts)) {
    return "none (not an orientable manifold)";
  }
  return fmt::format("{}{}", genus_of(counts), counts.components > 1 ? " (all components)" : "");
}

std::string verdict(const std::string& refusal, bool open) {
  return !refusal.empty() ? "refuses it: " + refusal
         : open           ? "takes it, with its boundary"
                          : "takes it";
}

std::string lines_of(const Findings& found) {
  const MeshSurvey& s = found.counts;
  const MeshQuality& q = found.quality;
  const auto count = [](std::int64_t n) { return fmt::format("{}", n); };
  Lines lines = {
      {"vertices", count(s.vertices)},
      {"edges", count(s.edges)},
      {"faces", count(s.faces)},
      {"components", count(s.components)},
      {"genus", genus_text(s)},
      {"Euler number", count(s.euler_number)},
      {"orientable", s.orientable ? "yes" : "no"},
      {"boundary edges", fmt::format("{} in {} loops", s.boundary_edges, s.boundary_loops)},
      {"non-manifold edges", count(s.nonmanifold_edges)},
      {"non-manifold vertices", count(s.nonmanifold_vertices)},
      {"misoriented edges",
       fmt::format("{} (faces to turn round: {})", s.misoriented_edges, found.reoriented_faces)},
      {"repeated corners", count(s.repeated_corner_faces)},
      {"duplicate faces", count(s.duplicate_faces)},
      {"coincident vertices", count(s.coincident_vertices)},
      {"unused vertices", count(s.unused_vertices)},
      {"area", fmt::format("{:.6g}", s.area)},
      {"bounding box", fmt::format("{:.6g} (diagonal)", s.bbox_diagonal)},
      {"edge lengths", fmt::format("{:.6g} to {:.6g}", s.edge_min, s.edge_max)},
      {"angles", fmt::format("smallest {:.4g}, smallest on average {:.2f} degrees, {:.2f} % of the "
                             "triangles below 30",
                             s.angle_min_deg, q.angle_min_avg_deg, 100 * q.below_30)},
      {"Q", fmt::format("smallest {:.4g}, on average {:.4f}", q.q_min, q.q_avg)},
      {"regular", fmt::format("{:.2f} % of the vertices", 100 * q.regular)},
      {"remesh", verdict(found.refusal, found.counts.boundary_edges > 0)},
  };
  if (found.repair) {
    lines.emplace_back("repair", summary_of(*found.repair));
    lines.emplace_back("remesh --repair", verdict(found.refusal_after_repair, false));
  }
  return aligned(lines);
}

Json report_of(const InfoArguments& arguments, const Findings& found,
               std::chrono::steady_clock::time_point start) {
  const MeshSurvey& s = found.counts;
  Json report;
  report["input"] = input_report(arguments.shared.input, s);
  report["topology"] = {{"edges", s.edges},
                        {"euler_number", s.euler_number},
                        {"orientable", s.orientable},
                        {"boundary_edges", s.boundary_edges},
                        {"boundary_loops", s.boundary_loops},
                        {"nonmanifold_edges", s.nonmanifold_edges},
                        {"nonmanifold_vertices", s.nonmanifold_vertices},
                        {"misoriented_edges", s.misoriented_edges}};
  report["faults"] = {{"repeated_corner_faces", s.repeated_corner_faces},
                      {"duplicate_faces", s.duplicate_faces},
                      {"coincident_vertices", s.coincident_vertices},
                      {"unused_vertices", s.unused_vertices},
                      {"reoriented_faces", found.reoriented_faces}};
  report["quality"] = quality_report(found.quality);
  report["quality"]["edge_min"] = s.edge_min;
  report["quality"]["edge_max"] = s.edge_max;
  report["acceptable"] = found.refusal.empty();
  report["refusal"] = found.refusal.empty() ? Json() : Json(found.refusal);
  if (found.repair) {
    report["repair"] = repair_report(*found.repair);
    report["repair"]["acceptable"] = found.refusal_after_repair.empty();
    report["repair"]["refusal"] =
        found.refusal_after_repair.empty() ? Json() : Json(found.refusal_after_repair);
  }
  add_run_report(report, start);
  return report;
}

}  // namespace

ExitStatus run_info(const InfoArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const std::string& report = arguments.shared.report;
  check_writable(outputs_of(arguments));
  Supervisor supervisor(arguments.shared.limits);
  const Findings found = about_file(input_name(arguments.shared.input), [&] {
    return examine(read_mesh(arguments.shared.input), arguments.shared);
  });
  supervisor.begin_outputs();
  begin_computation();
  if (!report.empty()) {
    write_text(report, report_text(report_of(arguments, found, start)));
  }
  if (!arguments.shared.quiet && report != "-") {
    print_results(lines_of(found));
  }
  return ExitStatus::Done;
}

}  // namespace ucvt
