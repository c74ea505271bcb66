// How model points become pixels: the projections of pictures, and outlines of geodesic polygons.
//
// Picture coordinates are projected coordinates with y up: the view's right and up on the sphere,
// central coordinates in the plane and the Klein disk, w = (x, y)/(1 + z) in the Poincare disk,
// i (1 + w)/(1 - w) in the half plane.
#pragma once

#include <vector>

#include "figure/svg.h"
#include "ucvt/figure.h"

namespace ucvt {

struct Chart {
  Projection projection = Projection::Plane;  ///< never Automatic or BothHalves
  /// Orthographic: rows right, up and towards the viewer. Otherwise not used.
  ModelMatrix view{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double scale = 1;  ///< pixels in a unit of picture coordinates
  Pixel origin;      ///< where picture coordinates vanish
};

ModelPoint moved(const ModelMatrix& m, const ModelPoint& p);
std::vector<ModelPoint> moved(const ModelMatrix& m, std::vector<ModelPoint> points);
ModelMatrix product(const ModelMatrix& a, const ModelMatrix& b);

/// The model point at central coordinates k.
ModelPoint lifted(double kappa, const CentralPoint& k);

/// The view of the sphere with the given point below the viewer, north up.
ModelMatrix sphere_view(double lon_deg, double lat_deg);

/// The view from the other side, turned about the picture's vertical.
ModelMatrix from_behind(const ModelMatrix& view);

/// Whether the point is on the viewer's side; always, off the sphere.
bool visible(const Chart& chart, const ModelPoint& p);

Pixel pixel(const Chart& chart, const ModelPoint& p);

/// Continues a path, which stands at a, along the geodesic to b. Not on the sphere.
void add_geodesic(const Chart& chart, const ModelPoint& a, const ModelPoint& b, Path& path);

/// The visible part of a convex geodesic polygon; empty when nothing of it is visible. On the
/// sphere it is cut at the horizon and edges are polylines within 0.0002 of a radius of the arc.
Path outline(const Chart& chart, const std::vector<ModelPoint>& corners);

/// Area in square pixels of the straight polygon through the visible corners.
double drawn_area(const Chart& chart, const std::vector<ModelPoint>& corners);

}  // namespace ucvt
