// The same sheet in Bullet's deformable world, explicit and implicit.
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "hanging_grid.h"
#include "worlds.h"

namespace drench {
namespace {

using test::constantStiffness;
using test::Outcome;

constexpr int nodes = 17;
constexpr double side = 0.5;

enum class Mode { explicitSteps, implicitSteps };

/// A deformable world as an application would set one up, with Bullet's own gravity force.
class DeformableWorld {
  public:
    explicit DeformableWorld(Mode mode, double gravity = 9.81) : gravity_({0, btScalar(-gravity), 0}) {
        constraints_.setDeformableSolver(&solver_);
        world_ = std::make_unique<btDeformableMultiBodyDynamicsWorld>(
            &dispatcher_, &broadphase_, &constraints_, &configuration_, &solver_);
        world_->setGravity(gravity_.m_gravity);
        world_->getWorldInfo().m_gravity = gravity_.m_gravity;
        world_->setImplicit(mode == Mode::implicitSteps);
        world_->setUseProjection(mode == Mode::implicitSteps);
    }
    ~DeformableWorld() { end(); }
    DeformableWorld(const DeformableWorld&) = delete;
    DeformableWorld& operator=(const DeformableWorld&) = delete;

    btDeformableMultiBodyDynamicsWorld& world() { return *world_; }
    btSoftBodyWorldInfo& info() { return world_->getWorldInfo(); }

    void add(btSoftBody& sheet) {
        world_->addSoftBody(&sheet);
        world_->addForce(&sheet, &gravity_);
    }
    btRigidBody& addBall(const btVector3& centre, double radius) {
        ballShape_ = std::make_unique<btSphereShape>(btScalar(radius));
        btRigidBody::btRigidBodyConstructionInfo settings(0, nullptr, ballShape_.get());
        settings.m_startWorldTransform.setIdentity();
        settings.m_startWorldTransform.setOrigin(centre);
        ball_ = std::make_unique<btRigidBody>(settings);
        world_->addRigidBody(ball_.get());
        return *ball_;
    }
    btDeformableLagrangianForce& wetForce() {
        auto& forces = *solver_.getLagrangianForceArray();
        return *forces[forces.size() - 1];
    }
    void step(double time, int substeps) {
        constexpr int variableStep = 0;
        for (int i = 0; i < substeps; ++i) world_->stepSimulation(btScalar(time / substeps), variableStep);
    }
    /// Forces in the solver's list that are not Bullet's.
    int wetForces() {
        int count = 0;
        auto& forces = *solver_.getLagrangianForceArray();
        for (int i = 0; i < forces.size(); ++i)
            count += forces[i]->getForceType() > BT_MOUSE_PICKING_FORCE ? 1 : 0;
        return count;
    }
    /// The world ends before the rest of this.
    void end() {
        if (ball_ && world_) world_->removeRigidBody(ball_.get());
        world_.reset();
    }

