// What a layer refuses, with a message that names the value and says how to mend it, and the body as it was.
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "bullet/world/worlds.h"

namespace drench::refusal_test {
namespace {

// The message with which attaching is refused; fails the test if it is not, or if the body has changed.
std::string refusal(demo::BulletWorld& bullet, btSoftBody& body,
                    const Fabric& fabric = fabrics::cottonPlain(), const SheetSettings& settings = {}) {
    const btScalar inverseMass = body.m_nodes[1].m_im, drag = body.m_cfg.kDG;
    const bool waiting = body.m_bUpdateRtCst;
    const btCollisionShape* shape = body.getCollisionShape();
    std::string message;
    try {
        WetCloth cloth(bullet.world(), body, fabric, settings);
        ADD_FAILURE() << "attached";
    } catch (const std::invalid_argument& problem) {
        message = problem.what();
    }
    EXPECT_EQ(body.m_nodes[1].m_im, inverseMass);
    EXPECT_EQ(body.m_cfg.kDG, drag);
    EXPECT_EQ(body.m_bUpdateRtCst, waiting);
    EXPECT_EQ(body.getCollisionShape(), shape);
    return message;
}

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(Refusal, BodiesThatAreNoCloth) {
    demo::BulletWorld bullet;
    btSoftBodyWorldInfo& info = bullet.world().getWorldInfo();

    const btVector3 points[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    btSoftBody rope(&info, 3, points, nullptr);
    rope.appendLink(0, 1);
    EXPECT_CONTAINS(refusal(bullet, rope), "no faces");

    btSoftBody loose(&info, 3, points, nullptr);
    loose.m_nodes[2].m_x = {0, 1, 0};
    loose.appendFace(0, 1, 2);
    EXPECT_CONTAINS(refusal(bullet, loose), "no links");

    const auto clustered = test::smallSheet(info);
    clustered->generateClusters(4);
    EXPECT_CONTAINS(refusal(bullet, *clustered), "clusters");

    const auto byClusters = test::smallSheet(info);
    byClusters->m_cfg.collisions = btSoftBody::fCollision::CL_RS;
    EXPECT_CONTAINS(refusal(bullet, *byClusters), "clusters");

    const auto broken = test::smallSheet(info);
    broken->m_nodes[7].m_x.setX(std::numeric_limits<btScalar>::quiet_NaN());
    EXPECT_CONTAINS(refusal(bullet, *broken), "node 7");

    const auto doubled = test::smallSheet(info);
    doubled->m_nodes[21].m_x = doubled->m_nodes[20].m_x;
    EXPECT_CONTAINS(refusal(bullet, *doubled), "no area");
}

TEST(Refusal, WhatWouldCountTwice) {
    demo::BulletWorld bullet;
    btSoftBodyWorldInfo& info = bullet.world().getWorldInfo();
    const auto backFaces = test::smallSheet(info);
    const auto nodeOf = [&](int corner) {
        return int(backFaces->m_faces[0].m_n[corner] - &backFaces->m_nodes[0]);
    };
    backFaces->appendFace(nodeOf(2), nodeOf(1), nodeOf(0));
    EXPECT_CONTAINS(refusal(bullet, *backFaces), "as an earlier one does");
    const auto doubled = test::smallSheet(info);
    doubled->appendLink(1, 0);
    EXPECT_CONTAINS(refusal(bullet, *doubled), "twice as stiff");
    const auto endless = test::smallSheet(info);
    bullet.world().addSoftBody(endless.get());
    bullet.step(0.01, 1);
    endless->m_links[4].m_rl = std::numeric_limits<btScalar>::infinity();
    EXPECT_CONTAINS(refusal(bullet, *endless), "link 4");
    bullet.world().removeSoftBody(endless.get());
}

TEST(Refusal, WorldsInWhichTheSheetFloatsOrSinks) {
    demo::BulletWorld bullet;
    btSoftBodyWorldInfo& info = bullet.world().getWorldInfo();
    const auto sheet = test::smallSheet(info);

    info.m_sparsesdf.setDefaultVoxelsz(btScalar(0.25));
    info.m_sparsesdf.Reset();
    EXPECT_CONTAINS(refusal(bullet, *sheet), "setDefaultVoxelsz");
    {  // a body with a world info of its own, which is the one that Bullet looks into
        btSoftBodyWorldInfo own;
        own.m_sparsesdf.Initialize();
        const auto other = test::smallSheet(own);
        const WetCloth cloth(bullet.world(), *other, fabrics::cottonPlain());
    }
    info.m_sparsesdf.setDefaultVoxelsz(btScalar(0.02));
    info.m_sparsesdf.Reset();

    const btScalar margin = sheet->getCollisionShape()->getMargin();
    sheet->getCollisionShape()->setMargin(btScalar(0.25));
    EXPECT_CONTAINS(refusal(bullet, *sheet), "setMargin");
    sheet->getCollisionShape()->setMargin(margin);

    btStaticPlaneShape plane({0, 1, 0}, 0);
    btCollisionObject ground;
    ground.setCollisionShape(&plane);
    bullet.world().addCollisionObject(&ground);
    EXPECT_CONTAINS(refusal(bullet, *sheet), "plane");
    bullet.world().removeCollisionObject(&ground);
    {  // one that comes later
        bullet.world().addSoftBody(sheet.get());
        const WetCloth cloth(bullet.world(), *sheet, fabrics::cottonPlain());
        bullet.step(0.01, 1);
        bullet.world().addCollisionObject(&ground);
        EXPECT_THROW(bullet.step(0.01, 1), std::invalid_argument);
        EXPECT_THROW(bullet.step(0.01, 1), std::invalid_argument);
        bullet.world().removeCollisionObject(&ground);
        bullet.step(0.01, 1);
        bullet.world().removeSoftBody(sheet.get());
    }
    // One that the sheet cannot meet does no harm.
    bullet.world().addCollisionObject(&ground, 2, 2);
    bullet.world().addSoftBody(sheet.get(), 1, 1);
    { WetCloth cloth(bullet.world(), *sheet, fabrics::cottonPlain()); }
    bullet.world().removeSoftBody(sheet.get());
    bullet.world().removeCollisionObject(&ground);
}

TEST(Refusal, SettingsAndFabricsOutOfRange) {
    demo::BulletWorld bullet;
    const auto sheet = test::smallSheet(bullet.world().getWorldInfo());
    Fabric bad = fabrics::cottonPlain();
    bad.stretchWarp = std::numeric_limits<double>::quiet_NaN();
    EXPECT_CONTAINS(refusal(bullet, *sheet, bad), "stretchWarp");

    SheetSettings settings;
    settings.waterSpeed = -1;
    EXPECT_CONTAINS(refusal(bullet, *sheet, fabrics::cottonPlain(), settings), "waterSpeed");
    settings.waterSpeed = std::numeric_limits<double>::quiet_NaN();
    EXPECT_CONTAINS(refusal(bullet, *sheet, fabrics::cottonPlain(), settings), "waterSpeed");
    settings.waterSpeed = 1;
    settings.materialCoordinates.assign(3, {0, 0});
    EXPECT_CONTAINS(refusal(bullet, *sheet, fabrics::cottonPlain(), settings),
                    "3 material coordinates for 289 nodes");
    settings.materialCoordinates.assign(289, {0, 0});
    EXPECT_CONTAINS(refusal(bullet, *sheet, fabrics::cottonPlain(), settings), "material coordinates");
}

TEST(Refusal, ASecondLayerOnTheSameBody) {
    demo::BulletWorld bullet;
    const auto sheet = test::smallSheet(bullet.world().getWorldInfo());
    WetCloth cloth(bullet.world(), *sheet, fabrics::cottonPlain());
    EXPECT_CONTAINS(refusal(bullet, *sheet), "has a WetCloth already");
}

TEST(Refusal, ASleeveNeedsItsMaterialCoordinates) {
    demo::BulletWorld bullet;
    constexpr int around = 24, along = 12;
    constexpr double radius = 0.1, spacing = 0.025;
    std::vector<btVector3> points;
    std::vector<Eigen::Vector2d> coordinates;
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * 3.14159265358979 * i / around;
            points.emplace_back(btScalar(radius * std::cos(angle)), btScalar(1 - spacing * j),
                                btScalar(radius * std::sin(angle)));
        }
    btSoftBody sleeve(&bullet.world().getWorldInfo(), around * along, points.data(), nullptr);
    sleeve.getCollisionShape()->setMargin(btScalar(0.005));
    bullet.world().getWorldInfo().m_sparsesdf.setDefaultVoxelsz(btScalar(0.02));
    bullet.world().getWorldInfo().m_sparsesdf.Reset();
    for (int j = 0; j + 1 < along; ++j)
        for (int i = 0; i < around; ++i) {
            const int a = i + around * j, b = (i + 1) % around + around * j, c = b + around, d = a + around;
            sleeve.appendLink(a, b);
            sleeve.appendLink(a, d);
            sleeve.appendLink(a, c);
            sleeve.appendFace(a, b, c);
            sleeve.appendFace(a, c, d);
        }
    EXPECT_CONTAINS(refusal(bullet, sleeve), "SheetSettings::materialCoordinates");
}

}  // namespace
}  // namespace drench::refusal_test
