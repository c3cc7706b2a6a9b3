// What air and water do to the faces of a sheet.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bullet/simd/fluid_kernels.h"
#include "bullet/world/worlds.h"
#include "drench/water.h"

namespace drench::fluid_test {
namespace {

using test::SmallStepWorld;

constexpr double gravity = 9.81;

Fabric airtight() {
    Fabric fabric = fabrics::cottonPlain();
    fabric.airPermeabilityDry = fabric.airPermeabilitySaturated = 0;
    return fabric;
}

// Full pores and the film that faces retain, kg/m2.
double soaking(const Fabric& fabric) {
    return fabric.poreCapacity() + 2 * waterDensity * retainedFilmThickness;
}

// Water that soaked cloth displaces, kg/m2.
double displacedBy(const Fabric& fabric) {
    return waterDensity * fabric.arealDensity / fabric.fibreDensity + soaking(fabric);
}

double meanHeight(const btSoftBody& body) {
    double sum = 0;
    for (int n = 0; n < body.m_nodes.size(); ++n) sum += double(body.m_nodes[n].m_x.y());
    return sum / body.m_nodes.size();
}

double meanSpeed(const btSoftBody& body) {
    return double(test::momentum(body).y()) / test::mass(body);
}

TEST(Fluid, FreeLevelClothFallsAtItsTerminalVelocityInAirInAnySubstep) {
    // m g = 1/2 rho C_n v^2: 1.4296 m/s for 0.15 kg/m2.
    const double expected = std::sqrt(0.150 * gravity / (0.5 * airDensity * 1.2));
    for (const double frameTime : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
        SmallStepWorld rig;
        const Fabric fabric = airtight();
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.5, 9, 0));
        rig.cover(sheet, fabric).air().vapourExchange = 0;
        rig.run(1, frameTime);
        const double from = meanHeight(sheet);
        rig.run(1, frameTime);
        EXPECT_NEAR(-meanSpeed(sheet), expected, 0.005 * expected) << frameTime;
        EXPECT_NEAR(from - meanHeight(sheet), expected, 0.005 * expected) << frameTime;
    }
}

TEST(Fluid, SoakedClothSinksAtItsTerminalVelocityInAnySubstep) {
    const Fabric fabric = airtight();
    // Only the fibre weighs under water: 0.029 m/s.
    const double net = 0.150 * (1 - waterDensity / fabric.fibreDensity);
    const double expected = std::sqrt(net * gravity / (0.5 * waterDensity * 1.2));
    for (const double frameTime : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
        SmallStepWorld rig;
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.3, 7, 0));
        WetCloth& cloth = rig.cover(sheet, fabric);
        cloth.soakPores(soaking(fabric));
        cloth.add(Pool(10));
        rig.run(15, frameTime);
        const double from = meanHeight(sheet);
        rig.run(5, frameTime);
        EXPECT_NEAR(-meanSpeed(sheet), expected, 0.01 * expected) << frameTime;
        EXPECT_NEAR((from - meanHeight(sheet)) / 5, expected, 0.01 * expected) << frameTime;
    }
}

TEST(Fluid, HeldClothFeelsTheWholeWindOnceItIsHeld) {
    // All nodes pinned: nothing yields, and the drag is that of the wind, however long the substep.
    for (const double frameTime : {1.0 / 30, 1.0 / 240}) {
        SmallStepWorld rig;
        const Fabric fabric = airtight();
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 1, 9, 0));
        for (int n = 0; n < sheet.m_nodes.size(); ++n) sheet.m_nodes[n].m_im = 0;
        SheetSettings settings;
        settings.stepping = Stepping::byApplication;
        WetCloth& cloth = rig.cover(sheet, fabric, settings);
        cloth.air().wind = {0, 10, 0};
        btVector3 force(0, 0, 0);
        for (int i = 0; i < 400; ++i) {
            cloth.preSubstep(btScalar(frameTime));
            force.setZero();
            for (int n = 0; n < sheet.m_nodes.size(); ++n) {
                force += sheet.m_nodes[n].m_f;
                sheet.m_nodes[n].m_f.setZero();
            }
        }
        EXPECT_NEAR(double(force.y()), 0.5 * airDensity * 1.2 * 100, 72 * 0.01) << frameTime;
    }
}

