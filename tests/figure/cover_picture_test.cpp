#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cover/layout.h"
#include "oracle/meshes.h"
#include "result/cover_cells.h"
#include "result/cover_data.h"
#include "svg_reader.h"
#include "triangulation/frame.h"
#include "ucvt/error.h"
#include "ucvt/surface_figure.h"

namespace ucvt {
namespace {

using oracle::in_group;
using oracle::read_path;

const ClosedSurface& surface_of_genus(int genus) {
  static const std::vector<ClosedSurface> all{
      oracle::closed(oracle::icosphere(3)), oracle::closed(oracle::grid_torus(24, 12)),
      oracle::closed(oracle::voxel_frame(2)), oracle::closed(oracle::voxel_frame(3))};
  return all[static_cast<std::size_t>(genus)];
}

RemeshResult few_cells(int genus, int sites) {
  RemeshOptions options;
  options.sites = sites, options.iterations = 10, options.init = InitialSites::Random;
  return remesh(surface_of_genus(genus), options);
}

/// Cells in the cover; a sphere is its own.
struct Covered {
  explicit Covered(const RemeshResult& r) {
    if (r.report.genus > 0) {
      cover.emplace(r.surface);
      polygon.emplace(*cover);
    }
    cells = cover_cells(r, polygon ? &*polygon : nullptr, cover ? &*cover : nullptr);
  }
  std::optional<Cover> cover;
  std::optional<CentredPolygon> polygon;
  CoverCells cells;
};

double distance(double kappa, const ModelPoint& p, const ModelPoint& q) {
  const ModelPoint d{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  return std::sqrt(std::max(0.0, d[0] * d[0] + d[1] * d[1] + kappa * d[2] * d[2]));
}

TEST(CoverPicture, ShowsThePolygonItsCopiesAndItsSides) {
  for (const int genus : {1, 2, 3}) {
    const std::string svg = cover_picture(Cover(uniformize(surface_of_genus(genus))));
    const auto g = static_cast<std::size_t>(genus);
    EXPECT_EQ(in_group(svg, "copies", "path").size(), 16 * g * g - 8 * g);
    EXPECT_EQ(in_group(svg, "labels", "text").size(), 4 * g);
    const auto domain = in_group(svg, "domain", "path");
    ASSERT_EQ(domain.size(), 1U);
    // A move, a line to every other corner, and the end.
    EXPECT_EQ(read_path(domain[0].attributes.at("d")).size(), 4 * g + 1);
  }
}

TEST(CoverPicture, NamesTheSidesInOrder) {
  const std::string svg = cover_picture(Cover(uniformize(surface_of_genus(2))));
  std::string names;
  for (const auto& part : in_group(svg, "labels", "tspan")) {
    names += part.text;
  }
  const std::string inverse = "\u22121";
  EXPECT_EQ(names, "a1b1a1" + inverse + "b1" + inverse + "a2b2a2" + inverse + "b2" + inverse);
}

TEST(CoverPicture, CoordinatesOfAnotherGeometryAreRefused) {
  const Cover torus(uniformize(surface_of_genus(1))), double_torus(uniformize(surface_of_genus(2)));
  CoverPictureOptions options;
  options.coordinates = CoverCoordinates::Plane;
  EXPECT_NO_THROW(cover_picture(torus, options));
  EXPECT_THROW(cover_picture(double_torus, options), InvalidInput);
  for (const auto c : {CoverCoordinates::Poincare, CoverCoordinates::HalfPlane}) {
    options.coordinates = c;
    EXPECT_THROW(cover_picture(torus, options), InvalidInput);
    const auto domain = in_group(cover_picture(double_torus, options), "domain", "path");
    EXPECT_NE(domain[0].attributes.at("d").find('A'), std::string::npos) << "sides are arcs";
  }
  options.width = 10;
  EXPECT_THROW(cover_picture(torus, options), InvalidInput);
}

TEST(CoverPicture, MeshEdgesShowEveryFace) {
  const UniformizedSurface t = uniformize(surface_of_genus(2));
  CoverPictureOptions options;
  options.mesh_edges = true;
  const std::string svg = cover_picture(Cover(t), options);
  EXPECT_GE(in_group(svg, "mesh", "path").size(), surface_of_genus(2).mesh.faces.size());
}

TEST(CellCoverPicture, DrawsOneCellOneDotAndOneCentroidForEachSite) {
  for (const int genus : {1, 2}) {
    const RemeshResult r = few_cells(genus, 30);
    const std::string svg = cell_cover_picture(r);
    const auto g = static_cast<std::size_t>(genus);
    EXPECT_EQ(in_group(svg, "cells", "path").size(), r.sites.size());
    EXPECT_EQ(in_group(svg, "sites", "circle").size(), r.sites.size());
    EXPECT_EQ(in_group(svg, "centroids", "circle").size(), r.sites.size());
    EXPECT_EQ(in_group(svg, "copies", "path").size(), 16 * g * g - 8 * g);
    EXPECT_EQ(in_group(svg, "copy-cells", "path").size(), 16 * g * g - 8 * g);
    EXPECT_GE(in_group(svg, "copy-sites", "circle").size(), 8U);
  }
}

TEST(CellCoverPicture, ASphereIsShownWhole) {
  const RemeshResult r = few_cells(0, 40);
  const std::string svg = cell_cover_picture(r);
  EXPECT_EQ(in_group(svg, "sites", "circle").size(), r.sites.size());
}

TEST(CellCoverPicture, NeedsCells) {
  RemeshResult r = few_cells(1, 20);
  r.cells = nullptr;
  EXPECT_THROW(cell_cover_picture(r), InvalidInput);
}

TEST(CoverCells, FillTheSurfaceAndSurroundTheirSites) {
  for (const int genus : {0, 1, 2}) {
    const RemeshResult r = few_cells(genus, 60);
    const double kappa = genus == 0 ? 1 : genus == 1 ? 0 : -1;
    const Covered covered(r);
    const CoverCells& c = covered.cells;
    double area = 0;
    for (std::size_t i = 0; i < c.cells.size(); ++i) {
      const Frame at = frame_at(kappa, on_model(kappa, c.sites[i]));
      const auto& corners = c.cells[i].corners;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        area += central_triangle_area(
            {kappa}, offset_in(at, on_model(kappa, corners[k])),
            offset_in(at, on_model(kappa, corners[(k + 1) % corners.size()])));
      }
    }
    EXPECT_NEAR(area, r.surface.report().area, 1e-6 * area) << genus;
  }
}

TEST(CoverCells, ThreeMeetInEveryCorner) {
  // Copies included: cells of the domain reach across its sides.
  for (const int genus : {0, 1, 2}) {
    const RemeshResult r = few_cells(genus, 60);
    const Covered covered(r);
    const CoverCells& c = covered.cells;
    std::vector<ModelMatrix> lifts{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    if (covered.polygon) {
      const auto copies = covered.polygon->neighbours();
      lifts.insert(lifts.end(), copies.begin(), copies.end());
    }
    std::vector<ModelPoint> all;
    for (const ModelMatrix& m : lifts) {
      for (const SpaceCell& cell : c.cells) {
        for (const ModelPoint& p : cell.corners) {
          all.push_back(transformed(m, p));
        }
      }
    }
    const double kappa = genus == 0 ? 1 : genus == 1 ? 0 : -1;
    for (const SpaceCell& cell : c.cells) {
      for (const ModelPoint& p : cell.corners) {
        int ends = 0;
        for (const ModelPoint& q : all) {
          ends += distance(kappa, p, q) < 1e-5 ? 1 : 0;
        }
        EXPECT_GE(ends, 3) << genus;
      }
    }
  }
}

TEST(CentredPolygon, BringsEveryPointInside) {
  const Cover cover(uniformize(surface_of_genus(2)));
  const CentredPolygon polygon(cover);
  const auto neighbours = polygon.neighbours();
  // A point inside, seen in every copy, comes back to where it was.
  const ModelPoint inside{0, 0, 1};
  for (const ModelMatrix& m : neighbours) {
    const ModelPoint there = transformed(m, inside);
    const ModelPoint back = transformed(model_matrix(-1, polygon.bringing(there)), there);
    EXPECT_LT(distance(-1, back, inside), 1e-5);
  }
  EXPECT_LT(off_identity(polygon.bringing(inside)), 1e-12);
}

}  // namespace
}  // namespace ucvt
