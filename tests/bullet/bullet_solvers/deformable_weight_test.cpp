// How sheets hang in the deformable world, explicit and implicit, and the force that they hang by.
#include <gtest/gtest.h>

#include <string>

#include "deformable_rig.h"

namespace drench::deformable_weight_test {
namespace {

using namespace test;

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

using Vectors = btAlignedObjectArray<btVector3>;

Vectors zeros(int count) {
    Vectors vectors;
    vectors.resize(count, btVector3(0, 0, 0));
    return vectors;
}

// Sheet without pins, crumpled, after a first step.
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
            const int column = n % 9, row = n / 9;
            const double u = column, v = row;
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
        const auto forcesAt = [&](btScalar factor) {
            for (int n = 0; n < step.size(); ++n) crumpled.sheet->m_nodes[n].m_q += step[n] * factor;
            const Vectors found = crumpled.forces();
            for (int n = 0; n < step.size(); ++n) crumpled.sheet->m_nodes[n].m_q -= step[n] * factor;
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

}  // namespace
}  // namespace drench::deformable_weight_test
