// Two sheets that Bullet's own solvers move: contact, wet friction and cling between them.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "wet_contact_rig.h"
#include "world/deformable_world.h"

namespace drench::cloth_on_cloth_test {
namespace {

using test::gravity;

enum class Path { stock, explicitSteps, implicitSteps };

std::unique_ptr<demo::SceneWorld> worldFor(Path path) {
    if (path == Path::stock) return demo::makeWorld(demo::WorldKind::softRigid, demo::SolverKind::stock);
    auto world = std::make_unique<demo::DeformableWorld>();
    world->world().setImplicit(path == Path::implicitSteps);
    world->world().setUseProjection(path == Path::implicitSteps);
    return world;
}

// Two level sheets above each other in a world of their own, in air that moves along with them.
class TwoSheets {
  public:
    TwoSheets(Path path, const Fabric& fabric, double spacing, int nodesAbove, int nodesBelow)
        : path_(path), fabric_(fabric), world_(worldFor(path)) {
        int nodes = nodesAbove;
        for (auto& sheet : sheets_) {
            sheet = test::levelSheet(world_->worldInfo(), fabric, spacing * (nodes - 1), nodes, 0);
            sheet->m_cfg.collisions |=
                path == Path::stock ? btSoftBody::fCollision::VF_SS : btSoftBody::fCollision::VF_DD;
            nodes = nodesBelow;
        }
        lower().translate({0, -2 * margin() + btScalar(5e-4), 0});
    }
    ~TwoSheets() {
        for (std::size_t i : {0u, 1u}) remove(i);
    }
    TwoSheets(const TwoSheets&) = delete;
    TwoSheets& operator=(const TwoSheets&) = delete;

    demo::SceneWorld& world() { return *world_; }
    btSoftBody& upper() { return *sheets_[0]; }
    btSoftBody& lower() { return *sheets_[1]; }
    btScalar margin() { return upper().getCollisionShape()->getMargin(); }

    void endGravity() {
        world_->world().setGravity({0, 0, 0});
        world_->worldInfo().m_gravity = {0, 0, 0};
        falls_ = false;
    }
    static void hold(btSoftBody& sheet) {
        for (int n = 0; n < sheet.m_nodes.size(); ++n) sheet.m_nodes[n].m_im = 0;
    }

    // Has both meet, with water that neither dries nor runs.
    void begin(double saturationAbove, double saturationBelow) {
        SheetSettings settings;
        settings.waterSpeed = 0;
        for (std::size_t i : {0u, 1u}) {
            btSoftBody& sheet = *sheets_[i];
            if (path_ != Path::stock && !falls_)
                static_cast<demo::DeformableWorld&>(*world_).world().addSoftBody(&sheet);
            else
                world_->addSoftBody(sheet);
            cloths_[i] = std::make_unique<WetCloth>(world_->world(), sheet, fabric_, settings);
            const double saturation = i == 0 ? saturationAbove : saturationBelow;
            if (saturation > 0) cloths_[i]->soakPores(saturation * fabric_.poreCapacity());
        }
    }

    int substeps() const {
        return path_ == Path::explicitSteps ? static_cast<int>(std::ceil(1 / cloths_[1]->stepBound())) : 240;
    }
    void run(double time) {
        const int perSecond = substeps(), steps = static_cast<int>(std::lround(time * perSecond));
        for (int i = 0; i < steps; ++i) {
            for (std::size_t k : {0u, 1u}) {
                if (!cloths_[k]) continue;
                const double mass = test::mass(*sheets_[k]);
                const btVector3 velocity =
                    mass > 0 ? test::momentum(*sheets_[k]) / btScalar(mass) : btVector3(0, 0, 0);
                cloths_[k]->air().wind = {double(velocity.x()), double(velocity.y()), double(velocity.z())};
            }
            world_->step(1.0 / perSecond, 1);
        }
    }

    // Takes a sheet out of the world and deletes it.
    void remove(std::size_t index) {
        if (!sheets_[index]) return;
        cloths_[index].reset();
        if (sheets_[index]->getBroadphaseHandle()) world_->removeSoftBody(*sheets_[index]);
        sheets_[index].reset();
    }
    void endCloth(std::size_t index) { cloths_[index].reset(); }

