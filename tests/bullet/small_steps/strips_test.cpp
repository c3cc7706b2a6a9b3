// Whether links and plates in strips are all of a mesh's, and move its nodes as one link or plate after the other would.
#include "bullet/simd/strips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "bullet/simd/small_step_kernels.h"
#include "bullet/simd/strip_cloth.h"

namespace drench::strips_test {
namespace {

using Links = std::vector<std::array<int, 2>>;

// Structural links and both diagonals; a tube's last row is linked to its first.
Links gridLinks(int columns, int rows, bool isTube = false) {
    Links links;
    for (const auto& step : {std::array<int, 2>{1, 0}, {0, 1}, {1, 1}, {-1, 1}})
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                const int column = i + step[0], row = j + step[1];
                if (column < 0 || column >= columns || (row >= rows && !isTube)) continue;
                const int one = i + j * columns, other = column + row % rows * columns;
                links.push_back({std::min(one, other), std::max(one, other)});
            }
    return links;
}

// Six nodes of each triangle of a grid, as plates have them.
std::vector<std::array<int, 6>> gridPlates(int columns, int rows) {
    constexpr int patterns[2][6][2] = {{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {0, 1}, {0, -1}},
                                       {{0, 0}, {1, 1}, {0, 1}, {1, 2}, {-1, 0}, {1, 0}}};
    std::vector<std::array<int, 6>> plates;
    for (int j = 0; j + 1 < rows; ++j)
        for (int i = 0; i + 1 < columns; ++i)
            for (const auto& pattern : patterns) {
                std::array<int, 6>& nodes = plates.emplace_back();
                for (std::size_t k = 0; k < 6; ++k) {
                    const int column = i + pattern[k][0], row = j + pattern[k][1];
                    const bool isThere = column >= 0 && column < columns && row >= 0 && row < rows;
                    nodes[k] = isThere ? column + row * columns : -1;
                }
            }
    return plates;
}

// Each element is in one lane, at the nodes that its block says, and no two in a block share a node.
template <std::size_t Nodes>
void expectComplete(const std::vector<std::array<int, Nodes>>& elements, const Strips& strips,
                    const std::string& name) {
    std::multiset<int> found;
    for (const StripBlock<Nodes>& block : stripBlocks(elements, strips)) {
        std::set<int> nodes;
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            const int element = block.elements[lane];
            if (element < 0) continue;
            found.insert(element);
            for (std::size_t k = 0; k < Nodes; ++k) {
                const int node = elements[std::size_t(element)][k];
                if (node < 0) continue;
                ASSERT_TRUE(nodes.insert(node).second) << name << ": two elements at node " << node;
                const std::size_t of = (lane + std::size_t(block.turns[k])) % blockWidth;
                ASSERT_EQ(std::size_t(block.vectors[k]) + of * strips.length, std::size_t(node)) << name;
            }
        }
    }
    ASSERT_EQ(found.size(), elements.size()) << name;
    for (std::size_t i = 0; i < elements.size(); ++i) ASSERT_EQ(found.count(int(i)), 1u) << name;
}

TEST(Strips, HaveEveryLinkAndPlateOnceAndNoNodeTwiceInABlock) {
    for (const auto& [columns, rows] : {std::pair{2, 2},
                                        {3, 3},
                                        {5, 5},
                                        {6, 6},
                                        {9, 4},
                                        {4, 9},
                                        {13, 13},
                                        {16, 16},
                                        {25, 25},
                                        {33, 17},
                                        {7, 64},
                                        {64, 7},
                                        {40, 40},
                                        {2, 50}}) {
        const std::string name = std::to_string(columns) + " x " + std::to_string(rows);
        for (const bool isTube : {false, true}) {
            const Links links = gridLinks(columns, rows, isTube && rows > 2);
            for (const int length : {columns, columns * ((rows + 7) / 8), (columns * rows + 7) / 8})
                if (length * int(blockWidth) >= columns * rows)
                    expectComplete(links, {std::size_t(length)}, name + (isTube ? ", a tube" : ""));
        }
        expectComplete(gridPlates(columns, rows), {std::size_t(columns * ((rows + 7) / 8))}, name);
    }
}

