#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "figure/chart.h"
#include "figure/layers.h"
#include "figure/shading.h"
#include "figure/svg.h"
#include "ucvt/error.h"
#include "ucvt/figure.h"

namespace ucvt {
namespace {

/// The torus is shown within its parallelogram enlarged by this; 3 would show 8 whole copies.
constexpr double torus_window = 1.8;
constexpr double tallest = 1.5;  ///< of a plane picture, height over width

/// The projections that a domain has; the first is the automatic one.
std::vector<Projection> projections_of(DomainKind kind) {
  switch (kind) {
    case DomainKind::Sphere:
      return {Projection::Orthographic, Projection::BothHalves};
    case DomainKind::Torus:
    case DomainKind::PlanePolygon:
      return {Projection::Plane};
    default:
      return {Projection::Klein, Projection::Poincare};
  }
}

Projection chosen_projection(const Domain& domain, Projection asked) {
  const std::vector<Projection> offered = projections_of(domain.kind);
  if (asked == Projection::Automatic) {
    return offered[0];
  }
  if (std::find(offered.begin(), offered.end(), asked) == offered.end()) {
    throw InvalidInput(
        "the projection does not show this domain; use Automatic, or Orthographic or BothHalves "
        "for "
        "the sphere, Plane for plane and torus, Klein or Poincare for the hyperbolic plane");
  }
  return asked;
}

/// The torus has copies across its corners too: translations commute.
std::vector<ModelMatrix> copies_of(const Domain& domain) {
  std::vector<ModelMatrix> out = domain.across;
  if (domain.kind == DomainKind::Torus) {
    for (std::size_t i = 0; i < domain.across.size(); ++i) {
      out.push_back(product(domain.across[i], domain.across[(i + 1) % domain.across.size()]));
    }
  }
  return out;
}

std::vector<CentralPoint> enlarged(std::vector<CentralPoint> polygon, double factor) {
  CentralPoint centre{0, 0};
  for (const CentralPoint& p : polygon) {
    centre[0] += p[0] / static_cast<double>(polygon.size());
    centre[1] += p[1] / static_cast<double>(polygon.size());
  }
  for (CentralPoint& p : polygon) {
    p = {centre[0] + factor * (p[0] - centre[0]), centre[1] + factor * (p[1] - centre[1])};
  }
  return polygon;
}

struct Box {
  Pixel lo{-1, -1}, hi{1, 1};
};

/// What a chart must show, in picture coordinates.
Box extent(const Scene& scene, Projection projection) {
  if (projection != Projection::Plane) {
    return {};
  }
  const double far = std::numeric_limits<double>::max();
  Box box{{far, far}, {-far, -far}};
  const auto include = [&box](double x, double y) {
    box.lo = {std::min(box.lo.x, x), std::min(box.lo.y, y)};
    box.hi = {std::max(box.hi.x, x), std::max(box.hi.y, y)};
  };
  for (const CentralPoint& p : scene.window.empty() ? scene.domain.polygon : scene.window) {
    include(p[0], p[1]);
  }
  if (scene.window.empty()) {
    for (const SpaceCell& c : scene.cells) {
      for (const ModelPoint& p : c.corners) {
        include(p[0] / p[2], p[1] / p[2]);
      }
    }
  }
  return box;
}

/// Sets line width and dot size by the cells: a fraction of the side of the median cell.
void set_sizes(Scene& scene, const Chart& chart) {
  std::vector<double> areas;
  for (const SpaceCell& c : scene.cells) {
    const double area = drawn_area(chart, c.corners);
    if (area > 0) {
      areas.push_back(area);
    }
  }
  if (areas.empty()) {
    return;
  }
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  std::nth_element(areas.begin(), middle, areas.end());
  const double side = std::sqrt(*middle);
  scene.line = std::clamp(0.04 * side, 0.2, 1.2);
  scene.dot = std::clamp(0.085 * side, 0.4, 3.5);
}

bool finite(const ModelPoint& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

void check(const Scene& scene, const PictureOptions& o) {
  if (scene.cells.empty() || scene.cells.size() != scene.sites.size()) {
    throw InvalidInput(fmt::format("{} cells and {} sites; a picture needs one cell for each site",
                                   scene.cells.size(), scene.sites.size()));
  }
  for (std::size_t i = 0; i < scene.cells.size(); ++i) {
    const SpaceCell& c = scene.cells[i];
    if (!finite(c.centroid) || !finite(scene.sites[i]) ||
        !std::all_of(c.corners.begin(), c.corners.end(), finite)) {
      throw InvalidInput(fmt::format("a coordinate of cell {} is not finite; compute it anew", i));
    }
  }
  if (!std::isfinite(o.view_lon_deg) || !std::isfinite(o.view_lat_deg)) {
    throw InvalidInput("the view is not finite; give longitude and latitude in degrees");
  }
  if (o.width < 100 || o.width > 20000) {
    throw InvalidInput(fmt::format("width of {} pixels; give 100 to 20000", o.width));
  }
}

Scene make_scene(const SpaceResult& r, const PictureOptions& o) {
  Scene scene{
      r.domain, o, o.initial ? r.initial_cells : r.cells, o.initial ? r.initial_sites : r.sites, {},
      {},       {}};
  check(scene, o);
  scene.shading = shade(scene.cells, o);
  if (o.copies) {
    scene.copies = copies_of(r.domain);
  }
  if (r.domain.kind == DomainKind::Torus && !scene.copies.empty()) {
    scene.window = enlarged(r.domain.polygon, torus_window);
  }
  return scene;
}

}  // namespace

std::string space_picture(const SpaceResult& result, const PictureOptions& options) {
  Scene scene = make_scene(result, options);
  const Projection projection = chosen_projection(result.domain, options.projection);
  const bool halves = projection == Projection::BothHalves;
  const double width = options.width, font = std::max(11.0, width / 57), margin = font;

  const Box box = extent(scene, projection);
  const double wide = box.hi.x - box.lo.x, high = box.hi.y - box.lo.y;
  const double room = halves ? (width - 3 * margin) / 2 : width - 2 * margin;
  Chart chart;
  chart.projection = halves ? Projection::Orthographic : projection;
  chart.view = sphere_view(options.view_lon_deg, options.view_lat_deg);
  chart.scale = std::min(room / wide, tallest * width / high);
  const double top = margin + (options.title.empty() ? 0 : 1.8 * font);
  const double bottom = top + chart.scale * high;
  const double centre = halves ? margin + room / 2 : width / 2;
  chart.origin = {centre - chart.scale * (box.lo.x + box.hi.x) / 2,
                  bottom + chart.scale * box.lo.y};
  set_sizes(scene, chart);

  const double height = std::ceil(bottom + margin + legend_height(options.fill, font));
  Svg svg(width, height, font);
  draw_panel(svg, scene, chart, width, height);
  if (halves) {
    chart.origin.x += room + margin;
    chart.view = from_behind(chart.view);
    draw_panel(svg, scene, chart, width, height);
  }
  if (!options.title.empty()) {
    svg.text({width / 2, margin + font}, options.title,
             {{"text-anchor", "middle"}, {"font-size", number(1.15 * font)}});
  }
  draw_legend(svg, scene.shading, options, {width / 2, bottom + margin / 2}, 0.6 * width, font);
  return std::move(svg).finish();
}

}  // namespace ucvt
