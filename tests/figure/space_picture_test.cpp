#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "figure/samples.h"
#include "figure/svg_reader.h"
#include "ucvt/error.h"
#include "ucvt/figure.h"

namespace ucvt {
namespace {

using oracle::in_group;
using oracle::read_svg;

std::size_t count(const std::string& svg, const std::string& group, const std::string& name) {
  return in_group(svg, group, name).size();
}

TEST(SpacePicture, SphereShowsTheFrontOnly) {
  const std::string svg = space_picture(oracle::cube(1), {.centroids = true});
  EXPECT_EQ(count(svg, "cells", "path"), 5U) << "the face behind is hidden";
  EXPECT_EQ(count(svg, "sites", "circle"), 1U) << "sites on the horizon and behind it are hidden";
  EXPECT_EQ(count(svg, "centroids", "circle"), 1U);
  EXPECT_EQ(count(svg, "boundary", "circle"), 1U);
}

TEST(SpacePicture, BothHalvesShowEverySite) {
  const std::string svg =
      space_picture(oracle::cube(3),
                    {.projection = Projection::BothHalves, .view_lon_deg = 17, .view_lat_deg = 23});
  EXPECT_EQ(count(svg, "sites", "circle"), 54U);
  EXPECT_EQ(count(svg, "boundary", "circle"), 2U);
  const auto root = read_svg(svg)[0];
  EXPECT_GT(root.number("width"), 1.8 * root.number("height"));
}

TEST(SpacePicture, BothHalvesShowEachSiteOnce) {
  SpaceResult r = oracle::cube(1);
  r.cells.resize(1), r.sites.resize(1);
  const std::string svg = space_picture(r, {.projection = Projection::BothHalves});
  EXPECT_EQ(count(svg, "cells", "path"), 1U);
  EXPECT_EQ(count(svg, "sites", "circle"), 1U);
}

TEST(SpacePicture, PlaneShowsAllCellsAndTheBoundary) {
  const std::string svg = space_picture(oracle::square(4), {.centroids = true});
  EXPECT_EQ(count(svg, "cells", "path"), 16U);
  EXPECT_EQ(count(svg, "sites", "circle"), 16U);
  EXPECT_EQ(count(svg, "centroids", "circle"), 16U);
  EXPECT_EQ(count(svg, "boundary", "path"), 1U);
  EXPECT_EQ(count(svg, "boundary", "circle"), 0U);
  EXPECT_EQ(count(svg, "copies", "path"), 0U);
  EXPECT_EQ(count(svg, "legend", "rect"), 0U);
  const auto root = read_svg(svg)[0];
  EXPECT_EQ(root.number("width"), 800);
  EXPECT_NEAR(root.number("height"), 400, 30) << "the domain is twice as wide as high";
}

TEST(SpacePicture, InitialCellsOnDemand) {
  SpaceResult r = oracle::square(4);
  r.initial_cells = oracle::square(3).cells, r.initial_sites = oracle::square(3).sites;
  EXPECT_EQ(count(space_picture(r, {.initial = true}), "cells", "path"), 9U);
}

TEST(SpacePicture, TorusShowsEightNeighbours) {
  // With one cell every copy reaches into the window.
  EXPECT_EQ(count(space_picture(oracle::torus(1)), "copies", "path"), 8U);
  EXPECT_EQ(count(space_picture(oracle::torus(1)), "copy-sites", "circle"), 8U);
  const std::string many = space_picture(oracle::torus(6));
  EXPECT_EQ(count(many, "cells", "path"), 36U);
  EXPECT_LT(count(many, "copies", "path"), 8U * 36U) << "cells outside of the window are left out";
  EXPECT_GT(count(many, "copies", "path"), 2U * 36U);
  EXPECT_EQ(count(many, "copy-sites", "circle"), count(many, "copies", "path"));
  EXPECT_EQ(count(space_picture(oracle::torus(6), {.copies = false}), "copies", "path"), 0U);
}

TEST(SpacePicture, CopiesOfTheTorusAreLatticeTranslates) {
  const std::string svg = space_picture(oracle::torus(1));
  const auto corner = [](const oracle::SvgElement& e) {
    return oracle::read_path(e.attributes.at("d"))[0];
  };
  const auto cell = oracle::read_path(in_group(svg, "cells", "path")[0].attributes.at("d"));
  const double ax = cell[1].x - cell[0].x, ay = cell[1].y - cell[0].y;
  const double bx = cell[3].x - cell[0].x, by = cell[3].y - cell[0].y;
  std::set<std::pair<long, long>> seen;
  for (const auto& e : in_group(svg, "copies", "path")) {
    const double dx = corner(e).x - cell[0].x, dy = corner(e).y - cell[0].y;
    const double det = ax * by - ay * bx, u = (dx * by - dy * bx) / det,
                 v = (ax * dy - ay * dx) / det;
    EXPECT_NEAR(u, std::round(u), 1e-4);
    EXPECT_NEAR(v, std::round(v), 1e-4);
    seen.insert({std::lround(u), std::lround(v)});
  }
  EXPECT_EQ(seen.size(), 8U);
  EXPECT_EQ(seen.count({0, 0}), 0U);
}

TEST(SpacePicture, HyperbolicSurfaceShowsCopiesWithinTheDisk) {
  for (const Projection p : {Projection::Klein, Projection::Poincare}) {
    const std::string svg = space_picture(oracle::hyperbolic_copies(3), {.projection = p});
    EXPECT_EQ(count(svg, "copies", "path"), 4U * 9U);
    EXPECT_EQ(count(svg, "boundary", "path"), 1U);
    const auto disk = in_group(svg, "boundary", "circle");
    ASSERT_EQ(disk.size(), 1U);
    for (const auto& e : in_group(svg, "copies", "path")) {
      for (const oracle::PathStep& s : oracle::read_path(e.attributes.at("d"))) {
        if (s.command == 'Z') {
          continue;
        }
        EXPECT_LT(std::hypot(s.x - disk[0].number("cx"), s.y - disk[0].number("cy")),
                  disk[0].number("r"));
      }
    }
  }
}

TEST(SpacePicture, DegreesHaveColoursAndALegendOfThoseThatOccur) {
  SpaceResult r = oracle::square(4);
  for (std::size_t i = 0; i < r.cells.size(); ++i) {
    r.cells[i].degree = i < 2 ? 5 : i < 5 ? 7 : 6;
  }
  for (const Fill fill : {Fill::DegreeClasses, Fill::DegreeGreys}) {
    const std::string svg = space_picture(r, {.fill = fill});
    std::map<std::string, int> cells;
    for (const auto& e : in_group(svg, "cells", "path")) {
      ++cells[e.attributes.at("fill")];
    }
    ASSERT_EQ(cells.size(), 3U);
    EXPECT_EQ(cells.at("#ffffff"), 11);
    EXPECT_EQ(count(svg, "legend", "rect"), 3U);
    std::set<std::string> texts;
    for (const auto& e : in_group(svg, "legend", "text")) {
      texts.insert(e.text);
    }
    EXPECT_EQ(texts.count("5 (2)") + texts.count("6 (11)") + texts.count("7 (3)"), 3U);
  }
}

TEST(SpacePicture, MeasuresColourTheCells) {
  const SpaceResult r = oracle::square(4);
  for (const Measure m : {Measure::Degree, Measure::Area, Measure::Mass, Measure::Energy,
                          Measure::Radius, Measure::Nearest}) {
    const std::string svg = space_picture(r, {.fill = Fill::Measure, .measure = m});
    const auto cells = in_group(svg, "cells", "path");
    const bool flat = m == Measure::Mass || m == Measure::Energy || m == Measure::Nearest;
    EXPECT_EQ(cells.front().attributes.at("fill") == cells.back().attributes.at("fill"),
              flat || m == Measure::Degree);
    EXPECT_GE(count(svg, "legend", "text"), 2U) << "a name and a tick";
    if (flat) {
      EXPECT_EQ(cells.front().attributes.at("fill"), "#08a2af") << "the middle";
    }
  }
  const auto ends = [&](const PictureOptions& o) {
    const auto cells = in_group(space_picture(r, o), "cells", "path");
    return cells.front().attributes.at("fill") + cells.back().attributes.at("fill");
  };
  EXPECT_EQ(ends({.fill = Fill::Measure}), "#501d7a#faf170") << "least and greatest area";
  EXPECT_EQ(ends({.fill = Fill::Measure, .fill_range = {2, 3}}), "#501d7a#501d7a");
}

TEST(SpacePicture, EveryPictureIsWellFormedFiniteAndTheSameAgain) {
  const std::vector<SpaceResult> results{oracle::cube(3), oracle::square(3), oracle::torus(3),
                                         oracle::klein_square(3), oracle::hyperbolic_copies(2)};
  for (const SpaceResult& r : results) {
    for (const Fill fill : {Fill::None, Fill::DegreeClasses, Fill::DegreeGreys, Fill::Measure}) {
      const PictureOptions o{.fill = fill, .centroids = true, .title = "a < b & \"c\" > d"};
      const std::string svg = space_picture(r, o);
      const auto elements = read_svg(svg);
      EXPECT_EQ(svg.find("nan"), std::string::npos);
      EXPECT_EQ(svg.find("inf"), std::string::npos);
      bool titled = false;
      for (const auto& e : elements) {
        titled = titled || e.text == o.title;
      }
      EXPECT_TRUE(titled);
      EXPECT_EQ(svg, space_picture(r, o));
    }
  }
}

TEST(SpacePicture, RefusesWhatCannotBeShown) {
  EXPECT_THROW(space_picture({}), InvalidInput);
  EXPECT_THROW(space_picture(oracle::cube(1), {.initial = true}), InvalidInput);
  EXPECT_THROW(space_picture(oracle::cube(1), {.projection = Projection::Klein}), InvalidInput);
  EXPECT_THROW(space_picture(oracle::square(1), {.projection = Projection::Poincare}),
               InvalidInput);
  EXPECT_THROW(space_picture(oracle::torus(1), {.projection = Projection::BothHalves}),
               InvalidInput);
  EXPECT_THROW(space_picture(oracle::cube(1), {.width = 99}), InvalidInput);
  EXPECT_THROW(space_picture(oracle::cube(1), {.view_lon_deg = std::nan("")}), InvalidInput);
  SpaceResult r = oracle::square(2);
  r.cells[1].area = std::numeric_limits<double>::infinity();
  EXPECT_NO_THROW(space_picture(r));
  EXPECT_THROW(space_picture(r, {.fill = Fill::Measure}), InvalidInput);
  r.cells[1].corners[0][0] = std::nan("");
  EXPECT_THROW(space_picture(r), InvalidInput);
  SpaceResult hidden = oracle::cube(2);
  hidden.cells[3].corners[1][1] = std::nan("");
  EXPECT_THROW(space_picture(hidden), InvalidInput) << "not silently left out";
  const PictureOptions range{.fill = Fill::Measure, .fill_range = {0, std::nan("")}};
  EXPECT_THROW(space_picture(oracle::square(2), range), InvalidInput);
}

}  // namespace
}  // namespace ucvt