  private:
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btDeformableMultiBodyConstraintSolver constraints_;
    btDeformableBodySolver solver_;
    btDeformableGravityForce gravity_;
    std::unique_ptr<btDeformableMultiBodyDynamicsWorld> world_;
    std::unique_ptr<btCollisionShape> ballShape_;
    std::unique_ptr<btRigidBody> ball_;
};

// Weight, as in mechanics_test.cpp ----------------------------------------------------------------------

bool hangsByCorners(int node) {
    return node < 2 || (node >= nodes - 2 && node < nodes);
}

void pinCorners(btSoftBody& sheet) {
    for (int n = 0; n < nodes; ++n) sheet.m_nodes[n].m_im = hangsByCorners(n) ? btScalar(0) : btScalar(1);
}

Outcome outcomeOf(const btSoftBody& sheet) {
    Outcome outcome{-side - double(sheet.m_nodes[nodes / 2 + nodes * (nodes - 1)].m_x.y()), 0};
    outcome.meanStrain = test::meanStrain(sheet);
    return outcome;
}

/// Lets a sheet with `water` times its own mass of water come to rest.
Outcome inBullet(Mode mode, const Fabric& fabric, double water) {
    DeformableWorld bullet(mode);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodes);
    pinCorners(*sheet);
    bullet.add(*sheet);
    SheetSettings settings;
    settings.waterSpeed = 0;  // the solver knows no water that runs down
    WetCloth cloth(bullet.world(), *sheet, fabric, settings);
    cloth.presoak(water * fabric.arealDensity);
    constexpr double time = 2;
    const double dt = mode == Mode::implicitSteps ? 1.0 / 120 : cloth.stepBound();
    const int steps = static_cast<int>(std::ceil(time / dt));
    for (int i = 0; i < steps; ++i) {
        bullet.step(time / steps, 1);
        // Implicit steps know no m_cfg.drag.
        for (int n = 0; n < sheet->m_nodes.size(); ++n) sheet->m_nodes[n].m_v *= btScalar(1 - 10 * dt);
    }
    const Outcome outcome = outcomeOf(*sheet);
    bullet.world().removeSoftBody(sheet.get());
    return outcome;
}

/// The same sheet put together from the textile formulas alone and solved at rest in double precision.
Outcome atRest(const Fabric& fabric, double water) {
    const auto problem =
        test::hangingGrid(fabric, side, nodes, fabric.arealDensity * (1 + water), hangsByCorners);
    const auto x = test::solveStatic(problem);
    return {-side - x[std::size_t(nodes / 2 + nodes * (nodes - 1))].y(), test::meanStrain(problem, x)};
}

class Weight : public testing::TestWithParam<double> {};

void hangsAsAtRest(Mode mode, double stretch) {
    const Fabric fabric = constantStiffness(stretch);
    const Outcome single = inBullet(mode, fabric, 0), expectedSingle = atRest(fabric, 0);
    for (const int times : {1, 2, 3}) {
        const Outcome found = times == 1 ? single : inBullet(mode, fabric, times - 1),
                      expected = atRest(fabric, times - 1);
        std::printf(
            "k %.0f N/m, %d x mass: sag %.5f m (%+.2f %%), strain %.5f (%+.2f %%), ratio %.3f at rest %.3f\n",
            stretch, times, found.sag, 100 * (found.sag / expected.sag - 1), found.meanStrain,
            100 * (found.meanStrain / expected.meanStrain - 1), found.meanStrain / single.meanStrain,
            expected.meanStrain / expectedSingle.meanStrain);
        EXPECT_NEAR(found.sag / expected.sag, 1, 0.02) << times << " times the mass";
        EXPECT_NEAR(found.meanStrain / expected.meanStrain, 1, 0.02) << times << " times the mass";
    }
}

TEST_P(Weight, HangsAsAtRestExplicit) {
    hangsAsAtRest(Mode::explicitSteps, GetParam());
}
TEST_P(Weight, HangsAsAtRestImplicit) {
    hangsAsAtRest(Mode::implicitSteps, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Deformable, Weight, testing::Values(20.0, 100.0, 500.0));

// The force ----------------------------------------------------------------------------------------------

using Vectors = btAlignedObjectArray<btVector3>;

Vectors zeros(int count) {
    Vectors vectors;
    vectors.resize(count, btVector3(0, 0, 0));
    return vectors;
}

/// Sheet without pins, crumpled, after a first step.
struct Crumpled {
    DeformableWorld bullet{Mode::implicitSteps, 0};
    std::unique_ptr<btSoftBody> sheet;
    std::unique_ptr<WetCloth> cloth;

    Crumpled() {
        const Fabric fabric = constantStiffness(100);
        sheet = test::hangingSheet(bullet.info(), fabric, side, 9);
        for (int n = 0; n < 9; ++n) sheet->m_nodes[n].m_im = 1;
        bullet.add(*sheet);
        cloth = std::make_unique<WetCloth>(bullet.world(), *sheet, fabric);
        bullet.step(1e-3, 1);
        for (int n = 0; n < sheet->m_nodes.size(); ++n) {
            btSoftBody::Node& node = sheet->m_nodes[n];
            const double u = n % 9, v = n / 9;
            node.m_q = node.m_x + btVector3(btScalar(0.01 * std::sin(3 * u + v)), btScalar(0.006 * v),
                                            btScalar(0.02 * std::cos(2 * v - u)));
        }
    }
    ~Crumpled() { bullet.world().removeSoftBody(sheet.get()); }

    Vectors forces() {
        Vectors all = zeros(sheet->m_nodes.size());
        bullet.wetForce().addScaledForces(1, all);
        return all;
    }
};

TEST(WetSpringForce, NeitherPushesNorTurnsTheSheetAsAWhole) {
    Crumpled crumpled;
    const Vectors forces = crumpled.forces();
    btVector3 sum(0, 0, 0), torque(0, 0, 0);
    double size = 0;
    for (int n = 0; n < forces.size(); ++n) {
        sum += forces[n];
        torque += crumpled.sheet->m_nodes[n].m_q.cross(forces[n]);
        size += double(forces[n].length());
    }
    ASSERT_GT(size, 1.0);
    EXPECT_LT(double(sum.length()), 1e-6 * size);
    EXPECT_LT(double(torque.length()), 1e-6 * size);
}

TEST(WetSpringForce, DifferentialIsPositiveAndThatOfTheForce) {
    Crumpled crumpled;
    // Stretched all over, so that the differential leaves nothing out.
    for (int n = 0; n < crumpled.sheet->m_nodes.size(); ++n) crumpled.sheet->m_nodes[n].m_q *= btScalar(1.6);
    for (int direction = 0; direction < 4; ++direction) {
        Vectors step = zeros(crumpled.sheet->m_nodes.size());
        for (int n = 0; n < step.size(); ++n)
            step[n] = btVector3(btScalar(std::sin(1.0 + n * (direction + 1))), btScalar(std::cos(2.0 * n)),
                                btScalar(std::sin(0.7 * n + direction)));
        constexpr btScalar length = btScalar(2e-4);
        const auto forcesAt = [&](btScalar way) {
            for (int n = 0; n < step.size(); ++n) crumpled.sheet->m_nodes[n].m_q += step[n] * way;
            const Vectors found = crumpled.forces();
            for (int n = 0; n < step.size(); ++n) crumpled.sheet->m_nodes[n].m_q -= step[n] * way;
            return found;
        };
        const Vectors ahead = forcesAt(length), behind = forcesAt(-length);
        crumpled.forces();  // the differential is that of the place where the forces were last asked for
        Vectors change = zeros(step.size());
        crumpled.bullet.wetForce().addScaledElasticForceDifferential(1, step, change);
        double error = 0, size = 0, work = 0;
        for (int n = 0; n < step.size(); ++n) {
            const btVector3 measured = (ahead[n] - behind[n]) / (2 * length);
            error += double((measured - change[n]).length2());
            size += double(measured.length2());
            work -= double(change[n].dot(step[n]));
        }
        EXPECT_LT(std::sqrt(error / size), 0.01);
        EXPECT_GT(work, 0);
    }
    // Crushed, where the true differential is not positive.
    for (int n = 0; n < crumpled.sheet->m_nodes.size(); ++n) crumpled.sheet->m_nodes[n].m_q *= btScalar(0.3);
    crumpled.forces();
    for (int n = 0; n < crumpled.sheet->m_nodes.size(); ++n) {
        Vectors step = zeros(crumpled.sheet->m_nodes.size()), change = step;
        step[n] = btVector3(btScalar(0.1), btScalar(-0.2), 1);
        crumpled.bullet.wetForce().addScaledElasticForceDifferential(1, step, change);
        EXPECT_LE(double(change[n].dot(step[n])), 0) << n;
    }
}

// Motion -------------------------------------------------------------------------------------------------

class InBothModes : public testing::TestWithParam<Mode> {};
INSTANTIATE_TEST_SUITE_P(Deformable, InBothModes, testing::Values(Mode::explicitSteps, Mode::implicitSteps));

/// Largest substep that the test takes: the bound, or a frame where there is none.
double longestStep(const WetCloth& cloth) {
    return std::min(cloth.stepBound(), 1.0 / 60);
}

double totalMass(const btSoftBody& sheet) {
    double total = 0;
    for (int n = 0; n < sheet.m_nodes.size(); ++n) total += test::mass(sheet.m_nodes[n]);
    return total;
}

btVector3 momentum(const btSoftBody& sheet) {
    btVector3 total(0, 0, 0);
    for (int n = 0; n < sheet.m_nodes.size(); ++n)
        total += sheet.m_nodes[n].m_v * btScalar(test::mass(sheet.m_nodes[n]));
    return total;
}

TEST_P(InBothModes, FallsFreely) {
    DeformableWorld bullet(GetParam());
    const Fabric fabric = constantStiffness(100);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodes);
    for (int n = 0; n < nodes; ++n) sheet->m_nodes[n].m_im = 1;
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.air().vapourExchange = 0;
        cloth.presoak(0.1);
        constexpr double time = 0.1;
        bullet.step(time, static_cast<int>(std::ceil(time / longestStep(cloth))));
        // Edge on, so that the air hardly brakes it.
        EXPECT_NEAR(double(momentum(*sheet).y()) / totalMass(*sheet), -9.81 * time, 0.01 * 9.81 * time);
        EXPECT_LT(test::largestStrain(*sheet), 1e-3);
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST_P(InBothModes, WaterBringsItsMomentum) {
    DeformableWorld bullet(GetParam(), 0);
    const Fabric fabric = constantStiffness(100);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodes);
    for (int n = 0; n < nodes; ++n) sheet->m_nodes[n].m_im = 1;
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.air().vapourExchange = 0;
        constexpr double water = 1e-4, speed = 3;
        cloth.addWater(nodes * 8 + 8, water, {btScalar(speed), 0, 0});
        // Bullet's conjugate gradients stop early in single precision; the stiffer a step, the more is lost.
        bullet.step(std::min(longestStep(cloth), 1e-3), 1);
        EXPECT_NEAR(double(momentum(*sheet).x()), water * speed, 0.01 * water * speed);
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST_P(InBothModes, WindBlowsItAway) {
    DeformableWorld bullet(GetParam(), 0);
    const Fabric fabric = constantStiffness(100);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodes);
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.air().wind = {0, 0, 2};
        for (int i = 0; i < 30; ++i)
            bullet.step(1.0 / 60, static_cast<int>(std::ceil(1.0 / 60 / longestStep(cloth))));
        EXPECT_GT(double(sheet->m_nodes[nodes * nodes - 1].m_x.z()), 0.1);
        EXPECT_LT(test::largestStrain(*sheet), 0.3);
        EXPECT_EQ(double(sheet->m_nodes[0].m_x.z()), 0);
    }
    bullet.world().removeSoftBody(sheet.get());
}

