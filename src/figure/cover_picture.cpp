#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cover/layout.h"
#include "figure/chart.h"
#include "figure/svg.h"
#include "result/cover_cells.h"
#include "result/cover_data.h"
#include "triangulation/frame.h"
#include "ucvt/error.h"
#include "ucvt/figure.h"
#include "ucvt/surface_figure.h"

namespace ucvt {
namespace {

/// The plane is shown within the parallelogram enlarged by this, the half plane within the polygon's
/// box likewise.
constexpr double torus_window = 1.5, half_plane_window = 1.6;
constexpr double tallest = 1.3;  ///< height over width

constexpr const char *shade = "#e3e6eb", *shade_edge = "#8b93a1", *copy_ink = "#5d6470";

/// Edges of cells in copies shorter than this, in pixels, are left out; so are dots of that radius.
constexpr double least_edge = 0.35, least_dot = 0.3;

Projection projection_of(double kappa, CoverCoordinates c) {
  if (kappa == 0) {
    return Projection::Plane;
  }
  return c == CoverCoordinates::Poincare    ? Projection::Poincare
         : c == CoverCoordinates::HalfPlane ? Projection::HalfPlane
                                            : Projection::Klein;
}

struct Box {
  double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
  void include(const Pixel& p) {
    x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
  }
};

ModelPoint middle(double kappa, const ModelPoint& a, const ModelPoint& b) {
  const ModelPoint s{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  const double n = std::sqrt(s[2] * s[2] + kappa * (s[0] * s[0] + s[1] * s[1]));
  return {s[0] / n, s[1] / n, s[2] / n};
}

/// A picture of a cover under construction.
class Sheet {
 public:
  Sheet(const Cover& cover, const CoverPictureOptions& options)
      : polygon_(cover), options_(options), copies_(polygon_.neighbours()) {
    if (options.width < 100 || options.width > 20000) {
      throw InvalidInput(fmt::format("width of {} pixels; give 100 to 20000", options.width));
    }
    chart_.projection = projection_of(polygon_.kappa(), options.coordinates);
    set_window();
  }

  [[nodiscard]] const CentredPolygon& polygon() const { return polygon_; }

  std::string finish(const auto& draw_inside, const auto& draw_above) {
    Svg svg(options_.width, height_, font());
    clip(svg, "window", window_);
    clip(svg, "domain", outline(chart_, polygon_.corners()).data());
    svg.open("g", {{"clip-path", "url(#window)"}});
    draw_polygons(svg);
    draw_inside(svg);
    draw_boundary(svg);
    draw_above(svg);
    svg.close();
    if (chart_.projection != Projection::Plane) {
      svg.element("path", {{"class", "rim"},
                           {"fill", "none"},
                           {"stroke", "#000000"},
                           {"stroke-width", "1.2"},
                           {"d", rim_}});
    }
    if (!options_.title.empty()) {
      svg.text({options_.width / 2.0, 1.5 * font()}, options_.title,
               {{"text-anchor", "middle"}, {"font-size", number(1.15 * font())}});
    }
    return std::move(svg).finish();
  }

  void draw_mesh(Svg& svg, const Cover& cover) const;
  void draw_labels(Svg& svg, const DeckGroup& group) const;
  void draw_cells(Svg& svg, const CoverCells& cells);
  void draw_dots(Svg& svg, const CoverCells& cells) const;

 private:
  [[nodiscard]] double font() const { return std::max(11.0, options_.width / 50.0); }
  [[nodiscard]] Box extent() const;
  void set_window();

  static void clip(Svg& svg, const std::string& id, const std::string& path) {
    svg.open("clipPath", {{"id", id}});
    svg.element("path", {{"d", path}});
    svg.close();
  }

  void draw_polygons(Svg& svg) const;
  void draw_boundary(Svg& svg) const;
  [[nodiscard]] bool in_window(const Pixel& p) const {
    return p.x > -20 && p.x < options_.width + 20 && p.y > -20 && p.y < height_ + 20;
  }
  void add_edges(const std::vector<ModelPoint>& corners, Path& path);
  void draw_dot(Svg& svg, const ModelPoint& p, const std::vector<ModelPoint>& corners,
                double least) const;

  CentredPolygon polygon_;
  const CoverPictureOptions& options_;
  std::vector<ModelMatrix> copies_;
  Chart chart_;
  double height_ = 0, dot_ = 1;
  std::string window_, rim_;
  std::set<std::pair<long, long>> drawn_;  ///< edges by their middles, in twentieths of a pixel
};

Box Sheet::extent() const {
  Box box;
  if (chart_.projection == Projection::Klein || chart_.projection == Projection::Poincare) {
    box.include({-1, -1}), box.include({1, 1});
    return box;
  }
  const auto& corners = polygon_.corners();
  Chart unit;  // pixels with y down
  unit.projection = chart_.projection;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    ModelPoint a = corners[i], b = corners[(i + 1) % corners.size()];
    const Pixel p = pixel(unit, a), q = pixel(unit, middle(polygon_.kappa(), a, b));
    const double by = chart_.projection == Projection::Plane ? torus_window : 1;
    box.include({by * p.x, -by * p.y});
    if (chart_.projection == Projection::HalfPlane) {
      box.include({q.x, -q.y});
    }
  }
  if (chart_.projection == Projection::HalfPlane) {
    const double pad = (half_plane_window - 1) / 2 * (box.x1 - box.x0);
    box.x0 -= pad, box.x1 += pad, box.y0 = 0, box.y1 *= half_plane_window;
  }
  return box;
}

void Sheet::set_window() {
  const Box box = extent();
  const double margin = 0.6 * font(), top = margin + (options_.title.empty() ? 0 : 1.9 * font());
  const double room = options_.width - 2 * margin;
  chart_.scale = std::min(room / (box.x1 - box.x0), tallest * room / (box.y1 - box.y0));
  const double bottom = top + chart_.scale * (box.y1 - box.y0);
  chart_.origin = {options_.width / 2.0 - chart_.scale * (box.x0 + box.x1) / 2,
                   bottom + chart_.scale * box.y0};
  height_ = std::ceil(bottom + margin);
  const Pixel& o = chart_.origin;
  const double r = chart_.scale;
  Path window, rim;
  if (chart_.projection == Projection::Plane) {
    std::vector<ModelPoint> corners = polygon_.corners();
    for (ModelPoint& p : corners) {
      p = {torus_window * p[0], torus_window * p[1], 1};
    }
    window_ = outline(chart_, corners).data();
  } else if (chart_.projection == Projection::HalfPlane) {
    const double x0 = o.x + r * box.x0, x1 = o.x + r * box.x1;
    window.move({x0, top}).line({x1, top}).line({x1, bottom}).line({x0, bottom}).close();
    window_ = window.data();
    rim_ = rim.move({x0, bottom}).line({x1, bottom}).data();
  } else {
    rim.move({o.x - r, o.y}).arc(r, true, {o.x + r, o.y}).arc(r, true, {o.x - r, o.y}).close();
    window_ = rim_ = rim.data();
  }
}

void Sheet::draw_polygons(Svg& svg) const {
  svg.open("g", {{"class", "copies"},
                 {"fill", shade},
                 {"stroke", shade_edge},
                 {"stroke-width", "0.8"},
                 {"stroke-linejoin", "round"}});
  for (const ModelMatrix& m : copies_) {
    svg.element("path", {{"d", outline(chart_, moved(m, polygon_.corners())).data()}});
  }
  svg.close();
  svg.open("g", {{"class", "domain"}, {"fill", "#ffffff"}});
  svg.element("path", {{"d", outline(chart_, polygon_.corners()).data()}});
  svg.close();
}

void Sheet::draw_boundary(Svg& svg) const {
  svg.open("g", {{"class", "boundary"},
                 {"fill", "none"},
                 {"stroke", "#000000"},
                 {"stroke-width", number(std::max(1.6, options_.width / 350.0))},
                 {"stroke-linejoin", "round"}});
  svg.element("path", {{"d", outline(chart_, polygon_.corners()).data()}});
  svg.close();
}

void Sheet::draw_mesh(Svg& svg, const Cover& cover) const {
  const CoverData& data = cover.data();
  const UniformSurface& t = data.surface.value().surface;
  const std::vector<DeckMap> layout = laid_out(t, data.system);
  const double kappa = polygon_.kappa();
  const auto place = [&](const DeckMap& m) {
    const Offset p = image_of_origin(product(kappa, polygon_.centring(), m));
    return ModelPoint{p.x, p.y, model_z({kappa}, p)};
  };
  svg.open("g", {{"class", "mesh"},
                 {"clip-path", "url(#domain)"},
                 {"fill", "none"},
                 {"stroke", "#7a8290"},
                 {"stroke-width", "0.5"}});
  for (std::size_t f = 0; f < layout.size(); f += 3) {
    const std::vector<ModelPoint> corners{place(layout[f]), place(layout[f + 1]),
                                          place(layout[f + 2])};
    // Once for every copy that a corner lies in: each of these lifts shows a part of the face.
    std::vector<ModelPoint> shown;
    for (const ModelPoint& p : corners) {
      const auto lift = moved(model_matrix(kappa, polygon_.bringing(p)), corners);
      const bool again = std::any_of(shown.begin(), shown.end(), [&](const ModelPoint& q) {
        const Pixel u = pixel(chart_, q), v = pixel(chart_, lift[0]);
        return std::hypot(u.x - v.x, u.y - v.y) < least_edge;
      });
      if (!again) {
        shown.push_back(lift[0]);
        svg.element("path", {{"d", outline(chart_, lift).data()}});
      }
    }
  }
  svg.close();
}

void Sheet::draw_labels(Svg& svg, const DeckGroup& group) const {
  const auto& corners = polygon_.corners();
  svg.open("g", {{"class", "corners"}, {"fill", "#000000"}});
  for (const ModelPoint& p : corners) {
    svg.circle(pixel(chart_, p), options_.width / 220.0);
  }
  svg.close();
  svg.open("g", {{"class", "labels"}});
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ModelPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const Pixel p = pixel(chart_, a), q = pixel(chart_, b);
    const double length = std::hypot(p.x - q.x, p.y - q.y);
    const double size = std::clamp(0.22 * length, 0.8 * font(), 1.9 * font());
    const bool curved =
        chart_.projection == Projection::Poincare || chart_.projection == Projection::HalfPlane;
    const Pixel at = curved ? pixel(chart_, middle(polygon_.kappa(), a, b))
                            : Pixel{(p.x + q.x) / 2, (p.y + q.y) / 2};
    // The polygon lies to the left of its sides.
    const double inwards = length > 0 ? 0.85 * size / length : 0;
    const std::int32_t letter = group.relator[i];
    const std::string& name = group.generators[static_cast<std::size_t>(std::abs(letter) - 1)].name;
    svg.symbol({at.x + inwards * (q.y - p.y), at.y - inwards * (q.x - p.x)}, name.substr(0, 1),
               name.substr(1), letter < 0 ? "\u22121" : "", size);
  }
  svg.close();
}

void Sheet::add_edges(const std::vector<ModelPoint>& corners, Path& path) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ModelPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const Pixel p = pixel(chart_, a), q = pixel(chart_, b);
    const bool visible =
        std::hypot(p.x - q.x, p.y - q.y) > least_edge && (in_window(p) || in_window(q));
    if (visible &&
        drawn_.emplace(std::lround(10 * (p.x + q.x)), std::lround(10 * (p.y + q.y))).second) {
      add_geodesic(chart_, a, b, path.move(p));
    }
  }
}

