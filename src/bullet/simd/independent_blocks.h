// Groups elements that share no node into blocks, so that a loop can process a whole block at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "bullet/simd/nodes.h"
#include "cloth/independent_sets.h"

namespace drench {

// Indices of elements; -1 for unused lanes.
using IndependentBlock = std::array<int, blockWidth>;

// Visits elements in sets that share no node. Elements are grouped in tiles of neighbouring nodes, so that a sweep
// finds them in the cache, and within a tile by graph colouring, which also keeps the sweep stable.
// @param elements  the nodes of each element; negative ones are ignored
// @param visit     called with the indices of the elements of each set
template <std::size_t Nodes, typename Visit>
void forEachIndependentSet(const std::vector<std::array<int, Nodes>>& elements, std::size_t nodes,
                           std::size_t tileNodes, Visit visit) {
    std::vector<std::vector<int>> tiles(nodes / tileNodes + 1);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        std::size_t lowest = nodes - 1;
        for (const int node : elements[i])
            if (node >= 0) lowest = std::min(lowest, static_cast<std::size_t>(node));
        tiles[lowest / tileNodes].push_back(static_cast<int>(i));
    }
    IndependentSets colours(elements, nodes);
    for (std::vector<int>& waiting : tiles)
        while (!waiting.empty()) visit(colours.take(waiting));
}

// Blocks in which no two elements share a node, in the order of these sets.
// @param elements  the nodes of each element; negative ones are ignored
template <std::size_t Nodes>
std::vector<IndependentBlock> independentBlocks(const std::vector<std::array<int, Nodes>>& elements,
                                                std::size_t nodes) {
    constexpr std::size_t tileNodes = 2048;
    std::vector<IndependentBlock> blocks;
    forEachIndependentSet(elements, nodes, tileNodes, [&](const std::vector<int>& colour) {
        for (std::size_t i = 0; i < colour.size(); ++i) {
            if (i % blockWidth == 0) blocks.emplace_back().fill(-1);
            blocks.back()[i % blockWidth] = colour[i];
        }
    });
    return blocks;
}

}  // namespace drench
