// Surfaces of several components: each is uniformized and tessellated by itself, as if it were alone.
//
// Sites are shared out by area; vertices, cells and colours of the joined results are numbered
// through, component by component.
#pragma once

#include <cstdint>
#include <vector>

#include "ucvt/mesh.h"
#include "ucvt/partition.h"
#include "ucvt/remesh.h"

namespace ucvt {

struct Component {
  ClosedSurface surface;                 ///< its `input_vertex` counts in the whole mesh
  std::vector<std::int32_t> input_face;  ///< number in the whole mesh of each face
};

/// Checks the mesh as `closed_surface` does, but for the number of components, and takes it apart.
///
/// In the order of their first faces; faces are turned round in each by itself. Throws InvalidInput.
std::vector<Component> closed_components(const TriangleMesh& mesh);

/// Number of sites for each component: its share of the area by largest remainders, but at least
/// what it takes (4 on a sphere, 1 elsewhere), and what a simplicial mesh of its genus has at least
/// (4, 7, 10, ...) while `sites` suffices for that on all.
///
/// Source of the least numbers: G. Ringel and M. Jungerman, "Minimal triangulations on orientable
/// surfaces", Acta Mathematica 145, 1980. Throws InvalidInput when `sites` are too few.
std::vector<int> share_sites(const std::vector<Component>& components, int sites);

/// Remeshes one component after the other; result i belongs to component i.
///
/// For several components, initial sites and sizes of the options must be empty. Throws as `remesh`,
/// messages with the component named.
std::vector<RemeshResult> remesh(const std::vector<Component>& components,
                                 const RemeshOptions& options = {});

/// The dual meshes as one.
TriangleMesh joined_mesh(const std::vector<RemeshResult>& results);

/// What the results are together: sums, means, and the quality of the joined mesh.
struct JoinedReport {
  RemeshReport remesh;  ///< genus: the sum
  CvtReport cvt;        ///< no energies; of the moves the largest last one; converged: all
  Spread cell_area_3d;
};
JoinedReport joined_report(const std::vector<RemeshResult>& results);

/// A partition of several components together; its input is what the components hold.
struct JoinedPartition {
  Partition partition;
  std::vector<std::int32_t> input_vertex;  ///< number in the whole mesh of each input vertex
  std::vector<std::int32_t> input_face;    ///< and of each input face; both ascend
};
JoinedPartition partition(const std::vector<Component>& components,
                          const std::vector<RemeshResult>& results);
/// The same for an open surface, which has one component.
JoinedPartition partition(const OpenSurface& surface, const RemeshResult& result);

}  // namespace ucvt
