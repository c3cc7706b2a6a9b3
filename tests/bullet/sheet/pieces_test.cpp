// Sheets that would fall apart, because their mesh is in several pieces, are reported when their WetCloth is made.
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "bullet/world/any_world.h"
#include "bullet/world/worlds.h"

namespace drench::pieces_test {
namespace {

using test::AnyWorld;
using test::SmallStepWorld;

// Two triangles of a square with side 0.2 m whose top is at 1 m, as a flat-shaded export has them.
TriangleMesh flatShaded() {
    TriangleMesh mesh;
    mesh.vertices = {{0, 1, 0}, {0.2, 1, 0}, {0, 0.8, 0}, {0.2, 1, 0}, {0.2, 0.8, 0}, {0, 0.8, 0}};
    mesh.triangles = {{0, 2, 1}, {3, 5, 4}};
    return mesh;
}

TEST(Pieces, SplitVerticesAreReportedOnce) {
    SmallStepWorld world;
    btSoftBody& body = world.add(makeSheet(world.info(), Fabric(), flatShaded()));
    pin(body, {0, 1});
    WetCloth& cloth = world.cover(body, Fabric());
    ASSERT_EQ(cloth.troubles().size(), 1u);
    const TroubleReport& report = cloth.troubles()[0];
    EXPECT_EQ(report.what, Trouble::pieces);
    EXPECT_EQ(report.node, 3);
    EXPECT_EQ(report.value, 2);
    EXPECT_EQ(
        report.message,
        "the sheet is in 2 pieces, of 1 and 1 triangles, which nothing joins; 2 of its nodes are in the same "
        "place as a node of another piece; join those with drench::weld, as readMesh does, before the body "
        "is "
        "made, or set SheetSettings::mayBeInPieces if the pieces are to be apart");
    world.run(1);
    EXPECT_LT(body.m_nodes[4].m_x.y(), -1);  // as Bullet has it, it falls
    EXPECT_EQ(cloth.troubles()[0].substeps, 1);
    EXPECT_EQ(cloth.health().troubles, 1);
    cloth.clearTroubles();
    world.run(0.1);
    EXPECT_TRUE(cloth.troubles().empty());
}

TEST(Pieces, WeldedItHangs) {
    SmallStepWorld world;
    const WeldedMesh welded = weld(flatShaded());
    EXPECT_EQ(welded.coincidentVertices, 2);
    btSoftBody& body = world.add(makeSheet(world.info(), Fabric(), welded.mesh));
    pin(body, {welded.nodeOfVertex[0], welded.nodeOfVertex[1]});
    WetCloth& cloth = world.cover(body, Fabric(), test::throwing());
    world.run(2);
    EXPECT_NEAR(body.m_nodes[welded.nodeOfVertex[4]].m_x.y(), 0.8, 0.01);
    EXPECT_TRUE(cloth.troubles().empty());
    EXPECT_NEAR(cloth.dryMass(), Fabric().arealDensity * 0.04, 1e-7);
}

TEST(Pieces, ThrownWhereTheApplicationWantsThat) {
    SmallStepWorld world;
    btSoftBody& body = world.add(makeSheet(world.info(), Fabric(), flatShaded()));
    const btScalar before = body.m_nodes[2].m_im;
    std::string why;
    try {
        world.cover(body, Fabric(), test::throwing());
    } catch (const std::runtime_error& problem) {
        why = problem.what();
    }
    EXPECT_EQ(why.find("drench: the sheet is in 2 pieces"), 0u) << why;
    EXPECT_EQ(body.m_nodes[2].m_im, before);
    SheetSettings settings = test::throwing();
    settings.mayBeInPieces = true;
    WetCloth& cloth = world.cover(body, Fabric(), settings);  // the refused one has left nothing behind
    world.run(0.1);
    EXPECT_TRUE(cloth.troubles().empty());
}

TEST(Pieces, WithoutCoincidentNodesThereIsNothingToWeld) {
    SmallStepWorld world;
    TriangleMesh mesh = flatShaded();
    for (std::size_t v = 3; v < 6; ++v) mesh.vertices[v].x() += 0.5;
    btSoftBody& body = world.add(makeSheet(world.info(), Fabric(), mesh));
    const std::string message = world.cover(body, Fabric()).troubles().at(0).message;
    EXPECT_NE(message.find("; 0 of its nodes"), std::string::npos) << message;
    EXPECT_EQ(message.find("weld"), std::string::npos) << message;
}

TEST(Pieces, OfManyTheLargestAreNamed) {
    SmallStepWorld world;
    TriangleMesh mesh;
    for (int piece = 0; piece < 9; ++piece)
        for (int t = 0; t <= piece; ++t) {  // a strip
            const int first = int(mesh.vertices.size()) - (t == 0 ? 0 : 2);
            if (t == 0)
                for (const double y : {0.0, 0.1}) mesh.vertices.emplace_back(piece, y, 0);
            mesh.vertices.emplace_back(piece + 0.1 * (t + 1), t % 2 == 0 ? 0 : 0.1, 0);
            mesh.triangles.push_back({first, first + 1, first + 2});
        }
    btSoftBody& body = world.add(makeSheet(world.info(), Fabric(), mesh));
    const TroubleReport report = world.cover(body, Fabric()).troubles().at(0);
    EXPECT_NE(report.message.find("in 9 pieces, of 9, 8, 7, 6, 5 ... 1 triangles"), std::string::npos)
        << report.message;
    EXPECT_EQ(report.value, 9);
}

// Nodes that meet in one node, or that only a link joins, hang together.
TEST(Pieces, WhatHangsTogetherIsOnePiece) {
    SmallStepWorld world;
    TriangleMesh mesh = flatShaded();
    mesh.triangles[1] = {3, 2, 4};
    mesh.vertices.pop_back();
    EXPECT_TRUE(world.cover(world.add(makeSheet(world.info(), Fabric(), mesh)), Fabric()).troubles().empty());
    auto linked = makeSheet(world.info(), Fabric(), flatShaded());
    linked->appendLink(0, 4);
    EXPECT_TRUE(world.cover(world.add(std::move(linked)), Fabric()).troubles().empty());
    EXPECT_TRUE(world.cover(world.add(test::levelSheet(world.info(), Fabric(), 1, 9, 1)), Fabric())
                    .troubles()
                    .empty());
    std::unique_ptr<btSoftBody> patch(btSoftBodyHelpers::CreatePatch(world.info(), {0, 1, 0}, {1, 1, 0},
                                                                     {0, 1, 1}, {1, 1, 1}, 8, 8, 0, true));
    patch->getCollisionShape()->setMargin(btScalar(0.02));
    EXPECT_TRUE(world.cover(world.add(std::move(patch)), Fabric()).troubles().empty());
}

// Cutting is the application's wish, even into two pieces.
TEST(Pieces, CutsAreNotReported) {
    for (const test::Mover mover : test::movers) {
        SCOPED_TRACE(test::nameOf(mover));
        AnyWorld rig(mover, test::throwing());
        rig.run(2);
        const auto crosses = [&](const auto& part) {  // the middle
            int upper = 0, count = 0;
            for (const btSoftBody::Node* node : part.m_n) {
                upper += (node - &rig.sheet().m_nodes[0]) / 9 < 5;
                ++count;
            }
            return upper > 0 && upper < count;
        };
        const auto removeAcross = [&](auto& parts) {
            for (int i = parts.size(); i-- > 0;)
                if (crosses(parts[i])) {
                    parts.swap(i, parts.size() - 1);
                    parts.pop_back();
                }
        };
        removeAcross(rig.sheet().m_links);
        removeAcross(rig.sheet().m_faces);
        EXPECT_NO_THROW(rig.run(3));
        EXPECT_EQ(rig.cloth().health().refits, 1);
        EXPECT_TRUE(rig.cloth().troubles().empty());
    }
}

}  // namespace
}  // namespace drench::pieces_test
