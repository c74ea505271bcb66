#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "conformal/uniformize.h"
#include "figure/colour_bar.h"
#include "figure/solid.h"
#include "figure/surface_values.h"
#include "result/colouring.h"
#include "result/cover_data.h"
#include "result/loops_file.h"
#include "ucvt/error.h"
#include "ucvt/surface_figure.h"

namespace ucvt {
namespace {

constexpr Colour plain{222, 226, 232}, paper{250, 249, 245}, ink{25, 28, 36};
constexpr Colour no_value{150, 150, 150};

/// Widths in pixels of a picture 600 wide.
constexpr double boundary_width = 1.3, edge_width = 0.9, wire_width = 1.1, loop_radius = 3.2;

double relative(double pixels, int width) {
  return pixels * std::max(0.6, width / 600.0);
}

/// Puts the image into a document, below the title and above what `legend` draws from a height on.
std::string framed(const Raster& raster, const Shot& shot, const std::string& title,
                   double legend_height, const std::function<void(Svg&, double, double)>& overlay) {
  const double font = std::max(11.0, shot.width / 50.0);
  const double top = title.empty() ? 0 : std::ceil(2.2 * font);
  Svg svg(shot.width, std::ceil(top + shot.height + legend_height * font), font);
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

/// Draws a mesh, smoothly shaded. colour(face, bary) is its own, label(face) what it bears.
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

std::int32_t one_label(std::size_t) {
  return 0;
}

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
  draw_mesh(raster, shot.view, t.input, one_label, [&](std::size_t f, const auto& bary) {
    double v = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      v += bary[i] * value[static_cast<std::size_t>(t.input.faces[f][i])];
    }
    return std::isfinite(v) ? map_colour(r.hi > r.lo ? (v - r.lo) / (r.hi - r.lo) : 0.5) : no_value;
  });
  return framed(raster, shot, options.title, colour_bar_height + 0.4,
                [&](Svg& svg, double top, double font) {
                  svg.open("g", {{"class", "legend"}});
                  draw_colour_bar(svg, r.lo, r.hi,
                                  angle ? "largest stretch / smallest stretch"
                                        : "area on the surface / area in the cover, log10",
                                  {shot.width / 2.0, top + shot.height}, 0.6 * shot.width, font);
                  svg.close();
                });
}

// ---- loops

/// Dark enough to stand out from the surface and apart from each other (Tol's "bright" scheme).
constexpr Colour loop_colours[] = {{204, 51, 68},  {51, 102, 170}, {34, 136, 51}, {221, 136, 17},
                                   {136, 51, 136}, {0, 153, 170},  {110, 80, 40}};

Colour loop_colour(std::size_t i) {
  return loop_colours[i % std::size(loop_colours)];
}

/// Where a loop's name stands: where it is seen and farthest from the others and their names.
struct LoopLabel {
  bool seen = false;
  Pixel at;
};

constexpr std::size_t label_candidates = 150;

std::vector<std::vector<Pixel>> seen_points(const Raster& raster, const View& view,
                                            const std::vector<std::vector<Position>>& loops) {
  std::vector<std::vector<Pixel>> out;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    std::vector<Pixel>& seen = out.emplace_back();
    const std::size_t stride = std::max<std::size_t>(1, loops[i].size() / label_candidates);
    for (std::size_t k = 0; k < loops[i].size(); k += stride) {
      const Position p = view.place(loops[i][k]);
      if (raster.label_at(p[0], p[1]) == static_cast<std::int32_t>(i + 1)) {
        seen.push_back({p[0], p[1]});
      }
    }
  }
  return out;
}

