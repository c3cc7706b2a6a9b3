// What may happen to sheets and other bodies in a world with a SmallStepSolver while it runs.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>

#include "bullet/world/worlds.h"

namespace drench::small_step_lifetime_test {
namespace {

// Soft bodies of all kinds that Drench does not move, falling on a ground and a ball, beside a sheet of its own.
class MixedWorld {
  public:
    explicit MixedWorld(btSoftBodySolver* solver) : bullet_(solver) {
        btSoftBodyWorldInfo& info = bullet_.world().getWorldInfo();
        info.m_sparsesdf.setDefaultVoxelsz(btScalar(0.02));
        info.m_sparsesdf.Reset();
        bullet_.addGround(0);
        bullet_.addBall({0, btScalar(0.3), 0}, 0.2, 0);
        bullet_.addBall({2, btScalar(1.2), 0}, 0.1, 0.3);
        addCloth(info);
        addVolumes(info);
        sheet_ = test::levelSheet(info, fabrics::cottonPlain(), 0.5, 13, 1);
        sheet_->translate({-6, 0, 0});
        bullet_.world().addSoftBody(sheet_.get());
        cloth_ = std::make_unique<WetCloth>(bullet_.world(), *sheet_, fabrics::cottonPlain());
    }
    ~MixedWorld() {
        cloth_.reset();
        bullet_.world().removeSoftBody(sheet_.get());
        posedCloth_.reset();
        for (const auto& body : bodies_) bullet_.world().removeSoftBody(body.get());
    }
    MixedWorld(const MixedWorld&) = delete;
    MixedWorld& operator=(const MixedWorld&) = delete;

    void run(int frames) {
        for (int i = 0; i < frames; ++i) bullet_.step(1.0 / 60, 1);
    }
    const std::vector<std::unique_ptr<btSoftBody>>& others() const { return bodies_; }
    const btSoftBody& sheet() const { return *sheet_; }

  private:
    btSoftBody& add(btSoftBody* body) {
        bodies_.emplace_back(body);
        bullet_.world().addSoftBody(body);
        return *body;
    }
    void addCloth(btSoftBodyWorldInfo& info) {
        add(test::patch(info).release()).m_cfg.piterations = 4;
        add(btSoftBodyHelpers::CreateRope(info, {2, 1, btScalar(-0.5)}, {2, 1, btScalar(0.5)}, 16, 1 + 2));
        // A sheet of Drench's with pose matching goes Bullet's way, too.
        btSoftBody& posed = add(test::levelSheet(info, fabrics::cottonPlain(), 0.4, 9, 0.8).release());
        posed.translate({4, 0, 0});
        posedCloth_ = std::make_unique<WetCloth>(bullet_.world(), posed, fabrics::cottonPlain());
        posed.setPose(false, true);
        posed.m_cfg.kMT = btScalar(0.05);
    }
    void addVolumes(btSoftBodyWorldInfo& info) {
        const btVector3 radii(btScalar(0.2), btScalar(0.2), btScalar(0.2));
        btSoftBody& balloon = add(btSoftBodyHelpers::CreateEllipsoid(info, {6, btScalar(0.6), 0}, radii, 64));
        balloon.m_cfg.kPR = 50;
        balloon.setTotalMass(btScalar(0.1), true);
        btSoftBody& posed = add(btSoftBodyHelpers::CreateEllipsoid(info, {8, btScalar(0.6), 0}, radii, 64));
        posed.setPose(true, false);
        posed.m_cfg.kVC = btScalar(0.5);
        btSoftBody& clustered =
            add(btSoftBodyHelpers::CreateEllipsoid(info, {10, btScalar(0.6), 0}, radii, 64));
        clustered.m_cfg.collisions = btSoftBody::fCollision::CL_RS | btSoftBody::fCollision::CL_SS;
        clustered.generateClusters(4);
    }

