// The mouse tools: holding cloth, the hose, the towel.
#include "hand/hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "hand/wetting.h"
#include "stage/stage.h"
#include "world/vectors.h"

namespace drench::demo::hand_test {
namespace {

constexpr double frameTime = Scene::frameTime;

struct Kind {
    const char* name;
    WorldKind world;
    SolverKind solver;
};
std::ostream& operator<<(std::ostream& out, const Kind& kind) {
    return out << kind.name;
}
constexpr Kind smallSteps{"SmallSteps", WorldKind::softRigid, SolverKind::smallStep};
constexpr Kind stock{"Stock", WorldKind::softRigid, SolverKind::stock};
constexpr Kind deformable{"Deformable", WorldKind::deformable, SolverKind::stock};

// A square metre of cotton that hangs by its upper corners, or lies in the air, and a hand.
class Rig {
  public:
    explicit Rig(const Kind& kind, double saturation = 0) : stage_(description(kind, saturation)) {}

    Stage& stage() { return stage_; }
    SceneCloth& sheet() { return stage_.sheet("sheet"); }
    WetCloth& cloth() { return sheet().wet(); }
    Hand& hand() { return hand_; }

    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            hand_.act({{&stage_.world(), &sheet().body(), &sheet().wet()}}, pointer_, frameTime);
            stage_.step(frameTime);
        }
    }
    // Points from 3 m before the sheet at a place in its plane.
    void point(double x, double y, bool pressed, Tool tool = Tool::hand) {
        pointer_.pressed = pressed;
        pointer_.tool = tool;
        pointer_.ray.origin = {0, 1, 3};
        pointer_.ray.direction = (Eigen::Vector3f(float(x), float(y), 0) - pointer_.ray.origin).normalized();
        pointer_.forward = {0, 0, -1};
    }
    int pins() {
        int count = 0;
        for (int n = 0; n < sheet().body().m_nodes.size(); ++n)
            count += sheet().body().m_nodes[n].m_im > 0 ? 0 : 1;
        return count;
    }
    double fastest() {
        double speed = 0;
        for (int n = 0; n < sheet().body().m_nodes.size(); ++n)
            speed = std::max(speed, double(sheet().body().m_nodes[n].m_v.length()));
        return speed;
    }
    // Of a stretch link.
    double largestStrain() {
        double largest = 0;
        const btSoftBody& body = sheet().body();
        for (int l = 0; l < body.m_links.size(); ++l) {
            const btSoftBody::Link& link = body.m_links[l];
            if (link.m_bbending) continue;
            largest =
                std::max(largest, double((link.m_n[1]->m_x - link.m_n[0]->m_x).length() / link.m_rl) - 1);
        }
        return largest;
    }
    double imbalance() {
        const Ledger ledger = cloth().ledger();
        return std::abs(ledger.imbalance()) / std::max(ledger.supplied, 1e-9);
    }
    Account account(const std::string& name) {
        for (const Account& account : cloth().ledger().accounts)
            if (account.name == name) return account;
        return {};
    }

  private:
    static SceneDescription description(const Kind& kind, double saturation) {
        SceneDescription scene;
        scene.solver.world = kind.world;
        scene.solver.solver = kind.solver;
        SheetDescription sheet;
        sheet.nodes = {15, 15};
        sheet.pins = {{0, 0}, {-1, 0}};
        sheet.saturation = saturation;
        sheet.damping = 1;
        scene.sheets.push_back(sheet);
        SolidDescription ground;
        ground.shape = SolidDescription::Shape::ground;
        ground.position = {0, 0, 0};
        scene.solids.push_back(ground);
        return scene;
    }

    Stage stage_;
    Hand hand_;
    Pointer pointer_;
};

