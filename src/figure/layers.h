// What a picture of a tessellation is drawn from, and the layers of one panel of it.
#pragma once

#include <vector>

#include "figure/chart.h"
#include "figure/shading.h"
#include "figure/svg.h"
#include "ucvt/figure.h"

namespace ucvt {

/// What every panel of a picture shares.
struct Scene {
  const Domain& domain;
  const PictureOptions& options;
  const std::vector<SpaceCell>& cells;
  const std::vector<ModelPoint>& sites;
  Shading shading;
  std::vector<ModelMatrix> copies;   ///< transformations of the copies shown
  std::vector<CentralPoint> window;  ///< torus with copies: what is shown of the plane
  double line = 1, dot = 1;          ///< widths and radii in pixels
};

/// Draws copies, cells, boundary and dots, lowest first. Width and height are those of the picture.
void draw_panel(Svg& svg, const Scene& scene, const Chart& chart, double width, double height);

}  // namespace ucvt
