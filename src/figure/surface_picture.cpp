#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "conformal/uniformize.h"
#include "figure/colour_bar.h"
#include "figure/solid.h"
#include "figure/surface_values.h"
#include "result/colouring.h"
#include "ucvt/surface_figure.h"

namespace ucvt {
namespace {

constexpr Colour paper{250, 249, 245};
constexpr Colour no_value{150, 150, 150};

/// Widths in pixels of a picture 600 wide.
constexpr double boundary_width = 1.3, edge_width = 0.9, wire_width = 1.1;

// ---- values on the surface

struct ColourRange {
  double lo = 0, hi = 0;
};

ColourRange range_of(std::vector<double> values, SurfaceValue shown) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) {
    return {1, 1};
  }
  const auto percentile = [&values](std::size_t p) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * p / 100);
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  return {shown == SurfaceValue::Angle ? 1 : percentile(2), percentile(98)};
}

std::string value_picture(const Uniformized& t, SurfaceValue shown,
                          const SurfacePictureOptions& options) {
  const bool angle = shown == SurfaceValue::Angle;
  const std::vector<double> value = angle ? angle_distortion(t) : area_distortion(t);
  const ColourRange r = range_of(value, shown);
  const Shot shot = fit(t.input, options);
  Raster raster(shot.width, shot.height);
  draw_mesh(
      raster, shot.view, t.input, [](std::size_t) { return 0; },
      [&](std::size_t f, const auto& bary) {
        double v = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          v += bary[i] * value[static_cast<std::size_t>(t.input.faces[f][i])];
        }
        return std::isfinite(v) ? map_colour(r.hi > r.lo ? (v - r.lo) / (r.hi - r.lo) : 0.5)
                                : no_value;
      });
  return framed(raster, shot, options.title, colour_bar_height + 0.4,
                [&](Svg& svg, double top, double font) {
                  svg.open("g", {{"class", "legend"}});
                  draw_colour_bar(svg,
                                  {r.lo, r.hi,
                                   angle ? "largest stretch / smallest stretch"
                                         : "area on the surface / area in the cover, log10"},
                                  {shot.width / 2.0, top + shot.height}, 0.6 * shot.width, font);
                  svg.close();
                });
}

// ---- cells

/// The normals of the input, at the corners of a face of the cut surface.
class InputNormals {
 public:
  explicit InputNormals(const Uniformized& t)
      : t_(t), normals_(corner_normals(t.input)), place_(t.input.faces.size()) {
    for (std::size_t f = 0; f < place_.size(); ++f) {
      place_[static_cast<std::size_t>(t.input_face[f])] = f;
    }
  }

  [[nodiscard]] std::array<Position, 3> at(const Partition& p, std::size_t face) const {
    const std::size_t f = place_[static_cast<std::size_t>(p.input_face[face])];
    const auto corner = [&](std::size_t i) -> const Position& {
      return t_.input.positions[static_cast<std::size_t>(t_.input.faces[f][i])];
    };
    const Position u = minus(corner(1), corner(0)), v = minus(corner(2), corner(0));
    const double uu = dot_product(u, u), uv = dot_product(u, v), vv = dot_product(v, v);
    const double det = uu * vv - uv * uv;
    std::array<Position, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Position w =
          minus(p.mesh.positions[static_cast<std::size_t>(p.mesh.faces[face][i])], corner(0));
      const double wu = dot_product(w, u), wv = dot_product(w, v);
      const double b1 = det > 0 ? (vv * wu - uv * wv) / det : 0;
      const double b2 = det > 0 ? (uu * wv - uv * wu) / det : 0;
      for (std::size_t k = 0; k < 3; ++k) {
        out[i][k] =
            (1 - b1 - b2) * normals_[f][0][k] + b1 * normals_[f][1][k] + b2 * normals_[f][2][k];
      }
    }
    return out;
  }

 private:
  const Uniformized& t_;
  std::vector<std::array<Position, 3>> normals_;
  std::vector<std::size_t> place_;  ///< by face of the closed surface: its number in t.input
};