void Sheet::draw_cells(Svg& svg, const CoverCells& cells) {
  std::vector<double> areas;
  for (const SpaceCell& c : cells.cells) {
    areas.push_back(drawn_area(chart_, c.corners));
  }
  const std::size_t large = areas.size() * 3 / 4;
  std::nth_element(areas.begin(), areas.begin() + static_cast<std::ptrdiff_t>(large), areas.end());
  const double side = std::sqrt(areas[large]);
  dot_ = std::clamp(0.13 * side, 0.5, options_.width / 180.0);
  const std::string line = number(std::clamp(0.045 * side, 0.3, 1.1));
  svg.open("defs", {});
  svg.open("g", {{"id", "edges"},
                 {"fill", "none"},
                 {"stroke-width", line},
                 {"stroke-linecap", "round"},
                 {"stroke-linejoin", "round"}});
  svg.open("g", {{"class", "cells"}});
  for (const SpaceCell& c : cells.cells) {
    svg.element("path", {{"d", outline(chart_, c.corners).data()}});
    Path marked;
    add_edges(c.corners, marked);
  }
  svg.close();
  svg.open("g", {{"class", "copy-cells"}});
  for (const ModelMatrix& m : copies_) {
    Path path(2);
    for (const SpaceCell& c : cells.cells) {
      add_edges(moved(m, c.corners), path);
    }
    svg.element("path", {{"d", path.data()}});
  }
  svg.close();
  svg.close();
  svg.close();
  // Cells reach across the sides, either way: edges are black in the domain whosever they are.
  const Attribute edges{"xlink:href", "#edges"},
      xlink{"xmlns:xlink", "http://www.w3.org/1999/xlink"};
  svg.element("use", {xlink, edges, {"stroke", copy_ink}});
  svg.element("use", {xlink, edges, {"stroke", "#000000"}, {"clip-path", "url(#domain)"}});
}

