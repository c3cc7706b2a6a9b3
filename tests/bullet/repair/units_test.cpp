// Worlds that are not in metres are recognised, and worlds that are only unusual are not.
#include "bullet/repair/units.h"

#include "bullet/world/any_world.h"

namespace drench::units_test {
namespace {

using test::SmallStepWorld;

// Reports of a sheet of that length after a few substeps under that gravity.
std::vector<TroubleReport> reportsOf(double length, double gravity, int nodes = 9,
                                     const SheetSettings& settings = {}) {
    SmallStepWorld rig;
    rig.setGravity({0, btScalar(-gravity), 0});
    const btScalar voxel = btScalar(length / nodes / 2);
    rig.info().m_sparsesdf.setDefaultVoxelsz(voxel);
    rig.info().m_sparsesdf.Reset();
    btSoftBody& body = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), length, nodes));
    body.getCollisionShape()->setMargin(voxel);
    WetCloth& cloth = rig.cover(body, fabrics::cottonPlain(), settings);
    rig.run(0.05);
    return cloth.troubles();
}

void expectReport(double length, double gravity, std::initializer_list<const char*> parts, int nodes = 9) {
    SCOPED_TRACE(testing::Message() << length << " m, " << gravity << " m/s2");
    const auto reports = reportsOf(length, gravity, nodes);
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_EQ(reports[0].what, Trouble::units);
    EXPECT_EQ(reports[0].substeps, 1) << "reported once";
    EXPECT_EQ(reports[0].firstSubstep, 0);
    for (const char* part : parts)
        EXPECT_NE(reports[0].message.find(part), std::string::npos) << part << ": " << reports[0].message;
}

TEST(Units, ACentimetreWorldIsReportedWithItsValues) {
    expectReport(100, 981,
                 {"100 x 100 m", "1500 kg", "981 m/s2", "looks like centimetres", "by 0.01", "9.81"});
    expectReport(30, 980, {"30 x 30 m", "centimetres"});
    expectReport(0.5, 981, {"centimetres"});
    expectReport(100, 9.81, {"100 x 100 m", "centimetres or millimetres"});
}

TEST(Units, MillimetresAndOtherUnitsAreReported) {
    expectReport(1000, 9810, {"1000 x 1000 m", "looks like millimetres", "by 0.001"});
    expectReport(10, 98.1, {"tenths of a metre", "by 0.1"});
    expectReport(3, 32.2, {"feet", "by 0.3048"});
    expectReport(40, 386, {"inches", "by 0.0254"});
}

TEST(Units, AWorldOfReducedScaleIsReported) {
    expectReport(0.1, 0.981, {"units of 10 m", "0.1 x 0.1 m", "by 10"});
    expectReport(0.1, 0.98, {"units of 10 m"});
    expectReport(0.01, 0.0981, {"units of 100 m"});
    expectReport(0.005, 9.81, {"reduced scale"});
    EXPECT_NE(wrongUnit({{0.02, 0.02}, 0.5e-4, 6e-5, 9.81}).find("reduced scale"), std::string::npos);
}

TEST(Units, AGravityBeyondAllPlanetsIsReported) {
    expectReport(1, 274, {"274 m/s2", "another unit"});
}

TEST(Units, WhatIsOnlyUnusualIsNot) {
    constexpr double doll = 0.03, tent = 40;
    for (const double length : {0.01, 50.0}) EXPECT_TRUE(reportsOf(length, 9.81).empty()) << length;
    for (const double length : {doll, 0.5, 2.0, tent})
        for (const double gravity : {0.0, 1e-6, 0.1, 0.28, 0.62, 1.0, 1.31, 1.62, 3.72, 8.87, 9.8, 9.81, 10.0,
                                     19.6, 24.8, 29.4, 49.0})
            EXPECT_TRUE(reportsOf(length, gravity).empty()) << length << " m, " << gravity << " m/s2";
    EXPECT_TRUE(reportsOf(doll, 9.81, 65).empty());
    EXPECT_TRUE(reportsOf(tent, 9.81, 5).empty()) << "ten metres a link";
}

TEST(Units, WhatIsMeantIsNot) {
    SheetSettings settings = test::throwing();
    settings.unusualScale = true;
    EXPECT_TRUE(reportsOf(80, 9.81, 9, settings).empty()) << "the roof of a stadium";
    EXPECT_TRUE(reportsOf(0.5, 0.981, 9, settings).empty()) << "a tenth of a g";
}

TEST(Units, WrongOnesAreThrownUntilTheyAreMended) {
    SmallStepWorld rig;
    rig.setGravity({0, -981, 0});
    btSoftBody& body = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 9));
    const WetCloth& cloth = rig.cover(body, fabrics::cottonPlain(), test::throwing());
    for (int i = 0; i < 2; ++i) EXPECT_THROW(rig.run(1.0 / 60), std::runtime_error);
    rig.world().clearForces();
    rig.setGravity({0, btScalar(-9.81), 0});
    EXPECT_NO_THROW(rig.run(1.0 / 60));
    EXPECT_TRUE(cloth.troubles().empty());
}

TEST(Units, GravityThatGrowsLaterIsNot) {
    SmallStepWorld rig;
    btSoftBody& body = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 9));
    const WetCloth& cloth = rig.cover(body, fabrics::cottonPlain());
    for (const double g : {9.81, 32.2, 98.1, 200.0}) {
        rig.setGravity({0, btScalar(-g), 0});
        rig.run(1.0 / 60);
    }
    EXPECT_TRUE(cloth.troubles().empty());
}

}  // namespace
}  // namespace drench::units_test