/// The side, in pixels, of a square as large as the cells are on average.
double cell_side(const Partition& p, const View& view) {
  double area = 0;
  for (const PartitionCell& c : p.cells) {
    area += c.area_3d / static_cast<double>(p.cells.size());
  }
  return std::sqrt(area) * view.scale;
}

// ---- wires

std::set<std::pair<std::int32_t, std::int32_t>> edges_of(const TriangleMesh& mesh) {
  std::set<std::pair<std::int32_t, std::int32_t>> out;
  for (const Corners& f : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      out.insert(std::minmax(f[i], f[(i + 1) % 3]));
    }
  }
  return out;
}

void draw_wires(Raster& raster, const Shot& shot, const TriangleMesh& mesh) {
  double near = -std::numeric_limits<double>::infinity(), far = -near;
  for (const Position& p : mesh.positions) {
    const double z = shot.view.place(p)[2];
    near = std::max(near, z), far = std::min(far, z);
  }
  const auto shade = [&](const Position& at, const Position&) {
    const double t = near > far ? (near - at[2]) / (near - far) : 0;
    const auto mix = [t](int a) { return static_cast<int>(std::lround(a + t * (222 - a))); };
    return Colour{mix(ink.r), mix(ink.g), mix(ink.b)};
  };
  for (const auto& [a, b] : edges_of(mesh)) {
    const auto at = [&](std::int32_t v) { return mesh.positions[static_cast<std::size_t>(v)]; };
    draw_tube(raster, shot.view, {at(a), at(b)}, relative(wire_width, shot.width) / 2, 0, shade);
  }
}

}  // namespace

std::string surface_picture(const UniformizedSurface& surface, SurfaceValue value,
                            const SurfacePictureOptions& options) {
  const Uniformized& t = surface.value();
  if (value != SurfaceValue::None) {
    return value_picture(t, value, options);
  }
  const Shot shot = fit(t.input, options);
  Raster raster(shot.width, shot.height);
  draw_plain_mesh(raster, shot.view, t.input);
  return framed(raster, shot, options.title, 0, [](Svg&, double, double) {});
}

std::string cells_picture(const RemeshResult& result, const Partition& cells,
                          const SurfacePictureOptions& options) {
  const Shot shot = fit(cells.mesh, options);
  Raster raster(shot.width, shot.height);
  const InputNormals normals(result.surface.value());
  for (std::size_t f = 0; f < cells.mesh.faces.size(); ++f) {
    const auto cell = static_cast<std::size_t>(cells.cell[f]);
    const auto colour = static_cast<std::size_t>(cells.cells[cell].colour);
    const auto& rgb = cell_palette[colour % cell_palette.size()];
    const auto normal = normals.at(cells, f);
    raster.triangle(placed_corners(shot.view, cells.mesh, f), cells.cell[f], [&](const auto& bary) {
      return lit({rgb[0], rgb[1], rgb[2]}, mixed_normal(shot.view, normal, bary));
    });
  }
  const double side = cell_side(cells, shot.view);
  raster.outline(std::min(relative(boundary_width, shot.width), std::max(0.09 * side, 0.5)), ink);
  const double radius = std::clamp(0.075 * side, 0.6, 4.5);
  for (const PartitionCell& c : cells.cells) {
    raster.ball(shot.view.place(c.site), radius, 0,
                [](const Position&) { return Colour{0, 0, 0}; });
  }
  return framed(raster, shot, options.title, 0, [](Svg&, double, double) {});
}

std::string mesh_picture(const TriangleMesh& mesh, MeshStyle style,
                         const SurfacePictureOptions& options) {
  const Shot shot = fit(mesh, options);
  Raster raster(shot.width, shot.height);
  if (style == MeshStyle::Wireframe) {
    draw_wires(raster, shot, mesh);
  } else {
    draw_mesh(
        raster, shot.view, mesh, [](std::size_t f) { return static_cast<std::int32_t>(f); },
        [](std::size_t, const auto&) { return paper; });
    raster.outline(relative(edge_width, shot.width), ink);
  }
  return framed(raster, shot, options.title, 0, [](Svg&, double, double) {});
}

}  // namespace ucvt
