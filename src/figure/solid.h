// Bodies in space as a raster shows them: the view, smooth shading, meshes and tubes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "figure/raster.h"
#include "figure/svg.h"
#include "ucvt/mesh.h"
#include "ucvt/spaces.h"
#include "ucvt/surface_figure.h"

namespace ucvt {

/// From the mesh's coordinates to those of a raster.
struct View {
  ModelMatrix axes{};  ///< rows right, up and towards the viewer
  double scale = 1;    ///< pixels in a unit of length
  Pixel origin;        ///< where the mesh's origin lies in the picture

  [[nodiscard]] Position place(const Position& p) const;
  /// A direction, in the raster's axes.
  [[nodiscard]] Position direction(const Position& p) const;
};

/// A view, and the size of a picture that all of the mesh fits into.
struct Shot {
  View view;
  int width = 0, height = 0;
};

/// Throws InvalidInput when the camera, the width or a coordinate is unfit.
Shot fit(const TriangleMesh& mesh, const SurfacePictureOptions& options);

/// The colour of a surface with this unit normal (raster's axes), seen from either side.
Colour lit(const Colour& colour, const Position& normal);

Position minus(const Position& a, const Position& b);
Position cross_product(const Position& a, const Position& b);
double dot_product(const Position& a, const Position& b);

/// Unit normals at the corners of every face, the mean of the faces round the vertex that do not bend
/// away by more than an edge of the body would.
std::vector<std::array<Position, 3>> corner_normals(const TriangleMesh& mesh);

/// sum of bary[i] p[i], turned into the raster's axes and of unit length.
Position mixed_normal(const View& view, const std::array<Position, 3>& normals,
                      const std::array<double, 3>& bary);

std::array<Position, 3> placed_corners(const View& view, const TriangleMesh& mesh,
                                       std::size_t face);

/// A tube along a polyline, radius in pixels, as balls that nearly coincide; colour(point, normal) is
/// given the place in the raster.
template <class ColourAt>
void draw_tube(Raster& raster, const View& view, const std::vector<Position>& line, double radius,
               std::int32_t label, const ColourAt& colour) {
  constexpr double step = 0.25;  // of the radius
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Position a = view.place(line[i]), b = view.place(line[i + 1]), d = minus(b, a);
    const double length = std::sqrt(dot_product(d, d));
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / (step * radius))));
    for (int k = 0; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      const Position at{a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
      raster.ball(at, radius, label, [&](const Position& n) { return colour(at, n); });
    }
  }
}

constexpr Colour plain_surface{222, 226, 232}, ink{25, 28, 36};

/// Draws a mesh, smoothly shaded. colour(face, bary) is its own, label(face) what it
/// bears in the raster.
template <class ColourOf, class LabelOf>
void draw_mesh(Raster& raster, const View& view, const TriangleMesh& mesh, const LabelOf& label,
               const ColourOf& colour) {
  const auto normals = corner_normals(mesh);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    raster.triangle(placed_corners(view, mesh, f), label(f), [&](const auto& bary) {
      return lit(colour(f, bary), mixed_normal(view, normals[f], bary));
    });
  }
}

/// The same of one colour; label 0.
void draw_plain_mesh(Raster& raster, const View& view, const TriangleMesh& mesh);

/// A length given in pixels of a picture 600 wide, in one of another width.
double relative(double pixels, int width);

/// A document with the raster's image below the title. overlay(svg, top, font) draws over it, top being
/// the image's upper edge, and below it, in a strip as high as so many fonts.
std::string framed(const Raster& raster, const Shot& shot, const std::string& title, double strip,
                   const std::function<void(Svg&, double, double)>& overlay);

}  // namespace ucvt