/// From soaked to dry at the longest step: light as it gets, the sheet is still stable.
TEST_P(InBothModes, DriesWithoutBlowingUp) {
    DeformableWorld bullet(GetParam());
    Fabric fabric = fabrics::cottonPlain();
    fabric.stretchWarp = 100;
    fabric.stretchWeft = 100;
    fabric.shear = 20;
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodes);
    pinCorners(*sheet);
    bullet.add(*sheet);
    {
        SheetSettings settings;
        settings.waterSpeed = 1e4;
        WetCloth cloth(bullet.world(), *sheet, fabric, settings);
        cloth.air().humidity = 0.1;
        cloth.soak(0.4);
        const double dt = longestStep(cloth);
        double wet = 0;
        for (double time = 0; time < 3; time += 1.0 / 60) {
            bullet.step(1.0 / 60, static_cast<int>(std::ceil(1.0 / 60 / dt)));
            wet = std::max(wet, totalMass(*sheet));
            ASSERT_LT(test::largestStrain(*sheet), 0.5) << time;
        }
        EXPECT_GT(wet, 2 * cloth.dryMass());
        EXPECT_LT(cloth.waterMass(), 0.05 * cloth.dryMass());
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST(DeformableWorld, CantileverSagsByItsBendingRigidity) {
    DeformableWorld bullet(Mode::implicitSteps);
    Fabric fabric = constantStiffness(2000);
    fabric.bending = 2e-3;
    constexpr int along = 18, across = 9;
    constexpr double cell = 0.00625;
    const auto sheet = makeSheet(
        bullet.info(), fabric,
        flatCorners({0, 0, 0}, {btScalar((along - 1) * cell), 0, 0}, {0, 0, btScalar((across - 1) * cell)}),
        along, across);
    for (int n = 0; n < sheet->m_nodes.size(); ++n)
        if (n % along < 2) sheet->m_nodes[n].m_im = 0;
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.air().vapourExchange = 0;
        for (int i = 0; i < 240; ++i) {
            bullet.step(1.0 / 240, 1);
            for (int n = 0; n < sheet->m_nodes.size(); ++n) sheet->m_nodes[n].m_v *= btScalar(0.9);
        }
        const double load = cloth.nodeMass(along * 4 + 8) / (cell * cell) * 9.81;
        // The second pinned column has the curvature of half a cell to either side.
        const double length = (along - 1.5) * cell;
        const double expected = load * std::pow(length, 4) / (8 * fabric.bending);
        const double found = -double(sheet->m_nodes[along * 5 - 1].m_x.y());
        RecordProperty("deflection_error", std::to_string(found / expected - 1));
        EXPECT_NEAR(found, expected, 0.04 * expected);
    }
    bullet.world().removeSoftBody(sheet.get());
}

