// Partition: the input surface cut exactly along the boundaries of a CVT's cells.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ucvt/mesh.h"
#include "ucvt/remesh.h"

namespace ucvt {

/// One cell and its measures.
struct PartitionCell {
  Position site{};          ///< on the input surface
  double area_3d = 0;       ///< on the input surface, in its units
  double area = 0;          ///< in the uniform metric
  double radius = 0;        ///< distance of the farthest point from the site, in the uniform metric
  double nearest = 0;       ///< distance to the nearest site, in the uniform metric
  int degree = 0;           ///< sides
  std::int32_t colour = 0;  ///< 0, 1, ...: neighbours' colours differ
  std::vector<std::int32_t> neighbours;  ///< other cells along its sides: ascending, each once
};

/// Faces and vertices of the input are those of the ClosedSurface or OpenSurface that was remeshed.
struct Partition {
  /// The input's vertices first and in their order; oriented, closed if that is.
  TriangleMesh mesh;
  std::vector<std::int32_t> cell;         ///< of each face of the mesh; site i's is cell i
  std::vector<std::int32_t> input_face;   ///< face of the input that each face of the mesh lies in
  std::vector<std::int32_t> vertex_cell;  ///< cell of each vertex of the input
  std::vector<std::int32_t> face_cell;    ///< cell that has the largest part of each input face
  std::vector<PartitionCell> cells;
  int colours = 0;
};

/// Cuts the input along the boundaries of the cells of a finished run.
///
/// Every face of the result lies in one face of the input and in one cell. The result is an oriented
/// manifold with the input's genus and boundary, and every cell's inside is one open disk, by
/// construction (its closure is a disk when the dual mesh is simplicial). Cells on the boundary end there:
/// the boundary is none of their sides. Boundaries are where doubles put them, to about 1e-9 of T's faces.
/// Throws NumericalError when all boundaries lie inside one input face, or when doubles do not tell the
/// boundaries apart. Source: docs/mapping-back.md.
Partition partition(const RemeshResult& result);

/// Writes the cut surface as PLY: face properties `cell`, `red`, `green`,
/// `blue` by the cell's colour. "-" is standard output. Throws IoError; the file appears whole or not at
/// all, here and below.
void write_partition(const std::string& path, const Partition& p);

/// Writes `element,number,cell` for every vertex and every face of the input as CSV. Vertices are
/// numbered by `input_vertex`, that of the ClosedSurface, and faces by `input_face`, where it is not
/// empty; those with a negative number are left out.
void write_labels(const std::string& path, const Partition& p,
                  const std::vector<std::int32_t>& input_vertex,
                  const std::vector<std::int32_t>& input_face = {});

/// Writes the cells' measures as CSV.
void write_cells(const std::string& path, const Partition& p);

}  // namespace ucvt
