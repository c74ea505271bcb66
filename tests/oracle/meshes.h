// Small closed meshes made by code, for the tests of every room.
#pragma once

#include <cstdint>

#include "ucvt/mesh.h"

namespace ucvt::oracle {

/// Platonic solids with vertices on the unit sphere; the cube has 12 triangles.
TriangleMesh tetrahedron();
TriangleMesh cube();
TriangleMesh octahedron();
TriangleMesh icosahedron();

/// An icosahedron subdivided `levels` times, every vertex on the unit sphere.
TriangleMesh icosphere(int levels);

/// A torus of revolution (radii 1 and `minor`) with n x m quadrilaterals cut in two.
TriangleMesh grid_torus(int n, int m, double minor = 0.4);

/// The torus with seven vertices, every two of them joined by an edge; any coordinates.
TriangleMesh seven_vertex_torus();

/// The surface of a slab of cubes, 2 `holes` + 1 by 3 by 1, with that many holes: genus `holes`.
TriangleMesh voxel_frame(int holes);

/// A sphere of latitudes and longitudes: all vertices of a latitude are cocircular.
TriangleMesh latitude_sphere(int rings, int meridians);

/// A sphere with a tube of the given length and radius grown out of its north pole.
TriangleMesh finger(double length, double radius, int meridians);

/// The mesh with every vertex moved by up to `amplitude` in each coordinate.
TriangleMesh bumpy(TriangleMesh mesh, double amplitude, std::uint64_t seed);

/// The mesh with every coordinate multiplied.
TriangleMesh scaled(TriangleMesh mesh, double factor);

/// Checks and orients; what uniformize takes.
ClosedSurface closed(const TriangleMesh& mesh);

}  // namespace ucvt::oracle
