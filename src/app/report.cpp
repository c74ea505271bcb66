#include "app/report.h"

#include <algorithm>
#include <functional>
#include <numbers>

#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/task_arena.h>

#include "ucvt/version.h"

namespace ucvt {
namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;
constexpr std::int64_t bytes_per_kilobyte = 1024;
constexpr double bytes_per_megabyte = 1e6;

Json spread_report(const Spread& spread) {
  return {{"mean", spread.mean}, {"cv", spread.cv}, {"min", spread.min}, {"max", spread.max}};
}

Json cvt_report(const CvtReport& cvt) {
  const double per_iteration = cvt.iterations > 0 ? cvt.seconds / cvt.iterations : 0;
  return {{"method", cvt.method},         {"sites", cvt.sites},
          {"iterations", cvt.iterations}, {"converged", cvt.converged},
          {"energy", cvt.energy},         {"max_move", cvt.max_move},
          {"seconds", cvt.seconds},       {"seconds_per_iteration", per_iteration}};
}

Json uniformity_report(const UniformityReport& uniformity) {
  Json degree = Json::object();
  for (const auto& [neighbours, sites] : uniformity.degree) {
    degree[std::to_string(neighbours)] = sites;
  }
  return {{"radius", spread_report(uniformity.radius)},
          {"nearest", spread_report(uniformity.nearest)},
          {"area", spread_report(uniformity.area)},
          {"degree", degree},
          {"hexagons", uniformity.hexagons}};
}

Json dual_report(const RemeshReport& report) {
  Json remesh = {{"vertices", report.vertices},     {"faces", report.faces},
                 {"genus", report.genus},           {"boundary_loops", report.boundary_loops},
                 {"simplicial", report.simplicial}, {"sites_added", report.sites_added}};
  remesh.update(quality_report(report.quality));
  return remesh;
}

}  // namespace

bool has_genus(const MeshSurvey& counts) {
  return counts.orientable && counts.nonmanifold_edges == 0 && counts.nonmanifold_vertices == 0 &&
         counts.repeated_corner_faces == 0 && counts.duplicate_faces == 0;
}

std::int64_t genus_of(const MeshSurvey& counts) {
  return (2 * counts.components - counts.boundary_loops - counts.euler_number) / 2;
}

Json input_report(const std::string& file, const MeshSurvey& counts) {
  return {{"file", file},
          {"vertices", counts.vertices},
          {"faces", counts.faces},
          {"genus", has_genus(counts) ? Json(genus_of(counts)) : Json()},
          {"components", counts.components},
          {"area", counts.area},
          {"bbox_diagonal", counts.bbox_diagonal}};
}

Json uniformization_report(const UniformizationReport& report) {
  return {{"geometry", report.geometry},
          {"vertices", report.vertices},
          {"faces", report.faces},
          {"genus", report.genus},
          {"newton_iterations", report.newton_iterations},
          {"euclidean_flips", report.euclidean_flips},
          {"ptolemy_flips", report.ptolemy_flips},
          {"refined_vertices", report.refined_vertices},
          {"max_angle_error", report.max_angle_error * degrees_per_radian},
          {"area", report.area},
          {"log_scale_min", report.log_scale_min},
          {"log_scale_max", report.log_scale_max},
          {"seconds", report.seconds}};
}

Json group_report(const DeckGroup& group) {
  const GroupCertificate& c = group.certificate;
  return {{"base", group.base},
          {"residual", c.residual},
          {"residual_moebius", c.residual_moebius},
          {"residual_matrix", c.residual_matrix},
          {"largest_change", c.largest_change}};
}

Json quality_report(const MeshQuality& quality) {
  return {{"q_min", quality.q_min},
          {"q_avg", quality.q_avg},
          {"angle_min", quality.angle_min_deg},
          {"angle_min_avg", quality.angle_min_avg_deg},
          {"below_30", quality.below_30},
          {"regular", quality.regular}};
}

void add_remesh_report(Json& report, const RemeshResult& result) {
  report["cvt"] = cvt_report(result.cvt);
  report["cvt"]["energy_over_hexagonal"] = energy_over_hexagonal({&result, 1});
  report["uniformity"] = uniformity_report(result.uniformity);
  report["surface"] = {{"cell_area", spread_report(result.cell_area_3d)}};
  report["remesh"] = dual_report(result.report);
}

