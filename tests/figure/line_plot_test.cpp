#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "figure/samples.h"
#include "figure/svg.h"
#include "figure/svg_reader.h"
#include "ucvt/error.h"
#include "ucvt/figure.h"

namespace ucvt {
namespace {

using oracle::in_group;
using oracle::read_path;

const double nan = std::nan("");

TEST(LinePlot, OneCurveForEachSeriesToldApart) {
  PlotSpec spec;
  for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
    spec.series.push_back({name, {0, 1, 2}, {1, 3, 2}});
  }
  const std::string svg = line_plot(spec);
  const auto curves = in_group(svg, "curves", "path");
  ASSERT_EQ(curves.size(), 6U);
  std::set<std::string> colours, dashes;
  for (const auto& e : curves) {
    colours.insert(e.attributes.at("stroke"));
    dashes.insert(e.attributes.at("stroke-dasharray"));
  }
  EXPECT_EQ(colours.size(), 6U);
  EXPECT_EQ(dashes.size(), 6U);
  EXPECT_EQ(in_group(svg, "legend", "text").size(), 6U);
  for (const auto& e : oracle::read_svg(svg)) {
    if (e.attributes.count("class") > 0 && e.attributes.at("class") == "curves") {
      EXPECT_GE(e.number("stroke-width"), 1.2);
    }
  }
}

/// A value's place between two ticks of the plot, by their labels.
double read_off(const std::string& svg, const std::string& axis, double pixel) {
  std::vector<std::pair<double, double>> ticks;
  for (const auto& e : in_group(svg, "axes", "text")) {
    if (e.attributes.count("class") > 0 && e.attributes.at("class") == axis + "-tick") {
      const double shift = axis == "y" ? -0.35 * 13 : 0;
      ticks.emplace_back(e.number(axis) + shift, std::stod(e.text));
    }
  }
  const auto [p0, v0] = ticks.front();
  const auto [p1, v1] = ticks.back();
  return v0 + (v1 - v0) * (pixel - p0) / (p1 - p0);
}

TEST(LinePlot, CurvesAgreeWithTheTicks) {
  const PlotSpec spec{"", {"x"}, {"y"}, {{"", {0, 3, 10}, {5, 7.25, 30}}}};
  const std::string svg = line_plot(spec);
  const auto steps = read_path(in_group(svg, "curves", "path")[0].attributes.at("d"));
  ASSERT_EQ(steps.size(), 4U) << "the first point, doubled, and two lines";
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(read_off(svg, "x", steps[i + 1].x), spec.series[0].x[i], 0.01);
    EXPECT_NEAR(read_off(svg, "y", steps[i + 1].y), spec.series[0].y[i], 0.02);
  }
}

TEST(LinePlot, LogarithmicAxesHaveEqualDecades) {
  const PlotSpec spec{
      "", {"", AxisScale::Log}, {"", AxisScale::Log}, {{"", {1, 10, 100}, {1e-8, 1e-5, 1e-2}}}};
  const auto steps = read_path(in_group(line_plot(spec), "curves", "path")[0].attributes.at("d"));
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_NEAR(steps[2].x - steps[1].x, steps[3].x - steps[2].x, 0.01);
  EXPECT_NEAR(steps[2].y - steps[1].y, steps[3].y - steps[2].y, 0.01);
}

TEST(LinePlot, WhatCannotBeDrawnLeavesAGap) {
  const double inf = std::numeric_limits<double>::infinity();
  const PlotSpec spec{"", {}, {}, {{"", {0, 1, 2, 3, 4, 5}, {1, 2, nan, 3, inf, 4}}}};
  const std::string svg = line_plot(spec);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  const auto steps = read_path(in_group(svg, "curves", "path")[0].attributes.at("d"));
  int starts = 0;
  for (const auto& s : steps) {
    starts += s.command == 'M' ? 1 : 0;
  }
  EXPECT_EQ(starts, 3);
  const PlotSpec logarithmic{"", {}, {"", AxisScale::Log}, {{"", {0, 1, 2, 3}, {1, 0, -1, 10}}}};
  EXPECT_NO_THROW(oracle::read_svg(line_plot(logarithmic)));
}

