// The paper's table 1 next to its method and ucvt, both on this machine in one run. Prints markdown.
//
//   ucvt_bench_paper_table [--iterations K] [NAME...]
//
// Meshes come from $UCVT_SHARED_MESHES/paper; those that are not there are skipped with a word. Both
// methods start from the same random sites on the same T and run 200 Lloyd iterations on one thread,
// timed in processor seconds; with --iterations K the paper's method runs K only, its total is K's
// scaled to 200, and the table says so. NAME picks rows by the start of the surface's name.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cvt/surface_mass.h"
#include "paper_method/lloyd.h"
#include "result/cell_complex.h"
#include "result/density.h"
#include "ucvt/error.h"
#include "ucvt/remesh.h"

namespace {

constexpr int table_iterations = 200;

/// A line of the paper's table 1, and the mesh that stands for its surface here.
struct Row {
  std::string_view surface;
  int sites;
  double paper_each, paper_total;  ///< seconds, as printed
  std::string_view mesh;
  std::string_view remark;
};

constexpr Row rows[] = {
    {"Double Torus", 100, 0.38, 76.48, "double_torus_7k.off", "another double torus"},
    {"Kitten", 1000, 0.26, 52.48, "kitten_20k.off", ""},
    {"Igea", 2000, 13.57, 2714.01, "igea_full.ply", ""},
    {"Knot", 2000, 25.35, 5070.22, "knot_g2_standin.off", "stand-in"},
    {"David", 1000, 36.79, 7358.53, "david_full_g4.ply", "another scan, genus 4; the paper's 3"},
    {"Sculpture", 1000, 55.24, 11048.36, "sculpture_g3_standin.off", "stand-in"},
};

struct Measured {
  double each = 0;        ///< seconds
  double energy = 0;      ///< over that of hexagons
  double cv = 0;          ///< of cell areas on the input
  std::string triangles;  ///< whether they are D's
};

/// Of this process: what else runs on the machine does not count.
double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

ucvt::RemeshOptions lloyd_options(int sites, int iterations) {
  ucvt::RemeshOptions out;
  out.sites = sites, out.iterations = iterations, out.refine_for = sites;
  out.init = ucvt::InitialSites::Random, out.method = ucvt::Method::Lloyd;
  out.tolerance = 1e-300, out.threads = 1, out.ensure_simplicial = false;
  return out;
}

/// How far the triangles of sites and copies, modulo the deck group, are those of D.
std::string compared(const ucvt::paper::Lloyd& method, const ucvt::RemeshResult& r) {
  const auto expected = ucvt::paper::quotient(r.cells->delaunay);
  const auto found = quotient(method.current_diagram());
  std::vector<ucvt::Corners> differ;
  std::ranges::set_symmetric_difference(found, expected, std::back_inserter(differ));
  return differ.empty() ? "all" : fmt::format("{} differ", differ.size());
}

std::vector<ucvt::SurfacePoint> points(const std::vector<ucvt::Site>& sites) {
  std::vector<ucvt::SurfacePoint> out;
  for (const ucvt::Site& s : sites) {
    out.push_back({{s.face}, s.bary});
  }
  return out;
}

Measured by_ucvt(const ucvt::ClosedSurface& surface, const ucvt::RemeshResult& start) {
  auto options = lloyd_options(static_cast<int>(start.sites.size()), table_iterations);
  options.initial_sites = start.sites;
  // What is not an iteration is timed by a run without any.
  const double begin = processor_seconds();
  const ucvt::RemeshResult r = remesh(surface, options);
  const double middle = processor_seconds();
  options.iterations = 0;
  remesh(surface, options);
  const double iterating = middle - begin - (processor_seconds() - middle);
  return {iterating / table_iterations, r.cvt.energy.back() / r.hexagonal_energy, r.cell_area_3d.cv,
          "all"};
}

Measured by_the_paper(const ucvt::ClosedSurface& surface, const ucvt::RemeshResult& start,
                      int iterations) {
  ucvt::paper::Lloyd method(start.surface.value(), points(start.sites));
  method.run(iterations);
  const auto& time = method.timing();
  auto options = lloyd_options(static_cast<int>(start.sites.size()), 0);
  for (const ucvt::SurfacePoint& p : method.sites()) {
    options.initial_sites.push_back({p.face.id, p.bary});
  }
  const ucvt::RemeshResult r = remesh(surface, options);
  return {(time.diagrams + time.centroids) / time.iterations,
          r.cvt.energy.front() / r.hexagonal_energy, r.cell_area_3d.cv, compared(method, r)};
}

/// Processor seconds of a remesh with default settings on one thread, from the mesh to the dual.
double by_default(const ucvt::ClosedSurface& surface, int sites) {
  ucvt::RemeshOptions options;
  options.sites = sites, options.threads = 1;
  const double start = processor_seconds();
  remesh(surface, options);
  return processor_seconds() - start;
}

void print_head() {
  fmt::print(
      "| surface | genus | sites | paper: s each | paper: total s | its method here: s each | "
      "total s "
      "| ucvt Lloyd: s each | total s | times faster | ucvt default: total s | E / E_hex: its, "
      "ucvt "
      "| cv of areas: its, ucvt | its triangles that are D's |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
}

void print_row(const Row& row, const std::filesystem::path& folder, int iterations) {
  const std::string path = folder / row.mesh;
  if (!std::filesystem::exists(path)) {
    fmt::print("| {} | skipped: {} is not there |\n", row.surface, path);
    return;
  }
  const ucvt::ClosedSurface surface = closed_surface(ucvt::read_mesh(path));
  const ucvt::RemeshResult start = remesh(surface, lloyd_options(row.sites, 0));
  const Measured theirs = by_the_paper(surface, start, iterations);
  const Measured ours = by_ucvt(surface, start);
  const std::string name = row.remark.empty() ? std::string(row.surface)
                                              : fmt::format("{} ({})", row.surface, row.remark);
  fmt::print(
      "| {} | {} | {} | {:.2f} | {:.0f} | {:.3f} | {:.1f}{} | {:.4f} | {:.2f} | {:.0f} | {:.2f} "
      "| {:.4f}, {:.4f} | {:.3f}, {:.3f} | {} |\n",
      name, surface.genus, row.sites, row.paper_each, row.paper_total, theirs.each,
      theirs.each * table_iterations,
      iterations == table_iterations ? "" : fmt::format(" (from {})", iterations), ours.each,
      ours.each * table_iterations, theirs.each / ours.each, by_default(surface, row.sites),
      theirs.energy, ours.energy, theirs.cv, ours.cv, theirs.triangles);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const char* shared = std::getenv("UCVT_SHARED_MESHES");
  const auto folder =
      std::filesystem::path(shared != nullptr ? shared : "../shared/meshes") / "paper";
  int iterations = table_iterations;
  std::vector<std::string_view> names;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--iterations" && i + 1 < argc) {
      const std::string_view number = argv[++i];
      std::from_chars(number.data(), number.data() + number.size(), iterations);
    } else {
      names.push_back(word);
    }
  }
  if (iterations < 1) {
    fmt::print(stderr, "ucvt_bench_paper_table: --iterations takes a number from 1\n");
    return 2;
  }
  print_head();
  for (const Row& row : rows) {
    if (names.empty() || std::ranges::any_of(names, [&](std::string_view name) {
          return row.surface.starts_with(name);
        })) {
      try {
        print_row(row, folder, iterations);
      } catch (const std::exception& error) {
        fmt::print("| {} | {} |\n", row.surface, error.what());
      }
    }
  }
  return 0;
}
