// Edges, neighbours and independent sets of meshes, against a count by hand and Euler's formula.
#include "cloth/mesh_edges.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "cloth/independent_sets.h"
#include "meshes.h"

namespace drench::mesh_edges_test {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

struct Named {
    const char* name;
    Triangles triangles;
    std::size_t nodes;
    int pieces;       // that hang together by edges
    int borders;      // loops
    bool isManifold;  // with at most two triangles at each edge, and one fan at each node
};

Triangles besideEachOther(const Triangles& one, const Triangles& two, int nodesOfOne) {
    Triangles both = one;
    for (auto triangle : two) {
        for (int& node : triangle) node += nodesOfOne;
        both.push_back(triangle);
    }
    return both;
}

Triangles tetrahedron() {
    return {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}};
}

std::vector<Named> meshes() {
    const auto grid = meshes::grid(7, 5, 0.1).cloth.triangles;
    const auto irregular = meshes::irregular(9, 8, 0.1, 3).cloth.triangles;
    const auto tube = meshes::tube(6, 4, 0.1).cloth.triangles;
    Triangles turned = irregular;  // with triangles that go round the other way
    for (std::size_t t = 0; t < turned.size(); t += 3) std::swap(turned[t][1], turned[t][2]);
    Triangles fan;
    for (int i = 0; i < 40; ++i) fan.push_back({40, i, (i + 1) % 40});
    return {
        {"nothing", {}, 0, 0, 0, true},
        {"one triangle", {{2, 0, 1}}, 3, 1, 1, true},
        {"two triangles", {{0, 1, 2}, {2, 1, 3}}, 4, 1, 1, true},
        {"grid", grid, 35, 1, 1, true},
        {"irregular", irregular, 72, 1, 1, true},
        {"irregular, some turned", turned, 72, 1, 1, true},
        {"tube", tube, 24, 1, 2, true},
        {"closed", tetrahedron(), 4, 1, 0, true},
        {"fan", fan, 41, 1, 1, true},
        {"in two pieces", besideEachOther(grid, tube, 35), 59, 2, 3, true},
        {"three at an edge", {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5, 1, 0, false},
        {"two that meet in a node", {{0, 1, 2}, {2, 3, 4}}, 5, 2, 0, false},
        {"nodes without cloth", {{5, 1, 3}}, 8, 1, 0, false},
    };
}

// The triangles and apices at each edge, found the long way.
std::map<NodePair, std::vector<std::array<std::size_t, 2>>> countedEdges(const Named& mesh) {
    std::map<NodePair, std::vector<std::array<std::size_t, 2>>> counted;
    const int nodes = int(mesh.nodes);
    for (int a = 0; a < nodes; ++a)
        for (int b = a + 1; b < nodes; ++b)
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
                const std::set<int> of(mesh.triangles[t].begin(), mesh.triangles[t].end());
                if (of.count(a) == 0 || of.count(b) == 0) continue;
                for (std::size_t corner = 0; corner < 3; ++corner)
                    if (mesh.triangles[t][corner] != a && mesh.triangles[t][corner] != b)
                        counted[{a, b}].push_back({t, corner});
            }
    return counted;
}

TEST(MeshEdges, AreThoseThatOneCounts) {
    for (const Named& mesh : meshes()) {
        SCOPED_TRACE(mesh.name);
        const MeshEdges edges(mesh.triangles, mesh.nodes);
        const auto counted = countedEdges(mesh);
        ASSERT_EQ(edges.size(), counted.size());
        std::size_t edge = 0;
        for (const auto& [ends, triangles] : counted) {  // a map is in ascending order, too
            ASSERT_EQ(edges.ends()[edge], ends);
            EXPECT_EQ(edges.find(ends[0], ends[1]), edge);
            EXPECT_EQ(edges.find(ends[1], ends[0]), edge);
            const auto found = edges.trianglesAt(edge);
            ASSERT_EQ(found.size(), triangles.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                EXPECT_EQ(found[i].triangle, triangles[i][0]);
                EXPECT_EQ(found[i].apex, triangles[i][1]);
            }
            ++edge;
        }
    }
}

TEST(MeshEdges, AreNotFoundWhereThereAreNone) {
    for (const Named& mesh : meshes()) {
        SCOPED_TRACE(mesh.name);
        const MeshEdges edges(mesh.triangles, mesh.nodes);
        const auto counted = countedEdges(mesh);
        for (int a = -1; a <= int(mesh.nodes); ++a)
            for (int b = a; b <= int(mesh.nodes); ++b)
                EXPECT_EQ(edges.find(a, b).has_value(), counted.count({a, b}) > 0) << a << " " << b;
    }
}

