#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "figure/shading.h"
#include "ucvt/figure.h"

namespace ucvt {
namespace {

std::vector<double> numbers_from(double first, std::size_t count) {
  std::vector<double> out(count);
  std::iota(out.begin(), out.end(), first);
  return out;
}

}  // namespace

PlotSeries sorted_series(std::string name, const std::vector<SpaceCell>& cells, Measure measure) {
  PlotSeries out{std::move(name), numbers_from(1, cells.size()), {}};
  for (const SpaceCell& c : cells) {
    out.y.push_back(measure_of(c, measure));
  }
  std::sort(out.y.begin(), out.y.end());
  const double mean =
      std::accumulate(out.y.begin(), out.y.end(), 0.0) / static_cast<double>(out.y.size());
  for (double& y : out.y) {
    y = mean == 0 ? y : y / mean;
  }
  return out;
}

PlotSpec uniformity_plot(const SpaceResult& result) {
  PlotSpec out;
  out.x.title = "cells, each curve in ascending order";
  out.y.title = "value / mean";
  for (const Measure m : {Measure::Radius, Measure::Nearest, Measure::Area}) {
    out.series.push_back(sorted_series(std::string(measure_name(m)), result.cells, m));
  }
  return out;
}

PlotSpec comparison_plot(const SpaceResult& result, Measure measure) {
  PlotSpec out;
  out.x.title = "cells in ascending order";
  out.y.title = std::string(measure_name(measure)) + " / mean";
  out.series = {sorted_series("CVT", result.cells, measure),
                sorted_series("initial", result.initial_cells, measure)};
  return out;
}

PlotSpec energy_plot(const SpaceResult& result) {
  PlotSpec out;
  out.x.title = "iteration";
  out.y.title = "energy";
  out.series = {{"", numbers_from(0, result.paper_energy.size()), result.paper_energy}};
  return out;
}

}  // namespace ucvt
