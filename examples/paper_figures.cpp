// The paper's figures 1, 2 and 7 to 12 anew, as SVG; figures 3 to 6 are drawings of definitions.
//
//   example_paper_figures FOLDER
//
// Prints the numbers behind them as the tables of docs/paper.md. The paper does not say where its
// hexagon lies: here its corners are at 0.8 of the Klein disk's radius.
#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "ucvt/figure.h"
#include "ucvt/spaces.h"

namespace {

using ucvt::Measure;
using ucvt::PictureOptions;
using ucvt::SpaceOptions;
using ucvt::SpaceResult;

std::filesystem::path folder;

void write(const std::string& name, const std::string& svg) {
  std::ofstream out(folder / (name + ".svg"), std::ios::binary);
  out << svg;
  if (!out.flush()) {
    throw std::runtime_error("cannot write " + (folder / name).string());
  }
}

ucvt::Domain hexagon() {
  std::vector<ucvt::CentralPoint> corners;
  for (int i = 0; i < 6; ++i) {
    const double a = std::numbers::pi / 3 * i;
    corners.push_back({0.8 * std::cos(a), 0.8 * std::sin(a)});
  }
  return ucvt::polygon_domain(-1, std::move(corners));
}

SpaceResult lloyd(const ucvt::Domain& domain, int sites, int iterations, std::string density = {}) {
  SpaceOptions options;
  options.sites = sites, options.iterations = iterations, options.tolerance = 0;
  options.method = ucvt::Method::Lloyd, options.init = ucvt::InitialSites::Random;
  options.density = std::move(density);
  return tessellate(domain, options);
}

/// The cells before and after.
void pair(const std::string& name, const SpaceResult& r, PictureOptions options) {
  options.initial = false;
  write(name + "b", space_picture(r, options));
  options.initial = true;
  write(name + "a", space_picture(r, options));
}

void curves(const std::string& name, const SpaceResult& r) {
  write(name + "a", line_plot(comparison_plot(r, Measure::Radius)));
  write(name + "b", line_plot(comparison_plot(r, Measure::Nearest)));
  write(name + "c", line_plot(comparison_plot(r, Measure::Area)));
}

ucvt::PlotSpec energy(const SpaceResult& r, double sign, std::string axis) {
  ucvt::PlotSpec out = energy_plot(r);
  out.y.title = std::move(axis);
  for (double& y : out.series[0].y) {
    y *= sign;
  }
  return out;
}

double largest_rise(const std::vector<double>& energy) {
  double out = 0;
  for (std::size_t i = 1; i < energy.size(); ++i) {
    out = std::max(out, energy[i] / energy[i - 1] - 1);
  }
  return out;
}

void row(const std::string& name, const SpaceResult& r) {
  const auto &u = r.initial_uniformity, &v = r.uniformity;
  fmt::print(
      "| {} | {} | {:.6g} → {:.6g} | {:.1f} → {:.1f} % | {:.3f} → {:.3f} | {:.3f} → {:.3f} | "
      "{:.3f} → {:.3f} | {:.1g} |\n",
      name, r.cvt.iterations, r.paper_energy.front(), r.paper_energy.back(), 100 * u.hexagons,
      100 * v.hexagons, u.radius.cv, v.radius.cv, u.nearest.cv, v.nearest.cv, u.area.cv, v.area.cv,
      largest_rise(r.cvt.energy));
}

void sphere_500() {
  const SpaceResult r = lloyd(ucvt::sphere_domain(), 500, 300);
  PictureOptions dots;
  dots.centroids = true;
  pair("figure-1", r, dots);
  write("figure-7a", line_plot(energy(r, -1, "F max, sphere")));
  write("figure-7b", line_plot(energy(r, 1, "F min, sphere")));
  curves("figure-8", r);
  row("1, 7, 8: sphere, 500", r);
}

void hexagon_100() {
  const SpaceResult r = lloyd(hexagon(), 100, 300);
  PictureOptions dots;
  dots.centroids = true;
  pair("figure-2", r, dots);
  write("figure-7c", line_plot(energy(r, 1, "F, hyperbolic")));
  curves("figure-9", r);
  row("2, 7, 9: hexagon, 100", r);
}

void degrees() {
  PictureOptions greys;
  greys.fill = ucvt::Fill::DegreeGreys, greys.sites = false;
  const SpaceResult sphere = lloyd(ucvt::sphere_domain(), 5000, 300);
  pair("figure-10", sphere, greys);
  row("10: sphere, 5,000", sphere);
  const SpaceResult plane = lloyd(hexagon(), 1000, 300);
  pair("figure-11", plane, greys);
  row("11: hexagon, 1,000", plane);
}

void densities() {
  PictureOptions from_above;
  from_above.view_lon_deg = -90, from_above.view_lat_deg = 45;
  const SpaceResult sphere = lloyd(ucvt::sphere_domain(), 2562, 200, "exp(-6*(1-z)^2)");
  write("figure-12a", space_picture(sphere, from_above));
  row("12 (a): sphere, 2,562", sphere);
  // x and y in the Klein disk, where the paper's pictures are.
  const SpaceResult plane =
      lloyd(hexagon(), 1000, 200,
            "exp(-20*klein_x^2 - 20*klein_y^2) + 0.05*sin(pi*klein_x)^2*sin(pi*klein_y)^2");
  write("figure-12b", space_picture(plane, {}));
  row("12 (b): hexagon, 1,000", plane);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) {
      throw std::runtime_error("usage: example_paper_figures FOLDER");
    }
    folder = argv[1];
    std::filesystem::create_directories(folder);
    fmt::print(
        "| figure | Lloyd | paper's energy | hexagons | cv of radius | cv of nearest | cv of area "
        "| "
        "largest rise |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    sphere_500();
    hexagon_100();
    degrees();
    densities();
  } catch (const std::exception& e) {
    std::cerr << "example_paper_figures: " << e.what() << '\n';
    return 1;
  }
  return 0;
}
