// Water speed that changes on the way, and the times that steps take.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bullet/world/worlds.h"

namespace drench::step_times_test {
namespace {

using test::SheetWorld;

TEST(WaterSpeed, ChangesOnTheWay) {
    SheetWorld slow(test::smallSheet), changed(test::smallSheet);
    WetCloth slowCloth(slow.world(), slow.sheet(), fabrics::cottonPlain());
    WetCloth changedCloth(changed.world(), changed.sheet(), fabrics::cottonPlain());
    EXPECT_EQ(changedCloth.waterSpeed(), 1);
    for (WetCloth* const cloth : {&slowCloth, &changedCloth}) cloth->soakFilm(1);
    slow.bullet().step(1.0, 240);
    changedCloth.setWaterSpeed(10);
    EXPECT_EQ(changedCloth.waterSpeed(), 10);
    changed.bullet().step(0.1, 24);
    EXPECT_NEAR(changedCloth.saturation(100), slowCloth.saturation(100), 1e-5);

    changedCloth.setWaterSpeed(0);
    const double before = changedCloth.saturation(100);
    changed.bullet().step(0.1, 24);
    EXPECT_EQ(changedCloth.saturation(100), before);
}

TEST(WaterSpeed, RefusesWhatTheSettingRefuses) {
    SheetWorld rig(test::smallSheet);
    WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
    for (const double speed : {-1.0, 2e5, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(cloth.setWaterSpeed(speed), std::invalid_argument) << speed;
    EXPECT_EQ(cloth.waterSpeed(), 1);
}

// What a spray that brings the same water gives the sheet in a step, kg m/s, at a speed that is set after it was added.
double pushAtSpeed(double speed) {
    test::FreeSheet rig(fabrics::cottonPlain());
    rig.cloth().add(Spray({0.5, 1, 0.5}, {0, -1, 0}, 0.1 / speed));
    rig.cloth().setWaterSpeed(speed);
    rig.cloth().preSubstep(btScalar(1.0 / 60));
    return double(test::momentum(rig.sheet()).y());
}

TEST(WaterSpeed, SourcesThatAreThereAlreadyPushByTheBodysOwnTime) {
    const double usual = pushAtSpeed(1);
    EXPECT_LT(usual, -1e-4);
    EXPECT_NEAR(pushAtSpeed(10), usual / 10, 0.05 * std::abs(usual / 10));
}

TEST(StepTimes, AddUpToWhatTheStepsTake) {
    SheetWorld rig(test::smallSheet);
    WetCloth cloth(rig.world(), rig.sheet(), fabrics::cottonPlain());
    cloth.soakFilm(0.5);
    EXPECT_EQ(cloth.times().substeps, 0);
    const auto before = std::chrono::steady_clock::now();
    rig.bullet().step(1.0, 60);
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    const StepTimes times = cloth.times();
    EXPECT_EQ(times.substeps, 60);
    const double sum = times.supply + times.water + times.laws + times.air + times.contacts + times.solver;
    for (const double stage : {times.supply, times.water, times.laws, times.air, times.contacts})
        EXPECT_GE(stage, 0);
    EXPECT_GT(times.water, 0);
    EXPECT_GT(times.laws, 0);
    EXPECT_LE(sum, took);
}

TEST(StepTimes, HaveSmallStepsAndTheirContacts) {
    test::SmallStepWorld rig;
    rig.bullet().addGround(-0.05);
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17, 0));
    const WetCloth& cloth = rig.cover(sheet, fabrics::cottonPlain());
    rig.run(0.5);
    SheetWorld stock(test::smallSheet);
    const WetCloth stockCloth(stock.world(), stock.sheet(), fabrics::cottonPlain());
    stock.bullet().step(0.1, 10);
    const StepTimes times = cloth.times();
    EXPECT_EQ(times.substeps, 30);
    EXPECT_GT(times.clothContacts, 0) << "it may meet itself";
    EXPECT_GT(times.contacts, times.clothContacts);
    EXPECT_GT(times.solver, 0);
    EXPECT_EQ(stockCloth.times().clothContacts, 0);
    EXPECT_EQ(stockCloth.times().solver, 0) << "which only small steps have";
}

}  // namespace
}  // namespace drench::step_times_test
