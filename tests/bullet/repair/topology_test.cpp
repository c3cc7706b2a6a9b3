// Cloth that is cut, refined, sewn or torn apart while it hangs and drips.
#include <algorithm>
#include <set>
#include <utility>

#include "bullet/world/any_world.h"

namespace drench::topology_test {
namespace {

using test::AnyWorld;
using test::Mover;

constexpr int across = 9;  // nodes of a side

int at(int i, int j) {
    return i + across * j;
}

int linksOf(const btSoftBody& body, int node) {
    int count = 0;
    for (int i = 0; i < body.m_links.size(); ++i)
        for (const btSoftBody::Node* end : body.m_links[i].m_n)
            if (end == &body.m_nodes[node]) ++count;
    return count;
}

double water(const WetCloth& cloth) {
    return cloth.waterMass();
}

// The nodes that hang together with one through faces.
std::set<int> pieceOf(const btSoftBody& body, int first) {
    std::set<int> piece = {first};
    for (std::size_t before = 0; before != piece.size();) {
        before = piece.size();
        for (int f = 0; f < body.m_faces.size(); ++f) {
            int corners[3];
            for (int k = 0; k < 3; ++k) corners[k] = int(body.m_faces[f].m_n[k] - &body.m_nodes[0]);
            if (piece.count(corners[0]) + piece.count(corners[1]) + piece.count(corners[2]) > 0)
                piece.insert(corners, corners + 3);
        }
    }
    return piece;
}

// Unevenly wet, as a cut must not even it out.
void wet(AnyWorld& rig) {
    for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) rig.cloth().addWater(n, 1e-4 * (1 + n % 7));
    rig.cloth().account("hose").addPores(30, 2e-3);
}

TEST(Topology, ACutIsFollowedWithItsWater) {
    for (const Mover mover : test::movers) {
        SCOPED_TRACE(test::nameOf(mover));
        AnyWorld rig(mover);
        wet(rig);
        rig.run(20);
        const double before = water(rig.cloth()), drippedBefore = rig.cloth().ledger().dripped;
        ASSERT_TRUE(rig.sheet().cutLink(at(4, 4), at(5, 4), btScalar(0.25)));
        EXPECT_FALSE(rig.cloth().health().fits);
        rig.cloth().air().vapourExchange = 0;
        rig.run(1);
        const double dripped = rig.cloth().ledger().dripped - drippedBefore;
        EXPECT_NEAR(water(rig.cloth()) + dripped, before, 1e-14 * before);
        EXPECT_TRUE(rig.cloth().troubles().empty());
        const SheetHealth health = rig.cloth().health();
        EXPECT_TRUE(health.fits);
        EXPECT_EQ(health.refits, 1);
        ASSERT_EQ(rig.sheet().m_nodes.size(), across * across + 2);
        for (const int node : {across * across, across * across + 1}) {
            const Eigen::Vector2d position = rig.cloth().materialCoordinates()[std::size_t(node)],
                                  a = rig.cloth().materialCoordinates()[std::size_t(at(4, 4))],
                                  b = rig.cloth().materialCoordinates()[std::size_t(at(5, 4))];
            EXPECT_LT((position - (0.75 * a + 0.25 * b)).norm(), 1e-3);
            EXPECT_GT(rig.cloth().moistureContent(node), 0);
            EXPECT_LT(rig.cloth().nodeMass(node), rig.cloth().nodeMass(at(4, 4)));
            EXPECT_NEAR(double(rig.sheet().m_nodes[node].m_im) * rig.cloth().nodeMass(node), 1, 1e-5);
        }
        rig.run(120);
        EXPECT_LT(test::ledgerError(rig.cloth()), 1e-12);
        EXPECT_TRUE(rig.cloth().health().finite);
        EXPECT_LT(test::fastest(rig.sheet()), 5);
    }
}

TEST(Topology, RestLengthsAndWeightStayThoseOfTheCloth) {
    AnyWorld rig(Mover::smallSteps), whole(Mover::smallSteps);
    for (AnyWorld* each : {&rig, &whole}) {
        each->sheet().m_cfg.kDP = 3;
        each->cloth().soakPores(0.2);
        each->cloth().air().vapourExchange = 0;
        each->run(120);
    }
    // A slit along the thread that hangs, which takes nothing from its strength.
    for (int j = 3; j < 6; ++j) ASSERT_TRUE(rig.sheet().cutLink(at(4, j), at(5, j), btScalar(0.5)));
    rig.run(120);
    whole.run(120);
    EXPECT_NEAR(rig.cloth().dryMass(), whole.cloth().dryMass(), 1e-9);
    EXPECT_NEAR(test::lowest(rig.sheet()), test::lowest(whole.sheet()), 0.002);
    EXPECT_LT(rig.cloth().health().largestStrain, 0.03);
}

TEST(Topology, ClothThatIsTornOffFalls) {
    for (const Mover mover : test::movers) {
        SCOPED_TRACE(test::nameOf(mover));
        AnyWorld rig(mover);
        wet(rig);
        rig.run(5);
        // Each link that crosses the middle is taken out of the body, and with the bottom row its faces.
        auto& links = rig.sheet().m_links;
        const auto rowOf = [&](const btSoftBody::Node* node) {
            return int(node - &rig.sheet().m_nodes[0]) / across;
        };
        for (int i = links.size(); i-- > 0;)
            if ((rowOf(links[i].m_n[0]) < 5) != (rowOf(links[i].m_n[1]) < 5)) {
                links.swap(i, links.size() - 1);
                links.pop_back();
            }
        auto& faces = rig.sheet().m_faces;
        for (int i = faces.size(); i-- > 0;) {
            const int upper =
                (rowOf(faces[i].m_n[0]) < 5) + (rowOf(faces[i].m_n[1]) < 5) + (rowOf(faces[i].m_n[2]) < 5);
            if (upper == 0 || upper == 3) continue;
            faces.swap(i, faces.size() - 1);
            faces.pop_back();
        }
        rig.run(static_cast<int>(0.5 / rig.substep()));
        EXPECT_TRUE(rig.cloth().troubles().empty());
        EXPECT_EQ(rig.cloth().health().refits, 1);
        EXPECT_EQ(pieceOf(rig.sheet(), 0).size(), 45u);
        EXPECT_LT(double(rig.sheet().m_nodes[at(4, 6)].m_x.y()), -1);
        EXPECT_GT(double(rig.sheet().m_nodes[at(4, 4)].m_x.y()), -0.4);
        EXPECT_LT(test::ledgerError(rig.cloth()), 1e-12);
        double cutAway = 0;
        for (const Account& account : rig.cloth().ledger().accounts)
            if (account.name == "cut away") cutAway = account.returned;
        EXPECT_GT(cutAway, 0.05 * rig.cloth().ledger().supplied) << "an eighth of the cloth is gone";
        EXPECT_LT(cutAway, 0.25 * rig.cloth().ledger().supplied);
    }
}

// Bullet's own way to cut along a surface.
struct Plane final : btSoftBody::ImplicitFn {
    btScalar Eval(const btVector3& x) override { return x.x() + btScalar(0.3) * x.y() - btScalar(0.01); }
};

TEST(Topology, RefiningIsFollowed) {
    for (const Mover mover : test::movers)
        for (const bool cut : {false, true}) {
            SCOPED_TRACE(std::string(test::nameOf(mover)) + (cut ? ", cut" : ", refined"));
            AnyWorld rig(mover);
            wet(rig);
            rig.run(3);
            rig.cloth().air().vapourExchange = 0;
            const double dry = rig.cloth().dryMass(),
                         held = water(rig.cloth()) + rig.cloth().ledger().dripped;
            Plane plane;
            rig.sheet().refine(&plane, btScalar(1e-4), cut);
            rig.run(1);
            ASSERT_TRUE(rig.cloth().troubles().empty()) << rig.cloth().troubles()[0].message;
            EXPECT_EQ(rig.cloth().health().refits, 1);
            EXPECT_NEAR(rig.cloth().dryMass(), dry, 1e-6 * dry);
            EXPECT_NEAR(water(rig.cloth()) + rig.cloth().ledger().dripped, held, 1e-12 * held);
            rig.run(60);
            EXPECT_TRUE(rig.cloth().health().finite);
            EXPECT_LT(test::ledgerError(rig.cloth()), 1e-12);
            for (int n = 0; n < rig.sheet().m_nodes.size() && !cut; ++n)
                EXPECT_LT(double(rig.sheet().m_nodes[n].m_v.length()), 5) << n;
        }
}

TEST(Topology, PiecesMayBeSewnOn) {
    for (const Mover mover : test::movers) {
        SCOPED_TRACE(test::nameOf(mover));
        AnyWorld rig(mover);
        rig.cloth().soakFilm(0.1);
        rig.cloth().air().vapourExchange = 0;
        rig.run(3);
        btSoftBody& sheet = rig.sheet();
        const double held = water(rig.cloth()) + rig.cloth().ledger().dripped;
        const double dry = rig.cloth().dryMass();
        const btVector3 below = sheet.m_nodes[at(4, 8)].m_x + btVector3(0, btScalar(-0.06), 0);
        sheet.appendNode(below, 1);
        const int added = sheet.m_nodes.size() - 1;
        sheet.appendFace(at(4, 8), at(5, 8), added);
        sheet.appendLink(at(4, 8), added);
        sheet.appendLink(at(5, 8), added);
        rig.run(1);
        EXPECT_NEAR(water(rig.cloth()) + rig.cloth().ledger().dripped, held, 1e-12 * held);
        rig.run(60);
        EXPECT_TRUE(rig.cloth().health().finite);
        EXPECT_TRUE(rig.cloth().health().fits);
        EXPECT_TRUE(rig.cloth().troubles().empty());
        const double patch = 0.5 * 0.06 * 0.5 / (across - 1) * fabrics::cottonPlain().arealDensity;
        EXPECT_NEAR(rig.cloth().dryMass() - dry, patch, 0.02 * patch);
        EXPECT_NEAR(double(sheet.m_nodes[added].m_x.y()), -0.56, 0.02) << "it hangs on";
    }
}

TEST(Topology, AnotherOrderIsNoticedWithinSixtyFourSubsteps) {
    for (const Mover mover : test::movers) {
        SCOPED_TRACE(test::nameOf(mover));
        AnyWorld rig(mover);
        rig.cloth().soakFilm(0.1);
        rig.run(5);
        rig.sheet().randomizeConstraints();
        rig.run(64);
        EXPECT_GE(rig.cloth().health().refits, 1);
        EXPECT_TRUE(rig.cloth().troubles().empty());
        rig.run(60);
        EXPECT_LT(rig.cloth().health().largestStrain, 0.2);
        EXPECT_LT(test::ledgerError(rig.cloth()), 1e-12);
    }
}

// Bodies that are no cloth any more.
struct Ruin {
    const char* name;
    std::function<void(btSoftBody&)> happen;
};

std::vector<Ruin> ruins() {
    return {
        {"no faces", [](btSoftBody& body) { body.m_faces.clear(); }},
        {"fewer nodes",
         [](btSoftBody& body) {
             // The last row, cleanly.
             const auto isLast = [&](const btSoftBody::Node* node) {
                 return node - &body.m_nodes[0] >= across * (across - 1);
             };
             for (int i = body.m_links.size(); i-- > 0;)
                 if (isLast(body.m_links[i].m_n[0]) || isLast(body.m_links[i].m_n[1])) {
                     body.m_links.swap(i, body.m_links.size() - 1);
                     body.m_links.pop_back();
                 }
             for (int i = body.m_faces.size(); i-- > 0;)
                 if (isLast(body.m_faces[i].m_n[0]) || isLast(body.m_faces[i].m_n[1]) ||
                     isLast(body.m_faces[i].m_n[2])) {
                     body.m_faces.swap(i, body.m_faces.size() - 1);
                     body.m_faces.pop_back();
                 }
             for (int i = 0; i < across; ++i) {
                 body.m_ndbvt.remove(body.m_nodes[body.m_nodes.size() - 1].m_leaf);
                 body.m_nodes.pop_back();
             }
             body.m_fdbvt.clear();
             body.m_bUpdateRtCst = true;
         }},
        {"a double face", [](btSoftBody& body) { body.appendFace(0, 1, across + 1); }},
        {"a double link", [](btSoftBody& body) { body.appendLink(0, 1); }},
        {"a face of no area",
         [](btSoftBody& body) {
             const btVector3 position = body.m_nodes[40].m_x;
             body.appendNode(position, 1);
             body.appendFace(40, 41, body.m_nodes.size() - 1);
             body.appendLink(41, body.m_nodes.size() - 1);
         }},
    };
}

TEST(Topology, WhatIsNoClothIsLeftToBulletAndSaidSo) {
    for (const Mover mover : test::movers)
        for (const Ruin& ruin : ruins()) {
            SCOPED_TRACE(std::string(test::nameOf(mover)) + ", " + ruin.name);
            AnyWorld rig(mover);
            FallingDrops drops(rig.world());
            drops.add(rig.cloth());
            wet(rig);
            rig.run(5);
            ruin.happen(rig.sheet());
            EXPECT_FALSE(rig.cloth().health().fits);
            EXPECT_EQ(rig.cloth().health().largestStrain, 0);
            rig.cloth().add(Rain(10));
            EXPECT_GT(rig.cloth().moistureContent(at(4, 4)), 0);
            drops.step(0.1);
            const double before = water(rig.cloth());
            rig.run(5);
            EXPECT_EQ(test::reportOf(rig.cloth(), Trouble::topology).substeps, 5);
            EXPECT_EQ(water(rig.cloth()), before);
            EXPECT_TRUE(rig.cloth().health().finite);
            EXPECT_GT(rig.cloth().moistureContent(at(4, 4)), 0);
            rig.cloth().addWater(40, 1e-3);
            EXPECT_LT(test::ledgerError(rig.cloth()), 1e-12);
            drops.step(0.1);
            rig.clothOwner().reset();
            rig.run(5);
        }
}

TEST(Topology, ThrownWhereTheApplicationWantsThat) {
    AnyWorld rig(Mover::smallSteps, test::throwing());
    rig.run(2);
    rig.sheet().appendLink(0, 40);  // a stay across the sheet
    rig.run(2);
    EXPECT_EQ(rig.cloth().health().refits, 1);
    rig.sheet().appendLink(0, 1);
    EXPECT_THROW(rig.run(1), std::runtime_error);
    EXPECT_THROW(rig.run(1), std::runtime_error);
}

TEST(Topology, AClothThatIsCutMayEndBeforeTheNextStep) {
    for (const Mover mover : test::movers) {
        AnyWorld rig(mover);
        wet(rig);
        rig.run(5);
        ASSERT_TRUE(rig.sheet().cutLink(at(4, 4), at(5, 4), btScalar(0.5)));
        rig.clothOwner().reset();
        rig.run(5);
    }
}

TEST(Topology, ABodyThatWasCutIsGivenBackAsBulletWouldHaveIt) {
    AnyWorld rig(Mover::stock);
    const double before = double(rig.sheet().m_nodes[at(2, 2)].m_im);
    const btScalar drag = rig.sheet().m_cfg.kDG;
    wet(rig);
    rig.run(5);
    ASSERT_TRUE(rig.sheet().cutLink(at(4, 4), at(5, 4), btScalar(0.5)));
    rig.run(5);
    rig.clothOwner().reset();
    EXPECT_NEAR(double(rig.sheet().m_nodes[at(2, 2)].m_im), before, 1e-6 * before);
    EXPECT_GT(double(rig.sheet().m_nodes[81].m_im), before) << "less cloth, less mass";
    EXPECT_EQ(rig.sheet().m_cfg.kDG, drag);
    EXPECT_EQ(linksOf(rig.sheet(), 0), 5);
    rig.run(30);
    EXPECT_TRUE(test::isFinite(rig.sheet()));
}

// What the application's callbacks work on.
AnyWorld* rigOfCallbacks = nullptr;
int cutsLeft = 0;

void cutOnce(btDynamicsWorld*, btScalar) {
    if (cutsLeft-- > 0) {
        EXPECT_TRUE(rigOfCallbacks->sheet().cutLink(at(4, 4), at(5, 4), btScalar(0.5)));
    }
}

TEST(Topology, CutsMayComeOutOfTheWorldsCallbacks) {
    for (const Mover mover : test::movers)
        for (const bool preTick : {true, false}) {
            // In the deformable world Bullet itself falls over cuts between its collisions and its solve.
            if (mover == Mover::deformable && !preTick) continue;
            AnyWorld rig(mover);
            wet(rig);
            rig.run(5);
            rigOfCallbacks = &rig;
            cutsLeft = 1;
            rig.world().setInternalTickCallback(cutOnce, nullptr, preTick);
            if (preTick) {  // the slot is taken again by the next WetCloth
                SheetSettings settings;
                settings.materialCoordinates = rig.cloth().materialCoordinates();
                rig.clothOwner().reset();
                rig.clothOwner() =
                    std::make_unique<WetCloth>(rig.world(), rig.sheet(), fabrics::cottonPlain(), settings);
            }
            rig.run(30);
            EXPECT_EQ(rig.cloth().health().refits, 1) << test::nameOf(mover) << preTick;
            EXPECT_TRUE(rig.cloth().health().finite);
            EXPECT_TRUE(rig.cloth().troubles().empty());
        }
}

TEST(Topology, ACutSheetMeetsSolidsAndOtherSheets) {
    test::SmallStepWorld rig;
    rig.bullet().addGround(-1);
    const Fabric fabric = fabrics::cottonPlain();
    std::vector<WetCloth*> cloths;
    for (const double height : {0.0, 0.05}) {
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.5, across, height - 0.9));
        sheet.m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
        cloths.push_back(&rig.cover(sheet, fabric));
        cloths.back()->soakFilm(0.2);
    }
    cloths[0]->add(Touch(*cloths[1]));
    for (int i = 0; i < 60; ++i) {
        if (i % 10 == 5) {
            btSoftBody& sheet = *rig.world().getSoftBodyArray()[i % 20 == 5 ? 0 : 1];
            ASSERT_TRUE(sheet.cutLink(at(2 + i / 20, 4), at(2 + i / 20, 5), btScalar(0.5)));
        }
        rig.run(1.0 / 60);
    }
    for (const WetCloth* cloth : cloths) {
        EXPECT_EQ(cloth->health().refits, 3);
        EXPECT_TRUE(cloth->health().finite);
        EXPECT_TRUE(cloth->troubles().empty());
        EXPECT_LT(cloth->health().deepestPenetration, 0.005);
        EXPECT_LT(test::ledgerError(*cloth), 1e-12);
    }
}

