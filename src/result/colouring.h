// Colours of cells.
#pragma once

#include <cstdint>
#include <vector>

namespace ucvt {

/// A colour 0, 1, ... for every node of a graph, given by its lists of neighbours, such that neighbours
/// differ: greedily, always the node that sees most colours next (Brelaz 1979), which takes four or
/// five for maps on simple surfaces. Neighbours that are the node itself are passed over.
std::vector<std::int32_t> colour_graph(const std::vector<std::vector<std::int32_t>>& neighbours);

}  // namespace ucvt
