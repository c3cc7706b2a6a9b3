// Water of sheets that lie on each other, or are folded, in real worlds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numeric>
#include <vector>

#include "bullet/world/worlds.h"

namespace drench::cloth_layers_test {
namespace {

const Account* accountOf(const Ledger& ledger, const std::string& name) {
    for (const Account& account : ledger.accounts)
        if (account.name == name) return &account;
    return nullptr;
}

void expectClosed(const WetCloth& cloth) {
    const Ledger ledger = cloth.ledger();
    EXPECT_LT(std::abs(ledger.imbalance()), 1e-6 * std::max(ledger.supplied, 1e-12));
}

// Sheets of 0.3 m that lie on each other on a floor, from below, without air.
class Pile {
  public:
    Pile(int layers, int nodes, const std::function<Fabric(int)>& fabricOf,
         const SmallStepSettings& steps = {})
        : rig_(steps), ground_(rig_.bullet().addGround(0)) {
        for (int layer = 0; layer < layers; ++layer) {
            const Fabric fabric = fabricOf(layer);
            auto sheet = test::levelSheet(rig_.info(), fabric, 0.3, nodes, 0);
            const btScalar margin = sheet->getCollisionShape()->getMargin();
            sheet->translate({0, margin * btScalar(1.02 + 2.02 * layer), 0});
            bodies_.push_back(&rig_.add(std::move(sheet)));
            cloths_.push_back(&rig_.cover(*bodies_.back(), fabric));
            cloths_.back()->air().vapourExchange = 0;
        }
    }
    Pile(int layers, int nodes) : Pile(layers, nodes, [](int) { return fabrics::cottonPlain(); }) {}
    test::SmallStepWorld& rig() { return rig_; }
    WetCloth& operator[](int layer) { return *cloths_[static_cast<std::size_t>(layer)]; }
    btSoftBody& body(int layer) { return *bodies_[static_cast<std::size_t>(layer)]; }

    const btRigidBody& ground() const { return ground_; }