void Sheet::draw_dot(Svg& svg, const ModelPoint& p, const std::vector<ModelPoint>& corners,
                     double least) const {
  const Pixel at = pixel(chart_, p);
  const double radius = std::min(dot_, 0.19 * std::sqrt(drawn_area(chart_, corners)));
  if (least == 0 || (radius >= least && in_window(at))) {
    svg.circle(at, std::max(radius, 0.1));
  }
}

void Sheet::draw_dots(Svg& svg, const CoverCells& cells) const {
  const std::string thin = number(std::max(0.3 * dot_, 0.2));
  svg.open("g", {{"class", "copy-sites"},
                 {"fill", "#ffffff"},
                 {"stroke", copy_ink},
                 {"stroke-width", number(0.5 * std::max(0.3 * dot_, 0.2))}});
  for (const ModelMatrix& m : copies_) {
    for (std::size_t i = 0; i < cells.sites.size(); ++i) {
      draw_dot(svg, moved(m, cells.sites[i]), moved(m, cells.cells[i].corners), least_dot);
    }
  }
  svg.close();
  svg.open(
      "g",
      {{"class", "centroids"}, {"fill", "#ffffff"}, {"stroke", "#000000"}, {"stroke-width", thin}});
  for (const SpaceCell& c : cells.cells) {
    draw_dot(svg, c.centroid, c.corners, 0);
  }
  svg.close();
  svg.open("g", {{"class", "sites"}, {"fill", "#000000"}});
  for (std::size_t i = 0; i < cells.sites.size(); ++i) {
    draw_dot(svg, cells.sites[i], cells.cells[i].corners, 0);
  }
  svg.close();
}

}  // namespace