TEST(Strips, FillTheirLanesOnGridsAndAreNotTakenForOtherMeshes) {
    for (const auto& [nodes, fill] : {std::pair{16, 0.9}, {32, 0.95}, {64, 0.95}, {25, 0.7}, {17, 0.5}}) {
        const Links links = gridLinks(nodes, nodes);
        const Strips strips = stripsFor(links, std::size_t(nodes * nodes));
        ASSERT_GT(strips.length, 0u) << nodes;
        EXPECT_EQ(strips.length % std::size_t(nodes), 0u) << "whole rows";
        EXPECT_GT(double(links.size()) / double(stripBlocks(links, strips).size() * blockWidth), fill)
            << nodes;
    }
    std::mt19937 random(1);
    std::vector<int> numbers(900);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = int(i);
    std::shuffle(numbers.begin(), numbers.end(), random);
    Links links = gridLinks(30, 30);
    for (auto& link : links) {
        for (int& node : link) node = numbers[std::size_t(node)];
        std::sort(link.begin(), link.end());
    }
    EXPECT_EQ(stripsFor(links, 900).length, 0u) << "numbered at random";
    EXPECT_EQ(stripsFor({}, 3).length, 0u) << "no links";
    EXPECT_EQ(stripsFor({{0, 1}}, 2).length, 0u) << "one link";
}

// Random nodes with their links or plates in strips.
struct Crumpled {
    Crumpled(int columns, int rows)
        : count(std::size_t(columns * rows)), strips{std::size_t(columns * ((rows + 7) / 8))} {
        std::uniform_real_distribution<float> small(-0.1f, 0.1f), mass(0.5f, 2.0f);
        start.resize(strips.length);
        moved.resize(strips.length);
        inverseMass.resize(strips.length);
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t v = strips.vectorOf(n), lane = strips.laneOf(n);
            start[v].x[lane] = float(int(n) % columns) + small(random);
            start[v].y[lane] = float(int(n) / columns) + small(random);
            start[v].z[lane] = small(random);
            moved[v].x[lane] = small(random);
            moved[v].y[lane] = small(random);
            moved[v].z[lane] = small(random);
            inverseMass[v].of[lane] = n % 7 == 0 ? 0.0f : mass(random);
        }
    }
    std::array<double, 3> displacement(int node) const {
        const std::size_t v = strips.vectorOf(std::size_t(node)), lane = strips.laneOf(std::size_t(node));
        return {double(moved[v].x[lane]), double(moved[v].y[lane]), double(moved[v].z[lane])};
    }
    std::array<double, 3> position(int node) const {
        const std::size_t v = strips.vectorOf(std::size_t(node)), lane = strips.laneOf(std::size_t(node));
        return {double(start[v].x[lane]), double(start[v].y[lane]), double(start[v].z[lane])};
    }
    double massOf(int node) const {
        return double(inverseMass[strips.vectorOf(std::size_t(node))].of[strips.laneOf(std::size_t(node))]);
    }
    double farthestFrom(const std::vector<std::array<double, 3>>& expected) const {
        double farthest = 0;
        for (std::size_t n = 0; n < count; ++n)
            for (std::size_t axis = 0; axis < 3; ++axis)
                farthest = std::max(farthest, std::abs(expected[n][axis] - displacement(int(n))[axis]));
        return farthest;
    }

    std::size_t count;
    Strips strips;
    std::mt19937 random{3};
    std::vector<EightNodes> start, moved;
    std::vector<EightNumbers> inverseMass;
};

class StripLoops : public testing::TestWithParam<const SmallStepKernels*> {};

