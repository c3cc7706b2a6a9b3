// What goes wrong while a world runs: it is mended and reported, or thrown, and Bullet never sees it.
#include <limits>

#include "bullet/world/any_world.h"

namespace drench::health_test {
namespace {

using test::AnyWorld;
using test::Mover;
using test::reportOf;

constexpr auto nan = std::numeric_limits<btScalar>::quiet_NaN();
constexpr auto infinite = std::numeric_limits<btScalar>::infinity();

// Something that goes wrong between two substeps, and what Drench calls it.
struct Mishap {
    const char* name;
    Trouble trouble;
    int node;
    std::function<void(AnyWorld&)> happen;
    std::function<void(AnyWorld&)> repair;  // what the application would do about it
};

class WrongWind final : public WindField {
  public:
    Eigen::Vector3d velocity(const Eigen::Vector3d&, double) const override { return {std::nan(""), 0, 0}; }
    double length() const override { return 1; }
};

class WrongSource final : public Source {
  public:
    std::string name() const override { return "wrong"; }
    void supply(const SheetPose&, double dt, Supply& supply) override {
        if (dt == 0) return;
        supply.addFilm(3, 1e-4);
        supply.addFilm(4, std::nan(""));
    }
};

std::vector<Mishap> mishaps() {
    const auto nothing = [](AnyWorld&) {};
    const auto node = [](AnyWorld& rig, int n) -> btSoftBody::Node& { return rig.sheet().m_nodes[n]; };
    const auto setting = [&](const char* name, btScalar btSoftBody::Config::*member, btScalar value) {
        return Mishap{name, Trouble::bodySetting, -1,
                      [=](AnyWorld& rig) { rig.sheet().m_cfg.*member = value; }, nothing};
    };
    using Config = btSoftBody::Config;
    return {
        {"place", Trouble::position, 40, [=](AnyWorld& rig) { node(rig, 40).m_x.setY(nan); }, nothing},
        {"far", Trouble::position, 41, [=](AnyWorld& rig) { node(rig, 41).m_x.setZ(btScalar(-1e12)); },
         nothing},
        {"pin", Trouble::position, 3, [=](AnyWorld& rig) { node(rig, 3).m_x.setX(infinite); }, nothing},
        {"first", Trouble::position, 0, [=](AnyWorld& rig) { node(rig, 0).m_x.setX(nan); }, nothing},
        {"velocity", Trouble::velocity, 42, [=](AnyWorld& rig) { node(rig, 42).m_v.setX(nan); }, nothing},
        {"fast", Trouble::velocity, 43, [=](AnyWorld& rig) { node(rig, 43).m_v.setX(btScalar(1e20)); },
         nothing},
        {"force", Trouble::force, 44, [=](AnyWorld& rig) { node(rig, 44).m_f.setZ(-infinite); }, nothing},
        {"mass", Trouble::mass, 45, [=](AnyWorld& rig) { node(rig, 45).m_im = nan; }, nothing},
        {"negative", Trouble::mass, 46, [=](AnyWorld& rig) { node(rig, 46).m_im = -5; }, nothing},
        {"none", Trouble::mass, 47, [=](AnyWorld& rig) { node(rig, 47).m_im = infinite; }, nothing},
        {"gravity", Trouble::gravity, -1, [](AnyWorld& rig) { rig.info().m_gravity.setX(nan); }, nothing},
        {"none of it", Trouble::gravity, -1, [](AnyWorld& rig) { rig.info().m_gravity.setValue(0, nan, 0); },
         nothing},
        {"heavy", Trouble::gravity, -1, [](AnyWorld& rig) { rig.info().m_gravity.setY(btScalar(-1e6)); },
         nothing},
        setting("damping", &Config::kDP, nan),
        setting("drag", &Config::drag, infinite),
        setting("pressure", &Config::kPR, nan),
        setting("friction", &Config::kDF, nan),
        setting("pause", &Config::timescale, 0),
        setting("backwards", &Config::timescale, -1),
        {"scale", Trouble::bodySetting, -1, [](AnyWorld& rig) { rig.sheet().setRestLengthScale(nan); },
         nothing},
        {"wind", Trouble::air, -1, [](AnyWorld& rig) { rig.cloth().air().wind.setConstant(std::nan("")); },
         [](AnyWorld& rig) { rig.cloth().air().wind.setZero(); }},
        {"storm", Trouble::air, -1, [](AnyWorld& rig) { rig.cloth().air().wind.setConstant(1e6); },
         [](AnyWorld& rig) { rig.cloth().air().wind.setZero(); }},
        {"warm", Trouble::air, -1, [](AnyWorld& rig) { rig.cloth().air().temperature = 1e9; },
         [](AnyWorld& rig) { rig.cloth().air().temperature = 20; }},
        {"field", Trouble::air, -1,
         [](AnyWorld& rig) { rig.cloth().air().field = std::make_shared<WrongWind>(); },
         [](AnyWorld& rig) { rig.cloth().air().field = nullptr; }},
    };
}

TEST(Health, WhatGoesWrongIsMendedAndReportedOnce) {
    for (const Mover mover : test::movers)
        for (const Mishap& mishap : mishaps()) {
            SCOPED_TRACE(std::string(test::nameOf(mover)) + ", " + mishap.name);
            AnyWorld rig(mover);
            rig.cloth().soakFilm(0.1);
            rig.run(6);
            mishap.happen(rig);
            rig.run(1);
            EXPECT_TRUE(rig.cloth().health().finite);
            EXPECT_EQ(rig.cloth().health().troubles, 1);
            mishap.repair(rig);
            rig.run(6);
            const TroubleReport report = reportOf(rig.cloth(), mishap.trouble);
            EXPECT_EQ(report.node, mishap.node);
            EXPECT_EQ(report.substeps, 1);
            EXPECT_EQ(report.firstSubstep, 6);
            EXPECT_NEAR(report.since, 6 * rig.substep(), 1e-6);
            EXPECT_EQ(report.last, report.since);
            EXPECT_EQ(report.message.find("drench: "), std::string::npos);
            EXPECT_TRUE(rig.cloth().health().finite);
            EXPECT_LT(test::ledgerError(rig.cloth()), 1e-12);
            EXPECT_LT(test::fastest(rig.sheet()), 20);
            rig.cloth().clearTroubles();
            EXPECT_TRUE(rig.cloth().troubles().empty());
        }
}

TEST(Health, AnApplicationMayHaveItThrownWithNothingChanged) {
    SheetSettings settings = test::throwing();
    for (const Mover mover : test::movers)
        for (const Mishap& mishap : mishaps()) {
            SCOPED_TRACE(std::string(test::nameOf(mover)) + ", " + mishap.name);
            AnyWorld rig(mover, settings);
            rig.cloth().soakFilm(0.1);
            rig.run(2);
            const double pores = rig.cloth().moisture().totalPoreMass();
            mishap.happen(rig);
            const btVector3 position = rig.sheet().m_nodes[60].m_x;
            EXPECT_ANY_THROW(rig.run(1));
            EXPECT_EQ(rig.cloth().moisture().totalPoreMass(), pores);
            EXPECT_EQ(rig.sheet().m_nodes[60].m_x, position);
            EXPECT_TRUE(rig.cloth().troubles().empty());
        }
}

TEST(Health, ANodeThatIsLostComesBackToItsPlaceAtRest) {
    for (const Mover mover : test::movers) {
        AnyWorld rig(mover);
        rig.sheet().translate({1000, 0, 0});
        rig.run(10);
        const btVector3 position = rig.sheet().m_nodes[80].m_x;
        rig.sheet().m_nodes[80].m_x.setValue(nan, nan, nan);
        rig.sheet().m_nodes[80].m_v.setValue(nan, nan, nan);
        rig.run(1);
        EXPECT_LT(double((rig.sheet().m_nodes[80].m_x - position).length()), 0.02) << test::nameOf(mover);
        EXPECT_EQ(rig.cloth().troubles().size(), 1u);
    }
}

TEST(Health, AWholeSheetThatIsLostComesBack) {
    for (const Mover mover : test::movers) {
        AnyWorld rig(mover);
        rig.cloth().soakFilm(0.2);
        rig.run(30);
        for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) rig.sheet().m_nodes[n].m_x.setValue(nan, 0, nan);
        rig.run(60);
        EXPECT_TRUE(rig.cloth().health().finite) << test::nameOf(mover);
        EXPECT_LT(rig.cloth().health().largestStrain, 0.5) << test::nameOf(mover);
        EXPECT_LT(test::ledgerError(rig.cloth()), 1e-12);
        EXPECT_EQ(reportOf(rig.cloth(), Trouble::position).node, 0);
        EXPECT_EQ(reportOf(rig.cloth(), Trouble::position).substeps, 1);
    }
}

TEST(Health, TroubleThatLastsIsOneReport) {
    AnyWorld rig(Mover::smallSteps);
    for (int i = 0; i < 20; ++i) {
        rig.sheet().m_nodes[30 + i].m_f.setX(nan);
        rig.run(1);
    }
    ASSERT_EQ(rig.cloth().troubles().size(), 1u);
    const TroubleReport report = rig.cloth().troubles()[0];
    EXPECT_EQ(report.substeps, 20);
    EXPECT_EQ(report.firstSubstep, 0);
    EXPECT_EQ(report.lastSubstep, 19);
    EXPECT_EQ(report.node, 49);
    EXPECT_TRUE(std::isnan(report.value));
    EXPECT_NEAR(report.last, 19.0 / 60, 1e-6);
    EXPECT_NE(report.message.find("node 49"), std::string::npos) << report.message;
}

TEST(Health, ASourceThatThrowsBringsWhatItBroughtBefore) {
    for (const Mover mover : test::movers) {
        AnyWorld rig(mover);
        rig.cloth().air().vapourExchange = 0;
        rig.cloth().add(WrongSource());
        rig.cloth().add(TimedSoak({7}, 1e-3));
        rig.run(10);
        EXPECT_NEAR(rig.cloth().ledger().supplied, 10e-4 + 1e-3, 1e-12) << "the other sources go on";
        EXPECT_LT(test::ledgerError(rig.cloth()), 1e-12);
        const TroubleReport report = reportOf(rig.cloth(), Trouble::source);
        EXPECT_EQ(report.substeps, 10);
        EXPECT_NE(report.message.find("\"wrong\""), std::string::npos) << report.message;
    }
}

TEST(Health, ASubstepThatComesToNothingIsHeldAndReported) {
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;
    AnyWorld rig(Mover::smallSteps, settings);
    rig.cloth().preSubstep(btScalar(1.0 / 60));
    rig.sheet().m_nodes[50].m_v.setX(btScalar(1e38));  // after the checks
    rig.run(1);
    EXPECT_TRUE(rig.cloth().health().finite);
    EXPECT_EQ(rig.cloth().health().heldSubsteps, 1);
    for (int i = 0; i < 3; ++i) {
        rig.cloth().preSubstep(btScalar(1.0 / 60));
        rig.run(1);
    }
    const TroubleReport report = reportOf(rig.cloth(), Trouble::motion);
    EXPECT_EQ(report.substeps, 1);
    EXPECT_EQ(report.firstSubstep, 1);
    EXPECT_GE(report.node, 0);
    EXPECT_EQ(rig.cloth().troubles().size(), 1u);
}

TEST(Health, AHealthySheetHasNoTroubles) {
    for (const Mover mover : test::movers) {
        AnyWorld rig(mover);
        rig.cloth().soakFilm(0.2);
        rig.cloth().air().wind = {0, 0, 5};
        rig.run(60);
        EXPECT_TRUE(rig.cloth().troubles().empty())
            << test::nameOf(mover) << rig.cloth().troubles()[0].message;
        EXPECT_EQ(rig.cloth().health().troubles, 0);
        EXPECT_TRUE(rig.cloth().health().fits);
    }
}

}  // namespace
}  // namespace drench::health_test