TEST(Topology, AnchorsOfTheDeformableWorldFollow) {
    AnyWorld rig(Mover::deformable);
    btSphereShape shape(btScalar(0.05));
    btRigidBody weight(btRigidBody::btRigidBodyConstructionInfo(btScalar(0.01), nullptr, &shape));
    weight.setWorldTransform(btTransform(btQuaternion::getIdentity(), rig.sheet().m_nodes[at(8, 8)].m_x));
    rig.world().addRigidBody(&weight, 0, 0);
    rig.sheet().appendDeformableAnchor(at(8, 8), &weight);
    rig.run(10);
    ASSERT_TRUE(rig.sheet().cutLink(at(4, 4), at(5, 4), btScalar(0.5)));
    rig.run(60);
    EXPECT_EQ(rig.sheet().m_deformableAnchors[0].m_node, &rig.sheet().m_nodes[at(8, 8)]);
    EXPECT_TRUE(rig.cloth().health().finite);
    EXPECT_LT(double((weight.getWorldTransform().getOrigin() - rig.sheet().m_nodes[at(8, 8)].m_x).length()),
              0.1);
    rig.clothOwner().reset();
    rig.sheet().m_deformableAnchors.clear();
    rig.world().removeRigidBody(&weight);
}

}  // namespace
}  // namespace drench::topology_test
