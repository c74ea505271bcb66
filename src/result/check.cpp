#include "ucvt/check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "conformal/uniformize.h"
#include "cvt/consistency.h"
#include "cvt/surface_cells.h"
#include "result/cell_complex.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Bounds far above rounding and far below what could be seen in a mesh.
constexpr double most_surface_angle_rad = 1e-9, most_site_angle_rad = 1e-6;
constexpr double most_area = 1e-6, most_mass = 1e-6, most_circle = 1e-6, most_place = 1e-5;

double angle_error(const UniformSurface& t) {
  std::vector<double> sum(t.connectivity().vertex_count());
  for (std::size_t i = 0; i < t.connectivity().halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    sum[t.connectivity().origin(h).index()] += t.angle(h);
  }
  double worst = 0;
  for (const double s : sum) {
    worst = std::max(worst, std::abs(s - 2 * std::numbers::pi));
  }
  return worst;
}

double relative(double value, double wanted) {
  return std::abs(value - wanted) / wanted;
}

void require(const char* what, double value, double most) {
  if (!(value <= most)) {
    throw NumericalError(fmt::format("the self-check failed: {} is {:.3g}, at most {:.0e} is sound",
                                     what, value, most));
  }
}

}  // namespace

SelfCheck measure_errors(const RemeshResult& result) {
  const UniformSurface& t = result.surface.value().surface;
  const CellComplex& cells = *result.cells;
  const SurfaceMass mass(t, result.density);
  double area = 0, in_cells = 0;
  for (std::size_t f = 0; f < t.connectivity().face_count(); ++f) {
    area += t.area({static_cast<std::int32_t>(f)});
  }
  for (const Moments& m :
       SurfaceCells(t, cells.delaunay, cells.places).moments(mass, cells.places)) {
    in_cells += m.m;
  }
  const Consistency c = measure_consistency(t, cells.delaunay, cells.places);
  return {angle_error(t),
          c.angle_sum_rad,
          relative(cells.delaunay.area(), area),
          relative(in_cells, mass.total()),
          c.circle,
          c.place};
}

void check(const RemeshResult& result) {
  const auto vertices = static_cast<std::int64_t>(result.mesh.positions.size());
  const auto faces = static_cast<std::int64_t>(result.mesh.faces.size());
  const std::int64_t euler = result.surface.value().surface.connectivity().euler_number();
  if (2 * vertices - faces != 2 * euler ||
      result.cells->delaunay.connectivity().euler_number() != euler) {
    throw NumericalError(fmt::format(
        "the self-check failed: {} vertices and {} faces do not have the Euler number {}", vertices,
        faces, euler));
  }
  const SelfCheck found = measure_errors(result);
  require("the error of an angle sum of the uniform surface", found.surface_angle_rad,
          most_surface_angle_rad);
  require("the error of the angles round a site", found.site_angle_rad, most_site_angle_rad);
  require("the error of the triangulation's area", found.area, most_area);
  require("the error of the cells' mass", found.mass, most_mass);
  require("the depth of a site in another's circle", found.circle, most_circle);
  require("the distance of a site from where its neighbours see it", found.place, most_place);
}

}  // namespace ucvt
