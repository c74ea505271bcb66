// The paper's figure 19: a restricted Voronoi diagram in space glues sheets that nearly touch; a
// tessellation in the universal cover does not. Prints a markdown table and writes the dual meshes.
//
//   ucvt_bench_fig19 MESH OUT_FOLDER [--lloyd K]
//
// Both methods start from random sites. The restricted diagram gets K (20) Lloyd iterations with the
// centroids of its cells; ucvt runs as it does by default. Meshes: rvd_N.off and ucvt_N.off; pictures
// of the two that the paper compares, whole and opened: figure-19a.svg to figure-19d.svg.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "restricted_voronoi/restricted_voronoi.h"
#include "ucvt/figure.h"
#include "ucvt/remesh.h"
#include "ucvt/surface_figure.h"

namespace {

using ucvt::Position;

constexpr int rvd_sites[] = {200, 1000, 2000, 4000, 8000, 16000, 32000};
constexpr int ucvt_sites[] = {200, 1000, 2000, 4000};
constexpr int rvd_shown = 4000, ucvt_shown = 2000;

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

/// Points drawn uniformly by area.
std::vector<Position> random_points(const ucvt::TriangleMesh& mesh, int n) {
  std::vector<double> until;
  for (const ucvt::Corners& f : mesh.faces) {
    const ucvt::TriangleMesh one{{mesh.positions[static_cast<std::size_t>(f[0])],
                                  mesh.positions[static_cast<std::size_t>(f[1])],
                                  mesh.positions[static_cast<std::size_t>(f[2])]},
                                 {{0, 1, 2}}};
    until.push_back((until.empty() ? 0 : until.back()) + ucvt::survey(one).area);
  }
  std::mt19937_64 random(1);
  std::vector<Position> out;
  while (out.size() < static_cast<std::size_t>(n)) {
    const auto at = std::ranges::upper_bound(until, uniform(random) * until.back());
    const auto& f = mesh.faces[static_cast<std::size_t>(at - until.begin())];
    const double r = std::sqrt(uniform(random)), s = uniform(random);
    const double weight[] = {1 - r, r * (1 - s), r * s};
    Position p{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] += weight[i] * mesh.positions[static_cast<std::size_t>(f[i])][k];
      }
    }
    out.push_back(p);
  }
  return out;
}

void print_row(std::string_view method, int sites, std::string_view parts,
               const ucvt::TriangleMesh& dual) {
  const ucvt::MeshSurvey s = survey(dual);
  const bool valid = s.boundary_edges + s.nonmanifold_edges + s.nonmanifold_vertices == 0 &&
                     s.components == 1 && s.unused_vertices == 0;
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", method, sites, parts,
             s.vertices, s.faces, s.boundary_edges, s.nonmanifold_edges, s.nonmanifold_vertices,
             s.euler_number,
             valid ? fmt::format("genus {}", 1 - s.euler_number / 2) : "no surface");
  std::fflush(stdout);
}

/// The mesh without its upper half, so that the tube inside is seen.
ucvt::TriangleMesh lower_half(const ucvt::TriangleMesh& mesh) {
  ucvt::TriangleMesh out{mesh.positions, {}};
  for (const ucvt::Corners& f : mesh.faces) {
    double z = 0;
    for (const std::int32_t v : f) {
      z += mesh.positions[static_cast<std::size_t>(v)][2];
    }
    if (z < 0) {
      out.faces.push_back(f);
    }
  }
  return out;
}

void draw(const ucvt::TriangleMesh& mesh, const std::string& whole, const std::string& opened) {
  ucvt::SurfacePictureOptions options{{-20, 35, 0}, 600};
  ucvt::write_figure(whole, mesh_picture(mesh, ucvt::MeshStyle::HiddenLines, options));
  options.camera.lat_deg = 60;
  ucvt::write_figure(opened, mesh_picture(lower_half(mesh), ucvt::MeshStyle::HiddenLines, options));
}

void by_distance_in_space(const ucvt::TriangleMesh& mesh, int n, int lloyd,
                          const std::string& folder) {
  std::vector<Position> sites = random_points(mesh, n);
  for (int i = 0; i < lloyd; ++i) {
    const auto cells = ucvt::restricted::restricted_voronoi(mesh, sites).cells;
    for (std::size_t k = 0; k < sites.size(); ++k) {
      sites[k] = cells[k].area > 0 ? cells[k].centroid : sites[k];
    }
  }
  const auto d = ucvt::restricted::restricted_voronoi(mesh, sites);
  const auto in_parts =
      std::ranges::count_if(d.cells, [](const auto& cell) { return cell.parts > 1; });
  const ucvt::TriangleMesh dual{sites, d.dual};
  write_mesh(fmt::format("{}/rvd_{}.off", folder, n), dual);
  if (n == rvd_shown) {
    draw(dual, folder + "/figure-19a.svg", folder + "/figure-19c.svg");
  }
  print_row("restricted Voronoi", n, fmt::format("{}", in_parts), dual);
}

void in_the_universal_cover(const ucvt::ClosedSurface& surface, int n, const std::string& folder) {
  ucvt::RemeshOptions options;
  options.sites = n;
  const ucvt::RemeshResult r = remesh(surface, options);
  write_mesh(fmt::format("{}/ucvt_{}.off", folder, n), r.mesh);
  if (n == ucvt_shown) {
    draw(r.mesh, folder + "/figure-19b.svg", folder + "/figure-19d.svg");
  }
  print_row("ucvt", n, "0", r.mesh);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  int lloyd = 20;
  if (words.size() == 4 && words[2] == "--lloyd") {
    std::from_chars(words[3].data(), words[3].data() + words[3].size(), lloyd);
  } else if (words.size() != 2) {
    fmt::print(stderr, "usage: ucvt_bench_fig19 MESH OUT_FOLDER [--lloyd K]\n");
    return 2;
  }
  try {
    const ucvt::ClosedSurface surface = closed_surface(ucvt::read_mesh(words[0]));
    fmt::print(
        "| method | sites | cells in several parts | dual: vertices | triangles | open edges | "
        "non-manifold edges | non-manifold vertices | Euler number | |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const int n : rvd_sites) {
      by_distance_in_space(surface.mesh, n, lloyd, words[1]);
    }
    for (const int n : ucvt_sites) {
      in_the_universal_cover(surface, n, words[1]);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "ucvt_bench_fig19: {}\n", error.what());
    return 1;
  }
  return 0;
}
