#include "figure/solid.h"

#include <cstddef>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "figure/chart.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

constexpr double margin = 0.02;   ///< of the width, on all sides
constexpr double tallest = 1.25;  ///< height over width, at most

/// Faces that turn by more than this at an edge are shaded as a crease.
const double crease_cosine = std::cos(50 * std::numbers::pi / 180);

/// From the upper left, before the surface; and what is seen of a surface that turns away from it.
constexpr Position light{-0.45, -0.55, 0.70};
constexpr double ambient = 0.5;

Position normalized(const Position& p) {
  const double n = std::sqrt(dot_product(p, p));
  return n > 0 ? Position{p[0] / n, p[1] / n, p[2] / n} : p;
}

ModelMatrix rolled(const ModelMatrix& view, double roll_deg) {
  const double roll = roll_deg * std::numbers::pi / 180;
  const double c = std::cos(roll), s = std::sin(roll);
  ModelMatrix out = view;
  for (std::size_t k = 0; k < 3; ++k) {
    // Turning the picture counterclockwise turns right and up the other way.
    out[0][k] = c * view[0][k] - s * view[1][k];
    out[1][k] = s * view[0][k] + c * view[1][k];
  }
  return out;
}

void check(const TriangleMesh& mesh, const SurfacePictureOptions& o) {
  if (!std::isfinite(o.camera.lon_deg) || !std::isfinite(o.camera.lat_deg) ||
      !std::isfinite(o.camera.roll_deg)) {
    throw InvalidInput("the camera is not finite; give longitude, latitude and roll in degrees");
  }
  if (o.width < 100 || o.width > 4000) {
    throw InvalidInput(fmt::format("width of {} pixels; give 100 to 4000", o.width));
  }
  if (mesh.faces.empty()) {
    throw InvalidInput("a mesh without faces has no picture");
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (const double x : mesh.positions[v]) {
      if (!std::isfinite(x)) {
        throw InvalidInput(fmt::format("a coordinate of vertex {} is not finite", v));
      }
    }
  }
}

const Position& corner(const TriangleMesh& mesh, std::size_t face, std::size_t i) {
  return mesh.positions[static_cast<std::size_t>(mesh.faces[face][i])];
}

}  // namespace

Position minus(const Position& a, const Position& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Position cross_product(const Position& a, const Position& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot_product(const Position& a, const Position& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Position View::place(const Position& p) const {
  const Position d = direction(p);
  return {origin.x + scale * d[0], origin.y + scale * d[1], scale * d[2]};
}

Position View::direction(const Position& p) const {
  return {dot_product(axes[0], p), -dot_product(axes[1], p), dot_product(axes[2], p)};
}

Shot fit(const TriangleMesh& mesh, const SurfacePictureOptions& options) {
  check(mesh, options);
  Shot out;
  out.width = options.width;
  out.view.axes =
      rolled(sphere_view(options.camera.lon_deg, options.camera.lat_deg), options.camera.roll_deg);
  Position lo, hi;
  lo.fill(std::numeric_limits<double>::infinity());
  hi.fill(-std::numeric_limits<double>::infinity());
  for (const Corners& f : mesh.faces) {
    for (const std::int32_t v : f) {
      const Position p = out.view.direction(mesh.positions[static_cast<std::size_t>(v)]);
      for (std::size_t k = 0; k < 3; ++k) {
        lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
      }
    }
  }
  const double pad = std::ceil(margin * options.width);
  const double wide = hi[0] - lo[0], high = hi[1] - lo[1];
  const double room = options.width - 2 * pad;
  out.view.scale = std::min(room / wide, tallest * options.width / high);
  if (!std::isfinite(out.view.scale)) {
    throw InvalidInput("all vertices of the mesh coincide in this view; nothing is seen of it");
  }
  out.height = static_cast<int>(std::ceil(out.view.scale * high + 2 * pad));
  out.view.origin = {options.width / 2.0 - out.view.scale * (lo[0] + hi[0]) / 2,
                     pad - out.view.scale * lo[1]};
  return out;
}

Colour lit(const Colour& colour, const Position& normal) {
  const double facing = std::max(0.0, dot_product(normal, normalized(light)));
  const double shade = std::min(1.0, ambient + (1.06 - ambient) * facing);
  const auto channel = [shade](int c) { return static_cast<int>(std::lround(c * shade)); };
  return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

std::vector<std::array<Position, 3>> corner_normals(const TriangleMesh& mesh) {
  std::vector<Position> normal;
  std::vector<std::vector<std::size_t>> round(mesh.positions.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Position& a = corner(mesh, f, 0);
    normal.push_back(cross_product(minus(corner(mesh, f, 1), a), minus(corner(mesh, f, 2), a)));
    for (const std::int32_t v : mesh.faces[f]) {
      round[static_cast<std::size_t>(v)].push_back(f);
    }
  }
  std::vector<std::array<Position, 3>> out(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Position own = normalized(normal[f]);
    for (std::size_t i = 0; i < 3; ++i) {
      Position sum{};
      for (const std::size_t g : round[static_cast<std::size_t>(mesh.faces[f][i])]) {
        if (dot_product(own, normalized(normal[g])) > crease_cosine) {
          for (std::size_t k = 0; k < 3; ++k) {
            sum[k] += normal[g][k];
          }
        }
      }
      out[f][i] = normalized(sum);
    }
  }
  return out;
}

Position mixed_normal(const View& view, const std::array<Position, 3>& normals,
                      const std::array<double, 3>& bary) {
  Position sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += bary[i] * normals[i][k];
    }
  }
  const Position n = normalized(view.direction(sum));
  return n[2] < 0 ? Position{-n[0], -n[1], -n[2]} : n;
}

std::array<Position, 3> placed_corners(const View& view, const TriangleMesh& mesh,
                                       std::size_t face) {
  return {view.place(corner(mesh, face, 0)), view.place(corner(mesh, face, 1)),
          view.place(corner(mesh, face, 2))};
}

void draw_plain_mesh(Raster& raster, const View& view, const TriangleMesh& mesh) {
  draw_mesh(
      raster, view, mesh, [](std::size_t) { return 0; },
      [](std::size_t, const auto&) { return plain_surface; });
}

double relative(double pixels, int width) {
  return pixels * std::max(0.6, width / 600.0);
}

std::string framed(const Raster& raster, const Shot& shot, const std::string& title, double strip,
                   const std::function<void(Svg&, double, double)>& overlay) {
  const double font = std::max(11.0, shot.width / 50.0);
  const double top = title.empty() ? 0 : std::ceil(2.2 * font);
  Svg svg(shot.width, std::ceil(top + shot.height + strip * font), font);
  svg.element("image",
              {{"class", "surface"},
               {"x", "0"},
               {"y", number(top)},
               {"width", number(shot.width)},
               {"height", number(shot.height)},
               {"xmlns:xlink", "http://www.w3.org/1999/xlink"},
               {"xlink:href", "data:image/png;base64," + base64(png_bytes(raster.image()))}});
  if (!title.empty()) {
    svg.text({shot.width / 2.0, 1.4 * font}, title,
             {{"text-anchor", "middle"}, {"font-size", number(1.15 * font)}});
  }
  overlay(svg, top, font);
  return std::move(svg).finish();
}

}  // namespace ucvt