TEST(LinePlot, LabelsOfTicksDoNotOverlap) {
  for (const double hi : {7.0, 123456.0, 99999.0, 3e-5}) {
    for (const double lo : {0.0, -hi, 0.999 * hi}) {
      const PlotSpec spec{"", {"x"}, {"y"}, {{"name of a series", {lo, hi}, {lo, hi}}}, 320, 240};
      double last_x = -1e9, last_y = 1e9;
      for (const auto& e : in_group(line_plot(spec), "axes", "text")) {
        const std::string kind = e.attributes.count("class") > 0 ? e.attributes.at("class") : "";
        if (kind == "x-tick") {
          const double half = text_width(e.text, 13) / 2;
          EXPECT_GT(e.number("x") - half, last_x) << lo << " to " << hi;
          last_x = e.number("x") + half;
        } else if (kind == "y-tick") {
          EXPECT_LT(e.number("y"), last_y - 13) << lo << " to " << hi;
          EXPECT_GT(e.number("x") - text_width(e.text, 13), 13) << "clear of the axis title";
          last_y = e.number("y");
        }
      }
    }
  }
}

TEST(LinePlot, TextIsEscapedAndConstantsArePlotted) {
  const PlotSpec spec{"a & b", {"<x>"}, {"\"y\""}, {{"p < q", {1}, {4}}, {"r", {1, 1}, {4, 4}}}};
  std::set<std::string> texts;
  for (const auto& e : oracle::read_svg(line_plot(spec))) {
    texts.insert(e.text);
  }
  for (const char* text : {"a & b", "<x>", "\"y\"", "p < q"}) {
    EXPECT_EQ(texts.count(text), 1U) << text;
  }
  EXPECT_EQ(line_plot(spec), line_plot(spec));
}

TEST(LinePlot, RefusesWhatCannotBePlotted) {
  EXPECT_THROW(line_plot({}), InvalidInput);
  EXPECT_THROW(line_plot({"", {}, {}, {{"", {1}, {}}}}), InvalidInput);
  EXPECT_THROW(line_plot({"", {}, {}, {{"", {1}, {nan}}}}), InvalidInput);
  EXPECT_THROW(line_plot({"", {}, {"", AxisScale::Log}, {{"", {1}, {-1}}}}), InvalidInput);
  EXPECT_THROW(line_plot({"", {}, {}, {{"", {1}, {1}}}, 100, 100}), InvalidInput);
}

TEST(SpacePlots, SortedSeriesRiseAboutMeanOne) {
  const PlotSeries s = sorted_series("r", oracle::square(4).cells, Measure::Radius);
  ASSERT_EQ(s.y.size(), 16U);
  EXPECT_EQ(s.x.front(), 1);
  EXPECT_EQ(s.x.back(), 16);
  double sum = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    sum += s.y[i];
    EXPECT_TRUE(i == 0 || s.y[i] > s.y[i - 1]);
  }
  EXPECT_NEAR(sum, 16, 1e-12);
  for (const double y : sorted_series("e", oracle::square(2).cells, Measure::Energy).y) {
    EXPECT_EQ(y, 0) << "no division by a mean of 0";
  }
}

TEST(SpacePlots, PlotsOfAResult) {
  SpaceResult r = oracle::square(4);
  r.initial_cells = r.cells;
  r.paper_energy = {3, 2, 1.5};
  EXPECT_EQ(uniformity_plot(r).series.size(), 3U);
  EXPECT_EQ(comparison_plot(r, Measure::Nearest).series.size(), 2U);
  EXPECT_EQ(energy_plot(r).series.at(0).x, (std::vector<double>{0, 1, 2}));
  for (const PlotSpec& spec :
       {uniformity_plot(r), comparison_plot(r, Measure::Area), energy_plot(r)}) {
    EXPECT_NO_THROW(oracle::read_svg(line_plot(spec)));
  }
}

}  // namespace
}  // namespace ucvt