    demo::BulletWorld bullet_;
    std::vector<std::unique_ptr<btSoftBody>> bodies_;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> posedCloth_, cloth_;
};

TEST(SmallStepLifetime, BodiesThatAreNotDrenchsMoveBitForBitAsEver) {
    SmallStepSolver solver;
    MixedWorld stock(nullptr), small(&solver);
    stock.run(60);
    small.run(60);
    EXPECT_GT(solver.steps(), 0);
    ASSERT_EQ(stock.others().size(), 6u);
    for (std::size_t b = 0; b < stock.others().size(); ++b) {
        const btSoftBody &expected = *stock.others()[b], &found = *small.others()[b];
        for (int n = 0; n < expected.m_nodes.size(); ++n)
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_EQ(std::memcmp(&expected.m_nodes[n].m_x.m_floats[axis],
                                      &found.m_nodes[n].m_x.m_floats[axis], sizeof(btScalar)),
                          0)
                    << "body " << b << " node " << n;
                ASSERT_EQ(std::memcmp(&expected.m_nodes[n].m_v.m_floats[axis],
                                      &found.m_nodes[n].m_v.m_floats[axis], sizeof(btScalar)),
                          0)
                    << "body " << b << " node " << n;
            }
    }
    EXPECT_NE(0,
              std::memcmp(&stock.sheet().m_nodes[84].m_x, &small.sheet().m_nodes[84].m_x, sizeof(btVector3)));
}

// A soaked sheet that hangs gets a new, dry layer: its masses fall to less than half between two substeps.
struct Dried {
    double massRatio;      // wet over dry
    double fastest;        // m/s, ever after
    double before, after;  // the lowest point, m
    bool finite;
};

Dried dryAtOnce(int nodes, int count) {
    constexpr double dt = 1.0 / 30;
    test::SmallStepWorld rig({count, 0.01});
    btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, nodes));
    Dried result{};
    SheetSettings settings;
    {
        WetCloth soaked(rig.world(), sheet, fabrics::cottonPlain());
        soaked.soakFilm(0.35);
        rig.run(0.5, dt);
        settings.materialCoordinates = soaked.materialCoordinates();
        result.massRatio = test::mass(sheet);
    }
    result.before = test::lowest(sheet);
    const WetCloth dry(rig.world(), sheet, fabrics::cottonPlain(), settings);
    result.massRatio /= test::mass(sheet);
    for (int i = 0; i < 45; ++i) {
        rig.run(dt, dt);
        result.fastest = std::max(result.fastest, test::fastest(sheet));
    }
    result.after = test::lowest(sheet);
    result.finite = test::isFinite(sheet);
    return result;
}

TEST(SmallStepLifetime, TheApplicationsDenormalNumbersAreAsBefore) {
    test::SmallStepWorld rig;
    rig.cover(rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.3, 9, 0)),
              fabrics::cottonPlain());
    rig.run(0.1);
    volatile float denormal = std::numeric_limits<float>::min();
    denormal = denormal / 2;
    EXPECT_GT(denormal, 0);
}

TEST(SmallStepLifetime, DryingAtOnceDoesNotBlowUp) {
    for (const int count : {1, 4, 20}) {
        const Dried dried = dryAtOnce(17, count);
        EXPECT_GT(dried.massRatio, 2);
        EXPECT_TRUE(dried.finite);
        EXPECT_LT(dried.fastest, 5) << count << " steps";
        EXPECT_GT(dried.after, dried.before - 0.05) << count << " steps";
    }
    // A mesh as fine as that is like rubber in steps as long as these, and falls as far as that lets it.
    for (const int count : {1, 4}) {
        const Dried dried = dryAtOnce(64, count);
        EXPECT_TRUE(dried.finite);
        EXPECT_LT(dried.fastest, 15) << count << " steps";
    }
}

TEST(SmallStepLifetime, OneLongStepOfAFineSheetStaysFinite) {
    test::SmallStepWorld rig({1, 0.01});
    rig.bullet().addBall({0, btScalar(-0.5), 0}, 0.2, 0);
    btSoftBody& hanging = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 1, 64));
    btSoftBody& falling = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 1, 64, 0));
    rig.cover(hanging, fabrics::cottonPlain()).soakFilm(0.3);
    WetCloth& cloth = rig.cover(falling, fabrics::cottonPlain());
    cloth.air().wind = {10, 5, 3};
    rig.run(3, 1.0 / 30);
    EXPECT_TRUE(test::isFinite(hanging));
    EXPECT_TRUE(test::isFinite(falling));
    EXPECT_LT(test::fastest(hanging), 20);
}

