// Centroidal Voronoi tessellations of the three spaces themselves: sphere, plane, hyperbolic plane.
//
// A domain is a whole closed space (sphere, flat torus, hyperbolic surface) or a convex polygon in
// the plane or the hyperbolic plane. Points are given in the linear model P = (x, y, z): the unit
// sphere, the plane z = 1, or the upper sheet x^2 + y^2 - z^2 = -1 of the hyperboloid; (x, y)/z are
// their central coordinates (gnomonic, Cartesian, Klein), in which geodesics are straight.
// Source: sections 3 to 5 of the paper; docs/spaces.md.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ucvt/remesh.h"

namespace ucvt {

using ModelPoint = std::array<double, 3>;
/// Row-major; acts on model points from the left.
using ModelMatrix = std::array<std::array<double, 3>, 3>;
/// Central coordinates.
using CentralPoint = std::array<double, 2>;

enum class DomainKind : char { Sphere, Torus, PlanePolygon, HyperbolicPolygon, HyperbolicSurface };

/// How the sides of the regular 4g-gon are glued: each with its opposite, or a b a^-1 b^-1 ...
enum class SidePairing : char { Opposite, Canonical };

/// A domain; made by the functions below, which check what they are given.
struct Domain {
  DomainKind kind = DomainKind::Sphere;
  double kappa = 1;
  /// Corners counterclockwise in central coordinates: the polygon itself, or a fundamental polygon
  /// (torus: the parallelogram of the lattice, centred; surface: the regular 4g-gon). Sphere: empty.
  std::vector<CentralPoint> polygon;
  /// Deck transformations that take the fundamental polygon to those across its sides, side i from
  /// corner i to corner i + 1. Empty on sphere and polygons.
  std::vector<ModelMatrix> across;
  int genus = 0;    ///< of a closed domain
  double area = 0;  ///< in the space's own metric
};

Domain sphere_domain();
/// The flat torus of a lattice. Throws InvalidInput unless the vectors span the plane.
Domain torus_domain(const CentralPoint& a, const CentralPoint& b);
/// A convex polygon in the plane (kappa 0) or in the Klein disk (kappa -1), in either orientation.
/// Throws InvalidInput when it is not convex, has fewer than three corners or leaves the disk.
Domain polygon_domain(double kappa, std::vector<CentralPoint> corners);
/// The closed hyperbolic surface of a regular 4g-gon with angles 2 pi/(4g). Requires genus >= 2.
Domain surface_domain(int genus, SidePairing pairing);
/// True unless the domain is a polygon.
bool is_closed(const Domain& domain);

struct SpaceOptions {
  int sites = 1000;
  std::uint64_t seed = 1;
  /// Polygons start from random sites in place of the multilevel start; farthest-point sites there are
  /// none.
  InitialSites init = InitialSites::Multilevel;
  Method method = Method::Lbfgs;
  std::vector<ModelPoint> initial_sites;  ///< when not empty: start here
  std::string density;                    ///< formula (docs/spaces.md); empty: uniform
  double quadrature = 1e-10;              ///< relative error of the integrals of a formula
  int iterations = 1000;    ///< evaluations of all cells, at most, after the initial state
  double tolerance = 1e-4;  ///< of the largest move, relative to the site's spacing
  int threads = 0;
  bool keep_cells = true;  ///< fill SpaceResult::cells, initial_cells and triangles
  Monitor monitor;
};

/// A Voronoi cell with its measures, in the space's own metric.
struct SpaceCell {
  std::vector<ModelPoint> corners;  ///< counterclockwise, in the lift of its site
  ModelPoint centroid{};
  int degree = 0;      ///< neighbouring cells across its sides
  double area = 0;     ///< uniform
  double mass = 0;     ///< of the density
  double energy = 0;   ///< int rho chord^2
  double radius = 0;   ///< distance from the site to the farthest corner
  double nearest = 0;  ///< distance to the nearest other site (or lift of a site)
};

struct SpaceResult {
  Domain domain;
  std::vector<ModelPoint> initial_sites;  ///< of a multilevel start: on the last level
  std::vector<ModelPoint> sites;          ///< in a closed domain's fundamental polygon
  std::vector<SpaceCell> initial_cells;
  std::vector<SpaceCell> cells;  ///< cell i belongs to site i
  /// Delaunay triangles as three site numbers, counterclockwise; the dual of the cells' corners.
  std::vector<std::array<std::int32_t, 3>> triangles;
  CvtReport cvt;
  /// The paper's energy of each of `cvt.energy`: F^S_min = -F^S_max, F^E or F^H (its section 3).
  std::vector<double> paper_energy;
  double quadrature_error = 0;  ///< largest bound on the relative error of a final cell's integrals
  UniformityReport initial_uniformity, uniformity;
};

/// Computes a CVT of a domain.
///
/// Running out of iterations is a status (`cvt.converged`), not an error.
/// Throws InvalidInput when the options do not fit (a formula that cannot be read, a density that is
/// negative or not finite somewhere, initial sites outside the domain), Cancelled, NumericalError.
SpaceResult tessellate(const Domain& domain, const SpaceOptions& options = {});

}  // namespace ucvt