// The application's own water around a sheet without weight, without a time of its own.
class Weightless {
  public:
    explicit Weightless(const Fabric& fabric) : rig(fabric) {}

    void submerge(const Eigen::Vector3d& velocity = {0, 0, 0}) {
        for (std::size_t n = 0; n < rig.cloth().moisture().size(); ++n)
            rig.cloth().account("lake").submerge(n, 1, velocity);
    }
    void step(double dt) {
        rig.cloth().preSubstep(btScalar(dt));
        for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) {
            btSoftBody::Node& node = rig.sheet().m_nodes[n];
            node.m_v += node.m_f * (node.m_im * btScalar(dt));
            node.m_f.setZero();
        }
    }
    btVector3 velocity() { return test::momentum(rig.sheet()) / btScalar(test::mass(rig.sheet())); }

    test::FreeSheet rig;
};

TEST(Fluid, ClothThatEntersTheWaterSharesItsMomentumWithIt) {
    Weightless sheet(airtight());
    test::setVelocity(sheet.rig.sheet(), {0, -1, 0});
    sheet.step(1e-5);
    EXPECT_NEAR(double(sheet.velocity().y()), -1, 1e-4);
    sheet.submerge();
    sheet.step(1e-5);
    // pi/4 x 1000 kg/m3 x 0.1 m goes along with 0.15 kg/m2.
    EXPECT_NEAR(double(sheet.velocity().y()), -0.150 / (0.150 + 78.54), 1e-5);
}

TEST(Fluid, NothingGoesAlongWithClothThatEntersEdgeFirst) {
    Weightless sheet(airtight());
    test::setVelocity(sheet.rig.sheet(), {1, 0, 0});
    sheet.step(1e-5);
    sheet.submerge();
    sheet.step(1e-5);
    // 1/2 rho C_t v^2 = 15 Pa on 0.15 kg/m2 for 1e-5 s.
    EXPECT_NEAR(double(sheet.velocity().x()), 1 - 1e-3, 1e-4);
}

TEST(Fluid, AStreamTakesClothAlongButNeverFasterThanItself) {
    for (const double speed : {0.1, 2.0, 60.0})
        for (const bool across : {false, true}) {
            Weightless sheet(airtight());
            const Eigen::Vector3d stream =
                across ? Eigen::Vector3d(0, speed, 0) : Eigen::Vector3d(speed, 0, 0);
            double before = 0;
            for (int i = 0; i < 300; ++i) {
                sheet.submerge(stream);
                sheet.step(1.0 / 30);
                const double along = double(across ? sheet.velocity().y() : sheet.velocity().x());
                EXPECT_GE(along, before - 1e-5 * speed) << speed;
                EXPECT_LE(along, speed * (1 + 1e-5)) << speed;
                before = along;
            }
            EXPECT_GT(before, 0.4 * speed);
        }
}

TEST(Fluid, BuoyancyIsTheWeightOfFibrePoresAndFilm) {
    for (const double water : {0.0, 0.1, soaking(fabrics::cottonPlain())}) {
        SmallStepWorld rig;
        const Fabric fabric = fabrics::cottonPlain();
        btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabric, 0.5, 9));
        SheetSettings settings;
        settings.stepping = Stepping::byApplication;
        settings.waterSpeed = 0;
        WetCloth& cloth = rig.cover(sheet, fabric, settings);
        cloth.soakPores(water);
        cloth.add(Pool(100));
        cloth.preSubstep(btScalar(1.0 / 60));
        double lift = 0;
        for (int n = 0; n < sheet.m_nodes.size(); ++n) lift += double(sheet.m_nodes[n].m_f.y());
        // Air in the pores carries as water does; film counts by what there is of it.
        const double film = std::max(0.0, water - fabric.poreCapacity());
        const double displaced = displacedBy(fabric) - 2 * waterDensity * retainedFilmThickness + film;
        EXPECT_NEAR(lift, 0.25 * displaced * gravity, 1e-4 * lift) << water;
        const double weight = (cloth.dryMass() + cloth.waterMass()) * gravity;
        EXPECT_EQ(weight > lift, water > 0.168) << water;
    }
}