// Contact ------------------------------------------------------------------------------------------------

double largestExtension(const btSoftBody& sheet) {
    double largest = 0;
    for (int i = 0; i < sheet.m_links.size(); ++i) {
        const btSoftBody::Link& link = sheet.m_links[i];
        if (link.m_bbending) continue;
        largest = std::max(largest, double((link.m_n[1]->m_x - link.m_n[0]->m_x).length() / link.m_rl) - 1);
    }
    return largest;
}

TEST_P(InBothModes, AWetSheetRestsOnABall) {
    DeformableWorld bullet(GetParam());
    const Fabric fabric = constantStiffness(100);
    const btVector3 centre(0, 0, 0);
    constexpr double radius = 0.15;
    const btRigidBody& ball = bullet.addBall(centre, radius);
    const auto sheet =
        makeSheet(bullet.info(), fabric,
                  flatCorners({btScalar(-side / 2), btScalar(radius + 0.03), btScalar(-side / 2)},
                              {btScalar(side), 0, 0}, {0, 0, btScalar(side)}),
                  nodes, nodes);
    sheet->m_cfg.kDF = 1;
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.air().vapourExchange = 0;
        cloth.presoak(fabric.arealDensity);
        WetBody& wet = cloth.add(WetBody(ball));
        wet.filmThickness = 1e-4;
        const int substeps = GetParam() == Mode::implicitSteps
                                 ? 4
                                 : std::max(16, static_cast<int>(std::ceil(1.0 / 60 / cloth.stepBound())));
        double closest = 1;
        for (int i = 0; i < 60; ++i) {
            bullet.step(1.0 / 60, substeps);
            ASSERT_TRUE(test::isFinite(*sheet)) << i;
            ASSERT_LT(largestExtension(*sheet), 0.15) << i;
            for (int n = 0; n < sheet->m_nodes.size(); ++n)
                closest = std::min(closest, double((sheet->m_nodes[n].m_x - centre).length()));
        }
        EXPECT_GT(closest, radius - 0.002);
        EXPECT_GT(double(sheet->m_nodes[nodes * nodes / 2].m_x.y()), radius);
        EXPECT_GT(cloth.ledger().supplied, 1.05 * fabric.arealDensity * side * side);  // from the ball
        EXPECT_GT(sheet->m_nodeRigidContacts.size(), 0);
        EXPECT_EQ(sheet->m_rcontacts.size(), 0);
        EXPECT_EQ(sheet->m_cfg.collisions & btSoftBody::fCollision::SDF_RD, btSoftBody::fCollision::SDF_RD);
    }
    EXPECT_EQ(sheet->m_cfg.collisions, int(btSoftBody::fCollision::Default));
    bullet.world().removeSoftBody(sheet.get());
}