  private:
    Path path_;
    Fabric fabric_;
    std::unique_ptr<demo::SceneWorld> world_;
    std::unique_ptr<btSoftBody> sheets_[2];  // upper, lower
    std::unique_ptr<WetCloth> cloths_[2];
    bool falls_ = true;
};

class ClothOnCloth : public testing::TestWithParam<Path> {};

// How far a piece of cloth under another one like it, which is held everywhere, has come down after 0.4 s, m.
// Their nodes face each other, so that bonds and weights go together at the borders too.
double fall(Path path, double clingOverWeight, double saturationAbove, double saturationBelow) {
    TwoSheets rig(path, test::cottonThatClings(clingOverWeight), 0.02, 6, 6);
    rig.hold(rig.upper());
    const double start = test::lowest(rig.lower());
    rig.begin(saturationAbove, saturationBelow);
    rig.run(0.4);
    return start - test::lowest(rig.lower());
}

TEST_P(ClothOnCloth, WetClothHangsOnWetClothWhileItsBondExceedsItsWeight) {
    EXPECT_LT(fall(GetParam(), 1.2, 0.6, 0.6), 2e-3);
    EXPECT_GT(fall(GetParam(), 0.8, 0.6, 0.6), 0.2);
    EXPECT_GT(fall(GetParam(), 5, 0.6, 0), 0.5);
    EXPECT_GT(fall(GetParam(), 5, 0, 0.6), 0.5);
    EXPECT_GT(fall(GetParam(), 5, 0.6, 4), 0.5) << "dripping";
}

TEST_P(ClothOnCloth, SheetsThatClingKeepTheirMomentumAndDrawEachOtherAlong) {
    TwoSheets rig(GetParam(), fabrics::cottonPlain(), 0.02, 9, 6);
    rig.endGravity();
    rig.begin(0.6, 0.6);
    rig.run(0.05);
    const btVector3 pull(btScalar(0.05), btScalar(-0.2), 0);
    test::setVelocity(rig.lower(), pull);
    const auto total = [&] { return test::momentum(rig.upper()) + test::momentum(rig.lower()); };
    const btVector3 before = total();
    rig.run(0.5);
    EXPECT_LT(double((total() - before).length()), 0.01 * double(before.length()));
    const btVector3 together = before / btScalar(test::mass(rig.upper()) + test::mass(rig.lower()));
    for (const btSoftBody* sheet : {&rig.upper(), &rig.lower()}) {
        const btVector3 velocity = test::momentum(*sheet) / btScalar(test::mass(*sheet));
        EXPECT_LT(double((velocity - together).length()), 0.1 * double(pull.length()));
    }
}

TEST_P(ClothOnCloth, ASheetThatIsGoneHoldsNothing) {
    TwoSheets rig(GetParam(), test::cottonThatClings(5), 0.02, 11, 6);
    rig.hold(rig.upper());
    rig.begin(0.6, 0.6);
    rig.run(0.2);
    EXPECT_NEAR(double(test::centre(rig.lower()).y()), -2 * double(rig.margin()), 2e-3);
    rig.remove(0);
    rig.run(0.4);
    EXPECT_TRUE(test::isFinite(rig.lower()));
    EXPECT_LT(double(test::centre(rig.lower()).y()), -0.5);
}

TEST_P(ClothOnCloth, ASheetWhoseWetClothIsGoneHoldsNothing) {
    TwoSheets rig(GetParam(), test::cottonThatClings(5), 0.02, 11, 6);
    rig.hold(rig.upper());
    rig.begin(0.6, 0.6);
    rig.run(0.2);
    rig.endCloth(0);
    rig.run(0.4);
    EXPECT_TRUE(test::isFinite(rig.lower()));
    EXPECT_LT(double(test::centre(rig.lower()).y()), -0.5);
}

// How much slower a sheet slides on another, which is held, after a tenth of a second, without cling, m/s.
double slowed(Path path, double saturation) {
    Fabric fabric = fabrics::cottonPlain();
    fabric.clingEnergy = 0;
    TwoSheets rig(path, fabric, 0.02, 6, 13);
    rig.hold(rig.lower());
    rig.begin(saturation, saturation);
    rig.run(0.1);
    test::setVelocity(rig.upper(), {1, 0, 0});
    rig.run(0.1);
    return 1 - double(test::momentum(rig.upper()).x()) / test::mass(rig.upper());
}

TEST_P(ClothOnCloth, FrictionFollowsTheWater) {
    const Fabric cotton = fabrics::cottonPlain();
    EXPECT_NEAR(slowed(GetParam(), 0) / (0.1 * gravity * cotton.plateFrictionDry), 1, 0.1);
    EXPECT_NEAR(slowed(GetParam(), 0.6) / (0.1 * gravity * cotton.plateFrictionDamp), 1, 0.1);
}

TEST_P(ClothOnCloth, SheetsDoNotPassThroughEachOther) {
    // In a stock step Bullet's own search finds nothing of triangles as fine as these.
    const double spacing = GetParam() == Path::stock ? 0.01 : 0.02;
    for (const double speed : {0.0, 3.0}) {
        TwoSheets rig(GetParam(), fabrics::cottonPlain(), spacing, 6, 11);
        rig.hold(rig.lower());
        rig.begin(0, 0);
        rig.upper().translate({0, btScalar(0.01), 0});
        test::setVelocity(rig.upper(), {0, btScalar(-speed), 0});
        rig.run(0.2);
        EXPECT_GT(test::lowest(rig.upper()), -0.2 * double(rig.margin())) << speed << " m/s";
    }
}

TEST_P(ClothOnCloth, ASheetLiesOnOneThatLiesOnAFloor) {
    TwoSheets rig(GetParam(), fabrics::cottonPlain(), 0.02, 6, 11);
    const btScalar floor = -3 * rig.margin();
    rig.world().addBox({0, floor - btScalar(0.5), 0}, {1, btScalar(0.5), 1});
    rig.begin(0, 0);
    rig.run(0.3);
    EXPECT_GT(test::lowest(rig.lower()), double(floor));
    // Of the 2 margins of distance; implicit steps press them together the most.
    EXPECT_NEAR(double(test::centre(rig.upper()).y()), 0, 0.5 * double(rig.margin()));
    EXPECT_GT(test::lowest(rig.upper()), -0.8 * double(rig.margin()));
}

std::string nameOf(const testing::TestParamInfo<Path>& info) {
    switch (info.param) {
        case Path::stock:
            return "Stock";
        case Path::explicitSteps:
            return "Explicit";
        default:
            return "Implicit";
    }
}

INSTANTIATE_TEST_SUITE_P(Paths, ClothOnCloth,
                         testing::Values(Path::stock, Path::explicitSteps, Path::implicitSteps), nameOf);

}  // namespace
}  // namespace drench::cloth_on_cloth_test