  private:
    test::SmallStepWorld rig_;
    btRigidBody& ground_;
    std::vector<btSoftBody*> bodies_;
    std::vector<WetCloth*> cloths_;
};

TEST(ClothLayers, HalfOfTheWaterOfOneSheetMovesOverToTheOther) {
    Pile pile(2, 9);
    pile.rig().run(0.5);
    const Fabric cotton = fabrics::cottonPlain();
    pile[0].soakPores(0.8 * cotton.poreCapacity());
    const double before = pile[0].waterMass();
    double last = 0;
    for (int second = 0; second < 60; ++second) {
        pile.rig().run(1);
        EXPECT_GE(pile[1].waterMass(), last - 1e-4 * before);
        last = pile[1].waterMass();
    }
    std::printf("  %.4f of it after a minute\n", last / before);
    EXPECT_NEAR(last / before, 0.5, 0.01);
    EXPECT_NEAR((pile[0].waterMass() + last) / before, 1, 1e-6);
    for (const int layer : {0, 1}) expectClosed(pile[layer]);
    const Ledger below = pile[0].ledger(), above = pile[1].ledger();
    const Account *const from = accountOf(below, "touch"), *const to = accountOf(above, "touch");
    ASSERT_TRUE(from && to);
    EXPECT_NEAR(from->returned - from->supplied, last, 1e-6 * before);
    EXPECT_NEAR(to->supplied - to->returned, last, 1e-6 * before);
}

// The pile as a column of cells, one a layer, in short explicit steps.
std::vector<double> column(const Fabric& fabric, std::vector<double> s, double seconds) {
    constexpr double dt = 1e-4;
    const double mobility = 1000 * fabric.permeabilityThrough / 1e-3 / fabric.thickness;  // kg/(m2 s Pa)
    const auto psi = [&](double of) { return fabric.entryPressure / 4 * of * of * of * of; };
    for (double t = 0; t < seconds - dt / 2; t += dt)
        for (std::size_t i = 0; i + 1 < s.size(); ++i) {
            const double passed = mobility * (psi(s[i]) - psi(s[i + 1])) * dt / fabric.poreCapacity();
            s[i] -= passed;
            s[i + 1] += passed;
        }
    return s;
}

TEST(ClothLayers, APileWicksAsAColumn) {
    for (const int layers : {2, 4}) {
        Pile pile(layers, 9);
        pile.rig().run(1);
        const Fabric cotton = fabrics::cottonPlain();
        const double before = 0.95;
        pile[0].soakPores(before * cotton.poreCapacity());
        std::vector<double> start(static_cast<std::size_t>(layers), 0.0);
        start[0] = before;
        double time = 0;
        for (const double until : {0.5, 2.0, 10.0}) {
            pile.rig().run(until - time);
            time = until;
            const std::vector<double> law = column(cotton, start, until);
            for (int layer = 0; layer < layers; ++layer) {
                const double here = pile[layer].moisture().meanSaturation();
                std::printf("  layer %d of %d at %.1f s: %.3f, column %.3f\n", layer, layers, until, here,
                            law[static_cast<std::size_t>(layer)]);
                EXPECT_NEAR(here, law[static_cast<std::size_t>(layer)], 0.03)
                    << layer << " of " << layers << " at " << until << " s";
            }
        }
    }
}

TEST(ClothLayers, UnlikeMeshesAndFabricsPassWaterToo) {
    test::SmallStepWorld rig;
    rig.bullet().addGround(0);
    const Fabric cotton = fabrics::cottonPlain(), wool = fabrics::wool();
    auto below = test::levelSheet(rig.info(), cotton, 0.3, 9, 0.02);
    auto above = test::levelSheet(rig.info(), wool, 0.2, 13, 0);
    above->transform(btTransform(btQuaternion({0, 1, 0}, btScalar(0.4)), {0, btScalar(0.05), 0}));
    WetCloth& lower = rig.cover(rig.add(std::move(below)), cotton);
    WetCloth& upper = rig.cover(rig.add(std::move(above)), wool);
    for (WetCloth* const cloth : {&lower, &upper}) cloth->air().vapourExchange = 0;
    rig.run(1);
    upper.soakPores(0.9 * wool.poreCapacity());
    const double before = upper.waterMass();
    rig.run(60);
    // Cotton has the finer pores, and more of them: it draws nearly all of the wool's water.
    EXPECT_LT(upper.waterMass(), 0.5 * before);
    EXPECT_NEAR((upper.waterMass() + lower.waterMass() + upper.ledger().dripped) / before, 1, 1e-6);
    expectClosed(lower);
    expectClosed(upper);
}

struct Fold {
    explicit Fold(int nodes = 25) : nodes_(nodes) {
        rig.bullet().addGround(0);
        body = &rig.add(test::foldedSheet(rig.info(), 0.5, nodes));
        SheetSettings settings;
        settings.materialCoordinates = test::levelCoordinates(0.5, nodes);
        cloth = &rig.cover(*body, fabrics::cottonPlain(), settings);
        cloth->air().vapourExchange = 0;
        rig.run(2);
    }
    // Columns of the upper layer, away from the fold and the free end, and those that lie under them.
    bool isUpper(int node) const { return isUpperColumn(node % nodes_); }
    bool isLower(int node) const { return isUpperColumn(nodes_ + 1 - node % nodes_); }
    double mean(bool upper) const {
        double sum = 0;
        int count = 0;
        for (int n = 0; n < body->m_nodes.size(); ++n)
            if (upper ? isUpper(n) : isLower(n)) {
                sum += cloth->saturation(n);
                ++count;
            }
        return sum / count;
    }

    test::SmallStepWorld rig;
    btSoftBody* body;
    WetCloth* cloth;

