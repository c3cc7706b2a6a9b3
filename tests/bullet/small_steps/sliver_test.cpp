// Whether a few bad triangles leave the number of steps, and the drape, of a sheet as they are.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bullet/world/worlds.h"

namespace drench::sliver_test {
namespace {

enum class Sliver { none, atAnEdge, atTheDiagonal, atACorner };

// A level grid of `nodes` x `nodes`, with one more vertex in one of its cells: a hundredth of a cell from an edge of
// its first triangle, or from a corner.
TriangleMesh gridWith(Sliver sliver, int nodes, double cell) {
    TriangleMesh mesh;
    for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i) mesh.vertices.push_back({i * cell, 0, j * cell});
    const int at = nodes / 3;
    for (int j = 0; j + 1 < nodes; ++j)
        for (int i = 0; i + 1 < nodes; ++i) {
            const int a = i + nodes * j, b = a + 1, c = a + nodes, d = c + 1;
            mesh.triangles.push_back({b, c, d});
            if (sliver == Sliver::none || i != at || j != at) {
                mesh.triangles.push_back({a, c, b});
                continue;
            }
            const double along = sliver == Sliver::atACorner  ? 0.005
                                 : sliver == Sliver::atAnEdge ? 0.5
                                                              : 0.493,
                         across = sliver == Sliver::atACorner  ? 0.005
                                  : sliver == Sliver::atAnEdge ? 0.01
                                                               : 0.493;
            const int added = static_cast<int>(mesh.vertices.size());
            mesh.vertices.push_back({(i + along) * cell, 0, (j + across) * cell});
            mesh.triangles.insert(mesh.triangles.end(), {{a, c, added}, {c, b, added}, {b, a, added}});
        }
    return mesh;
}

struct Bent {
    int steps = 0;
    double speed = 0;                  // m/s
    std::vector<btVector3> positions;  // of the nodes of the grid, m
};

// Clamps the first two rows of a sheet, and lets the rest bend under its weight.
Bent bent(Sliver sliver, const Fabric& fabric, int nodes, double cell) {
    test::SmallStepWorld rig;
    btSoftBody& sheet = rig.add(makeSheet(rig.info(), fabric, gridWith(sliver, nodes, cell)));
    for (int i = 0; i < 2 * nodes; ++i) pin(sheet, {i});
    WetCloth& cloth = rig.cover(sheet, fabric);
    rig.run(4);
    Bent found{cloth.health().smallSteps, test::fastest(sheet), {}};
    for (int n = 0; n < nodes * nodes; ++n) found.positions.push_back(sheet.m_nodes[n].m_x);
    return found;
}

TEST(Sliver, LeavesStepsAndDrapeOfASheetAsTheyAre) {
    constexpr int nodes = 9;
    constexpr double side = 0.1;
    for (const Fabric& fabric : {fabrics::cottonPlain(), fabrics::polyesterTropical(), fabrics::denim()}) {
        const Bent plain = bent(Sliver::none, fabric, nodes, side / (nodes - 1));
        for (const Sliver sliver : {Sliver::atAnEdge, Sliver::atTheDiagonal, Sliver::atACorner}) {
            const Bent found = bent(sliver, fabric, nodes, side / (nodes - 1));
            EXPECT_EQ(found.steps, plain.steps) << fabric.name;
            EXPECT_LT(found.speed, std::max(0.01, 1.5 * plain.speed)) << fabric.name;
            for (std::size_t n = 0; n < plain.positions.size(); ++n)
                EXPECT_LT(double((found.positions[n] - plain.positions[n]).length()), 0.01 * side)
                    << fabric.name << ", node " << n;
        }
    }
}

// Ten triangles, of which up to four touch the added vertex: its height decided the step, and asked for 312 to 1,000.
TEST(Sliver, DoesNotDetermineTheStepsOfASmallMeshEither) {
    constexpr double cell = 0.0125;
    const Fabric fabric = fabrics::cottonPlain();
    const Bent plain = bent(Sliver::none, fabric, 3, cell);
    EXPECT_GT(plain.steps, 8);
    for (const Sliver sliver : {Sliver::atAnEdge, Sliver::atTheDiagonal, Sliver::atACorner}) {
        const Bent found = bent(sliver, fabric, 3, cell);
        EXPECT_LE(found.steps, 3 * plain.steps);
        EXPECT_LT(found.speed, 0.001);
        for (std::size_t n = 0; n < plain.positions.size(); ++n)
            EXPECT_LT(double((found.positions[n] - plain.positions[n]).length()), 0.2 * cell) << "node " << n;
    }
}

}  // namespace
}  // namespace drench::sliver_test