TEST(Fluid, ClothLetGoUnderWaterStartsAgainstTheWaterThatGoesAlong) {
    for (const double frameTime : {1.0 / 60, 1.0 / 240}) {
        SmallStepWorld rig;
        const Fabric fabric = airtight();
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.5, 9, 0));
        WetCloth& cloth = rig.cover(sheet, fabric);
        cloth.soakPores(soaking(fabric));
        cloth.add(Pool(10));
        const double mass = 0.150 + soaking(fabric), net = mass - displacedBy(fabric);
        const double expected = net * gravity / (mass + 78.54);
        rig.run(0.1, frameTime);
        const double before = meanSpeed(sheet);
        rig.run(0.2, frameTime);
        EXPECT_NEAR((before - meanSpeed(sheet)) / 0.2, expected, 0.02 * expected) << frameTime;
        EXPECT_NEAR(-before, 0.1 * expected, 0.05 * 0.1 * expected) << "from the first substep on";
    }
}

// Sag of a sheet of very soft cloth between two edges, m, under water or else in air.
double sag(double strength, bool underWater) {
    SmallStepWorld rig({20, 0.01});
    Fabric fabric = fabrics::cottonPlain();
    fabric.stretchWarp = fabric.stretchWeft = 20;
    fabric.shear = 1;
    fabric.bendingFriction = 0;
    rig.setGravity({0, btScalar(-strength), 0});
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.4, 9, 0));
    for (int n = 0; n < 81; ++n)
        if (n % 9 == 0 || n % 9 == 8) sheet.m_nodes[n].m_im = 0;
    sheet.m_cfg.kDP = 1;
    SheetSettings settings;
    settings.waterSpeed = 0;
    WetCloth& cloth = rig.cover(sheet, fabric, settings);
    cloth.soakPores(soaking(fabric));
    if (underWater) cloth.add(Pool(10));
    rig.run(30);
    EXPECT_LT(test::fastest(sheet), 1e-3);
    return -double(sheet.m_nodes[40].m_x.y());
}

TEST(Fluid, AHammockUnderWaterSagsByItsWeightThere) {
    const Fabric fabric = fabrics::cottonPlain();
    const double mass = 0.150 + soaking(fabric), net = mass - displacedBy(fabric);
    const double inWater = sag(gravity, true), inAir = sag(gravity * net / mass, false);
    EXPECT_NEAR(inWater, inAir, 0.01 * inAir);
    EXPECT_GT(sag(1.1 * gravity * net / mass, false), 1.02 * inAir) << "sag tells weight";
}

// Force of the water on soaked cloth that sinks until it is held, so long after that, over the lift alone.
double forceAfterLanding(double substep, double time) {
    SmallStepWorld rig;
    const Fabric fabric = airtight();
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.5, 9, 0));
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;
    settings.waterSpeed = 0;
    WetCloth& cloth = rig.cover(sheet, fabric, settings);
    cloth.soakPores(soaking(fabric));
    cloth.add(Pool(100));
    double force = 0;
    const int landing = static_cast<int>(std::lround(2 / substep));
    const int last = landing + static_cast<int>(std::lround(time / substep));
    for (int i = 0; i <= last; ++i) {
        cloth.preSubstep(btScalar(substep));
        force = 0;
        for (int n = 0; n < sheet.m_nodes.size(); ++n) {
            btSoftBody::Node& node = sheet.m_nodes[n];
            force += double(node.m_f.y());
            node.m_v += (node.m_f * node.m_im + rig.info().m_gravity) * btScalar(substep);
            if (i >= landing) node.m_v.setZero();
            node.m_f.setZero();
        }
    }
    return force / (0.25 * displacedBy(fabric) * gravity);
}

TEST(Fluid, ClothThatLandsHasItsWholeWeightSoon) {
    const Fabric fabric = airtight();
    const double weight = (0.150 + soaking(fabric)) / displacedBy(fabric);
    for (const double substep : {1.0 / 240, 1.0 / 60, 1.0 / 30}) {
        EXPECT_NEAR(forceAfterLanding(substep, 0), weight, 0.02 * (weight - 1)) << "while it sinks";
        EXPECT_NEAR(forceAfterLanding(substep, 0.8), 1, 0.1 * (weight - 1)) << substep;
        EXPECT_NEAR(forceAfterLanding(substep, 2), 1, 1e-3) << substep;
    }
}

