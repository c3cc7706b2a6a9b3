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

// Number of edges of one sheet that pass through faces of the other.
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
            bool isApart = false;
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

enum class Base { ground, ball };

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
    const double top = of.base == Base::ball ? 0.24 : 0;
    std::vector<btSoftBody*> sheets;
    for (int layer = 0; layer < of.layers; ++layer) {
        const Fabric& fabric = fabrics[of.isMixed ? std::size_t(layer) % fabrics.size() : 0];
        auto sheet = test::levelSheet(rig.info(), fabric, 0.3, of.nodes, 0);
        sheet->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
        const btQuaternion turn({0, 1, 0}, btScalar(of.angle * layer) * SIMD_RADS_PER_DEG);
        sheet->transform(
            btTransform(turn, {btScalar(of.shift * layer), btScalar(top + 0.03 * (layer + 1)), btScalar(0)}));
        sheets.push_back(&rig.add(std::move(sheet)));
        WetCloth& cloth = rig.cover(*sheets.back(), fabric);
        if (of.saturation > 0) cloth.soakPores(of.saturation * fabric.poreCapacity());
    }
    const double frame = 1.0 / of.perSecond;
    for (int i = 0; i < 5 * of.perSecond; ++i)
        rig.world().stepSimulation(btScalar(frame), 1, btScalar(frame));
    double fastest = 0;
    for (int i = 0; i < of.perSecond / 2; ++i) {
        rig.world().stepSimulation(btScalar(frame), 1, btScalar(frame));
        for (const btSoftBody* sheet : sheets) fastest = std::max(fastest, meanSpeed(*sheet));
    }
    EXPECT_LT(fastest, 1e-3) << "m/s";
    for (std::size_t a = 0; a < sheets.size(); ++a)
        for (std::size_t b = 0; b < sheets.size(); ++b)
            EXPECT_EQ(a == b ? 0 : crossings(*sheets[a], *sheets[b]), 0) << a << " and " << b;
}

INSTANTIATE_TEST_SUITE_P(Cases, ClothHeap,
                         testing::Values(Case{"two", 2, 9, 0, 0, false}, Case{"three", 3, 17, 0, 0, false},
                                         Case{"fine", 2, 25, 0, 0, false}, Case{"mixed", 3, 17, 30, 0, true},
                                         Case{"turnedBy45", 2, 17, 45, 0, false},
                                         Case{"onABall", 2, 9, 0, 0, false, Base::ball},
                                         Case{"wet", 3, 9, 0, 0, false, Base::ground, 0.6},
                                         Case{"longSteps", 3, 9, 0, 0, false, Base::ground, 0, 30},
                                         Case{"shortSteps", 3, 9, 0, 0, false, Base::ground, 0, 240}),
                         [](const testing::TestParamInfo<Case>& of) { return std::string(of.param.name); });

// A tree of faces costs time in each substep.
TEST(ClothHeapTrees, ASheetFarFromOthersHasNoTreeOfFaces) {
    test::SmallStepWorld rig;
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.3, 9, 0));
    btSoftBody& far = rig.add(test::levelSheet(rig.info(), fabrics::cottonPlain(), 0.3, 9, 3));
    for (btSoftBody* body : {&sheet, &far}) body->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
    for (btSoftBody* each : {&sheet, &far}) rig.cover(*each, fabrics::cottonPlain());
    rig.run(0.1);
    EXPECT_TRUE(sheet.m_fdbvt.empty());
    far.translate({0, btScalar(-2.98), 0});
    rig.run(0.1);
    EXPECT_FALSE(sheet.m_fdbvt.empty());
}

}  // namespace
}  // namespace drench::cloth_heap_test