  private:
    bool isUpperColumn(int column) const { return column > nodes_ / 2 + 5 && column < nodes_ - 2; }
    int nodes_;
};

TEST(ClothLayers, AFoldedSheetWetsItsOtherHalf) {
    Fold fold;
    const Fabric cotton = fabrics::cottonPlain();
    for (int n = 0; n < fold.body->m_nodes.size(); ++n)
        if (fold.isUpper(n))
            fold.cloth->account("poured").addPores(
                static_cast<std::size_t>(n),
                0.8 * cotton.poreCapacity() * fold.cloth->moisture().area(static_cast<std::size_t>(n)));
    const double before = fold.cloth->waterMass();
    fold.rig.run(30);
    std::printf("  upper half %.3f, lower half %.3f\n", fold.mean(true), fold.mean(false));
    EXPECT_NEAR(fold.mean(false) / fold.mean(true), 1, 0.05);
    EXPECT_NEAR(fold.cloth->waterMass() / before, 1, 1e-9);
    expectClosed(*fold.cloth);
    EXPECT_EQ(accountOf(fold.cloth->ledger(), "touch"), nullptr) << "it stays in the sheet";
}

TEST(ClothLayers, WhatIsCoveredDoesNotDry) {
    Pile pile(3, 9);
    pile.rig().run(1);
    for (const int layer : {0, 1, 2}) {
        pile[layer].soakPores(0.5 * fabrics::cottonPlain().poreCapacity());
        pile[layer].air().vapourExchange = 1;
        pile[layer].air().wind = {1, 0, 0};
    }
    pile.rig().run(20);
    const double top = pile[2].ledger().evaporated, middle = pile[1].ledger().evaporated,
                 bottom = pile[0].ledger().evaporated;
    std::printf("  evaporated: %.3g, %.3g, %.3g g from the top\n", 1e3 * top, 1e3 * middle, 1e3 * bottom);
    EXPECT_GT(top, 1e-5);
    EXPECT_LT(middle, 0.002 * top);
    EXPECT_LT(bottom, 0.002 * top);
}

TEST(ClothLayers, RainAndSprayWetTheUpperLayerFirst) {
    for (const bool isSpray : {false, true}) {
        Pile pile(3, 9);
        pile.rig().run(1);
        for (const int layer : {0, 1, 2}) {
            if (isSpray)
                pile[layer].add(Spray({0, 1, 0}, {0, -1, 0}, 0.002)).halfAngle = 0.5;
            else
                pile[layer].add(Rain(100));
        }
        pile.rig().run(1);
        const auto caught = [&](int layer) {
            return accountOf(pile[layer].ledger(), isSpray ? "spray" : "rain")->supplied;
        };
        std::printf("  %s: %.3g g on the top, %.3g and %.3g g below\n", isSpray ? "spray" : "rain",
                    1e3 * caught(2), 1e3 * caught(1), 1e3 * caught(0));
        if (!isSpray) {
            EXPECT_NEAR(caught(2), 100.0 / 3600 * 0.09, 0.1 * 100.0 / 3600 * 0.09);
        }
        EXPECT_LT(caught(1), 0.01 * caught(2));
        EXPECT_LT(caught(0), 0.01 * caught(2));
        EXPECT_GT(pile[2].moisture().meanSaturation(), 2 * pile[1].moisture().meanSaturation());
    }
}

TEST(ClothLayers, RainOnAFoldedSheetFallsOnItsUpperHalf) {
    Fold fold;
    fold.cloth->add(Rain(60));
    fold.rig.run(2);
    EXPECT_GT(fold.mean(true), 20 * fold.mean(false));
}

double areaOf(const WetCloth& cloth) {
    return cloth.dryMass() / cloth.fabric().arealDensity;
}

void expectKept(const char* what, const WetCloth& cloth, double pressure) {
    const double law = cloth.fabric().poreCapacityUnder(pressure);
    const double kept = cloth.moisture().totalPoreMass() / areaOf(cloth);
    std::printf("  %s under %.1f Pa: %.1f g/m2, law %.1f g/m2\n", what, pressure, 1e3 * kept, 1e3 * law);
    EXPECT_NEAR(kept / law, 1, 0.05) << what << ", " << pressure << " Pa";
    EXPECT_LT(law, 0.95 * cloth.fabric().poreCapacity()) << "nothing is pressed out";
    expectClosed(cloth);
}

TEST(ClothLayers, ClothUnderAPlateKeepsWhatCapillarityHolds) {
    for (const double mass : {15.0, 18.0, 22.0}) {
        const Fabric cotton = fabrics::cottonPlain();
        SmallStepSettings steps;
        steps.count = 20;  // cloth carries a thousand times its mass only in short steps
        Pile pile(
            1, 13, [&](int) { return cotton; }, steps);
        const double margin = double(pile.body(0).getCollisionShape()->getMargin());
        btRigidBody& plate = pile.rig().bullet().addBox({0, btScalar(2 * margin + 0.0101), 0},
                                                        {btScalar(0.2), btScalar(0.01), btScalar(0.2)},
                                                        btQuaternion::getIdentity(), mass);
        plate.setAngularFactor(btScalar(0));
        plate.setIgnoreCollisionCheck(&pile.ground(), true);
        pile[0].soakPores(cotton.poreCapacity());
        pile.rig().run(10);
        expectKept("cloth", pile[0], mass * 9.81 / areaOf(pile[0]));
    }
}

TEST(ClothLayers, LayersUnderLayersKeepWhatCapillarityHolds) {
    Fabric cloth = fabrics::cottonPlain();
    cloth.entryPressure = 4;  // so that the weight of a few layers counts
    Pile pile(3, 13, [&](int) { return cloth; });
    for (const int layer : {0, 1, 2}) pile[layer].soakPores(cloth.poreCapacity());
    pile.rig().run(20);
    double weight = 0;
    for (const int layer : {2, 1, 0}) {
        weight += 9.81 * (pile[layer].dryMass() + pile[layer].waterMass());
        const double pressure = weight / areaOf(pile[layer]);
        if (pressure > 1.5 * cloth.entryPressure)
            expectKept(layer == 0 ? "lowest layer" : "layer in between", pile[layer], pressure);
    }
    EXPECT_GT(pile[2].moisture().totalFilmMass(),
              0.9 * (pile[2].moisture().totalFilmMass() + pile[1].moisture().totalFilmMass() +
                     pile[0].moisture().totalFilmMass()))
        << "it comes out on the outer face";
}

TEST(ClothLayers, ASheetThatTouchesNothingIsAsWithoutLayers) {
    const auto waterOf = [](bool meetsItself) {
        test::SmallStepWorld rig;
        btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17));
        SheetSettings settings;
        settings.meetsItself = meetsItself;
        WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain(), settings);
        cloth.soakFilm(0.3);
        cloth.add(Rain(50));
        rig.run(3);
        return cloth.moisture().poreMass();
    };
    EXPECT_EQ(waterOf(true), waterOf(false));
}

