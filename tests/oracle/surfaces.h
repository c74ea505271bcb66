// Surfaces of constant curvature to test on, some of them without any help from src/conformal.
#pragma once

#include <random>

#include "conformal/uniformize.h"
#include "oracle/meshes.h"
#include "triangulation/delaunay.h"
#include "triangulation/uniform_surface.h"

namespace ucvt::oracle {

/// The flat torus of area 1 over the lattice of (1, 0)/s and (shear, height)/s, s^2 = height, cut
/// into n x m parallelograms and these in two.
UniformSurface flat_torus(int n, int m, double shear = 0.3, double height = 1.2);

/// The unit sphere triangulated by a mesh whose vertices lie on it.
UniformSurface sphere(const TriangleMesh& inscribed);

/// A genus-2 surface: the uniformized voxel frame (computed once).
const Uniformized& double_torus();

/// One of the three by its curvature: sphere of 42 vertices, torus of 30, double torus of 48.
const UniformSurface& surface_of(double kappa);

/// The same with edges that are short next to cells of 150 sites: 2562, 1200 and some 2000 vertices.
const UniformSurface& fine_surface_of(double kappa);

/// T as a Delaunay triangulation of its own vertices.
DelaunayTriangulation delaunay_of(const UniformSurface& t);

/// T with all vertices but one removed, the first twelve on a sphere: loops and multiple edges.
UniformSurface fewest_vertices(const UniformSurface& t);

/// Uniform in [0, 1), the same on every machine.
double uniform(std::mt19937_64& random);

/// A point of the surface, uniform in faces and in barycentric coordinates.
SurfacePoint random_point(const UniformSurface& t, std::mt19937_64& random);
std::vector<SurfacePoint> random_points(const UniformSurface& t, std::size_t n, std::uint64_t seed);

/// 2 pi |chi|; the flat tori made here have area 1.
double gauss_bonnet_area(const UniformSurface& t);

/// The worst angle |sum - 2 pi| over the vertices.
double worst_angle_error(const UniformSurface& t);

}  // namespace ucvt::oracle
