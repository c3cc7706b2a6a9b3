// Cloth does not pass through itself where it is folded, stacked, dropped, flicked, thrown and dragged: CGAL counts the
// faces that cross at the end of each frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "bullet/world/worlds.h"
#include "oracle/crossing_oracle.h"

namespace drench::crossing_checks_test {
namespace {

constexpr double frame = 1.0 / 60;

struct Found {
    int most = 0;        // pairs of faces that cross at the end of a frame
    int atEnd = 0;       // and of the last
    int longest = 0;     // frames in a row that have any
    double fastest = 0;  // node, m/s
    double energy = 0;   // largest kinetic, J
};

double kineticEnergy(const btSoftBody& body) {
    double sum = 0;
    for (int n = 0; n < body.m_nodes.size(); ++n)
        sum += 0.5 * test::mass(body.m_nodes[n]) * double(body.m_nodes[n].m_v.length2());
    return sum;
}

// @param between  called before each frame, with its number
Found watch(
    test::SmallStepWorld& rig, const std::vector<const btSoftBody*>& bodies, double time,
    const std::function<void(int)>& between = [](int) {}) {
    Found found;
    int inARow = 0;
    for (int i = 0; i < static_cast<int>(std::lround(time / frame)); ++i) {
        between(i);
        rig.run(frame, frame);
        found.atEnd = test::crossingsByCgal(bodies);
        found.most = std::max(found.most, found.atEnd);
        inARow = found.atEnd > 0 ? inARow + 1 : 0;
        found.longest = std::max(found.longest, inARow);
        double energy = 0;
        for (const btSoftBody* const body : bodies) {
            found.fastest = std::max(found.fastest, test::fastest(*body));
            energy += kineticEnergy(*body);
        }
        found.energy = std::max(found.energy, energy);
    }
    return found;
}

void move(btSoftBody& body, const std::function<btVector3(const btVector3&)>& to) {
    for (int n = 0; n < body.m_nodes.size(); ++n)
        body.m_nodes[n].m_q = body.m_nodes[n].m_x = to(body.m_nodes[n].m_x);
}

// A level sheet around the origin, moved before it gets its WetCloth.
btSoftBody& addSheet(test::SmallStepWorld& rig, double side, int nodes,
                     const std::function<btVector3(const btVector3&)>& to) {
    auto sheet = test::levelSheet(rig.info(), fabrics::cottonPlain(), side, nodes, 0);
    SheetSettings settings;
    for (int n = 0; n < sheet->m_nodes.size(); ++n)
        settings.materialCoordinates.emplace_back(double(sheet->m_nodes[n].m_x.x()),
                                                  double(sheet->m_nodes[n].m_x.z()));
    move(*sheet, to);
    btSoftBody& body = rig.add(std::move(sheet));
    rig.cover(body, fabrics::cottonPlain(), settings);
    return body;
}

// Folds the right half of a sheet over its left one, so high above it, m.
btVector3 folded(const btVector3& at, double height) {
    const double radius = height / 2, along = double(at.x());
    const double angle = std::clamp(along / radius, 0.0, double(SIMD_PI)),
                 beyond = std::max(along - SIMD_PI * radius, 0.0);
    return {btScalar(along < 0 ? along : radius * std::sin(angle) - beyond),
            btScalar(radius * (1 - std::cos(angle))), at.z()};
}

TEST(CrossingChecks, NoneInAFold) {
    test::SmallStepWorld rig;
    rig.bullet().addGround(0);
    const btSoftBody& sheet = addSheet(
        rig, 0.5, 33, [](const btVector3& at) { return folded(at, 0.02) + btVector3(0, btScalar(0.02), 0); });
    EXPECT_EQ(watch(rig, {&sheet}, 2).most, 0);
}

TEST(CrossingChecks, NoneInAStackThatFallsOnABall) {
    test::SmallStepWorld rig;
    rig.bullet().addGround(0);
    rig.bullet().addBall({0, btScalar(0.1), 0}, 0.1, 0);
    std::vector<const btSoftBody*> sheets;
    for (int layer = 0; layer < 16; ++layer)
        sheets.push_back(&addSheet(rig, 0.3, 13, [layer](const btVector3& at) {
            return at + btVector3(0, btScalar(0.22 + 0.02 * layer), 0);
        }));
    EXPECT_EQ(watch(rig, sheets, 1.5).most, 0);
}

// Dropped over a ball that turns, which is then pulled up through it at 3 m/s.
TEST(CrossingChecks, NoneWhereABallIsPulledThrough) {
    test::SmallStepWorld rig;
    auto& ball = rig.bullet().addBall({0, btScalar(-0.2), 0}, 0.15, 0);
    ball.setCollisionFlags(ball.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    ball.setActivationState(DISABLE_DEACTIVATION);
    const btSoftBody& sheet = addSheet(rig, 0.8, 49, [](const btVector3& at) { return at; });
    const Found found = watch(rig, {&sheet}, 1.2, [&](int i) {
        const double height = -0.2 + 3 * frame * std::max(i - 40, 0);
        ball.setWorldTransform(
            btTransform(btQuaternion({0, 1, 0}, btScalar(0.05 * i)), {0, btScalar(height), 0}));
    });
    EXPECT_EQ(found.most, 0);
    EXPECT_GT(found.fastest, 3);
}

TEST(CrossingChecks, NoneInASheetWhoseHemIsFlickedAndItsMomentumStays) {
    test::SmallStepWorld rig;
    rig.setGravity({0, 0, 0});
    constexpr int nodes = 33;
    auto made = test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.8, nodes, 0);
    btSoftBody& sheet = rig.add(std::move(made));
    rig.cover(sheet, fabrics::cottonPlain(), test::withoutAir());
    for (int row = 0; row < nodes; ++row)
        for (int column = 0; column < 3; ++column) sheet.m_nodes[row * nodes + column].m_v = {0, 10, 0};
    const btVector3 before = test::momentum(sheet);
    const Found found = watch(rig, {&sheet}, 1);
    EXPECT_EQ(found.most, 0);
    EXPECT_LT((test::momentum(sheet) - before).length(), 1e-5 * before.length());
}

TEST(CrossingChecks, NoneWhereOneStripHangsOverAnother) {
    test::SmallStepWorld rig;
    const auto strip = [&](double height, double angle) -> btSoftBody& {
        auto made = makeSheet(
            rig.info(), fabrics::cottonPlain(),
            flatCorners({btScalar(-0.5), 0, btScalar(-0.05)}, {1, 0, 0}, {0, 0, btScalar(0.1)}), 51, 6);
        made->transform(btTransform(btQuaternion({0, 1, 0}, btScalar(angle)), {0, btScalar(height), 0}));
        for (int row = 0; row < 6; ++row)
            for (const int end : {0, 50}) made->m_nodes[row * 51 + end].m_im = 0;
        btSoftBody& body = rig.add(std::move(made));
        rig.cover(body, fabrics::cottonPlain());
        return body;
    };
    const btSoftBody& lower = strip(0, 0);
    btSoftBody& upper = strip(0.1, SIMD_HALF_PI);
    // The ends of the upper one go down beside the lower one, which then carries it.
    const Found found = watch(rig, {&lower, &upper}, 1.5, [&](int i) {
        if (i >= 60) return;
        for (int row = 0; row < 6; ++row)
            for (const int end : {0, 50})
                upper.m_nodes[row * 51 + end].m_x.setY(btScalar(0.1 - 0.4 * frame * (i + 1)));
    });
    EXPECT_EQ(found.most, 0);
    EXPECT_GT(upper.m_nodes[2 * 51 + 25].m_x.y(), test::lowest(upper) + 0.1);
}

// Where small steps do not keep all cloth apart: few faces cross, nothing is thrown, and what crosses gets apart or is
// reported.
void expectFewThatAreResolvedOrReported(const Found& found, int most, const WetCloth& cloth) {
    EXPECT_LE(found.most, most);
    const auto& troubles = cloth.troubles();
    const bool isReported = std::any_of(troubles.begin(), troubles.end(), [](const TroubleReport& report) {
        return report.what == Trouble::crossing;
    });
    constexpr int longestUnreported = 90;  // frames: a second, and half a second between looks
    EXPECT_TRUE(isReported || found.longest <= longestUnreported) << found.longest << " frames";
}

TEST(CrossingChecks, FewAreResolvedOrReportedInASheetLetFallFromItsMiddle) {
    test::SmallStepWorld rig;
    rig.bullet().addGround(0);
    constexpr int nodes = 33, middle = nodes / 2 * nodes + nodes / 2;
    btSoftBody& sheet =
        addSheet(rig, 0.8, nodes, [](const btVector3& at) { return at + btVector3(0, btScalar(0.6), 0); });
    const btScalar inverseMass = sheet.m_nodes[middle].m_im;
    sheet.m_nodes[middle].m_im = 0;
    const Found found = watch(rig, {&sheet}, 3, [&](int i) {
        if (i == 90) sheet.m_nodes[middle].m_im = inverseMass;
    });
    expectFewThatAreResolvedOrReported(found, 6, rig.clothOf(0));
}

TEST(CrossingChecks, FewAreResolvedOrReportedInATowelThrownAtAWall) {
    test::SmallStepWorld rig;
    rig.bullet().addBox({1, 0, 0}, {btScalar(0.5), 2, 2});
    rig.bullet().addGround(-1);
    const btTransform tilted(
        btQuaternion(btVector3(btScalar(0.2), btScalar(0.3), 1).normalized(), btScalar(1.2)));
    btSoftBody& sheet = addSheet(rig, 0.6, 25, [&](const btVector3& at) { return tilted * at; });
    test::setVelocity(sheet, {10, 2, 0});
    const Found found = watch(rig, {&sheet}, 1.5);
    EXPECT_GT(found.fastest, 8);
    expectFewThatAreResolvedOrReported(found, sheet.m_faces.size() / 20, rig.clothOf(0));
}

TEST(CrossingChecks, FewAreResolvedOrReportedInAFoldThatAHeavyBallDragsAlong) {
    test::SmallStepWorld rig;
    rig.bullet().addGround(0);
    btSoftBody& sheet = addSheet(rig, 0.5, 25, [](const btVector3& at) {
        return folded(at, 0.025) + btVector3(0, btScalar(0.02), 0);
    });
    btRigidBody* ball = nullptr;
    const Found found = watch(rig, {&sheet}, 3, [&](int i) {
        if (i == 45) ball = &rig.bullet().addBall({btScalar(0.35), btScalar(0.055), btScalar(0.02)}, 0.05, 1);
        if (ball && i < 60) ball->setLinearVelocity({-3, ball->getLinearVelocity().y(), 0});
    });
    EXPECT_LT(found.fastest, 10);
    expectFewThatAreResolvedOrReported(found, sheet.m_faces.size() / 10, rig.clothOf(0));
}

// Starts in which faces cross.
struct Start {
    const char* name;
    int nodes;
    bool isFolded;
    // Where a node of the upper layer, or of the upper sheet, is to be. @param margin  of the sheet, m
    std::function<btVector3(const btVector3& at, int node, double margin)> moved;
};

// A dent, so deep, round a point.
btVector3 dented(const btVector3& at, double x, double z, double radius, double depth) {
    const double from = std::hypot(double(at.x()) - x, double(at.z()) - z);
    const double part = from < radius ? std::pow(std::cos(from / radius * SIMD_HALF_PI), 2) : 0.0;
    return at - btVector3(0, btScalar(depth * part), 0);
}

class Untangling : public testing::TestWithParam<Start> {};

// Sets up what crosses. @return the sheets
std::vector<const btSoftBody*> begin(test::SmallStepWorld& rig, const Start& start) {
    const double cell = 0.5 / (start.nodes - 1), margin = cell / 4;
    std::vector<const btSoftBody*> sheets;
    int node = 0;
    if (start.isFolded) {
        rig.bullet().addGround(0);
        sheets.push_back(&addSheet(rig, 0.5, start.nodes, [&](const btVector3& at) {
            const btVector3 lies = folded(at, 5 * margin) + btVector3(0, btScalar(0.02), 0);
            const bool isAbove = at.x() > 8 * margin;
            return isAbove ? start.moved(lies, node++, margin) : lies;
        }));
    } else {
        rig.setGravity({0, 0, 0});
        sheets.push_back(&addSheet(rig, 0.5, start.nodes, [](const btVector3& at) { return at; }));
        sheets.push_back(&addSheet(rig, 0.5, start.nodes,
                                   [&](const btVector3& at) { return start.moved(at, node++, margin); }));
    }
    return sheets;
}

TEST_P(Untangling, GetsClothApartWithinASecondAndThrowsNothing) {
    test::SmallStepWorld rig;
    const std::vector<const btSoftBody*> sheets = begin(rig, GetParam());
    const int before = test::crossingsByCgal(sheets);
    EXPECT_GT(before, sheets[0]->m_faces.size() / 40);
    const Found first = watch(rig, sheets, 1);
    EXPECT_EQ(first.atEnd, 0) << "of " << before << " of " << sheets[0]->m_faces.size() << " faces";
    const Found then = watch(rig, sheets, 0.5);
    EXPECT_EQ(then.most, 0);
    EXPECT_LT(std::max(first.fastest, then.fastest), 2) << "m/s";
    EXPECT_LT(std::max(first.energy, then.energy), 0.01) << "J";
    for (std::size_t i = 0; i < sheets.size(); ++i) EXPECT_TRUE(rig.clothOf(i).troubles().empty());
}

INSTANTIATE_TEST_SUITE_P(
    Starts, Untangling,
    testing::Values(
        Start{"dentThroughASheet", 25, false,
              [](const btVector3& at, int, double margin) {
                  return dented(at + btVector3(0, btScalar(2 * margin), 0), 0.05, 0, 0.1, 0.06);
              }},
        Start{"cornerThroughASheet", 25, false,
              [](const btVector3& at, int, double) {
                  return btTransform(btQuaternion(btVector3(1, 0, 1).normalized(), btScalar(0.6)),
                                     {btScalar(0.1), btScalar(0.1), btScalar(0.05)}) *
                         at;
              }},
        Start{"dentInAFold", 33, true,
              [](const btVector3& at, int, double) { return dented(at, -0.12, 0.05, 0.08, 0.05); }},
        Start{"dentInAFineFold", 49, true,
              [](const btVector3& at, int, double) { return dented(at, -0.12, 0.05, 0.08, 0.05); }},
        Start{"scatteredNodesOfAFold", 33, true,
              [](const btVector3& at, int node, double margin) {
                  const bool isOff = std::fmod(node * 0.6180339887, 1.0) < 0.05;
                  return at - btVector3(0, btScalar(isOff ? 7 * margin : 0), 0);
              }}),
    [](const testing::TestParamInfo<Start>& start) { return std::string(start.param.name); });

// Two sheets that cross from border to border, and are held there.
TEST(UntanglingInVain, IsReportedAfterASecond) {
    test::SmallStepWorld rig;
    rig.setGravity({0, 0, 0});
    btSoftBody& one = addSheet(rig, 0.5, 17, [](const btVector3& at) { return at; });
    btSoftBody& other = addSheet(rig, 0.5, 17, [](const btVector3& at) {
        return btTransform(btQuaternion({1, 0, 0}, btScalar(0.9)), {btScalar(0.01), btScalar(0.013), 0}) * at;
    });
    for (btSoftBody* const body : {&one, &other})
        for (int n = 0; n < 17 * 17; ++n)
            if (n / 17 % 16 == 0 || n % 17 % 16 == 0) body->m_nodes[n].m_im = 0;
    const Found found = watch(rig, {&one, &other}, 1.1);
    EXPECT_GT(found.atEnd, 0);
    EXPECT_LT(found.energy, 0.05) << "J";
    for (const std::size_t i : {0, 1}) {
        ASSERT_EQ(rig.clothOf(i).troubles().size(), 1u);
        EXPECT_EQ(rig.clothOf(i).troubles()[0].what, Trouble::crossing);
        EXPECT_NE(rig.clothOf(i).troubles()[0].message.find("with other sheets"), std::string::npos);
    }
    // Then it is left as it is, and comes to rest.
    one.m_cfg.kDP = other.m_cfg.kDP = 2;
    const Found later = watch(rig, {&one, &other}, 4);
    EXPECT_GT(later.atEnd, 0);
    for (const btSoftBody* const body : {&one, &other}) EXPECT_LT(test::fastest(*body), 0.005) << "m/s";
}

TEST(UntanglingOfASnapshot, GoesOnBitByBit) {
    test::SmallStepWorld rig;
    const Start start = {
        "", 25, true, [](const btVector3& at, int, double) { return dented(at, -0.12, 0.05, 0.08, 0.05); }};
    const btSoftBody& sheet = *begin(rig, start)[0];
    rig.run(frame);
    EXPECT_GT(test::crossingsByCgal({&sheet}), 0);
    const Snapshot snapshot = rig.clothOf(0).snapshot();
    const auto after = [&] {
        rig.run(6 * frame);
        std::vector<btScalar> all;
        for (int n = 0; n < sheet.m_nodes.size(); ++n)
            for (int axis = 0; axis < 3; ++axis) all.push_back(sheet.m_nodes[n].m_x[axis]);
        return all;
    };
    const std::vector<btScalar> first = after();
    rig.clothOf(0).restore(snapshot);
    EXPECT_EQ(after(), first);
}

}  // namespace
}  // namespace drench::crossing_checks_test
