// The trees in which Bullet looks for nodes and faces: as complete as Bullet's own, and shallow however large the sheet.
#include <gtest/gtest.h>

#include <set>

#include "bullet/sheet/face_tree.h"
#include "bullet/world/worlds.h"

namespace drench::tree_test {
namespace {

std::unique_ptr<btSoftBody> largeSheet(btSoftBodyWorldInfo& info, int nodes) {
    return makeSheet(info, fabrics::cottonPlain(), flatCorners({0, 0, 0}, {1, 0, 0}, {0, 0, 1}), nodes,
                     nodes);
}

// What the leaves of a tree stand for.
std::set<const void*> dataOf(const btDbvtNode* node) {
    if (!node) return {};
    if (node->isleaf()) return {node->data};
    std::set<const void*> data = dataOf(node->childs[0]), others = dataOf(node->childs[1]);
    data.merge(others);
    return data;
}

// Whether each node of a tree contains what is below it, and knows its parent.
bool isSound(const btDbvtNode& node) {
    if (node.isleaf()) return true;
    for (const btDbvtNode* child : node.childs)
        if (child->parent != &node || !node.volume.Contain(child->volume) || !isSound(*child)) return false;
    return true;
}

TEST(Tree, NodesOfAMadeSheetAreFoundWhereTheyAre) {
    demo::BulletWorld bullet;
    constexpr int side = 150;
    const auto sheet = largeSheet(bullet.worldInfo(), side);
    EXPECT_LT(btDbvt::maxdepth(sheet->m_ndbvt.m_root), 60) << "row by row it is over a thousand";
    EXPECT_TRUE(isSound(*sheet->m_ndbvt.m_root));
    EXPECT_EQ(dataOf(sheet->m_ndbvt.m_root).size(), std::size_t{side * side});
    for (int n = 0; n < sheet->m_nodes.size(); ++n) {
        const btSoftBody::Node& node = sheet->m_nodes[n];
        ASSERT_EQ(node.m_leaf->data, &node);
        ASSERT_LT(double((node.m_leaf->volume.Center() - node.m_x).length()), 1e-6);
        ASSERT_EQ(node.m_x, node.m_q);
        ASSERT_EQ(node.m_x, sheet->m_X[n]);
    }
    EXPECT_NEAR(double(sheet->m_nodes[side + 2].m_x.x()), 2.0 / (side - 1), 1e-6);
    EXPECT_NEAR(double(sheet->m_nodes[side + 2].m_x.z()), 1.0 / (side - 1), 1e-6);
}

TEST(Tree, OfFacesHasAllFacesAndIsAsShallowAsCanBe) {
    demo::BulletWorld bullet;
    const auto sheet = largeSheet(bullet.worldInfo(), 65);
    makeFaceTree(*sheet);
    const int faces = sheet->m_faces.size();
    EXPECT_EQ(btDbvt::maxdepth(sheet->m_fdbvt.m_root), 14) << "2^13 faces";
    EXPECT_EQ(sheet->m_fdbvt.m_leaves, faces);
    EXPECT_TRUE(isSound(*sheet->m_fdbvt.m_root));
    EXPECT_EQ(dataOf(sheet->m_fdbvt.m_root).size(), std::size_t(faces));
    for (int f = 0; f < faces; ++f) ASSERT_EQ(sheet->m_faces[f].m_leaf->data, &sheet->m_faces[f]);
    EXPECT_NE(sheet->m_fdbvnt, nullptr);
    makeFaceTree(*sheet);  // once more in place of the first
    dropFaceTree(*sheet);
    EXPECT_TRUE(sheet->m_fdbvt.empty());
    EXPECT_EQ(sheet->m_faces[0].m_leaf, nullptr);
}

// With Bullet's own trees this never ends.
TEST(Tree, ClothInTwoPiecesCollidesWithOtherCloth) {
    test::SmallStepWorld rig;
    const Fabric fabric = fabrics::cottonPlain();
    btSoftBody& sheet = rig.add(test::levelSheet(rig.info(), fabric, 0.5, 9, 0.02));
    btSoftBody& below = rig.add(test::levelSheet(rig.info(), fabric, 0.5, 9, 0));
    for (int n = 0; n < below.m_nodes.size(); ++n) below.m_nodes[n].m_im = 0;
    for (btSoftBody* body : {&sheet, &below}) body->m_cfg.collisions |= btSoftBody::fCollision::VF_SS;
    const auto column = [&](const btSoftBody::Node* node) { return int(node - &sheet.m_nodes[0]) % 9; };
    const auto crosses = [&](auto& part, int corners) {
        int left = 0;
        for (int k = 0; k < corners; ++k) left += column(part.m_n[k]) < 4;
        return left > 0 && left < corners;
    };
    for (int i = sheet.m_links.size(); i-- > 0;)
        if (crosses(sheet.m_links[i], 2)) {
            sheet.m_links.swap(i, sheet.m_links.size() - 1);
            sheet.m_links.pop_back();
        }
    for (int i = sheet.m_faces.size(); i-- > 0;)
        if (crosses(sheet.m_faces[i], 3)) {
            sheet.m_faces.swap(i, sheet.m_faces.size() - 1);
            sheet.m_faces.pop_back();
        }
    const WetCloth& cloth = rig.cover(sheet, fabric);
    rig.cover(below, fabric);
    rig.run(0.5);
    EXPECT_TRUE(cloth.health().finite);
    EXPECT_GT(test::lowest(sheet), 0);
}

}  // namespace
}  // namespace drench::tree_test
