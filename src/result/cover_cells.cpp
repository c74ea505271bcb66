#include "result/cover_cells.h"

#include <cmath>

#include "cover/layout.h"
#include "cvt/surface_cells.h"
#include "result/cell_complex.h"
#include "result/cover_data.h"
#include "triangulation/frame.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// The frame at an offset whose first axis points to another offset.
DeckMap frame_towards(Space s, const Offset& at, const Offset& to) {
  const double a = std::sqrt(1 - s.kappa * at.h / 2);
  const Offset there = transvect_back(s, at, to);
  const double half = std::atan2(there.y, there.x) / 2;
  return normalized(s.kappa, product(s.kappa, {{a, 0}, {at.x / (2 * a), at.y / (2 * a)}},
                                     {{std::cos(half), std::sin(half)}, {}}));
}

/// From the sites' frames to the picture's, by the layout of T.
std::vector<ModelMatrix> in_polygon(const CellComplex& cells, const CentredPolygon& polygon,
                                    const Cover& cover) {
  const UniformSurface& t = cover.data().surface.value().surface;
  const Space s = t.space();
  const std::vector<DeckMap> corner = laid_out(t, cover.data().system);
  const auto direction = half_directions(t);
  std::vector<ModelMatrix> out;
  for (const Place& p : cells.places) {
    const Halfedge h = halfedges(p.face)[0];
    const DeckMap on_t = product(s.kappa, corner[h.index()], {direction[h.index()], {}});
    const DeckMap site = product(s.kappa, product(s.kappa, polygon.centring(), on_t),
                                 inverse(frame_towards(s, p.corner[0], p.corner[1])));
    const Offset at = image_of_origin(site);
    const DeckMap lift = polygon.bringing({at.x, at.y, model_z(s, at)});
    out.push_back(model_matrix(s.kappa, product(s.kappa, lift, site)));
  }
  return out;
}

/// From the sites' frames to that of T's first face, on the sphere.
std::vector<ModelMatrix> on_sphere(const CellComplex& cells, const UniformSurface& t) {
  const Space s = t.space();
  const auto corner = fundamental_domain(t, {0});
  std::vector<ModelMatrix> out;
  for (const Place& p : cells.places) {
    const auto& there = corner[p.face.index()];
    const Offset along = from_chord(s, t.chord(halfedges(p.face)[0]), 1, 0);
    const Isometry local = placing(s, along, p.corner[0], p.corner[1]);
    const Isometry laid = placing(s, along, there[0], there[1]);
    ModelMatrix m{};
    const auto image = [&](const Offset& x) {
      const Offset y = laid.apply(s, local.apply_inverse(s, x));
      return ModelPoint{y.x, y.y, model_z(s, y)};
    };
    const std::array<ModelPoint, 3> column{image({1, 0, 1}), image({0, 1, 1}), image({0, 0, 0})};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        m[i][j] = column[j][i];
      }
    }
    out.push_back(m);
  }
  return out;
}

}  // namespace

CoverCells cover_cells(const RemeshResult& result, const CentredPolygon* polygon,
                       const Cover* cover) {
  if (!result.cells || result.report.boundary_loops > 0) {
    throw InvalidInput("only a closed surface's cells can be developed; take them from remesh");
  }
  const CellComplex& complex = *result.cells;
  const DelaunayTriangulation& d = complex.delaunay;
  const UniformSurface& t = result.surface.value().surface;
  const Space s = t.space();
  const std::vector<ModelMatrix> place =
      cover != nullptr ? in_polygon(complex, *polygon, *cover) : on_sphere(complex, t);
  const SurfaceMass mass(t, result.density);
  const std::vector<Moments> moments =
      SurfaceCells(t, d, complex.places).moments(mass, complex.places);
  const auto placed = [&](std::size_t i, const Offset& x) {
    return transformed(place[i], {x.x, x.y, model_z(s, x)});
  };
  CoverCells out;
  for (std::size_t i = 0; i < complex.places.size(); ++i) {
    SpaceCell& cell = out.cells.emplace_back();
    d.connectivity().for_outgoing({static_cast<std::int32_t>(i)}, [&](Halfedge h) {
      const Central k = circumcentre(d.offset(h), d.offset(d.connectivity().rotate(h)));
      cell.corners.push_back(placed(i, from_central(s, k.x, k.y)));
      ++cell.degree;
    });
    cell.centroid = placed(i, centroid(s, moments[i]));
    out.sites.push_back(placed(i, {}));
  }
  return out;
}

}  // namespace ucvt