TEST_P(StripLoops, SweepOverLinksAsOneLinkAfterTheOtherDoes) {
    for (const auto& [columns, rows] : {std::pair{6, 6}, {13, 13}, {16, 20}, {9, 40}}) {
        const Links links = gridLinks(columns, rows);
        Crumpled cloth(columns, rows);
        std::vector<StripLinks> packed;
        std::vector<StripLinkEnds> ends;
        std::vector<std::array<double, 3>> expected;
        for (std::size_t n = 0; n < cloth.count; ++n) expected.push_back(cloth.displacement(int(n)));
        for (const StripBlock<2>& block : stripBlocks(links, cloth.strips)) {
            ends.push_back({block.vectors[0], block.vectors[1], block.turns[1]});
            StripLinks& of = packed.emplace_back(StripLinks{});
            for (std::size_t lane = 0; lane < blockWidth; ++lane) {
                if (block.elements[lane] < 0) continue;
                const auto& link = links[std::size_t(block.elements[lane])];
                of.restLength[lane] = 0.8f + 0.01f * float(lane);
                of.share[lane] = 0.3f;
                const auto from = cloth.position(link[0]), to = cloth.position(link[1]);
                std::array<double, 3> along;
                double length = 0;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    along[axis] = to[axis] + expected[std::size_t(link[1])][axis] - from[axis] -
                                  expected[std::size_t(link[0])][axis];
                    length += along[axis] * along[axis];
                }
                const double stretch =
                    (1 - double(of.restLength[lane]) / std::sqrt(length)) * double(of.share[lane]);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    expected[std::size_t(link[0])][axis] += along[axis] * stretch * cloth.massOf(link[0]);
                    expected[std::size_t(link[1])][axis] -= along[axis] * stretch * cloth.massOf(link[1]);
                }
            }
        }
        const double before = cloth.farthestFrom(expected);
        GetParam()->strips.solveLinks(cloth.moved.data(), cloth.start.data(), cloth.inverseMass.data(),
                                      packed.data(), ends.data(), packed.size());
        EXPECT_GT(before, 0.05);
        EXPECT_LT(cloth.farthestFrom(expected), 3e-6) << columns << " x " << rows;
    }
}

TEST_P(StripLoops, SweepOverPlatesAsOnePlateAfterTheOtherDoes) {
    for (const auto& [columns, rows] : {std::pair{6, 6}, {13, 13}, {16, 20}, {9, 40}}) {
        Crumpled cloth(columns, rows);
        std::vector<PlateElement> plates;
        std::uniform_real_distribution<double> any(-1, 1);
        for (const auto& nodes : gridPlates(columns, rows)) {
            PlateElement& plate = plates.emplace_back(PlateElement{nodes, {}, 1, 0});
            for (auto& component : plate.weights)
                for (std::size_t k = 0; k < 6; ++k) component[k] = nodes[k] < 0 ? 0 : any(cloth.random);
        }
        std::vector<std::array<int, 6>> elements;
        for (const PlateElement& plate : plates) elements.push_back(plate.nodes);
        std::vector<StripPlates> packed;
        std::vector<StripPlateNodes> of;
        std::vector<PlateWeights> weights;
        std::vector<std::array<double, 3>> expected;
        for (std::size_t n = 0; n < cloth.count; ++n) expected.push_back(cloth.displacement(int(n)));
        for (const StripBlock<6>& block : stripBlocks(elements, cloth.strips)) {
            of.push_back(plateNodesOf(block, int(weights.size())));
            StripPlates& fractions = packed.emplace_back(StripPlates{});
            PlateWeights& table = weights.emplace_back(PlateWeights{});
            for (std::size_t lane = 0; lane < blockWidth; ++lane) {
                if (block.elements[lane] < 0) continue;
                const PlateElement& plate = plates[std::size_t(block.elements[lane])];
                std::array<std::array<double, 3>, 3> curvature = {};
                for (std::size_t m = 0; m < 3; ++m) {
                    fractions.fraction[m][lane] = 0.02f * float(m + 1);
                    for (std::size_t k = 0; k < 6; ++k) {
                        table.of[m][k][lane] = float(plate.weights[m][k]);
                        if (plate.nodes[k] < 0) continue;
                        for (std::size_t axis = 0; axis < 3; ++axis)
                            curvature[m][axis] +=
                                plate.weights[m][k] * expected[std::size_t(plate.nodes[k])][axis];
                    }
                }
                for (std::size_t k = 0; k < 6; ++k)
                    for (std::size_t m = 0; m < 3 && plate.nodes[k] >= 0; ++m)
                        for (std::size_t axis = 0; axis < 3; ++axis)
                            expected[std::size_t(plate.nodes[k])][axis] -=
                                plate.weights[m][k] * double(fractions.fraction[m][lane]) *
                                curvature[m][axis] * cloth.massOf(plate.nodes[k]);
            }
        }
        const double before = cloth.farthestFrom(expected);
        GetParam()->strips.solvePlates(cloth.moved.data(), cloth.moved.data(), cloth.inverseMass.data(),
                                       packed.data(), of.data(), weights.data(), packed.size());
        EXPECT_GT(before, 0.01);
        EXPECT_LT(cloth.farthestFrom(expected), 3e-6) << columns << " x " << rows;
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, StripLoops, testing::Values(&scalarKernels(), &bestKernels()),
                         [](const auto& each) { return each.index == 0 ? "scalar" : "best"; });

}  // namespace
}  // namespace drench::strips_test
