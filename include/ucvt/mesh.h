// Triangle meshes: the input and the output of ucvt.
//
// A TriangleMesh is a plain list of positions and corner triples. `read_mesh` takes it from a file
// as it stands there; `closed_surface` turns it into what most of ucvt requires (closed, manifold,
// oriented, connected) or refuses it with one line that names the fault; `open_surface` does so for
// surfaces with boundary, which can be remeshed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ucvt {

using Position = std::array<double, 3>;
using Corners = std::array<std::int32_t, 3>;

/// Positions in the units of the file; faces as three indices into them, counterclockwise from
/// outside.
struct TriangleMesh {
  std::vector<Position> positions;
  std::vector<Corners> faces;
};

/// Reads OFF, OBJ, PLY (ascii, both binaries) or STL (ascii, binary) into a mesh, cutting polygons
/// into triangles.
///
/// The format is told from the content, then from the extension; "-" reads standard input. STL
/// corners are welded by exact position. Nothing is repaired and unused vertices are kept.
/// Throws IoError when the file cannot be read, InvalidInput (with the line or byte where it
/// applies) when it is not a mesh: unknown format, truncated, index out of range, coordinate not
/// finite, no face.
TriangleMesh read_mesh(const std::string& path);

/// Writes a mesh in the format named by the extension (.obj, .off, .ply, .stl); "-" writes OFF to
/// standard output.
///
/// The file appears whole or not at all: it is written beside and renamed. OBJ, OFF and PLY keep
/// doubles exactly. Throws InvalidInput for an unknown extension, IoError otherwise.
void write_mesh(const std::string& path, const TriangleMesh& mesh);

/// What a mesh is, as an abstract surface and as triangles in space; see `survey`.
struct MeshSurvey {
  std::int64_t vertices = 0;  ///< used by some face
  std::int64_t faces = 0;
  std::int64_t edges = 0;
  std::int64_t unused_vertices = 0;
  std::int64_t components = 0;
  std::int64_t boundary_edges = 0;
  std::int64_t boundary_loops = 0;
  std::int64_t nonmanifold_edges = 0;     ///< with three faces or more
  std::int64_t nonmanifold_vertices = 0;  ///< whose faces do not form one fan or disk
  std::int64_t repeated_corner_faces = 0;
  std::int64_t duplicate_faces = 0;
  std::int64_t coincident_vertices = 0;  ///< used vertices at the place of an earlier one
  std::int64_t misoriented_edges = 0;    ///< whose two faces run along them in the same direction
  bool orientable = true;
  std::int64_t euler_number = 0;  ///< vertices - edges + faces
  double area = 0;
  double bbox_diagonal = 0;
  double edge_min = 0, edge_max = 0;
  double angle_min_deg = 0;
};

/// Counts everything `ucvt info` reports. Never throws on a mesh that `read_mesh` returned.
MeshSurvey survey(const TriangleMesh& mesh);

/// The area of a face, in squares of the mesh's unit. Neither overflows nor vanishes early.
double face_area(const TriangleMesh& mesh, const Corners& face);

/// The sum of the faces' areas.
double surface_area(const TriangleMesh& mesh);

/// A mesh fit for uniformization, and how it was got.
struct ClosedSurface {
  TriangleMesh mesh;  ///< used vertices only, in their order; faces oriented
  int genus = 0;
  std::vector<std::int32_t> input_vertex;  ///< index in the input of each vertex
  std::int64_t reoriented_faces = 0;       ///< faces turned round to agree with the first one
};

/// Checks that the mesh is one closed, manifold, orientable surface; drops unused vertices and
/// turns faces round where their orientations disagree.
///
/// The abstract surface decides: any positions are accepted as long as they are finite. Throws
/// InvalidInput that names all faults, each with its count and one element (numbering from 0), and a
/// remedy: no faces, boundary, non-manifold edge or vertex, repeated corner, duplicate face, not
/// orientable; else several components. `repair.h` mends, `components.h` takes several.
ClosedSurface closed_surface(const TriangleMesh& mesh);

/// A mesh with boundary fit for remeshing, and how it was got.
struct OpenSurface {
  TriangleMesh mesh;  ///< used vertices only, in their order; faces oriented
  int genus = 0;      ///< of the surface with its holes filled
  int boundary_loops = 0;
  std::vector<std::int32_t> input_vertex;  ///< index in the input of each vertex
  std::int64_t reoriented_faces = 0;       ///< faces turned round to agree with the first one
};

/// True when some edge has one face only and the mesh does not close by welding coincident vertices.
bool has_boundary(const TriangleMesh& mesh);

/// As `closed_surface`, for a surface with one boundary loop or more. Throws InvalidInput as that
/// does; boundary is no fault here unless welding coincident vertices would close it, and a closed
/// surface is refused.
OpenSurface open_surface(const TriangleMesh& mesh);

}  // namespace ucvt
