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
constexpr double most_area = 1e-6, most_mass = 1e-6, most_circle = 1e-6, most_place = 1e-5,
                 most_mirror = 1e-6;

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

/// Sites of an open surface on its boundary, each the start of a boundary edge.
std::int64_t boundary_sites(const RemeshResult& result) {
  return result.report.boundary_loops == 0
             ? 0
             : static_cast<std::int64_t>(2 * result.mesh.positions.size() - result.sites.size());
}

/// Sites of an open surface: those on its boundary, then pair by pair. Areas on T: the density is linear
/// over its faces, which need not be symmetric where two pairs of them lie on one circle.
double mirror_error(const RemeshResult& result, const SurfaceCells& found) {
  const UniformSurface& t = result.surface.value().surface;
  const std::vector<Moments> cells = found.moments(
      SurfaceMass(t, std::vector<double>(result.density.size(), 1.0)), result.cells->places);
  double worst = 0;
  for (auto i = static_cast<std::size_t>(boundary_sites(result)); i < cells.size(); i += 2) {
    worst = std::max(worst, relative(cells[i].m, cells[i + 1].m));
  }
  return worst;
}

/// By counts: in a mesh with loops and double edges vertices do not tell edges apart.
void check_topology(const RemeshResult& result) {
  const RemeshReport& r = result.report;
  const auto vertices = static_cast<std::int64_t>(result.mesh.positions.size());
  const auto faces = static_cast<std::int64_t>(result.mesh.faces.size());
  const std::int64_t boundary = boundary_sites(result);
  const std::int64_t euler = 2 - 2 * r.genus - r.boundary_loops;
  const std::int64_t whole = r.boundary_loops > 0 ? 2 * euler : euler;
  if (2 * vertices - faces - boundary != 2 * euler ||
      result.surface.value().surface.connectivity().euler_number() != whole ||
      result.cells->delaunay.connectivity().euler_number() != whole) {
    throw NumericalError(fmt::format(
        "the self-check failed: {} vertices, {} faces and {} boundary edges do not have the Euler "
        "number {}",
        vertices, faces, boundary, euler));
  }
  if (r.simplicial && survey(result.mesh).boundary_loops != r.boundary_loops) {
    throw NumericalError(fmt::format(
        "the self-check failed: the mesh does not have {} boundary loops", r.boundary_loops));
  }
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
  const SurfaceCells found(t, cells.delaunay, cells.places);
  for (const Moments& m : found.moments(mass, cells.places)) {
    in_cells += m.m;
  }
  const Consistency c = measure_consistency(t, cells.delaunay, cells.places);
  return {angle_error(t),
          c.angle_sum_rad,
          relative(cells.delaunay.area(), area),
          relative(in_cells, mass.total()),
          c.circle,
          c.place,
          result.report.boundary_loops > 0 ? mirror_error(result, found) : 0};
}

void check(const RemeshResult& result) {
  check_topology(result);
  const SelfCheck found = measure_errors(result);
  require("the error of an angle sum of the uniform surface", found.surface_angle_rad,
          most_surface_angle_rad);
  require("the error of the angles round a site", found.site_angle_rad, most_site_angle_rad);
  require("the error of the triangulation's area", found.area, most_area);
  require("the error of the cells' mass", found.mass, most_mass);
  require("the depth of a site in another's circle", found.circle, most_circle);
  require("the distance of a site from where its neighbours see it", found.place, most_place);
  require("the difference of a cell's area from its mirror image's", found.mirror, most_mirror);
}

}  // namespace ucvt