/// With pins, and as stiff as cotton.
TEST(DeformableWorld, ImplicitCurtainIsBlownAgainstABall) {
    DeformableWorld bullet(Mode::implicitSteps);
    const btVector3 centre(0, btScalar(-0.3), btScalar(0.17));
    constexpr double radius = 0.15;
    bullet.addBall(centre, radius);
    const auto sheet = test::hangingSheet(bullet.info(), fabrics::cottonPlain(), side, nodes);
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabrics::cottonPlain());
        cloth.presoak(0.1);
        cloth.air().wind = {0, 0, 4};
        int touched = 0;
        double closest = 1;
        for (int i = 0; i < 60; ++i) {
            bullet.step(1.0 / 60, 4);
            touched = std::max(touched, sheet->m_nodeRigidContacts.size());
            ASSERT_LT(largestExtension(*sheet), 0.1) << i;
            for (int n = 0; n < sheet->m_nodes.size(); ++n)
                closest = std::min(closest, double((sheet->m_nodes[n].m_x - centre).length()));
        }
        EXPECT_GT(touched, 10);
        EXPECT_GT(closest, radius - 0.005);
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST(DeformableWorld, SheetsThatTouchShareTheirWater) {
    DeformableWorld bullet(Mode::explicitSteps, 0);
    const Fabric fabric = constantStiffness(100);
    const auto level = [&](double height) {
        auto sheet =
            makeSheet(bullet.info(), fabric,
                      flatCorners({0, btScalar(height), 0}, {btScalar(side), 0, 0}, {0, 0, btScalar(side)}),
                      nodes, nodes);
        sheet->m_cfg.collisions |= btSoftBody::fCollision::VF_DD;
        bullet.add(*sheet);
        return sheet;
    };
    const auto lower = level(0), upper = level(0.01);
    {
        WetCloth wet(bullet.world(), *lower, fabric), dry(bullet.world(), *upper, fabric);
        wet.presoak(0.1);
        const double before = dry.waterMass();
        dry.add(Touch(wet));
        for (int i = 0; i < 10; ++i) bullet.step(1.0 / 60, 27);
        EXPECT_GT(dry.waterMass(), before + 1e-5);
    }
    bullet.world().removeSoftBody(lower.get());
    bullet.world().removeSoftBody(upper.get());
}

