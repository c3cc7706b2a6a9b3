// Whether a SmallStepSolver's cloth hangs as it should, against a solver that shares nothing with it, and
// whatever the time step and the mesh are.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <tuple>

#include "bullet/small_steps/small_step_sheet.h"
#include "bullet/world/body_watch.h"
#include "bullet/world/worlds.h"
#include "hanging_grid.h"

namespace drench::small_step_test {
namespace {

using test::Outcome;

constexpr int nodes = 17;
constexpr double side = 0.5;

// Cloth that hardly bends, and is equally stiff wet and dry: nothing but springs and weight.
Fabric springs(double stretch) {
    Fabric fabric = test::constantStiffness(stretch);
    fabric.bending = 1e-9;
    fabric.bendingFriction = 0;
    return fabric;
}

// Lets a sheet with `water` times its own mass of water come to rest under its upper edge.
Outcome inBullet(const Fabric& fabric, double water, const SmallStepSettings& steps) {
    test::SmallStepWorld rig(steps);
    btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabric, side, nodes));
    SheetSettings settings;
    settings.waterSpeed = 0;  // the static solver knows no water that runs down
    rig.cover(sheet, fabric, settings).soakPores(water * fabric.arealDensity);
    sheet.m_cfg.kDP = 3;
    rig.run(5);
    return {-side - double(sheet.m_nodes[nodes / 2 + nodes * (nodes - 1)].m_x.y()), test::meanStrain(sheet)};
}

// The same sheet put together from the textile formulas alone and solved at rest in double precision.
Outcome atRest(const Fabric& fabric, double water) {
    const auto problem = test::hangingGrid(fabric, side, nodes, fabric.arealDensity * (1 + water),
                                           [](int node) { return node < nodes; });
    const auto x = test::solveStatic(problem);
    return {-side - x[std::size_t(nodes / 2 + nodes * (nodes - 1))].y(), test::meanStrain(problem, x)};
}

struct Resolved {
    double stretch;  // N/m
    int steps;       // that resolve it
};

class SmallStepSag : public testing::TestWithParam<Resolved> {};

TEST_P(SmallStepSag, AndStrainAreThoseOfAnIndependentSolverAtRest) {
    const Fabric fabric = springs(GetParam().stretch);
    const SmallStepSettings steps{GetParam().steps, 0.01};
    const Outcome single = inBullet(fabric, 0, steps), singleAtRest = atRest(fabric, 0);
    for (const int times : {1, 2, 3}) {
        const Outcome found = inBullet(fabric, times - 1, steps), expected = atRest(fabric, times - 1);
        RecordProperty("sag_error_" + std::to_string(times), std::to_string(found.sag / expected.sag - 1));
        EXPECT_NEAR(found.sag / expected.sag, 1, 0.02) << times << " times the mass";
        EXPECT_NEAR(found.meanStrain / expected.meanStrain, 1, 0.02) << times << " times the mass";
        // At rest 1.999 and 2.996 for the softest: it grows narrower as it stretches.
        EXPECT_NEAR(found.meanStrain / single.meanStrain, times, 0.03 * times);
        EXPECT_NEAR(expected.meanStrain / singleAtRest.meanStrain, times, 0.002 * times);
    }
}

INSTANTIATE_TEST_SUITE_P(Stiffness, SmallStepSag,
                         testing::Values(Resolved{20, 20}, Resolved{100, 40}, Resolved{500, 80}),
                         [](const auto& each) { return std::to_string(int(each.param.stretch)); });

TEST(SmallStep, AutomaticStepsKeepTheirTolerance) {
    for (const double tolerance : {0.01, 0.001, 0.0003}) {
        const Fabric fabric = springs(500);
        const double excess = inBullet(fabric, 0, {0, tolerance}).meanStrain - atRest(fabric, 0).meanStrain;
        EXPECT_LT(std::abs(excess), tolerance);
    }
}

// How far down a square metre of cotton hangs.
double lowestPoint(int meshNodes, bool byCorners, double tolerance, double dt, double time) {
    test::SmallStepWorld rig({0, tolerance});
    btSoftBody& sheet = rig.add(test::hangingSheet(rig.info(), fabrics::cottonPlain(), 1, meshNodes));
    if (byCorners)
        for (int i = 1; i + 1 < meshNodes; ++i) sheet.m_nodes[i].m_im = 1;
    rig.cover(sheet, fabrics::cottonPlain());
    sheet.m_cfg.kDP = 8;
    rig.run(time, dt);
    return -test::lowest(sheet);
}

TEST(SmallStep, SheetsHangEquallyLowAtAnyTimeStep) {
    constexpr int meshNodes = 32;
    for (const bool byCorners : {false, true}) {
        double min = 1e9, max = 0;
        for (const double rate : {30, 60, 120, 240}) {
            const double found = lowestPoint(meshNodes, byCorners, 0.01, 1 / rate, 2);
            min = std::min(min, found);
            max = std::max(max, found);
        }
        RecordProperty(byCorners ? "by_corners" : "by_edge", std::to_string(max / min - 1));
        EXPECT_LT(max / min, 1.02) << (byCorners ? "by two corners" : "by the upper edge");
    }
}

