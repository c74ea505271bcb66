// Colours of cells.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ucvt {

/// By colour modulo their number: light ones that stay apart in print and for the colour-blind (Tol's "light" scheme).
constexpr std::array<std::array<std::uint8_t, 3>, 9> cell_palette{{{119, 170, 221},
                                                                   {238, 221, 136},
                                                                   {255, 170, 187},
                                                                   {68, 187, 153},
                                                                   {238, 136, 102},
                                                                   {187, 204, 51},
                                                                   {153, 221, 255},
                                                                   {170, 170, 0},
                                                                   {221, 221, 221}}};

/// A colour 0, 1, ... for every node of a graph, given by its lists of neighbours, such that neighbours
/// differ: greedily, always the node that sees most colours next (Brelaz 1979), which takes four or
/// five for maps on simple surfaces. Neighbours that are the node itself are passed over.
std::vector<std::int32_t> colour_graph(const std::vector<std::vector<std::int32_t>>& neighbours);

}  // namespace ucvt