// Borders ------------------------------------------------------------------------------------------------

std::string errorOf(DeformableWorld& bullet, double dt) {
    try {
        bullet.step(dt, 1);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(DeformableWorld, RefusesStepsThatWouldBlowUp) {
    DeformableWorld bullet(Mode::explicitSteps);
    const Fabric fabric = constantStiffness(100);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodes);
    bullet.add(*sheet);
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        const double bound = cloth.stepBound();
        const double cellMass = cloth.dryMass() / ((nodes - 1) * (nodes - 1));
        RecordProperty("k_dt2_over_m", std::to_string(100 * bound * bound / cellMass));
        EXPECT_GT(100 * bound * bound / cellMass, 0.15);
        EXPECT_LT(100 * bound * bound / cellMass, 0.30);

        const btVector3 before = sheet->m_nodes[100].m_x;
        EXPECT_NE(errorOf(bullet, 1.0 / 60).find("27 substeps for a frame of 1/60 s"), std::string::npos)
            << errorOf(bullet, 1.0 / 60);
        EXPECT_EQ(sheet->m_nodes[100].m_x, before);
        EXPECT_EQ(errorOf(bullet, bound), "");

        cloth.soak(0.2);  // heavier, but it will dry
        EXPECT_EQ(errorOf(bullet, bound), "");
        EXPECT_EQ(cloth.stepBound(), bound);
        EXPECT_NE(errorOf(bullet, 1.1 * bound), "");

        bullet.world().setImplicit(true);
        EXPECT_NE(errorOf(bullet, bound).find("setUseProjection"), std::string::npos);
        bullet.world().setUseProjection(true);
        EXPECT_EQ(errorOf(bullet, 1.0 / 60), "");
        EXPECT_TRUE(std::isinf(cloth.stepBound()));
    }
    bullet.world().removeSoftBody(sheet.get());
}

TEST(DeformableWorld, TheBoundIsNotFarFromWhereStepsBlowUp) {
    const Fabric fabric = constantStiffness(100);
    for (const double times : {1.0, 2.0}) {
        DeformableWorld bullet(Mode::explicitSteps);
        const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodes);
        for (int n = 0; n < nodes; ++n) sheet->m_nodes[n].m_im = 1;
        bullet.add(*sheet);
        {
            SheetSettings settings;
            settings.stepping = Stepping::byApplication;
            WetCloth cloth(bullet.world(), *sheet, fabric, settings);
            cloth.preSubstep(btScalar(1e-5));  // the only one, so that nothing refuses what follows
            sheet->m_nodes[100].m_v.setX(btScalar(0.01));
            bullet.step(200 * times * cloth.stepBound(), 200);
            if (times > 1)
                EXPECT_GT(largestExtension(*sheet), 0.5);
            else
                EXPECT_LT(largestExtension(*sheet), 0.01);
        }
        bullet.world().removeSoftBody(sheet.get());
    }
}

TEST(DeformableWorld, OtherWorldsAreRefused) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld rigid(&dispatcher, &broadphase, &solver, &configuration);
    demo::BulletWorld bullet;
    const auto sheet = test::smallSheet(bullet.world().getWorldInfo());
    try {
        const WetCloth cloth(rigid, *sheet, fabrics::cottonPlain());
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("btDeformableMultiBodyDynamicsWorld"), std::string::npos);
    }
    EXPECT_THROW(const FallingDrops drops(rigid), std::invalid_argument);
}