std::string cover_picture(const Cover& cover, const CoverPictureOptions& options) {
  require_coordinates(cover.group().genus, options.coordinates);
  Sheet sheet(cover, options);
  const auto inside = [&](Svg& svg) {
    if (options.mesh_edges) {
      sheet.draw_mesh(svg, cover);
    }
  };
  return sheet.finish(inside, [&](Svg& svg) { sheet.draw_labels(svg, cover.group()); });
}

std::string cell_cover_picture(const RemeshResult& result, const CoverPictureOptions& options) {
  if (result.report.genus == 0) {
    const CoverCells cells = cover_cells(result, nullptr, nullptr);
    SpaceResult space;
    space.domain = sphere_domain();
    space.sites = cells.sites, space.cells = cells.cells;
    PictureOptions picture;
    picture.projection = Projection::BothHalves;
    picture.centroids = true;
    picture.width = options.width, picture.title = options.title;
    return space_picture(space, picture);
  }
  require_coordinates(result.report.genus, options.coordinates);
  const Cover cover(result.surface);
  Sheet sheet(cover, options);
  const CoverCells cells = cover_cells(result, &sheet.polygon(), &cover);
  return sheet.finish([&](Svg& svg) { sheet.draw_cells(svg, cells); },
                      [&](Svg& svg) { sheet.draw_dots(svg, cells); });
}

}  // namespace ucvt
