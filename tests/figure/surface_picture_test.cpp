#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "figure/solid.h"
#include "figure/surface_values.h"
#include "oracle/meshes.h"
#include "svg_reader.h"
#include "ucvt/error.h"
#include "ucvt/figure.h"
#include "ucvt/surface_figure.h"

namespace ucvt {
namespace {

using oracle::in_group;
using oracle::read_svg;
using oracle::SvgElement;

SurfacePictureOptions small() {
  SurfacePictureOptions options;
  options.width = 200;
  return options;
}

const ClosedSurface& torus() {
  static const ClosedSurface surface = oracle::closed(oracle::grid_torus(24, 12));
  return surface;
}

RemeshResult few_cells(const ClosedSurface& surface) {
  RemeshOptions options;
  options.sites = 20, options.iterations = 20, options.init = InitialSites::Random;
  return remesh(surface, options);
}

/// The image of a surface picture.
SvgElement image_of(const std::string& svg) {
  const auto all = read_svg(svg);
  const auto found =
      std::find_if(all.begin(), all.end(), [](const SvgElement& e) { return e.name == "image"; });
  return found == all.end() ? SvgElement{} : *found;
}

TEST(Solid, ASphereFillsTheDiskOfItsRadius) {
  const TriangleMesh mesh = oracle::icosphere(4);
  SurfacePictureOptions options;
  options.width = 400;
  const Shot shot = fit(mesh, options);
  Raster raster(shot.width, shot.height);
  draw_mesh(
      raster, shot.view, mesh, [](std::size_t) { return 0; },
      [](std::size_t, const auto&) { return Colour{0, 0, 0}; });
  double area = 0;
  for (const std::uint8_t channel : raster.image().rgb) {
    area += (255 - channel) / 255.0 / 3;
  }
  const double disk = std::numbers::pi * shot.view.scale * shot.view.scale;
  EXPECT_NEAR(area, disk, 0.01 * disk);
}

TEST(Solid, TheCameraLooksDownTheAxisItNames) {
  const TriangleMesh mesh = oracle::icosphere(2);
  SurfacePictureOptions options = small();
  options.camera = {-90, 90, 0};
  const View above = fit(mesh, options).view;
  EXPECT_NEAR(above.direction({1, 0, 0})[0], 1, 1e-12);
  EXPECT_NEAR(above.direction({0, 1, 0})[1], -1, 1e-12);
  EXPECT_NEAR(above.direction({0, 0, 1})[2], 1, 1e-12);
  options.camera.roll_deg = 90;
  const View turned = fit(mesh, options).view;
  EXPECT_NEAR(turned.direction({1, 0, 0})[1], -1, 1e-12) << "x points up now";
  EXPECT_NEAR(turned.direction({0, 1, 0})[0], -1, 1e-12) << "and y to the left";
  options.camera = {30, 0, 0};
  const View level = fit(mesh, options).view;
  EXPECT_NEAR(level.direction({std::cos(std::numbers::pi / 6), 0.5, 0})[2], 1, 1e-12);
  EXPECT_NEAR(level.direction({0, 0, 1})[1], -1, 1e-12);
}

TEST(Solid, NormalsOfACubeStayApartAtItsEdges) {
  const TriangleMesh cube = oracle::cube();
  const auto normals = corner_normals(cube);
  for (std::size_t f = 0; f < normals.size(); ++f) {
    EXPECT_NEAR(dot_product(normals[f][0], normals[f][1]), 1, 1e-12);
    EXPECT_NEAR(dot_product(normals[f][0], normals[f][2]), 1, 1e-12);
  }
}

TEST(SurfaceValues, DilatationIsTheRatioOfTheStretches) {
  const auto sides = [](double stretch) {
    const std::array<std::array<double, 2>, 3> p{{{0, 0}, {2, 0.3}, {0.4, 1.1}}};
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = p[i], &b = p[(i + 1) % 3];
      out[i] = std::hypot(stretch * (b[0] - a[0]), b[1] - a[1]);
    }
    return out;
  };
  EXPECT_NEAR(dilatation(sides(1), sides(3)), 3, 1e-12);
  EXPECT_NEAR(dilatation(sides(3), sides(1)), 3, 1e-12);
  EXPECT_NEAR(dilatation(sides(1), {2 * sides(1)[0], 2 * sides(1)[1], 2 * sides(1)[2]}), 1, 1e-12);
  EXPECT_TRUE(std::isnan(dilatation({1, 1, 2}, {1, 1, 1})));
}

TEST(SurfaceValues, ASphereIsNotDistorted) {
  const UniformizedSurface t = uniformize(oracle::closed(oracle::scaled(oracle::icosphere(3), 10)));
  for (const double k : angle_distortion(t.value())) {
    EXPECT_LT(k, 1.1);
    EXPECT_GE(k, 1);
  }
  const auto area = area_distortion(t.value());
  EXPECT_EQ(area.size(), 642U);
  EXPECT_NEAR(*std::max_element(area.begin(), area.end()), 0, 0.3);
}

TEST(SurfacePicture, IsAnImageWithALegend) {
  const UniformizedSurface t = uniformize(torus());
  SurfacePictureOptions options = small();
  options.title = "a < b";
  for (const SurfaceValue v : {SurfaceValue::None, SurfaceValue::Area, SurfaceValue::Angle}) {
    const std::string svg = surface_picture(t, v, options);
    const SvgElement image = image_of(svg);
    EXPECT_EQ(image.number("width"), 200);
    EXPECT_EQ(image.attributes.at("xlink:href").rfind("data:image/png;base64,iVBORw0KGgo", 0), 0U);
    EXPECT_EQ(in_group(svg, "legend", "rect").empty(), v == SurfaceValue::None);
    EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
  }
}

TEST(SurfacePicture, LoopsAreNamed) {
  const Cover cover(uniformize(torus()));
  SurfacePictureOptions options = small();
  options.camera = {0, 60, 0};
  const std::string svg = loops_picture(cover, options);
  EXPECT_EQ(in_group(svg, "legend", "line").size(), 2U);
  EXPECT_EQ(in_group(svg, "labels", "text").size(), 2U);
}

TEST(SurfacePicture, BytesDoNotDependOnThreads) {
  const RemeshResult result = few_cells(torus());
  const Partition cells = partition(result);
  const std::string many = cells_picture(result, cells, small());
  const std::string wires = mesh_picture(result.mesh, MeshStyle::Wireframe, small());
  const std::string cover = cell_cover_picture(result);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(cells_picture(result, cells, small()), many);
  EXPECT_EQ(mesh_picture(result.mesh, MeshStyle::Wireframe, small()), wires);
  EXPECT_EQ(cell_cover_picture(result), cover);
}

TEST(SurfacePicture, RefusesWhatCannotBeShown) {
  TriangleMesh mesh = oracle::cube();
  SurfacePictureOptions options = small();
  options.camera.roll_deg = std::numeric_limits<double>::infinity();
  EXPECT_THROW(mesh_picture(mesh, {}, options), InvalidInput);
  options = small(), options.width = 50;
  EXPECT_THROW(mesh_picture(mesh, {}, options), InvalidInput);
  EXPECT_THROW(mesh_picture({}, {}, small()), InvalidInput);
  mesh.positions[0][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mesh_picture(mesh, {}, small()), InvalidInput);
}

TEST(WriteFigure, GoesByTheExtension) {
  const std::string svg = mesh_picture(oracle::cube(), {}, small());
  const auto folder = std::filesystem::path(testing::TempDir()) / "ucvt-write-figure";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto content = [](const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  write_figure((folder / "cube.svg").string(), svg);
  EXPECT_EQ(content(folder / "cube.svg"), svg);
  EXPECT_THROW(write_figure((folder / "cube.gif").string(), svg), InvalidInput);
  EXPECT_FALSE(std::filesystem::exists(folder / "cube.gif"));
  const std::string png = (folder / "cube.png").string();
  if (!can_write_png()) {
    EXPECT_THROW(write_figure(png, svg), InvalidInput);
    return;
  }
  write_figure(png, svg);
  const std::string bytes = content(png);
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  EXPECT_EQ(static_cast<unsigned char>(bytes[19]), 200) << "width in pixels";
}

}  // namespace
}  // namespace ucvt