TEST(DeformableWorld, PlanesAreRefused) {
    DeformableWorld bullet(Mode::explicitSteps);
    const auto sheet = test::smallSheet(bullet.info());
    btStaticPlaneShape plane({0, 1, 0}, 0);
    btCollisionObject ground;
    ground.setCollisionShape(&plane);
    bullet.world().addCollisionObject(&ground);
    EXPECT_THROW(const WetCloth cloth(bullet.world(), *sheet, fabrics::cottonPlain()), std::invalid_argument);
    bullet.world().removeCollisionObject(&ground);
}

TEST(DeformableWorld, AnchorsFollowTheMass) {
    DeformableWorld bullet(Mode::explicitSteps);
    const Fabric fabric = constantStiffness(100);
    const auto sheet = test::hangingSheet(bullet.info(), fabric, side, nodes);
    for (int n = 0; n < nodes; ++n) sheet->m_nodes[n].m_im = 1;
    btRigidBody& ball = bullet.addBall({0, 1, 0}, 0.1);
    bullet.add(*sheet);
    sheet->appendDeformableAnchor(0, &ball);
    sheet->appendDeformableAnchor(nodes - 1, &ball);
    const btVector3 held = sheet->m_nodes[0].m_x;
    const int substeps = 27;
    {
        WetCloth cloth(bullet.world(), *sheet, fabric);
        cloth.presoak(0.3);
        for (int i = 0; i < 30; ++i) bullet.step(1.0 / 60, substeps);
        EXPECT_EQ(sheet->m_deformableAnchors[0].m_c2, sheet->m_nodes[0].m_im);
        EXPECT_NEAR(1 / double(sheet->m_nodes[0].m_im), cloth.nodeMass(0), 1e-9);
        EXPECT_LT(double((sheet->m_nodes[0].m_x - held).length()), 1e-4);
        EXPECT_LT(largestExtension(*sheet), 0.5);
    }
    EXPECT_EQ(sheet->m_deformableAnchors[0].m_c2, sheet->m_nodes[0].m_im);
    bullet.world().removeSoftBody(sheet.get());
}

// Several sheets, and who ends first -----------------------------------------------------------------------

TEST_P(InBothModes, TwoSheetsAndOneOfAnotherKind) {
    DeformableWorld bullet(GetParam());
    const auto hang = [&](double stretch, double z) {
        auto sheet = test::hangingSheet(bullet.info(), constantStiffness(stretch), side, nodes);
        pinCorners(*sheet);
        sheet->translate({0, 0, btScalar(z)});
        bullet.add(*sheet);
        return sheet;
    };
    const auto plain = hang(50, -0.3), soft = hang(20, 0), stiff = hang(100, 0.3);
    for (int n = 0; n < plain->m_nodes.size(); ++n)
        if (plain->m_nodes[n].m_im > 0) plain->m_nodes[n].m_im = btScalar(1 / 1.5e-4);
    btDeformableMassSpringForce springs(50, btScalar(0.01), true, 0);
    bullet.world().addForce(plain.get(), &springs);
    {
        SheetSettings settings;
        settings.waterSpeed = 0;
        WetCloth softCloth(bullet.world(), *soft, constantStiffness(20), settings);
        WetCloth stiffCloth(bullet.world(), *stiff, constantStiffness(100), settings);
        const double dt = longestStep(stiffCloth);
        for (double time = 0; time < 1.5; time += dt) {
            bullet.step(dt, 1);
            for (const btSoftBody* sheet : {plain.get(), soft.get(), stiff.get()})
                for (int n = 0; n < sheet->m_nodes.size(); ++n)
                    const_cast<btSoftBody*>(sheet)->m_nodes[n].m_v *= btScalar(1 - 10 * dt);
        }
        EXPECT_EQ(bullet.wetForces(), 2);
        EXPECT_NEAR(outcomeOf(*soft).sag, atRest(constantStiffness(20), 0).sag, 5e-4);
        EXPECT_NEAR(outcomeOf(*stiff).sag, atRest(constantStiffness(100), 0).sag, 1e-4);
        EXPECT_GT(outcomeOf(*plain).sag, 0.001);
        EXPECT_LT(largestExtension(*plain), 0.5);
        bullet.world().removeSoftBody(soft.get());
        EXPECT_EQ(bullet.wetForces(), 1);
        bullet.step(dt, 5);
        EXPECT_NEAR(outcomeOf(*stiff).sag, atRest(constantStiffness(100), 0).sag, 1e-4);
    }
    EXPECT_EQ(bullet.wetForces(), 0);
    bullet.step(1e-4, 1);
    bullet.world().removeSoftBody(stiff.get());
    bullet.world().removeSoftBody(plain.get());
}