TEST(SmallStepLifetime, PinsComeAndGo) {
    test::SmallStepWorld rig({20, 0.01});
    btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17));
    rig.cover(sheet, fabrics::cottonPlain());
    rig.run(0.5);
    for (int i = 0; i < 16; ++i) sheet.m_nodes[i].m_im = 1;  // the layer gives it its mass
    rig.run(1);
    EXPECT_LT(double(sheet.m_nodes[0].m_x.y()), -0.2);
    EXPECT_EQ(double(sheet.m_nodes[16].m_x.y()), 0);
    const btVector3 caught = sheet.m_nodes[0].m_x;
    sheet.m_nodes[0].m_im = 0;
    sheet.m_nodes[0].m_v.setZero();
    rig.run(1);
    EXPECT_EQ(caught, sheet.m_nodes[0].m_x);
    EXPECT_TRUE(test::isFinite(sheet));
    EXPECT_LT(test::fastest(sheet), 5);
}

TEST(SmallStepLifetime, PinsThatTheApplicationMovesPullTheSheetAlongSmoothly) {
    for (const bool byPosition : {true, false})
        for (const int steps : {4, 20, 100}) {
            test::SmallStepWorld rig({steps, 0.01});
            btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17));
            rig.cover(sheet, fabrics::cottonPlain());
            sheet.m_cfg.kDP = 1;
            double speed = 0;
            for (int i = 0; i < 120; ++i) {
                speed = std::min(1.0, speed + 0.05);
                for (int n = 0; n < 17; ++n) {
                    if (byPosition)
                        sheet.m_nodes[n].m_x += btVector3(0, 0, btScalar(speed / 60));
                    else
                        sheet.m_nodes[n].m_v.setValue(0, 0, btScalar(speed));
                }
                rig.run(1.0 / 60);
            }
            EXPECT_NEAR(double(sheet.m_nodes[8].m_x.z()), 2 - 0.5 * 20 * 0.05 * 19 / 60.0, 0.01);
            EXPECT_LT(test::fastest(sheet), 1.2) << steps;
        }
}

TEST(SmallStepLifetime, AStraySetMassChangesNothingForLong) {
    test::SmallStepWorld rig({20, 0.01});
    btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17));
    rig.cover(sheet, fabrics::cottonPlain()).air().vapourExchange = 0;
    sheet.m_cfg.kDP = 3;
    rig.run(2);
    const double before = test::lowest(sheet), massBefore = test::mass(sheet);
    for (int i = 0; i < 60; ++i) {
        sheet.setMass(100 + i, 0.5);
        rig.run(1.0 / 60);
    }
    rig.run(1);
    EXPECT_NEAR(test::lowest(sheet), before, 1e-3);
    EXPECT_NEAR(test::mass(sheet) / massBefore, 1, 1e-5);
}

TEST(SmallStepLifetime, AWetClothMayEndAndComeAgainWhileTheWorldRuns) {
    test::SmallStepWorld rig({20, 0.01});
    btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17));
    btSoftBody& other = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 17));
    other.translate({2, 0, 0});
    rig.cover(other, fabrics::cottonPlain());
    SheetSettings settings;
    for (int times = 0; times < 4; ++times) {
        auto cloth = std::make_unique<WetCloth>(rig.world(), sheet, fabrics::cottonPlain(), settings);
        settings.materialCoordinates = cloth->materialCoordinates();
        cloth->soakFilm(0.1);
        rig.run(0.5);
        cloth.reset();
        rig.run(0.5);  // as Bullet's own cloth
        EXPECT_TRUE(test::isFinite(sheet));
    }
    EXPECT_LT(test::fastest(sheet), 3);
    EXPECT_GT(test::lowest(sheet), -0.9);
    EXPECT_NEAR(test::lowest(other), -0.5, 0.01);
}

