// What is said of settings of sheets and solvers that are off, and of wind fields that throw.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "bullet/world/any_world.h"

namespace drench::messages_test {
namespace {

using test::AnyWorld;
using test::Mover;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Value {
    double value;
    const char* text;
};
const Value wrong[] = {{-1e-7, "-1e-7"},       {-1, "-1"},
                       {1e300, "1e300"},       {std::nan(""), "NaN"},
                       {infinite, "infinity"}, {-infinite, "-infinity"}};

std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    ADD_FAILURE() << "not refused";
    return "";
}

TEST(Messages, SettingsOfSheetsSayTheValueAndWhatToGive) {
    AnyWorld rig(Mover::smallSteps);
    rig.cloth().soakFilm(0.1);
    rig.run(2);
    rig.clothOwner().reset();
    for (const Value& each : wrong) {
        const btScalar inverseMass = rig.sheet().m_nodes[40].m_im;
        SheetSettings settings;
        settings.waterSpeed = each.value;
        EXPECT_EQ(refusal([&] { WetCloth(rig.world(), rig.sheet(), fabrics::cottonPlain(), settings); }),
                  std::string("drench: SheetSettings::waterSpeed is ") + each.text +
                      "; give a value from 0 to 100000");
        EXPECT_EQ(rig.sheet().m_nodes[40].m_im, inverseMass);
    }
}

TEST(Messages, SettersOfSheetsChangeNothing) {
    AnyWorld rig(Mover::stock);
    rig.cloth().soakFilm(0.1);
    const double pores = rig.cloth().moisture().totalPoreMass();
    for (const Value& each : wrong) {
        EXPECT_EQ(refusal([&] { rig.cloth().setWaterSpeed(each.value); }),
                  std::string("drench: the water speed is ") + each.text + "; give a value from 0 to 100000");
        EXPECT_EQ(refusal([&] { rig.cloth().soakFilm(each.value); }),
                  std::string("drench: soaking with ") + each.text + " kg/m2; give a value from 0 to 1000");
        EXPECT_EQ(rig.cloth().moisture().totalPoreMass(), pores);
    }
}

TEST(Messages, SettingsOfSmallSteps) {
    const auto refusalOf = [](int count, double tolerance) {
        SmallStepSettings settings;
        settings.count = count;
        settings.stretchTolerance = tolerance;
        return refusal([&] { SmallStepSolver solver(settings); });
    };
    for (const Value& each : wrong)
        EXPECT_EQ(refusalOf(0, each.value), std::string("drench: SmallStepSettings::stretchTolerance is ") +
                                                each.text + "; give 1e-5 to 1");
    EXPECT_EQ(refusalOf(0, 1e-7), "drench: SmallStepSettings::stretchTolerance is 1e-7; give 1e-5 to 1");
    EXPECT_EQ(refusalOf(-3, 0.01),
              "drench: SmallStepSettings::count is -3; give 1 to 1000, or 0 to have it chosen");
}

TEST(Messages, WaterOfSheetsAndDrops) {
    AnyWorld rig(Mover::stock);
    rig.cloth().soakFilm(0.1);
    const double water = rig.cloth().waterMass();
    FallingDrops drops(rig.world());
    btCollisionObject tray;
    for (const Value& each : wrong) {
        EXPECT_EQ(
            refusal([&] { rig.cloth().addWater(40, each.value); }),
            std::string("drench: ") + each.text + " kg of water for node 40; give a mass from 0 to 1e6 kg");
        WetBody wet(tray);
        wet.filmThickness = each.value;
        EXPECT_EQ(refusal([&] { rig.cloth().add(wet); }), std::string("drench: WetBody::filmThickness is ") +
                                                              each.text + " m; give a value from 0 to 0.01");
        Surface slippery = {0, 0, 0};
        slippery.frictionDamp = each.value;
        EXPECT_EQ(
            refusal([&] { rig.cloth().setSurface(tray, slippery); }),
            std::string("drench: Surface::frictionDamp is ") + each.text + "; give a value from 0 to 5");
        if (each.value < 1e300 || each.value > 1e300 ||
            std::isnan(each.value)) {  // 1e300 s is long, and allowed
            EXPECT_EQ(refusal([&] { drops.step(each.value); }),
                      std::string("drench: drops cannot fall for ") + each.text +
                          " s; give a finite time of at least 0 s");
        }
    }
    EXPECT_EQ(
        refusal([&] {
            rig.cloth().addWater(40, 1e-3, {btScalar(2e6), 0, 0});
        }),
        "drench: water for node 40 has a velocity of (2e6, 0, 0) m/s; give finite numbers from -1e6 to 1e6");
    EXPECT_EQ(rig.cloth().waterMass(), water);
}

TEST(Messages, BodiesOfNumbersThatAreNotFinite) {
    demo::BulletWorld bullet;
    const auto sheet = test::smallSheet(bullet.worldInfo());
    sheet->m_nodes[7].m_x.setValue(btScalar(0.1), std::numeric_limits<btScalar>::quiet_NaN(), 0);
    EXPECT_EQ(refusal([&] { WetCloth(bullet.world(), *sheet, fabrics::cottonPlain()); }),
              "drench: WetCloth: node 7 is at (0.1, NaN, 0) m, with a velocity of (0, 0, 0) m/s; give finite "
              "numbers "
              "before attaching");
}

class ThrowingWind final : public WindField {
  public:
    Eigen::Vector3d velocity(const Eigen::Vector3d&, double) const override {
        throw std::runtime_error("out of balloons");
    }
    double length() const override { return 1; }
};

class EndlessWind final : public WindField {
  public:
    Eigen::Vector3d velocity(const Eigen::Vector3d&, double) const override { return {0, infinite, 1e-7}; }
    double length() const override { return infinite; }
};

TEST(Messages, TroubleOfAWindFieldNamesIt) {
    AnyWorld rig(Mover::stock);
    rig.cloth().air().field = std::make_shared<ThrowingWind>();
    rig.run(1);
    ASSERT_EQ(rig.cloth().troubles().size(), 1u);
    EXPECT_EQ(rig.cloth().troubles()[0].what, Trouble::air);
    EXPECT_EQ(rig.cloth().troubles()[0].message, "the wind field in WetCloth::air().field: out of balloons");

    rig.cloth().clearTroubles();
    rig.cloth().air().field = std::make_shared<EndlessWind>();
    rig.run(1);
    ASSERT_EQ(rig.cloth().troubles().size(), 1u);
    const std::string message = rig.cloth().troubles()[0].message;
    EXPECT_EQ(
        message.rfind(
            "the wind field in WetCloth::air().field has a velocity of (0, infinity, 1e-7) m/s at (", 0),
        0u)
        << message;
}

class ThrowingSource final : public Source {
  public:
    std::string name() const override { return "tap"; }
    void supply(const SheetPose&, double dt, Supply&) override {
        if (dt > 0) throw std::runtime_error("drench: the tap is stuck");
    }
};

TEST(Messages, TroubleOfASourceNamesItWithoutThePrefix) {
    AnyWorld rig(Mover::stock);
    rig.cloth().add(std::make_unique<ThrowingSource>());
    rig.run(1);
    ASSERT_EQ(rig.cloth().troubles().size(), 1u);
    EXPECT_EQ(rig.cloth().troubles()[0].message, "the source \"tap\": the tap is stuck");
}

}  // namespace
}  // namespace drench::messages_test