/// The three things whose order of ending is free. Each ends once.
struct Ending {
    DeformableWorld bullet{Mode::explicitSteps};
    std::unique_ptr<btSoftBody> body = test::hangingSheet(bullet.info(), constantStiffness(100), side, nodes);
    std::unique_ptr<WetCloth> cloth;

    Ending() {
        bullet.add(*body);
        cloth = std::make_unique<WetCloth>(bullet.world(), *body, constantStiffness(100));
        cloth->soak(0.1);
        step();
        EXPECT_EQ(bullet.wetForces(), 1);
    }
    void step() { bullet.step(0.002, 5); }
    void removeBody() { bullet.world().removeSoftBody(body.get()); }
};

TEST(DeformableLifetime, ClothFirst) {
    for (const bool worldBeforeBody : {true, false}) {
        Ending ending;
        ending.cloth.reset();
        EXPECT_EQ(ending.bullet.wetForces(), 0);
        ending.step();
        if (worldBeforeBody) {
            ending.bullet.end();
        } else {
            ending.removeBody();
            ending.body.reset();
            ending.step();
        }
    }
}

TEST(DeformableLifetime, BodyFirst) {
    for (const bool worldBeforeCloth : {true, false}) {
        Ending ending;
        ending.removeBody();
        EXPECT_EQ(ending.bullet.wetForces(), 0);
        ending.body.reset();
        ending.step();
        if (worldBeforeCloth) ending.bullet.end();
        ending.cloth.reset();
        if (!worldBeforeCloth) ending.step();
    }
}

TEST(DeformableLifetime, WorldFirst) {
    for (const bool bodyBeforeCloth : {true, false}) {
        Ending ending;
        ending.bullet.end();
        if (bodyBeforeCloth) ending.body.reset();
        ending.cloth.reset();
    }
}

TEST(DeformableLifetime, ABodyThatLeavesAndComesBackGoesOn) {
    Ending ending;
    ending.removeBody();
    ending.step();
    ending.bullet.add(*ending.body);
    ending.step();
    EXPECT_EQ(ending.bullet.wetForces(), 1);
    ending.removeBody();
    ending.cloth.reset();
    EXPECT_EQ(ending.bullet.wetForces(), 0);
}

TEST(DeformableLifetime, AnotherClothForTheSameBody) {
    Ending ending;
    ending.cloth.reset();
    ending.cloth = std::make_unique<WetCloth>(ending.bullet.world(), *ending.body, constantStiffness(100));
    ending.step();
    EXPECT_EQ(ending.bullet.wetForces(), 1);
    ending.bullet.world().removeSoftBodyForce(ending.body.get());  // the application takes all forces away
    ending.step();
    EXPECT_EQ(ending.bullet.wetForces(), 1);
    ending.removeBody();
}

TEST(DeformableLifetime, AttachedBeforeItIsInTheWorld) {
    DeformableWorld bullet(Mode::implicitSteps);
    const auto sheet = test::hangingSheet(bullet.info(), constantStiffness(100), side, nodes);
    WetCloth cloth(bullet.world(), *sheet, constantStiffness(100));
    bullet.step(1.0 / 60, 1);
    EXPECT_EQ(bullet.wetForces(), 0);
    bullet.add(*sheet);
    bullet.step(1.0 / 60, 1);
    EXPECT_EQ(bullet.wetForces(), 1);
    bullet.world().removeSoftBody(sheet.get());
}

TEST(DeformableLifetime, SteppedByTheApplication) {
    DeformableWorld bullet(Mode::explicitSteps);
    const auto sheet = test::hangingSheet(bullet.info(), constantStiffness(100), side, nodes);
    bullet.add(*sheet);
    {
        SheetSettings settings;
        settings.stepping = Stepping::byApplication;
        WetCloth cloth(bullet.world(), *sheet, constantStiffness(100), settings);
        EXPECT_THROW(cloth.preSubstep(btScalar(1.0 / 60)), std::runtime_error);
        cloth.preSubstep(btScalar(1e-4));
        bullet.step(1e-4, 1);
        EXPECT_EQ(bullet.wetForces(), 1);
    }
    EXPECT_EQ(bullet.wetForces(), 0);
    bullet.world().removeSoftBody(sheet.get());
}

}  // namespace
}  // namespace drench
