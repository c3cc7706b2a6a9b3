// Scenes of wet sheets that can be built again and again, for the tests of snapshots.
#pragma once

#include <drench/drench.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bullet/world/worlds.h"
#include "world/deformable_world.h"
#include "world/scene_world.h"

namespace drench::test {

enum class Mover { smallSteps, stock, explicitSteps, implicitSteps };

inline std::unique_ptr<demo::SceneWorld> worldFor(Mover mover, const SmallStepSettings& steps = {}) {
    if (mover == Mover::smallSteps)
        return demo::makeWorld(demo::WorldKind::softRigid, demo::SolverKind::smallStep, steps);
    if (mover == Mover::stock) return demo::makeWorld(demo::WorldKind::softRigid, demo::SolverKind::stock);
    auto world = std::make_unique<demo::DeformableWorld>();
    world->world().setImplicit(mover == Mover::implicitSteps);
    world->world().setUseProjection(mover == Mover::implicitSteps);
    return world;
}

// A world with sheets of which snapshots are taken together.
class WetScene {
  public:
    explicit WetScene(Mover mover, const SmallStepSettings& steps = {})
        : mover_(mover), world_(worldFor(mover, steps)) {}
    ~WetScene() {
        cloths_.clear();
        for (const auto& sheet : sheets_) world_->removeSoftBody(*sheet);
    }
    WetScene(const WetScene&) = delete;
    WetScene& operator=(const WetScene&) = delete;

    Mover mover() const { return mover_; }
    demo::SceneWorld& world() { return *world_; }
    std::size_t size() const { return sheets_.size(); }
    btSoftBody& sheet(std::size_t i = 0) { return *sheets_[i]; }
    WetCloth& cloth(std::size_t i = 0) { return *cloths_[i]; }

    btSoftBody& add(std::unique_ptr<btSoftBody> sheet) {
        world_->addSoftBody(*sheet);
        sheets_.push_back(std::move(sheet));
        return *sheets_.back();
    }
    WetCloth& cover(btSoftBody& sheet, const Fabric& fabric, const SheetSettings& settings = {}) {
        cloths_.push_back(std::make_unique<WetCloth>(world_->world(), sheet, fabric, settings));
        return *cloths_.back();
    }

    void step(int count) {
        const double dt = mover_ == Mover::smallSteps      ? 1.0 / 60
                          : mover_ == Mover::stock         ? 1.0 / 480
                          : mover_ == Mover::implicitSteps ? 1.0 / 240
                                                           : cloth().stepBound();
        for (int i = 0; i < count; ++i) {
            if (everyStep) everyStep(*this);
            world_->step(dt, 1);
        }
    }
    std::function<void(WetScene&)> everyStep;  // what the application does before each

    std::vector<Snapshot> save() const {
        std::vector<Snapshot> all;
        for (const auto& cloth : cloths_) all.push_back(cloth->snapshot());
        return all;
    }
    void restore(const std::vector<Snapshot>& all) {
        for (std::size_t i = 0; i < all.size(); ++i) cloths_[i]->restore(all[i]);
    }

  private:
    Mover mover_;
    std::unique_ptr<demo::SceneWorld> world_;
    std::vector<std::unique_ptr<btSoftBody>> sheets_;
    std::vector<std::unique_ptr<WetCloth>> cloths_;
};

// A sheet that hangs by two corners in gusts and rain, its foot in a pool, before a ball that keeps rain and wind off.
inline std::unique_ptr<WetScene> hangingInRain(Mover mover) {
    auto scene = std::make_unique<WetScene>(mover);
    scene->world().addBall({0, btScalar(-0.1), btScalar(0.25)}, 0.1, 0);
    const Fabric fabric = fabrics::cottonPlain();
    auto sheet = hangingSheet(scene->world().worldInfo(), fabric, 0.4, 11);
    for (int i = 1; i < 10; ++i) sheet->m_nodes[i].m_im = sheet->m_nodes[50].m_im;
    WetCloth& cloth = scene->cover(scene->add(std::move(sheet)), fabric);
    cloth.air().field = std::make_shared<Gusts>(Eigen::Vector3d(1, 0, 3), 0.3, 0.5);
    cloth.air().shelterLength = 0.5;
    cloth.add(Rain(200));
    cloth.add(Pool(-0.35));
    cloth.add(Spray({0, -0.2, 1}, {0, 0, -1}, 0.01));
    cloth.add(TimedSoak({60, 61, 62}, 0.01, 1));
    cloth.soakPores(0.1);
    return scene;
}

// A soaked sheet that has fallen on a ball and the ground, and clings to both.
inline std::unique_ptr<WetScene> lyingOnBall(Mover mover) {
    auto scene = std::make_unique<WetScene>(mover);
    btRigidBody& ball = scene->world().addBall({0, btScalar(-0.12), 0}, 0.1, 0);
    scene->world().addGround(-0.14);
    const Fabric fabric = fabrics::cottonPlain();
    btSoftBody& sheet = scene->add(levelSheet(scene->world().worldInfo(), fabric, 0.4, 11, 0));
    sheet.translate({0, sheet.getCollisionShape()->getMargin() - btScalar(0.019), 0});
    WetCloth& cloth = scene->cover(sheet, fabric);
    cloth.soakPores(0.8 * fabric.poreCapacity());
    cloth.add(WetBody(ball)).amount = 0.01;
    return scene;
}

// Two wet sheets, one on the other, on a box.
inline std::unique_ptr<WetScene> twoSheets(Mover mover) {
    auto scene = std::make_unique<WetScene>(mover);
    scene->world().addBox({0, btScalar(-0.1), 0}, {btScalar(0.1), btScalar(0.1), btScalar(0.1)});
    const Fabric fabric = fabrics::cottonPlain();
    for (const int margins : {1, 3}) {
        auto sheet = levelSheet(scene->world().worldInfo(), fabric, 0.3, 9, 5e-4 * margins);
        sheet->translate({0, btScalar(margins) * sheet->getCollisionShape()->getMargin(), 0});
        sheet->m_cfg.collisions |= mover == Mover::explicitSteps || mover == Mover::implicitSteps
                                       ? btSoftBody::fCollision::VF_DD
                                       : btSoftBody::fCollision::VF_SS;
        scene->cover(scene->add(std::move(sheet)), fabric).soakPores(0.1);
    }
    scene->cloth(1).add(Touch(scene->cloth(0)));
    return scene;
}

// 3 x 3 nodes, hung by two corners, and wet.
inline std::unique_ptr<WetScene> smallestScene(const Fabric& fabric) {
    auto scene = std::make_unique<WetScene>(Mover::smallSteps);
    auto sheet = hangingSheet(scene->world().worldInfo(), fabric, 0.2, 3);
    scene->cover(scene->add(std::move(sheet)), fabric).soakFilm(0.25);
    return scene;
}

}  // namespace drench::test
