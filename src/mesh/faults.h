// The faults of a mesh in words: all of them, each with a count and one example.
#pragma once

#include <string>

#include "mesh/topology.h"

namespace ucvt {

/// What keeps a mesh from being made of closed orientable surfaces, in one line without a remedy;
/// empty when nothing does. Vertices and faces by their numbers in the mesh. A boundary is a fault
/// only when the surfaces are to be closed.
std::string describe_faults(const TriangleMesh& mesh, const Topology& found, bool closed = true);

/// Whether `repair` may help: the mesh is not merely empty or one-sided.
bool may_be_repaired(const Topology& found);

}  // namespace ucvt
