// The nodes of a sheet in eight strips, one a lane, so that a loop reads eight nodes without gathering them.
//
// A strip is a range of consecutive nodes. Node `at` of each strip is in the vector with that index. On a mesh that
// repeats itself from strip to strip, as a grid that is numbered row by row, the links and plates at the same place in
// all strips connect the same vectors; where they lead to the next strip, the lanes of a vector are turned.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "bullet/simd/independent_blocks.h"
#include "bullet/simd/nodes.h"

namespace drench {

// How nodes are divided among strips.
struct Strips {
    std::size_t length;  // number of vectors

    std::size_t vectorOf(std::size_t node) const { return node % length; }
    std::size_t laneOf(std::size_t node) const { return node / length; }
    // Number of nodes with those that are missing in the last strips.
    std::size_t slots() const { return length * blockWidth; }
};

// Elements at the same place in up to eight strips.
template <std::size_t Nodes>
struct StripBlock {
    std::array<int, blockWidth> elements;  // index of each; -1 for unused lanes
    std::array<int, Nodes> vectors;        // of each node; -1 where no element has it
    std::array<int, Nodes> turns;  // how many strips each node is ahead of the element's first, 0 to 7
};

namespace strip_packing {

template <std::size_t Nodes>
struct Placed {
    int element;
    std::size_t lane;
    std::array<int, Nodes> vectors, turns;

    // Elements with the same first nodes may be in the same block.
    auto key() const {
        constexpr std::size_t last = Nodes < 3 ? Nodes - 1 : 2;
        return std::tie(vectors[0], vectors[1], turns[1], vectors[last], turns[last]);
    }
};

template <std::size_t Nodes>
Placed<Nodes> placed(int element, const std::array<int, Nodes>& nodes, const Strips& strips) {
    Placed<Nodes> at{element, strips.laneOf(static_cast<std::size_t>(nodes[0])), {}, {}};
    for (std::size_t k = 0; k < Nodes; ++k) {
        at.vectors[k] = -1;
        if (nodes[k] < 0) continue;
        const auto node = static_cast<std::size_t>(nodes[k]);
        at.vectors[k] = static_cast<int>(strips.vectorOf(node));
        at.turns[k] = static_cast<int>((strips.laneOf(node) + blockWidth - at.lane) % blockWidth);
    }
    return at;
}

// Whether an element has no node in common with those of a block, whose nodes are where its own are.
template <std::size_t Nodes>
bool sharesNode(const StripBlock<Nodes>& block, std::size_t lane) {
    for (std::size_t i = 0; i < Nodes; ++i)
        for (std::size_t k = 0; k < Nodes; ++k) {
            if (block.vectors[i] < 0 || block.vectors[i] != block.vectors[k] ||
                block.turns[i] == block.turns[k])
                continue;
            const std::size_t other =
                (lane + static_cast<std::size_t>(block.turns[i] - block.turns[k]) + blockWidth) % blockWidth;
            if (block.elements[other] >= 0) return true;
        }
    return false;
}

// Puts an element into a block, if it fits.
template <std::size_t Nodes>
bool add(StripBlock<Nodes>& block, const Placed<Nodes>& element) {
    StripBlock<Nodes> with = block;
    for (std::size_t k = 0; k < Nodes; ++k) {
        if (element.vectors[k] < 0) continue;
        if (with.vectors[k] < 0) {
            with.vectors[k] = element.vectors[k];
            with.turns[k] = element.turns[k];
        }
        if (with.vectors[k] != element.vectors[k] || with.turns[k] != element.turns[k]) return false;
    }
    with.elements[element.lane] = element.element;
    for (std::size_t lane = 0; lane < blockWidth; ++lane)
        if (with.elements[lane] >= 0 && sharesNode(with, lane)) return false;
    block = with;
    return true;
}

}  // namespace strip_packing

// Blocks in which no two elements share a node, in no useful order.
// @param elements  the nodes of each element, the first of them not negative; other negative ones are ignored
template <std::size_t Nodes>
std::vector<StripBlock<Nodes>> unorderedStripBlocks(const std::vector<std::array<int, Nodes>>& elements,
                                                    const Strips& strips) {
    using namespace strip_packing;
    std::vector<Placed<Nodes>> all;
    all.reserve(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
        all.push_back(placed(static_cast<int>(i), elements[i], strips));
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return std::make_tuple(a.key(), a.element) < std::make_tuple(b.key(), b.element);
    });
    std::vector<StripBlock<Nodes>> blocks;
    std::size_t firstOfKey = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i > 0 && all[i].key() != all[i - 1].key()) firstOfKey = blocks.size();
        std::size_t block = firstOfKey;
        while (block < blocks.size() && !add(blocks[block], all[i])) ++block;
        if (block < blocks.size()) continue;
        StripBlock<Nodes>& begun = blocks.emplace_back();
        begun.elements.fill(-1);
        begun.vectors.fill(-1);
        begun.turns.fill(0);
        add(begun, all[i]);
    }
    return blocks;
}