// Of two runs, and of one that goes on from a snapshot.
TEST(ClothLayers, AreTheSameAgainBitByBit) {
    const auto prepare = [](Fold& fold) {
        fold.cloth->soakPores(0.05);
        for (int n = 0; n < fold.body->m_nodes.size(); ++n)
            if (fold.isUpper(n)) fold.cloth->addWater(n, 5e-5);
    };
    Fold one(17), two(17);
    prepare(one);
    prepare(two);
    one.rig.run(1);
    two.rig.run(1);
    ASSERT_EQ(one.cloth->snapshot().hash(), two.cloth->snapshot().hash());
    const Snapshot between = one.cloth->snapshot();
    one.rig.run(1);
    const auto after = one.cloth->snapshot().hash();
    two.rig.run(0.2);
    two.cloth->restore(between);
    EXPECT_EQ(two.cloth->snapshot().hash(), between.hash());
    two.rig.run(1);
    EXPECT_EQ(two.cloth->snapshot().hash(), after);
}

TEST(ClothLayers, ASheetMayGoWhileAnotherLiesOnIt) {
    Pile pile(2, 9);
    pile.rig().run(1);
    pile[0].soakPores(0.1);
    pile.rig().run(0.5);
    pile.rig().world().removeSoftBody(&pile.body(0));
    const double left = pile[1].waterMass();
    pile.rig().run(1);
    EXPECT_NEAR(pile[1].waterMass() + pile[1].ledger().dripped, left, 1e-9);
    pile.rig().world().addSoftBody(&pile.body(0));
    pile.rig().run(0.1);
}

}  // namespace
}  // namespace drench::cloth_layers_test
