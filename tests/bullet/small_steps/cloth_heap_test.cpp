// Sheets on sheets come to rest, and do not pass through each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "bullet/world/worlds.h"

namespace drench::cloth_heap_test {
namespace {

struct Point {
    double x, y, z;
};
Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point cross(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Point at(const btSoftBody::Node* node) {
    return {double(node->m_x.x()), double(node->m_x.y()), double(node->m_x.z())};
}

// Whether an edge passes through a face (Moeller and Trumbore).
bool passes(const Point& from, const Point& to, const btSoftBody::Face& face) {
    const Point a = at(face.m_n[0]), one = at(face.m_n[1]) - a, two = at(face.m_n[2]) - a;
    const Point along = to - from, across = cross(along, two), offset = from - a;
    const double determinant = dot(one, across);
    if (std::abs(determinant) < 1e-14) return false;
    const double u = dot(offset, across) / determinant;
    const Point around = cross(offset, one);
    const double v = dot(along, around) / determinant, t = dot(two, around) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1;
}

// Number of edges of a sheet that pass through faces of another, or of itself, but for those that share a node.
int crossings(const btSoftBody& edges, const btSoftBody& faces) {
    int count = 0;
    for (int l = 0; l < edges.m_links.size(); ++l) {
        const btSoftBody::Link& link = edges.m_links[l];
        if (link.m_bbending) continue;
        btVector3 low = link.m_n[0]->m_x, high = low;
        low.setMin(link.m_n[1]->m_x);
        high.setMax(link.m_n[1]->m_x);
        for (int f = 0; f < faces.m_faces.size(); ++f) {
            const btSoftBody::Face& face = faces.m_faces[f];
            const auto isEnd = [&](const btSoftBody::Node* node) {
                return node == link.m_n[0] || node == link.m_n[1];
            };
            bool isApart = std::any_of(face.m_n, face.m_n + 3, isEnd);
            for (int axis = 0; axis < 3; ++axis) {
                const auto of = [&](int corner) { return face.m_n[corner]->m_x[axis]; };
                isApart = isApart || std::max({of(0), of(1), of(2)}) < low[axis] ||
                          std::min({of(0), of(1), of(2)}) > high[axis];
            }
            if (!isApart && passes(at(link.m_n[0]), at(link.m_n[1]), face)) ++count;
        }
    }
    return count;
}

double meanSpeed(const btSoftBody& body) {
    double sum = 0;
    for (int n = 0; n < body.m_nodes.size(); ++n) sum += double(body.m_nodes[n].m_v.length2());
    return std::sqrt(sum / body.m_nodes.size());
}

enum class Base { ground, ball, box };

struct Case {
    const char* name;
    int layers, nodes;
    double angle;  // of each sheet to the one below it, degrees
    double shift;  // m
    bool isMixed;  // fabrics
    Base base = Base::ground;
    double saturation = 0;
    int perSecond = 60;
};

class ClothHeap : public testing::TestWithParam<Case> {};

TEST_P(ClothHeap, ComesToRestWithoutCrossing) {
    const Case& of = GetParam();
    const std::vector<Fabric> fabrics = {fabrics::cottonPlain(), fabrics::denim(),
                                         fabrics::polyesterTropical(), fabrics::jersey()};
    test::SmallStepWorld rig;
    rig.bullet().addGround(0);
    if (of.base == Base::ball) rig.bullet().addBall({0, btScalar(0.12), 0}, 0.12, 0);
    constexpr auto half = btScalar(0.1);
    if (of.base == Base::box) rig.bullet().addBox({0, half, 0}, {half, half, half});
    const double top = of.base == Base::ball ? 0.24 : of.base == Base::box ? 0.2 : 0;
    std::vector<btSoftBody*> sheets;
    for (int layer = 0; layer < of.layers; ++layer) {
        const Fabric& fabric = fabrics[of.isMixed ? std::size_t(layer) % fabrics.size() : 0];
        auto sheet = test::levelSheet(rig.info(), fabric, 0.3, of.nodes, 0);
        const btQuaternion turn({0, 1, 0}, btScalar(of.angle * layer) * SIMD_RADS_PER_DEG);
        sheet->transform(
            btTransform(turn, {btScalar(of.shift * layer), btScalar(top + 0.03 * (layer + 1)), btScalar(0)}));
        sheets.push_back(&rig.add(std::move(sheet)));
        WetCloth& cloth = rig.cover(*sheets.back(), fabric);
        if (of.saturation > 0) cloth.soakPores(of.saturation * fabric.poreCapacity());
    }
    const double frame = 1.0 / of.perSecond;
    // On a ball layers slip a little for some seconds more.
    const int seconds = of.base == Base::ball ? 8 : 5;
    for (int i = 0; i < seconds * of.perSecond; ++i)
        rig.world().stepSimulation(btScalar(frame), 1, btScalar(frame));
    double fastest = 0;
    for (int i = 0; i < of.perSecond / 2; ++i) {
        rig.world().stepSimulation(btScalar(frame), 1, btScalar(frame));
        for (const btSoftBody* sheet : sheets) fastest = std::max(fastest, meanSpeed(*sheet));
    }
    EXPECT_LT(fastest, 1e-3) << "m/s";
    for (std::size_t a = 0; a < sheets.size(); ++a)
        for (std::size_t b = 0; b < sheets.size(); ++b)
            EXPECT_EQ(crossings(*sheets[a], *sheets[b]), 0) << a << " and " << b;
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ClothHeap,
    testing::Values(Case{"two", 2, 9, 0, 0, false}, Case{"three", 3, 17, 0, 0, false},
                    Case{"fine", 2, 25, 0, 0, false}, Case{"mixed", 3, 17, 30, 0, true},
                    Case{"seven", 7, 17, 0, 0, false}, Case{"sevenMixed", 7, 9, 0, 0, true},
                    Case{"sixteen", 16, 9, 0, 0, false}, Case{"turnedBy45", 2, 17, 45, 0, false},
                    Case{"turnedBy10", 3, 9, 10, 0, false}, Case{"turnedBy20", 7, 9, 20, 0, true},
                    Case{"overEdges", 3, 13, 0, 0.1, false}, Case{"overEdgesMixed", 4, 17, 33, 0.03, true},
                    Case{"onABall", 2, 9, 0, 0, false, Base::ball},
                    Case{"fineOnABall", 2, 17, 0, 0, false, Base::ball},
                    Case{"fourOnABall", 4, 9, 0, 0, false, Base::ball},
                    Case{"stairs", 5, 13, 10, 0.05, false}, Case{"onABox", 2, 9, 0, 0, false, Base::box},
                    Case{"wetOnABox", 2, 17, 0, 0, false, Base::box, 0.1},
                    Case{"wet", 3, 9, 0, 0, false, Base::ground, 0.6},
                    Case{"longSteps", 3, 9, 0, 0, false, Base::ground, 0, 30},
                    Case{"shortSteps", 3, 9, 0, 0, false, Base::ground, 0, 240}),
    [](const testing::TestParamInfo<Case>& of) { return std::string(of.param.name); });

TEST(ClothFold, LiesInTwoLayersAndRests) {
    constexpr int nodes = 33;
    constexpr double side = 0.5;
    test::SmallStepWorld rig;
    rig.bullet().addGround(0);
    btSoftBody& sheet = rig.add(test::foldedSheet(rig.info(), side, nodes));
    SheetSettings settings;
    settings.materialCoordinates = test::levelCoordinates(side, nodes);
    rig.cover(sheet, fabrics::cottonPlain(), settings);
    for (int frame = 0; frame < 240; ++frame) {
        rig.run(1.0 / 60);
        if (frame % 10 == 0) {
            ASSERT_EQ(crossings(sheet, sheet), 0) << "frame " << frame;
        }
    }
    EXPECT_LT(meanSpeed(sheet), 1e-3) << "m/s";
    // The layers keep both margins. Measured away from the fold and the free ends.
    const double margin = double(sheet.getCollisionShape()->getMargin());
    double sum = 0;
    int count = 0;
    for (int n = 0; n < sheet.m_nodes.size(); ++n) {
        const int column = n % nodes;
        if (column < nodes - 8 || column >= nodes - 2) continue;
        sum += double(sheet.m_nodes[n].m_x.y());
        ++count;
    }
    EXPECT_NEAR(sum / count - margin, 2 * margin, 0.05 * 2 * margin);
}

// How far a sheet slides in a second on a fixed sheet that is inclined by an angle, degrees; bulging by so much per square
// metre, 1/m.
double slideOnASlope(double degrees, double bulge) {
    const double angle = degrees * 3.14159265 / 180;
    test::SmallStepWorld rig;
    rig.setGravity({btScalar(9.81 * std::sin(angle)), btScalar(-9.81 * std::cos(angle)), 0});
    auto slope = test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.6, 17, 0);
    for (int n = 0; n < slope->m_nodes.size(); ++n) {
        btSoftBody::Node& node = slope->m_nodes[n];
        node.m_im = 0;
        node.m_x.setY(btScalar(-bulge) * node.m_x.length2());
        node.m_q = node.m_x;
    }
    btSoftBody& lower = rig.add(std::move(slope));
    auto sheet = test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.3, 9, 0);
    sheet->transform(btTransform(btQuaternion({0, 1, 0}, btScalar(0.25)),
                                 {btScalar(0.02), btScalar(0.02), btScalar(0.01)}));
    btSoftBody& upper = rig.add(std::move(sheet));
    for (btSoftBody* const each : {&lower, &upper}) {
        each->m_cfg.kDF = btScalar(0.25);
        rig.cover(*each, fabrics::cottonPlain(), test::withoutAir());
    }
    const auto place = [&upper] {
        btScalar sum = 0;
        for (int n = 0; n < upper.m_nodes.size(); ++n) sum += upper.m_nodes[n].m_x.x();
        return double(sum) / upper.m_nodes.size();
    };
    rig.run(0.5);
    const double before = place();
    rig.run(1);
    return place() - before;
}

// Coulomb: it slides where the slope is steeper than atan 0.25, which is 14.04 degrees.
TEST(ClothOnCloth, SticksUpToItsFrictionAndThenSlides) {
    EXPECT_NEAR(slideOnASlope(0, 0), 0, 1e-5);
    EXPECT_NEAR(slideOnASlope(13.5, 0), 0, 1e-5);
    EXPECT_NEAR(slideOnASlope(5, 1), 0, 1e-5) << "on a bulge";
    EXPECT_GT(slideOnASlope(15, 0), 0.02);
}

TEST(ClothFold, PassesThroughItselfOnlyIfSaidSo) {
    test::SmallStepWorld rig;
    rig.bullet().addGround(0);
    btSoftBody& sheet = rig.add(test::foldedSheet(rig.info(), 0.5, 17));
    SheetSettings settings;
    settings.materialCoordinates = test::levelCoordinates(0.5, 17);
    settings.meetsItself = false;
    rig.cover(sheet, fabrics::cottonPlain(), settings);
    rig.run(2);
    double highest = 0;
    for (int n = 0; n < sheet.m_nodes.size(); ++n)
        highest = std::max(highest, double(sheet.m_nodes[n].m_x.y()));
    EXPECT_LT(highest, 1.5 * double(sheet.getCollisionShape()->getMargin()));
}

TEST(ClothFold, SheetsPassEachOtherOnlyIfSaidSo) {
    test::SmallStepWorld rig;
    rig.setGravity({0, 0, 0});
    btSoftBody& lower = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.3, 9, 0));
    btSoftBody& upper = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.3, 9, 0.05));
    SheetSettings settings;
    settings.meetsSheets = false;
    rig.cover(lower, fabrics::cottonPlain());
    rig.cover(upper, fabrics::cottonPlain(), settings);
    test::setVelocity(upper, {0, -1, 0});
    rig.run(0.2);
    EXPECT_LT(test::lowest(upper), test::lowest(lower) - 0.05);
}

}  // namespace
}  // namespace drench::cloth_heap_test