// The same in the order of a sweep: in tiles of neighbouring vectors, within a tile by graph colouring, and within a
// colour by the elements.
template <std::size_t Nodes>
std::vector<StripBlock<Nodes>> stripBlocks(const std::vector<std::array<int, Nodes>>& elements,
                                           const Strips& strips) {
    constexpr std::size_t tileVectors = 128;
    std::vector<StripBlock<Nodes>> unordered = unorderedStripBlocks(elements, strips);
    const auto lowest = [](const StripBlock<Nodes>& block) {
        int found = std::numeric_limits<int>::max();
        for (const int element : block.elements)
            if (element >= 0) found = std::min(found, element);
        return found;
    };
    std::sort(unordered.begin(), unordered.end(),
              [&](const auto& a, const auto& b) { return lowest(a) < lowest(b); });
    std::vector<std::array<int, Nodes>> vectors;
    for (const StripBlock<Nodes>& block : unordered) vectors.push_back(block.vectors);
    std::vector<StripBlock<Nodes>> blocks;
    forEachIndependentSet(vectors, strips.length, tileVectors, [&](const std::vector<int>& colour) {
        for (const int block : colour) blocks.push_back(unordered[static_cast<std::size_t>(block)]);
    });
    return blocks;
}

// The numbers of nodes by which most links go on, from one row to the next on a grid; at most so many, and not 1.
// @param links  the two nodes of each, the lower first
inline std::vector<std::size_t> commonSteps(const std::vector<std::array<int, 2>>& links, std::size_t most) {
    std::map<int, int> counts;
    for (const auto& link : links) ++counts[link[1] - link[0]];
    counts.erase(1);
    std::vector<std::pair<int, int>> steps;  // how many, and the step
    for (const auto& [step, count] : counts) steps.emplace_back(count, step);
    std::sort(steps.begin(), steps.end(), std::greater<>());
    steps.resize(std::min(most, steps.size()));
    std::vector<std::size_t> common;
    for (const auto& step : steps) common.push_back(static_cast<std::size_t>(step.second));
    return common;
}

// Strips of whole rows whose links fill at least half of the lanes, or of length 0 if there are none. The number of rows
// is even, so that links from row to row have the same two colours in all strips, and a sweep goes over them as it would
// without strips. (Other strips may fill the lanes better, but the sag at rest then differs by up to 0.2 %.)
// @param links  the two nodes of each, the lower first
inline Strips stripsFor(const std::vector<std::array<int, 2>>& links, std::size_t nodes) {
    constexpr std::size_t tried = 3;  // across rows, and both diagonals
    for (const std::size_t row : commonSteps(links, tried)) {
        const std::size_t rows = (nodes + row - 1) / row;
        const Strips strips = {(rows + 2 * blockWidth - 1) / (2 * blockWidth) * 2 * row};
        if (2 * links.size() >= blockWidth * unorderedStripBlocks(links, strips).size()) return strips;
    }
    return {0};
}

}  // namespace drench
