// Puts elements that share no node side by side, so that a loop may work on a whole block of them at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "bullet/packed/nodes.h"

namespace drench {

/// Indices of elements, -1 where a place stays empty.
using IndependentBlock = std::array<int, blockWidth>;

/// Blocks in which no two elements share a node. Elements come in tiles of neighbouring nodes, so that a sweep
/// finds them in the cache, and within a tile in colours, which also keeps the sweep stable.
/// @param elements  the nodes of each element; negative ones do not count
template <std::size_t Nodes>
std::vector<IndependentBlock> independentBlocks(const std::vector<std::array<int, Nodes>>& elements,
                                                std::size_t nodes) {
    constexpr std::size_t tileNodes = 2048;
    std::vector<std::vector<int>> tiles(nodes / tileNodes + 1);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        std::size_t lowest = nodes - 1;
        for (const int node : elements[i])
            if (node >= 0) lowest = std::min(lowest, static_cast<std::size_t>(node));
        tiles[lowest / tileNodes].push_back(static_cast<int>(i));
    }

    std::vector<IndependentBlock> blocks;
    std::vector<int> colourAt(nodes, -1);
    int colour = 0;
    for (std::vector<int>& waiting : tiles)
        for (; !waiting.empty(); ++colour) {
            std::size_t left = 0, place = blockWidth;
            for (const int element : waiting) {
                const auto& touched = elements[static_cast<std::size_t>(element)];
                const bool taken = std::any_of(touched.begin(), touched.end(), [&](int node) {
                    return node >= 0 && colourAt[static_cast<std::size_t>(node)] == colour;
                });
                if (taken) {
                    waiting[left++] = element;
                    continue;
                }
                for (const int node : touched)
                    if (node >= 0) colourAt[static_cast<std::size_t>(node)] = colour;
                if (place == blockWidth) {
                    blocks.emplace_back().fill(-1);
                    place = 0;
                }
                blocks.back()[place++] = element;
            }
            waiting.resize(left);
        }
    return blocks;
}

}  // namespace drench
