#include "figure/layers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ucvt {
namespace {

std::vector<ModelPoint> model_points(const Domain& domain, const std::vector<CentralPoint>& k) {
  std::vector<ModelPoint> out;
  for (const CentralPoint& p : k) {
    out.push_back(lifted(domain.kappa, p));
  }
  return out;
}

void draw_cells(Svg& svg, const Scene& scene, const Chart& chart) {
  svg.open("g", {{"class", "cells"},
                 {"stroke", "#000000"},
                 {"stroke-width", number(scene.line)},
                 {"stroke-linejoin", "round"}});
  for (std::size_t i = 0; i < scene.cells.size(); ++i) {
    const Path path = outline(chart, scene.cells[i].corners);
    if (!path.empty()) {
      svg.element("path", {{"fill", hex(scene.shading.colour[i])}, {"d", path.data()}});
    }
  }
  svg.close();
}

/// Whether some of a cell of the torus can lie in the window.
bool in_window(const Scene& scene, const std::vector<ModelPoint>& corners) {
  if (scene.window.empty()) {
    return true;
  }
  for (int axis = 0; axis < 2; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const auto by_axis = [k](const auto& a, const auto& b) { return a[k] < b[k]; };
    const auto [c0, c1] = std::minmax_element(corners.begin(), corners.end(), by_axis);
    const auto [w0, w1] = std::minmax_element(scene.window.begin(), scene.window.end(), by_axis);
    if ((*c1)[k] < (*w0)[k] || (*c0)[k] > (*w1)[k]) {
      return false;
    }
  }
  return true;
}

void draw_copies(Svg& svg, const Scene& scene, const Chart& chart) {
  svg.open("g", {{"class", "copies"},
                 {"stroke", "#a0a0a0"},
                 {"stroke-width", number(0.6 * scene.line)},
                 {"stroke-linejoin", "round"}});
  for (const ModelMatrix& m : scene.copies) {
    for (std::size_t i = 0; i < scene.cells.size(); ++i) {
      const std::vector<ModelPoint> corners = moved(m, scene.cells[i].corners);
      if (!in_window(scene, corners)) {
        continue;
      }
      svg.element("path", {{"fill", hex(faded(scene.shading.colour[i]))},
                           {"d", outline(chart, corners).data()}});
    }
  }
  svg.close();
}

/// One dot for each visible point; a dot is smaller where its cell is much smaller than most.
void draw_dots(Svg& svg, const Scene& scene, const Chart& chart, bool centroids,
               const ModelMatrix* copy) {
  for (std::size_t i = 0; i < scene.cells.size(); ++i) {
    const SpaceCell& cell = scene.cells[i];
    ModelPoint p = centroids ? cell.centroid : scene.sites[i];
    std::vector<ModelPoint> corners = cell.corners;
    if (copy != nullptr) {
      p = moved(*copy, p), corners = moved(*copy, std::move(corners));
    }
    if (!visible(chart, p) || (copy != nullptr && !in_window(scene, corners))) {
      continue;
    }
    const double own = 0.16 * std::sqrt(drawn_area(chart, corners));
    svg.circle(pixel(chart, p), std::max(std::min(scene.dot, own), 0.1));
  }
}

void draw_points(Svg& svg, const Scene& scene, const Chart& chart) {
  if (scene.options.sites) {
    svg.open("g", {{"class", "sites"}, {"fill", "#000000"}});
    draw_dots(svg, scene, chart, false, nullptr);
    svg.close();
  }
  if (scene.options.centroids) {
    svg.open("g", {{"class", "centroids"},
                   {"fill", "#ffffff"},
                   {"stroke", "#000000"},
                   {"stroke-width", number(std::max(0.35 * scene.dot, 0.2))}});
    draw_dots(svg, scene, chart, true, nullptr);
    svg.close();
  }
}

/// Hides what copies show outside of the window: the picture without the window, in white.
void draw_mask(Svg& svg, const Scene& scene, const Chart& chart, double width, double height) {
  const Path window = outline(chart, model_points(scene.domain, scene.window));
  Path picture;
  picture.move({0, 0}).line({width, 0}).line({width, height}).line({0, height}).close();
  svg.element("path", {{"class", "mask"},
                       {"fill", "#ffffff"},
                       {"fill-rule", "evenodd"},
                       {"d", picture.data() + window.data()}});
}

void draw_boundary(Svg& svg, const Scene& scene, const Chart& chart) {
  svg.open("g", {{"class", "boundary"},
                 {"fill", "none"},
                 {"stroke", "#000000"},
                 {"stroke-width", number(std::max(1.4, 1.6 * scene.line))},
                 {"stroke-linejoin", "round"}});
  if (chart.projection != Projection::Plane) {
    svg.circle(chart.origin, chart.scale);
  }
  const Path polygon = outline(chart, model_points(scene.domain, scene.domain.polygon));
  if (!polygon.empty()) {
    svg.element("path", {{"d", polygon.data()}});
  }
  svg.close();
}

}  // namespace

void draw_panel(Svg& svg, const Scene& scene, const Chart& chart, double width, double height) {
  if (!scene.copies.empty()) {
    draw_copies(svg, scene, chart);
  }
  draw_cells(svg, scene, chart);
  if (!scene.copies.empty() && scene.options.sites) {
    svg.open("g", {{"class", "copy-sites"}, {"fill", "#a0a0a0"}});
    for (const ModelMatrix& m : scene.copies) {
      draw_dots(svg, scene, chart, false, &m);
    }
    svg.close();
  }
  if (!scene.window.empty()) {
    draw_mask(svg, scene, chart, width, height);
  }
  draw_boundary(svg, scene, chart);
  draw_points(svg, scene, chart);
}

}  // namespace ucvt
