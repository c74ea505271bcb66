// Files of the tessellations of spaces.h: Delaunay mesh, cells, measures, sites.
//
// docs/formats.md describes them. Every file appears whole or not at all; "-" is standard input or
// standard output. Numbers are written so that reading gives the same doubles.
#pragma once

#include <string>
#include <vector>

#include "ucvt/mesh.h"
#include "ucvt/spaces.h"

namespace ucvt {

/// Where the points of the hyperbolic plane are put. Those of the sphere are written as they are,
/// those of plane and torus as (x, y, 0).
enum class Coordinates : char {
  Central,   ///< Klein disk: (x, y)/z, 0
  Poincare,  ///< Poincare disk: (x, y)/(1 + z), 0
  Model,     ///< hyperboloid: x, y, z
};

/// The Delaunay mesh of the final sites; vertex i is site i.
///
/// On a torus or a hyperbolic surface every triangle is given once, at the lift whose circumcentre
/// lies in the fundamental polygon; corners outside are further vertices, copies of sites. Requires
/// the result to have cells. Throws InvalidInput when there is no triangle (two or three sites on a
/// sphere; fewer than three, or sites on one line, in a polygon), NumericalError when the triangles of
/// a closed domain do not fit together.
TriangleMesh delaunay_mesh(const SpaceResult& result, Coordinates coordinates = {});

/// Writes the final cells as VTK polygons (.vtu, ascii) with their measures. Throws IoError.
///
/// Cell i lies about site i, also where that is outside the fundamental polygon; cells share no
/// points. Requires the result to have cells.
void write_cells(const std::string& path, const SpaceResult& result, Coordinates coordinates = {});

/// Writes one line of measures for each final cell, comma separated. Throws IoError.
/// Requires the result to have cells.
void write_cell_table(const std::string& path, const SpaceResult& result);

/// Writes the final sites as JSON. Throws IoError.
void write_space_sites(const std::string& path, const SpaceResult& result);

/// Reads what `write_space_sites` wrote. Throws IoError; InvalidInput when it is something else, or
/// of another kind of space than the domain.
std::vector<ModelPoint> read_space_sites(const std::string& path, const Domain& domain);

/// Reads the corners of a polygon: two numbers a line, comments with #. Throws IoError; InvalidInput
/// with the line.
std::vector<CentralPoint> read_polygon(const std::string& path);

}  // namespace ucvt
