#include "drench/sheet.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "bullet/world/worlds.h"

namespace drench::sheet_test {
namespace {

TEST(MakeSheet, HasTheLinksFacesAndMassesOfItsGrid) {
    demo::BulletWorld bullet;
    const int n = 12, m = 9;
    const auto sheet = makeSheet(bullet.world().getWorldInfo(), fabrics::cottonPlain(),
                                 flatCorners({0, 0, 0}, {btScalar(1.1), 0, 0}, {0, 0, btScalar(0.8)}), n, m);
    EXPECT_EQ(sheet->m_nodes.size(), n * m);
    EXPECT_EQ(sheet->m_faces.size(), 2 * (n - 1) * (m - 1));
    int bending = 0;
    for (int i = 0; i < sheet->m_links.size(); ++i) bending += sheet->m_links[i].m_bbending ? 1 : 0;
    EXPECT_EQ(bending, (n - 2) * m + n * (m - 2));
    EXPECT_EQ(sheet->m_links.size() - bending, (n - 1) * m + n * (m - 1) + 2 * (n - 1) * (m - 1));
    double total = 0;
    for (int i = 0; i < sheet->m_nodes.size(); ++i) total += test::mass(sheet->m_nodes[i]);
    EXPECT_NEAR(total, 0.150 * 1.1 * 0.8, 1e-6);
    // An inner node stands for one cell.
    EXPECT_NEAR(test::mass(sheet->m_nodes[5 + n * 4]), 0.150 * 0.1 * 0.1, 1e-8);
}

TEST(MakeSheet, LinksComeInColours) {
    demo::BulletWorld bullet;
    const auto sheet = test::hangingSheet(bullet.world().getWorldInfo(), fabrics::cottonPlain(), 1, 20);
    // Walk the links; a colour ends where a node comes up again.
    int colours = 1;
    std::set<const btSoftBody::Node*> used;
    for (int i = 0; i < sheet->m_links.size(); ++i)
        for (const btSoftBody::Node* node : sheet->m_links[i].m_n)
            if (!used.insert(node).second) {
                ++colours;
                used = {sheet->m_links[i].m_n[0], sheet->m_links[i].m_n[1]};
                break;
            }
    EXPECT_LE(colours, 14);  // 12 links meet at an inner node, so 12 is the least
}

TEST(MakeSheet, RefinesTheDistanceFieldOnlyWhereItIsTooCoarse) {
    demo::BulletWorld bullet;
    btSoftBodyWorldInfo& info = bullet.world().getWorldInfo();
    EXPECT_EQ(info.m_sparsesdf.voxelsz, btScalar(0.25));
    test::hangingSheet(info, fabrics::cottonPlain(), 0.64, 17);  // cells of 40 mm
    EXPECT_NEAR(info.m_sparsesdf.voxelsz, 0.02, 1e-6);
    test::hangingSheet(info, fabrics::cottonPlain(), 1.28, 17);
    EXPECT_NEAR(info.m_sparsesdf.voxelsz, 0.02, 1e-6);
}

TEST(MakeSheet, RefusesWhatIsNoSheet) {
    demo::BulletWorld bullet;
    btSoftBodyWorldInfo& info = bullet.world().getWorldInfo();
    const Corners good = flatCorners({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    const Fabric cotton = fabrics::cottonPlain();
    EXPECT_THROW(makeSheet(info, cotton, good, 1, 10), std::invalid_argument);
    EXPECT_THROW(makeSheet(info, cotton, good, 10, 10001), std::invalid_argument);
    EXPECT_THROW(makeSheet(info, cotton, flatCorners({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 10, 10),
                 std::invalid_argument);
    for (const btVector3& where : {good.origin, good.warpEnd, good.weftEnd}) {
        Corners folded = good;
        folded.opposite = where;
        EXPECT_THROW(makeSheet(info, cotton, folded, 2, 2), std::invalid_argument);
    }
    Corners notFinite = good;
    notFinite.opposite.setX(std::numeric_limits<btScalar>::quiet_NaN());
    EXPECT_THROW(makeSheet(info, cotton, notFinite, 10, 10), std::invalid_argument);
    Fabric bad = cotton;
    bad.arealDensity = -1;
    EXPECT_THROW(makeSheet(info, bad, good, 10, 10), std::invalid_argument);
    EXPECT_EQ(info.m_sparsesdf.voxelsz, btScalar(0.25));  // and nothing was changed on the way
}

}  // namespace
}  // namespace drench::sheet_test