std::vector<LoopLabel> place_labels(const std::vector<std::vector<Pixel>>& seen, double font,
                                    const Shot& shot) {
  std::vector<LoopLabel> out(seen.size());
  const auto room = [&](const Pixel& p, std::size_t own) {
    double nearest = std::min({p.x, p.y, shot.width - p.x, shot.height - p.y}) + font;
    for (std::size_t j = 0; j < seen.size(); ++j) {
      for (const Pixel& q : seen[j]) {
        nearest = j == own ? nearest : std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
      }
      if (out[j].seen) {
        nearest = std::min(nearest, std::hypot(p.x - out[j].at.x, p.y - out[j].at.y));
      }
    }
    return nearest;
  };
  for (std::size_t i = 0; i < seen.size(); ++i) {
    double most = -1;
    LoopLabel best;
    for (std::size_t k = 0; k < seen[i].size(); ++k) {
      const double here = room(seen[i][k], i);
      if (here > most) {
        most = here;
        // Beside the curve, on the side away from the picture's middle.
        const Pixel &p = seen[i][k], &q = seen[i][k + 1 < seen[i].size() ? k + 1 : k - 1];
        Pixel n{p.y - q.y, q.x - p.x};
        const double length = std::hypot(n.x, n.y);
        const double out_x = p.x - shot.width / 2.0, out_y = p.y - shot.height / 2.0;
        const double sign = n.x * out_x + n.y * out_y < 0 ? -1 : 1;
        const double by = length > 0 ? sign * 1.1 * font / length : 0;
        best = {true, {p.x + by * n.x, p.y + by * n.y}};
      }
    }
    out[i] = best;
  }
  return out;
}

void loops_legend(Svg& svg, const DeckGroup& group, double top, double width, double font) {
  const double item = 4 * font;
  const auto in_row = static_cast<std::size_t>(std::max(1.0, width / item));
  const std::size_t n = group.generators.size();
  svg.open("g", {{"class", "legend"}});
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t row = i / in_row, here = std::min(in_row, n - row * in_row);
    const double x =
        width / 2 + item * (static_cast<double>(i % in_row) - static_cast<double>(here) / 2);
    const double y = top + font * (1.2 + 1.8 * static_cast<double>(row));
    svg.line({x + 0.4 * font, y}, {x + 1.9 * font, y},
             {{"stroke", hex(loop_colour(i))}, {"stroke-width", number(0.3 * font)}});
    const std::string& name = group.generators[i].name;
    svg.symbol({x + 2.7 * font, y}, name.substr(0, 1), name.substr(1), "", 1.2 * font);
  }
  svg.close();
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

double dot_radius(const Partition& p, const View& view) {
  double area = 0;
  for (const PartitionCell& c : p.cells) {
    area += c.area_3d / static_cast<double>(p.cells.size());
  }
  return std::clamp(0.075 * std::sqrt(area) * view.scale, 0.7, 4.5);
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
  draw_mesh(raster, shot.view, t.input, one_label, [](std::size_t, const auto&) { return plain; });
  return framed(raster, shot, options.title, 0, [](Svg&, double, double) {});
}

std::string loops_picture(const Cover& cover, const SurfacePictureOptions& options) {
  const CoverData& data = cover.data();
  const Uniformized& t = data.surface.value();
  const Shot shot = fit(t.input, options);
  Raster raster(shot.width, shot.height);
  draw_mesh(raster, shot.view, t.input, one_label, [](std::size_t, const auto&) { return plain; });
  const auto loops = loops_on_input(t, data.system);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    draw_tube(raster, shot.view, loops[i], relative(loop_radius, shot.width),
              static_cast<std::int32_t>(i + 1),
              [i](const Position&, const Position& n) { return lit(loop_colour(i), n); });
  }
  const Position base = shot.view.place(loops[0][0]);
  raster.ball(base, 1.8 * relative(loop_radius, shot.width),
              static_cast<std::int32_t>(loops.size() + 1),
              [](const Position& n) { return lit(ink, n); });
  const double rows = std::ceil(static_cast<double>(loops.size()) * 4 / 50);
  return framed(
      raster, shot, options.title, 0.8 + 1.8 * rows, [&](Svg& svg, double top, double font) {
        const auto labels = place_labels(seen_points(raster, shot.view, loops), font, shot);
        svg.open("g", {{"class", "labels"}});
        for (std::size_t i = 0; i < labels.size(); ++i) {
          if (labels[i].seen) {
            const std::string& name = data.group.generators[i].name;
            svg.symbol({labels[i].at.x, top + labels[i].at.y}, name.substr(0, 1), name.substr(1),
                       "", 1.6 * font);
          }
        }
        svg.close();
        loops_legend(svg, data.group, top + shot.height, shot.width, font);
      });
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
  raster.outline(relative(boundary_width, shot.width), ink);
  const double radius = dot_radius(cells, shot.view);
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