// V - E + F = 2 pieces - borders of surfaces without handles.
TEST(MeshEdges, ObeyEulersFormula) {
    for (const Named& mesh : meshes()) {
        if (!mesh.isManifold) continue;
        SCOPED_TRACE(mesh.name);
        const MeshEdges edges(mesh.triangles, mesh.nodes);
        EXPECT_EQ(int(mesh.nodes) - int(edges.size()) + int(mesh.triangles.size()),
                  2 * mesh.pieces - mesh.borders);
    }
}

TEST(MeshEdges, LeadToTheOneTriangleAcross) {
    for (const Named& mesh : meshes()) {
        SCOPED_TRACE(mesh.name);
        const MeshEdges edges(mesh.triangles, mesh.nodes);
        for (const auto& [ends, triangles] : countedEdges(mesh))
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                const EdgeTriangle* const across = edges.across(triangles[i][0], triangles[i][1]);
                ASSERT_EQ(across != nullptr, triangles.size() == 2) << ends[0] << " " << ends[1];
                if (!across) continue;
                EXPECT_EQ(across->triangle, triangles[1 - i][0]);
                EXPECT_EQ(across->apex, triangles[1 - i][1]);
            }
    }
}

TEST(MeshEdges, TrianglesAroundNodesComeInAscendingOrder) {
    for (const Named& mesh : meshes()) {
        SCOPED_TRACE(mesh.name);
        const CompressedRows<std::size_t> around = trianglesAround(mesh.triangles, mesh.nodes);
        ASSERT_EQ(around.size(), mesh.nodes);
        EXPECT_EQ(around.valueCount(), 3 * mesh.triangles.size());
        for (std::size_t node = 0; node < mesh.nodes; ++node) {
            std::vector<std::size_t> counted;
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
                for (const int corner : mesh.triangles[t])
                    if (corner == int(node)) counted.push_back(t);
            EXPECT_EQ(std::vector<std::size_t>(around[node].begin(), around[node].end()), counted) << node;
        }
    }
}

TEST(MeshEdges, ThirdsOfTrianglesAddUpToAll) {
    for (const Named& mesh : meshes()) {
        std::vector<double> ofNodes(mesh.nodes, 0.0);
        double sum = 0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            addThirds(mesh.triangles[t], double(t + 1), ofNodes);
            sum += double(t + 1);
        }
        double there = 0;
        for (const double ofNode : ofNodes) there += ofNode;
        EXPECT_NEAR(there, sum, 1e-12 * (sum + 1)) << mesh.name;
    }
}

TEST(CompressedRows, KeepTheOrderInWhichValuesCome) {
    const std::vector<std::array<std::size_t, 2>> values = {{2, 5}, {0, 7}, {2, 4}, {2, 6}, {0, 7}};
    const CompressedRows<std::size_t> rows(4, [&](const auto& add) {
        for (const auto& [row, value] : values) add(row, value);
    });
    const auto asVector = [&](std::size_t row) {
        return std::vector<std::size_t>(rows[row].begin(), rows[row].end());
    };
    EXPECT_EQ(rows.size(), 4u);
    EXPECT_EQ(asVector(0), (std::vector<std::size_t>{7, 7}));
    EXPECT_EQ(asVector(1), (std::vector<std::size_t>{}));
    EXPECT_EQ(asVector(2), (std::vector<std::size_t>{5, 4, 6}));
    EXPECT_EQ(asVector(3), (std::vector<std::size_t>{}));
    EXPECT_EQ(CompressedRows<int>().size(), 0u);
}

// Each element gets the first colour that no earlier element with a node in common has.
std::vector<std::vector<int>> firstFit(const Triangles& elements) {
    std::vector<std::vector<int>> colours;
    std::vector<std::size_t> colourOf;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        std::set<std::size_t> taken;
        for (std::size_t before = 0; before < i; ++before)
            for (const int node : elements[i])
                if (node >= 0 && std::count(elements[before].begin(), elements[before].end(), node) > 0)
                    taken.insert(colourOf[before]);
        std::size_t colour = 0;
        while (taken.count(colour) > 0) ++colour;
        colourOf.push_back(colour);
        if (colour == colours.size()) colours.emplace_back();
        colours[colour].push_back(int(i));
    }
    return colours;
}

TEST(IndependentSets, AreTheColoursOfTheFirstFit) {
    for (const Named& mesh : meshes()) {
        SCOPED_TRACE(mesh.name);
        Triangles elements = mesh.triangles;
        if (elements.size() > 3) elements[3][1] = -1;  // no node
        IndependentSets sets(elements, mesh.nodes);
        std::vector<int> waiting;
        for (int i = 0; i < int(elements.size()); ++i) waiting.push_back(i);
        for (const std::vector<int>& colour : firstFit(elements)) EXPECT_EQ(sets.take(waiting), colour);
        EXPECT_TRUE(waiting.empty());
    }
}

}  // namespace
}  // namespace drench::mesh_edges_test
