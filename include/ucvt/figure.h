// Figures: pictures of the tessellations of spaces.h and plots of their measures, as SVG text.
//
// Pictures show the cells, sites and centroids of a SpaceResult in one of the usual projections, as
// in figures 1, 2, 10, 11 and 12 of the paper; plots show curves, as in its figures 7 to 9. A figure
// is a string that holds a whole SVG 1.1 document; the same input gives the same bytes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ucvt/spaces.h"

namespace ucvt {

enum class Projection : char {
  Automatic,     ///< Orthographic, Plane or Klein, as the domain asks
  Orthographic,  ///< sphere: the half that faces the viewer
  BothHalves,    ///< sphere: that half, and beside it the other one seen from behind
  Plane,         ///< plane and torus, to scale
  Klein,         ///< hyperbolic: geodesics are straight
  Poincare,      ///< hyperbolic: angles are true, geodesics are circular arcs
  HalfPlane,     ///< the same in the upper half plane; of covers only (surface_figure.h)
};

/// A measure of SpaceCell.
enum class Measure : char { Degree, Area, Mass, Energy, Radius, Nearest };

enum class Fill : char {
  None,
  DegreeClasses,  ///< hexagons white; pentagons, heptagons and others each in a colour
  DegreeGreys,    ///< the same in greys, as in figures 10 and 11 of the paper
  Measure,        ///< PictureOptions::measure by a colour map of even steps in lightness
};

struct PictureOptions {
  Projection projection = Projection::Automatic;
  /// Sphere: the point below the viewer. North is up; (-90, 90) looks down the z axis, x to the right.
  double view_lon_deg = 0, view_lat_deg = 0;
  bool initial = false;  ///< the initial cells instead of the final ones
  Fill fill = Fill::None;
  Measure measure = Measure::Area;  ///< shown by Fill::Measure
  std::array<double, 2> fill_range{
      0, 0};               ///< values at the ends of the colour map; equal: the cells' own
  bool sites = true;       ///< solid dots
  bool centroids = false;  ///< hollow dots
  bool copies = true;      ///< closed domains: lighter copies across the sides
  int width = 800;         ///< of the figure, in pixels
  // Without it GCC warns of every designated initializer that leaves the title out.
  std::string title = {};  // NOLINT(readability-redundant-member-init)
};

/// Draws a tessellation.
///
/// Takes a result of `tessellate`; only its domain, sites, cells and their initial counterparts are
/// read. Returns an SVG document. Elements lie in groups of class `cells`, `copies`, `boundary`,
/// `sites`, `copy-sites`, `centroids` and `legend`, one path or circle for each cell or point.
/// Requires edges shorter than half a great circle on the sphere. Throws InvalidInput when the
/// projection does not show this domain, the width is not within 100 to 20000, there is not one cell
/// for each site, or the view, a coordinate or a value to be shown is not finite.
std::string space_picture(const SpaceResult& result, const PictureOptions& options = {});

struct PlotSeries {
  std::string name;  ///< in the legend
  std::vector<double> x, y;
};

enum class AxisScale : char { Linear, Log };

struct PlotAxis {
  std::string title;
  AxisScale scale = AxisScale::Linear;
};

struct PlotSpec {
  std::string title;
  PlotAxis x, y;
  std::vector<PlotSeries> series;
  int width = 640, height = 420;  ///< in pixels
};

/// Plots named curves over two axes with ticks at steps of 1, 2 or 5 times a power of ten.
///
/// Points that are not finite, or not positive on a logarithmic axis, are left out and leave a gap.
/// Returns an SVG document; curve i is the path i in the group of class `curves`. Throws
/// InvalidInput when a series has not as many x as y, no point is left, or the size is below 200 x
/// 150 or above 20000 pixels.
std::string line_plot(const PlotSpec& spec);

/// The values of one measure over all cells, ascending and divided by their mean, against the rank
/// of the cell from 1 (the curves of figures 8 and 9 of the paper). Values of mean 0 stay as they are.
PlotSeries sorted_series(std::string name, const std::vector<SpaceCell>& cells, Measure measure);

/// Sorted radius, distance to the nearest site and area of the final cells in one plot.
PlotSpec uniformity_plot(const SpaceResult& result);

/// One sorted measure of the initial and the final cells, as in figures 8 and 9 of the paper.
PlotSpec comparison_plot(const SpaceResult& result, Measure measure);

/// The paper's energy against the number of iterations, as in its figure 7.
PlotSpec energy_plot(const SpaceResult& result);

/// Writes a figure as .svg or .png, by the path's extension; "-" is SVG on standard output.
///
/// A PNG has one pixel for each pixel of the figure. The file appears whole or not at all. Throws
/// IoError; InvalidInput for another extension, and for .png unless `can_write_png`.
void write_figure(const std::string& path, const std::string& svg);

/// Whether this library was built with librsvg, by which figures become PNG files.
bool can_write_png();

}  // namespace ucvt
