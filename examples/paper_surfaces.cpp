// The paper's figures 13 to 18 anew, as SVG.
//
//   example_paper_surfaces FOLDER DOUBLE_TORUS.off [MESHES]
//
// Figures 13 and 14 show the double torus, as example_double_torus makes it; the others need meshes
// that are not ours to pass on, looked for in the folder MESHES: a figure whose mesh is not there is
// left out. Prints the numbers behind the figures as the table of docs/paper.md.
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "ucvt/figure.h"
#include "ucvt/partition.h"
#include "ucvt/remesh.h"
#include "ucvt/surface_figure.h"

namespace {

using ucvt::Camera;
using ucvt::CoverPictureOptions;
using ucvt::RemeshOptions;
using ucvt::RemeshResult;
using ucvt::SurfacePictureOptions;

constexpr int surface_width = 400, cover_width = 600;

std::filesystem::path folder, meshes;

void write(const std::string& name, const std::string& svg) {
  ucvt::write_figure((folder / (name + ".svg")).string(), svg);
}

SurfacePictureOptions from(const Camera& camera) {
  SurfacePictureOptions options;
  options.camera = camera, options.width = surface_width;
  return options;
}

CoverPictureOptions cover_options() {
  CoverPictureOptions options;
  options.width = cover_width;
  return options;
}

void row(const std::string& name, const RemeshResult& r) {
  fmt::print("| {} | {} | {} | {} | {:.3f} | {:.1f} % | {:.3f} / {:.3f} | {:.1f} |\n", name,
             r.report.genus, r.cvt.sites, r.cvt.iterations, r.cell_area_3d.cv,
             100 * r.uniformity.hexagons, r.report.quality.q_min, r.report.quality.q_avg,
             r.report.quality.angle_min_deg);
}

/// Random sites, and what Lloyd's method makes of them: (a) and (b) in the cover, (c) and (d) on the
/// surface.
void before_and_after(const std::string& number, const std::string& name,
                      const ucvt::ClosedSurface& surface, int sites, int iterations,
                      const Camera& camera) {
  RemeshOptions options;
  options.sites = sites, options.iterations = 0, options.tolerance = 1e-12;
  options.init = ucvt::InitialSites::Random, options.method = ucvt::Method::Lloyd;
  options.ensure_simplicial = false;
  const RemeshResult before = remesh(surface, options);
  row(fmt::format("{} (a, c): {}", number, name), before);
  write("figure-" + number + "a", cell_cover_picture(before, cover_options()));
  write("figure-" + number + "c", cells_picture(before, partition(before), from(camera)));
  options.iterations = iterations;
  const RemeshResult after = remesh(surface, options);
  row(fmt::format("{} (b, d): {}", number, name), after);
  write("figure-" + number + "b", cell_cover_picture(after, cover_options()));
  write("figure-" + number + "d", cells_picture(after, partition(after), from(camera)));
}

void double_torus(const std::string& path) {
  const ucvt::ClosedSurface surface = ucvt::closed_surface(ucvt::read_mesh(path));
  const Camera camera{-75, 38, 0};
  const ucvt::Cover cover(uniformize(surface));
  write("figure-13a", loops_picture(cover, from(camera)));
  write("figure-13b", cover_picture(cover, cover_options()));
  before_and_after("14", "double torus", surface, 100, 100, camera);
}

/// A CVT by the program's own method.
RemeshResult finished(const std::string& figure, const std::string& name,
                      const ucvt::ClosedSurface& surface, int sites) {
  RemeshOptions options;
  options.sites = sites;
  const RemeshResult result = remesh(surface, options);
  row(fmt::format("{}: {}", figure, name), result);
  return result;
}

/// Does the work with a mesh, if it is there.
template <class Work>
void with_mesh(const std::string& figure, const std::string& file, const Work& work) {
  const std::filesystem::path path = meshes / file;
  if (meshes.empty() || !std::filesystem::exists(path)) {
    std::cerr << "figure " << figure << ": left out, there is no " << file << '\n';
    return;
  }
  work(ucvt::closed_surface(ucvt::read_mesh(path.string())));
}

void surfaces() {
  with_mesh("15", "kitten_20k.off", [](const ucvt::ClosedSurface& s) {
    before_and_after("15", "kitten", s, 1000, 200, {-65, 75, 0});
  });
  with_mesh("16", "igea_full.ply", [](const ucvt::ClosedSurface& s) {
    before_and_after("16", "Igea", s, 2000, 200, {-90, 90, 0});
  });
  with_mesh("17", "knot_g2_standin.off", [](const ucvt::ClosedSurface& s) {
    const RemeshResult r = finished("17", "knot (stand-in)", s, 2000);
    write("figure-17a", cells_picture(r, partition(r), from({-90, 90, 0})));
    write("figure-17b", mesh_picture(r.mesh, ucvt::MeshStyle::Wireframe, from({-90, 90, 0})));
  });
  with_mesh("18 (a)", "david_full_g4.ply", [](const ucvt::ClosedSurface& s) {
    const RemeshResult r = finished("18 (a)", "David (genus 4 here)", s, 1000);
    write("figure-18a", cells_picture(r, partition(r), from({-90, 5, 0})));
  });
  with_mesh("18 (b)", "sculpture_g3_standin.off", [](const ucvt::ClosedSurface& s) {
    const RemeshResult r = finished("18 (b)", "sculpture (stand-in)", s, 2000);
    write("figure-18b", cells_picture(r, partition(r), from({-60, 25, 0})));
  });
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3 && argc != 4) {
      throw std::runtime_error("usage: example_paper_surfaces FOLDER DOUBLE_TORUS.off [MESHES]");
    }
    folder = argv[1];
    meshes = argc == 4 ? argv[3] : "";
    std::filesystem::create_directories(folder);
    fmt::print(
        "| figure | genus | sites | iterations | cv of cell areas on the surface | "
        "hexagons | Q, smallest / mean | smallest angle |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    double_torus(argv[2]);
    surfaces();
  } catch (const std::exception& e) {
    std::cerr << "example_paper_surfaces: " << e.what() << '\n';
    return 1;
  }
  return 0;
}
