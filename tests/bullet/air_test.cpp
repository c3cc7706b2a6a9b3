#include <gtest/gtest.h>

#include "worlds.h"

namespace drench {
namespace {

/// A level square metre of free cloth without gravity, whose layer the test steps itself.
class FreeSheet {
  public:
    explicit FreeSheet(const Fabric& fabric) {
        bullet_.world().getWorldInfo().m_gravity.setZero();
        sheet_ = makeSheet(bullet_.world().getWorldInfo(), fabric,
                           flatCorners({0, 0, 0}, {1, 0, 0}, {0, 0, 1}), 9, 9);
        bullet_.world().addSoftBody(sheet_.get());
        SheetSettings settings;
        settings.stepping = Stepping::byApplication;
        cloth_ = std::make_unique<WetCloth>(bullet_.world(), *sheet_, fabric, settings);
    }
    ~FreeSheet() { bullet_.world().removeSoftBody(sheet_.get()); }

    WetCloth& cloth() { return *cloth_; }
    btSoftBody& sheet() { return *sheet_; }

    btVector3 force(double dt) {
        cloth_->preSubstep(btScalar(dt));
        btVector3 total(0, 0, 0);
        for (int n = 0; n < sheet_->m_nodes.size(); ++n) {
            total += sheet_->m_nodes[n].m_f;
            sheet_->m_nodes[n].m_f.setZero();
        }
        return total;
    }

  private:
    demo::BulletWorld bullet_;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
};

Fabric airtight() {
    Fabric fabric = fabrics::cottonPlain();
    fabric.airPermeabilityDry = 0;
    fabric.airPermeabilitySaturated = 0;
    return fabric;
}

TEST(Air, DragOfAFlatSheetGrowsWithTheSquareOfSpeed) {
    FreeSheet rig(airtight());
    for (const double speed : {0.5, 2.0, 5.0, 30.0}) {
        rig.cloth().air().wind = {0, speed, 0};
        // 1/2 rho C_n A u^2; a very short step, so that the limiter has nothing to limit.
        EXPECT_NEAR(double(rig.force(1e-7).y()), 0.5 * 1.2 * 1.2 * speed * speed,
                    0.002 * 0.72 * speed * speed);
        rig.cloth().air().wind = {speed, 0, 0};
        EXPECT_NEAR(double(rig.force(1e-7).x()), 0.5 * 1.2 * 0.03 * speed * speed,
                    0.002 * 0.018 * speed * speed);
    }
}

TEST(Air, APermeableSheetLetsSomeThroughAndAWetOneLess) {
    Fabric gauze = fabrics::cottonPlain();
    gauze.airPermeabilityDry = 5;
    gauze.airPermeabilitySaturated = 0;
    FreeSheet rig(gauze);
    rig.cloth().air().wind = {0, 5, 0};
    const double dry = double(rig.force(1e-7).y());
    // Solve v = u - (5 / 100) * 0.72 v^2 by hand: v = 4.3262 m/s, pressure 13.476 Pa.
    EXPECT_NEAR(dry, 13.476, 0.01);
    rig.cloth().soak(gauze.poreCapacity());
    for (int i = 0; i < 30; ++i) rig.force(1);
    EXPECT_NEAR(double(rig.force(1e-7).y()), 0.72 * 25, 0.05);
}

TEST(Air, DragStopsRelativeMotionButNeverTurnsIt) {
    for (const double speed : {1.0, 10.0, 60.0}) {
        FreeSheet rig(airtight());
        rig.cloth().air().wind = {0, speed, 0};
        double before = 0;
        for (int i = 0; i < 200; ++i) {
            rig.cloth().preSubstep(btScalar(1.0 / 30));
            double fastest = -1e9, slowest = 1e9;
            for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) {
                btSoftBody::Node& node = rig.sheet().m_nodes[n];
                node.m_v += node.m_f * node.m_im / 30;
                node.m_f.setZero();
                fastest = std::max(fastest, double(node.m_v.y()));
                slowest = std::min(slowest, double(node.m_v.y()));
            }
            EXPECT_LE(fastest, speed * (1 + 1e-5)) << "after step " << i;
            EXPECT_GE(slowest, before - 1e-5 * speed) << "after step " << i;
            before = slowest;
        }
        EXPECT_GT(before, 0.8 * speed);
    }
}

}  // namespace
}  // namespace drench
