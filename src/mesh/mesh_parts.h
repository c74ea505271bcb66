// The connected components of a mesh, each as a mesh of its own.
#pragma once

#include <cstdint>
#include <vector>

#include "ucvt/mesh.h"

namespace ucvt {

struct MeshPart {
  TriangleMesh mesh;  ///< used vertices only; vertices and faces in their order
  std::vector<std::int32_t> input_vertex, input_face;  ///< their numbers in the whole mesh
};

/// Components are held together by vertices, and come in the order of their first faces.
std::vector<MeshPart> split_into_components(const TriangleMesh& mesh);

}  // namespace ucvt