TEST(Fluid, AHammockThatIsPulledThroughTheWaterFlattensOnceItStops) {
    for (const double frameTime : {1.0 / 240, 1.0 / 60, 1.0 / 30}) {
        SmallStepWorld rig({20, 0.01});
        const Fabric fabric = airtight();
        btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.4, 9, 0));
        for (int n = 0; n < 81; ++n)
            if (n % 9 == 0 || n % 9 == 8 || n < 9 || n >= 72) sheet.m_nodes[n].m_im = 0;
        SheetSettings settings;
        settings.waterSpeed = 0;
        WetCloth& cloth = rig.cover(sheet, fabric, settings);
        cloth.soakPores(soaking(fabric));
        cloth.add(Pool(10));
        const auto sagAfter = [&](double time, double pull) {
            for (int i = 0; i < std::lround(time / frameTime); ++i) {
                for (int n = 0; n < 81; ++n)
                    if (sheet.m_nodes[n].m_im == 0)
                        sheet.m_nodes[n].m_x += btVector3(0, btScalar(pull * frameTime), 0);
                rig.run(frameTime, frameTime);
            }
            return double(sheet.m_nodes[0].m_x.y() - sheet.m_nodes[40].m_x.y());
        };
        const double before = sagAfter(2, 0), pulled = sagAfter(1, 1);
        EXPECT_GT(pulled, 3 * before) << frameTime;
        EXPECT_NEAR(sagAfter(2, 0), before, 0.05 * before) << frameTime;
    }
}

TEST(Fluid, SubmergingRefusesWhatMakesNoSense) {
    Weightless sheet(airtight());
    Supply& lake = sheet.rig.cloth().account("lake");
    EXPECT_THROW(lake.submerge(121, 1, {0, 0, 0}), std::out_of_range);
    for (const double depth : {-1.1e9, 1.1e9, std::nan("")})
        EXPECT_THROW(lake.submerge(0, depth, {0, 0, 0}), std::invalid_argument);
    EXPECT_THROW(lake.submerge(0, 1, {0, std::nan(""), 0}), std::invalid_argument);
    EXPECT_THROW(lake.submerge(0, 1, {0, 2e6, 0}), std::invalid_argument);
}

// Forces on eight faces side by side, anyhow in air and water.
std::vector<FluidForce> forces(PushByFluid push) {
    unsigned long number = 12345;
    const auto random = [&number] {
        number = number * 1103515245 + 12345;
        return float(double((number >> 16) & 0x7fff) / 0x7fff - 0.5);
    };
    FaceBlock block = {};
    std::vector<PackedVector> positions, velocities;
    std::vector<OtherAcceleration> accelerations;
    std::vector<FluidForce> result(24, FluidForce{0, 0, 0, 7});
    std::vector<FluidNode> fluid;
    for (std::size_t n = 0; n < 24; ++n) {
        block.nodes[n % 3][n / 3] = static_cast<std::int32_t>(n);
        block.restArea[n / 3] = 0.01f;
        positions.push_back({0.2f * random(), 0.2f * random(), 0.2f * random(), 0});
        velocities.push_back({random(), random(), random(), 0});
        accelerations.push_back({9 * random(), 9 * random(), 9 * random(), 0});
        const float fraction = n < 9 ? 0 : 0.5f + random();
        fluid.push_back({fraction, 0.5f * fraction, 0.3f, 1e-3f});
    }
    push(result.data(), &block, positions.data(), velocities.data(), accelerations.data(), fluid.data(),
         {1.2f, 1000, 0.6f, 0.015f, 78, 1.0f / 60}, 1);
    return result;
}

TEST(Fluid, KernelsForAnyProcessorAndTheFastestAgree) {
    const std::vector<FluidForce> scalar = forces(scalarPushByFluid()), best = forces(bestPushByFluid());
    for (std::size_t n = 0; n < scalar.size(); ++n) {
        const float size = std::abs(scalar[n].x) + std::abs(scalar[n].y) + std::abs(scalar[n].z);
        EXPECT_GT(size, 0);
        EXPECT_NEAR(scalar[n].x, best[n].x, 1e-4f * size);
        EXPECT_NEAR(scalar[n].y, best[n].y, 1e-4f * size);
        EXPECT_NEAR(scalar[n].z, best[n].z, 1e-4f * size);
        EXPECT_EQ(scalar[n].inverseMass, 7);
        EXPECT_EQ(best[n].inverseMass, 7);
    }
}

}  // namespace
}  // namespace drench::fluid_test