void add_joined_report(Json& report, const std::vector<Component>& components,
                       const std::vector<RemeshResult>& results, const JoinedReport& joined) {
  const CvtReport& cvt = joined.cvt;
  report["cvt"] = {{"method", cvt.method},
                   {"sites", cvt.sites},
                   {"iterations", cvt.iterations},
                   {"converged", cvt.converged},
                   {"seconds", cvt.seconds}};
  report["surface"] = {{"cell_area", spread_report(joined.cell_area_3d)}};
  report["remesh"] = dual_report(joined.remesh);
  Json& list = report["components"] = Json::array();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const ClosedSurface& surface = components[i].surface;
    Json entry = {{"first_face", components[i].input_face.front()},
                  {"vertices", surface.mesh.positions.size()},
                  {"faces", surface.mesh.faces.size()},
                  {"genus", surface.genus}};
    entry["uniformization"] = uniformization_report(results[i].surface.report());
    add_remesh_report(entry, results[i]);
    list.push_back(std::move(entry));
  }
}

Json repair_report(const RepairReport& repair) {
  return {{"welded_vertices", repair.welded_vertices},
          {"repeated_corner_faces", repair.repeated_corners},
          {"duplicate_faces", repair.duplicate_faces},
          {"split_edges", repair.split_edges},
          {"split_vertices", repair.split_vertices},
          {"cut_edges", repair.cut_edges},
          {"reoriented_faces", repair.reoriented_faces},
          {"closed_holes", repair.closed_holes},
          {"added_faces", repair.added_faces},
          {"left_holes", repair.left_holes}};
}

void add_space_report(Json& report, const std::string& domain, const SpaceResult& result,
                      bool uniform_density) {
  const Domain& space = result.domain;
  const bool closed = is_closed(space);
  report["space"] = {{"domain", domain},
                     {"kappa", space.kappa},
                     {"area", space.area},
                     {"genus", closed ? Json(space.genus) : Json()}};
  report["cvt"] = cvt_report(result.cvt);
  Json& energies = report["cvt"]["paper_energy"] = Json::object();
  energies[space.kappa > 0 ? "F_S_min" : space.kappa < 0 ? "F_H" : "F_E"] = result.paper_energy;
  if (space.kappa > 0) {
    std::vector<double> largest = result.paper_energy;
    std::transform(largest.begin(), largest.end(), largest.begin(), std::negate<>());
    energies["F_S_max"] = largest;
  }
  report["cvt"]["energy_over_hexagonal"] =
      uniform_density ? Json(energy_over_hexagonal(result)) : Json();
  report["initial_uniformity"] = uniformity_report(result.initial_uniformity);
  report["uniformity"] = uniformity_report(result.uniformity);
  report["quadrature_error"] = result.quadrature_error;
}

double energy_over_hexagonal(std::span<const RemeshResult> results) {
  double sum = 0, sites = 0;
  for (const RemeshResult& r : results) {
    const auto n = static_cast<double>(r.sites.size());
    sum += n * (r.cvt.energy.empty() ? 0 : r.cvt.energy.back() / r.hexagonal_energy);
    sites += n;
  }
  return sum / sites;
}

double energy_over_hexagonal(const SpaceResult& result) {
  constexpr double hexagon = 5 / (18 * std::numbers::sqrt3);  // of area 1
  const double area = result.domain.area, sites = static_cast<double>(result.cvt.sites);
  return result.cvt.energy.back() / (hexagon * area * area / sites);
}

std::string not_converged(const CvtReport& cvt, double tolerance) {
  const std::string move =
      cvt.max_move.empty() ? ""
      : tolerance > 0
          ? fmt::format(" (largest move {:.2g}, tolerance {:.2g})", cvt.max_move.back(), tolerance)
          : fmt::format(" (largest move {:.2g})", cvt.max_move.back());
  return fmt::format(
      "did not converge in {} iteration{}{}; the sites are written as they are, --iterations "
      "allows "
      "more",
      cvt.iterations, cvt.iterations == 1 ? "" : "s", move);
}

void add_run_report(Json& report, std::chrono::steady_clock::time_point start) {
  report["seconds"] = seconds_since(start);
  report["peak_memory_bytes"] = peak_memory_bytes();
  report["version"] = UCVT_VERSION;
}

std::string report_text(const Json& report) {
  // File names need not be UTF-8, JSON must.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

int threads_used(int asked) {
  return asked > 0 ? asked : tbb::this_task_arena::max_concurrency();
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::int64_t peak_memory_bytes() {
  rusage usage = {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * bytes_per_kilobyte;
}

std::string aligned(const Lines& lines) {
  std::size_t width = 0;
  for (const auto& [name, value] : lines) {
    width = std::max(width, name.size());
  }
  std::string text;
  for (const auto& [name, value] : lines) {
    text += fmt::format("{:<{}}  {}\n", name, width, value);
  }
  return text;
}

std::string aligned(Lines lines, std::chrono::steady_clock::time_point start) {
  const double megabytes = static_cast<double>(peak_memory_bytes()) / bytes_per_megabyte;
  lines.emplace_back("time", fmt::format("{:.2f} s", seconds_since(start)));
  lines.emplace_back("peak memory", fmt::format("{:.0f} MB", megabytes));
  return aligned(lines);
}

}  // namespace ucvt