TEST(SmallStep, SheetsHangEquallyLowOnAnyMesh) {
    double min = 1e9, max = 0;
    for (const int meshNodes : {16, 32, 64, 128}) {
        // Stretch settles within tenths of a second.
        const double found = lowestPoint(meshNodes, false, 0.01, 1.0 / 60, meshNodes > 64 ? 0.7 : 1.5);
        min = std::min(min, found);
        max = std::max(max, found);
    }
    EXPECT_LT(max / min, 1.02) << "by the upper edge";

    // Two nodes carry it all: what the tolerance allows for the sheet's mean is several times more there.
    min = 1e9, max = 0;
    for (const int meshNodes : {16, 32, 64}) {
        const double found = lowestPoint(meshNodes, true, 0.003, 1.0 / 60, 1.5);
        min = std::min(min, found);
        max = std::max(max, found);
    }
    EXPECT_LT(max / min, 1.02) << "by two corners";
}

// A level grid, whose nodes may be numbered in another order than row by row.
std::unique_ptr<btSoftBody> levelGrid(btSoftBodyWorldInfo& info, const Fabric& fabric, int across,
                                      bool inRows) {
    TriangleMesh mesh;
    const int count = across * across;
    const auto number = [&](int node) { return std::size_t(inRows ? node : node * 29 % count); };
    mesh.vertices.resize(std::size_t(count));
    for (int node = 0; node < count; ++node)
        mesh.vertices[number(node)] = {0.025 * (node % across), 0, 0.025 * (node / across)};
    for (int j = 0; j + 1 < across; ++j)
        for (int i = 0; i + 1 < across; ++i) {
            const int a = int(number(i + j * across)), b = int(number(i + 1 + j * across)),
                      c = int(number(i + 1 + (j + 1) * across)), d = int(number(i + (j + 1) * across));
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    return makeSheet(info, fabric, mesh);
}

// A crumpled wet sheet that flies apart in all directions for one substep, by one kind of kernels, and after longer
// small steps if `longer` is above 1.
std::vector<Eigen::Vector3d> moved(const SmallStepKernels& kernels, int steps, double longer, bool inRows) {
    test::SmallStepWorld rig;
    Fabric fabric = fabrics::cottonPlain();
    btSoftBody& sheet = rig.add(levelGrid(rig.info(), fabric, 13, inRows));
    rig.cover(sheet, fabric).soakPores(0.03);
    SheetMechanics& mechanics = *BodyWatch::mechanicsOf(sheet);
    unsigned long number = 12345;
    const auto random = [&number] {
        number = number * 1103515245 + 12345;
        return btScalar(double((number >> 16) & 0x7fff) / 0x7fff - 0.5);
    };
    for (int n = 0; n < sheet.m_nodes.size(); ++n) {
        sheet.m_nodes[n].m_x += btVector3(random(), random(), random()) * btScalar(0.01);
        sheet.m_nodes[n].m_v = btVector3(random(), random(), random());
        mechanics.stretchRatios[std::size_t(n)] = 1 + 0.5 * double(random());
        mechanics.bendingRatios[std::size_t(n)] = 1 + 0.5 * double(random());
        if (n % 23 == 0) sheet.m_nodes[n].m_im = 0;
    }
    SmallStepSheet cloth(mechanics, kernels);
    EXPECT_EQ(cloth.isInStrips(), inRows);
    for (const double substep : {longer / 60, 1.0 / 60}) {
        cloth.begin(sheet, mechanics, substep);
        cloth.divide(mechanics, steps);
    }
    for (int i = 0; i < steps; ++i) {
        cloth.advance();
        cloth.solveCloth();
    }
    std::vector<Eigen::Vector3d> result;
    for (std::size_t n = 0; n < cloth.size(); ++n)
        result.emplace_back(cloth.moved(n).x, cloth.moved(n).y, cloth.moved(n).z);
    return result;
}

TEST(SmallStep, KernelsForAnyProcessorAndTheFastestAgree) {
    for (const auto& [steps, longer, inRows] : {std::tuple{1, 1.0, true},
                                                {8, 1.0, true},
                                                {40, 1.0, true},
                                                {8, 1.5, true},
                                                {40, 3.0, true},
                                                {1, 1.0, false},
                                                {8, 1.0, false},
                                                {40, 1.0, false},
                                                {8, 1.5, false},
                                                {40, 3.0, false}}) {
        const auto scalar = moved(scalarKernels(), steps, longer, inRows),
                   best = moved(bestKernels(), steps, longer, inRows);
        double largest = 0, apart = 0;
        for (std::size_t n = 0; n < scalar.size(); ++n) {
            largest = std::max(largest, scalar[n].norm());
            apart = std::max(apart, (scalar[n] - best[n]).norm());
        }
        RecordProperty(
            "apart_" + std::to_string(steps) + "_" + std::to_string(longer) + (inRows ? "_in_strips" : ""),
            std::to_string(apart));
        EXPECT_GT(largest, 1e-3);
        EXPECT_LT(apart, 1e-4 * largest);
    }
}

}  // namespace
}  // namespace drench::small_step_test