class HandWithSolver : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(Solvers, HandWithSolver, testing::Values(smallSteps, stock, deformable),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(HandWithSolver, TakesClothAlongAndLetsGo) {
    Rig rig(GetParam());
    rig.frames(60);
    rig.point(0, 0.8, true);
    rig.frames(1);
    EXPECT_GT(rig.pins(), 4);
    rig.point(0.1, 0.9, true);
    rig.frames(60);
    // The middle of the sheet, where it was taken hold of, is where the pointer is.
    const auto held = rig.sheet().body().m_nodes[7 + 10 * 15].m_x;
    EXPECT_NEAR(held.x(), 0.1, 0.06);
    EXPECT_NEAR(held.y(), 0.9, 0.06);

    rig.point(0.1, 0.9, false);
    rig.frames(1);
    EXPECT_EQ(rig.pins(), 2);
    rig.frames(90);
    EXPECT_LT(rig.fastest(), 2.5);
    EXPECT_LT(std::abs(rig.sheet().centre().x()), 0.1);
}

TEST_P(HandWithSolver, StandsAMouseThatJumps) {
    Rig rig(GetParam(), 1);
    rig.frames(30);
    const double positions[][2] = {{0, 0.8}, {8, 5}, {-8, -3}, {0.1, 40}, {3, 1}, {-0.4, 0.4}};
    for (const auto& position : positions) {
        rig.point(position[0], position[1], true);
        rig.frames(20);
        EXPECT_TRUE(rig.cloth().health().finite);
        EXPECT_LT(rig.largestStrain(), 1.2) << position[0] << ", " << position[1];
    }
    rig.point(0, 0, false);
    for (int frame = 0; frame < 60; ++frame) {
        rig.frames(1);
        EXPECT_LT(rig.fastest(), 15) << frame;
    }
    rig.frames(120);
    EXPECT_LT(rig.fastest(), 2);
    EXPECT_LT(rig.imbalance(), 1e-9);
}

TEST(Hand, LetsGoWhenToldAndTakesHoldAgainOnlyWithANewPress) {
    Rig rig(smallSteps);
    const int before = rig.pins();
    rig.point(0, 1, true);
    rig.frames(3);
    EXPECT_GT(rig.pins(), before);
    rig.hand().letGo();
    EXPECT_EQ(rig.pins(), before);
    EXPECT_EQ(rig.sheet().describe().pins.size(), std::size_t(before));
    rig.frames(3);
    EXPECT_EQ(rig.pins(), before);
}

TEST(Hand, StopsAtTheGround) {
    Rig rig(smallSteps);
    rig.frames(10);
    rig.point(0, 0.55, true);
    rig.frames(10);
    rig.point(0, -2, true);
    rig.frames(120);
    EXPECT_GT(rig.sheet().lowest(), -0.01);
}

TEST(Hand, LeavesASceneAloneThatItDoesNotTouch) {
    Rig touched(smallSteps), alone(smallSteps);
    touched.point(5, 5, true);  // beside the sheet
    touched.frames(30);
    for (int i = 0; i < 30; ++i) alone.stage().step(frameTime);
    for (int n = 0; n < alone.sheet().body().m_nodes.size(); ++n)
        ASSERT_EQ(touched.sheet().body().m_nodes[n].m_x, alone.sheet().body().m_nodes[n].m_x);
}

TEST(Hand, GoesOnAfterTheSheetThatItHeldIsGone) {
    Hand hand;
    Pointer pointer;
    pointer.pressed = true;
    pointer.ray = {{0, 1, 3}, {0, 0, -1}};
    {
        Rig rig(smallSteps);
        hand.act({{&rig.stage().world(), &rig.sheet().body(), &rig.cloth()}}, pointer, frameTime);
        EXPECT_GT(rig.pins(), 4);
    }
    hand.act({}, pointer, frameTime);
    pointer.pressed = false;
    hand.act({}, pointer, frameTime);
}

TEST_P(HandWithSolver, HoseWetsWhereItPointsInTheSheetsOwnTime) {
    double brought[2];
    for (const double waterSpeed : {1.0, 100.0}) {
        Rig rig(GetParam());
        rig.cloth().air().humidity = 0.65;
        rig.cloth().setWaterSpeed(waterSpeed);
        rig.point(0.2, 0.9, true, Tool::hose);
        rig.frames(30);
        rig.point(0.2, 0.9, false, Tool::hose);
        brought[waterSpeed > 1] = rig.account("hose").supplied;
        rig.frames(30);
        EXPECT_EQ(rig.account("hose").supplied, brought[waterSpeed > 1]);
        EXPECT_LT(rig.imbalance(), 1e-9);
        EXPECT_TRUE(rig.cloth().health().finite);
    }
    // Half a second of 0.1 kg/s, part of which may pass the sheet by.
    EXPECT_GT(brought[0], 0.02);
    EXPECT_LT(brought[0], 0.051);
    EXPECT_NEAR(brought[1], brought[0], 0.3 * brought[0]);
}

TEST(Hand, HosePushesTheSheetAway) {
    Rig rig(smallSteps);
    rig.frames(30);
    const double before = double(rig.sheet().centre().z());
    rig.point(0, 0.8, true, Tool::hose);
    rig.frames(30);
    EXPECT_LT(double(rig.sheet().centre().z()), before - 0.02);
}

TEST(Hand, TowelTakesWaterWhereItDabs) {
    Rig rig(smallSteps, 1);
    rig.cloth().soakFilm(0.05);
    rig.frames(5);
    const double before = rig.cloth().waterMass();
    rig.point(0, 1, true, Tool::towel);
    rig.frames(60);
    const Account towel = rig.account("towel");
    EXPECT_EQ(towel.supplied, 0);
    EXPECT_GT(towel.returned, 0.002);
    EXPECT_LT(towel.returned, 0.2 * before);
    EXPECT_LT(rig.cloth().saturation(7 + 7 * 15), 0.4);
    EXPECT_GT(rig.cloth().saturation(2 + 13 * 15), 0.9);
    EXPECT_LT(rig.imbalance(), 1e-9);
}

TEST(Wetting, GivesEachNodeItsShare) {
    Rig rig(smallSteps, 0.2);
    rig.cloth().soakFilm(0.05);
    for (const double fraction : {0.7, 0.3, 0.0, 1.0}) {
        wetTo(rig.cloth(), fraction);
        for (int n = 0; n < rig.sheet().body().m_nodes.size(); ++n)
            ASSERT_NEAR(rig.cloth().saturation(n), fraction, 1e-9);
        EXPECT_EQ(rig.cloth().moisture().totalFilmMass(), 0);
        EXPECT_LT(rig.imbalance(), 1e-12);
    }
}

}  // namespace
}  // namespace drench::demo::hand_test