TEST(SmallStepLifetime, OneSolverServesTwoWorldsAndManySheets) {
    // In turn, each as if it were alone but for the number of steps, which is given.
    const auto alone = [] {
        test::SmallStepWorld rig({20, 0.01});
        btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 9));
        test::setVelocity(sheet, {0, 0, 1});
        rig.cover(sheet, fabrics::cottonPlain());
        rig.run(1);
        return sheet.m_nodes[76].m_x;
    }();
    SmallStepSolver solver({20, 0.01});
    demo::BulletWorld first(&solver), second(&solver);
    std::vector<std::unique_ptr<btSoftBody>> sheets;
    std::vector<std::unique_ptr<WetCloth>> cloths;
    SheetSettings settings;
    settings.meetsSheets = false;  // two hang in one place
    for (demo::BulletWorld* world : {&first, &second, &second}) {
        sheets.push_back(test::hangingSheet(world->world().getWorldInfo(), fabrics::cottonPlain(), 0.5, 9));
        sheets.back()->m_cfg.collisions = btSoftBody::fCollision::SDF_RS;
        test::setVelocity(*sheets.back(), {0, 0, 1});
        world->world().addSoftBody(sheets.back().get());
        cloths.push_back(
            std::make_unique<WetCloth>(world->world(), *sheets.back(), fabrics::cottonPlain(), settings));
    }
    for (int i = 0; i < 60; ++i) {
        first.step(1.0 / 60, 1);
        second.step(1.0 / 60, 1);
    }
    for (const auto& sheet : sheets) EXPECT_EQ(sheet->m_nodes[76].m_x, alone);
    cloths.clear();
    first.world().removeSoftBody(sheets[0].get());
    second.world().removeSoftBody(sheets[1].get());
    second.world().removeSoftBody(sheets[2].get());
}

TEST(SmallStepLifetime, ASheetWithoutWetClothIsBulletsOwn) {
    const auto moved = [](btSoftBodySolver* solver) {
        demo::BulletWorld bullet(solver);
        const auto sheet = test::hangingSheet(bullet.world().getWorldInfo(), fabrics::cottonPlain(), 0.5, 17);
        bullet.world().addSoftBody(sheet.get());
        for (int i = 0; i < 30; ++i) bullet.step(1.0 / 60, 1);
        const btVector3 at = sheet->m_nodes[200].m_x;
        bullet.world().removeSoftBody(sheet.get());
        return at;
    };
    SmallStepSolver solver;
    EXPECT_EQ(moved(nullptr), moved(&solver));
    EXPECT_EQ(solver.steps(), 0);
}

TEST(SmallStepLifetime, SettingsOutOfRangeAreRefused) {
    EXPECT_THROW(SmallStepSolver({-1, 0.01}), std::invalid_argument);
    EXPECT_THROW(SmallStepSolver({1001, 0.01}), std::invalid_argument);
    EXPECT_THROW(SmallStepSolver({0, 0}), std::invalid_argument);
    EXPECT_THROW(SmallStepSolver({0, 2}), std::invalid_argument);
    EXPECT_THROW(SmallStepSolver({0, std::nan("")}), std::invalid_argument);
}

TEST(SmallStepLifetime, AForceThatIsNotFiniteLeavesTheSheetWhereItWas) {
    test::SmallStepWorld rig({4, 0.01});
    btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 0.5, 9));
    rig.cover(sheet, fabrics::cottonPlain(), test::throwing());
    rig.run(0.1);
    const btVector3 before = sheet.m_nodes[40].m_x;
    sheet.m_nodes[44].m_f.setValue(btScalar(std::nan("")), 0, 0);
    EXPECT_THROW(rig.run(1.0 / 60), std::runtime_error);
    EXPECT_EQ(before, sheet.m_nodes[40].m_x);
    sheet.m_nodes[44].m_f.setZero();
    rig.world().clearForces();
    rig.run(0.5);
    EXPECT_TRUE(test::isFinite(sheet));
    EXPECT_NE(before, sheet.m_nodes[40].m_x);
}

}  // namespace
}  // namespace drench::small_step_lifetime_test
