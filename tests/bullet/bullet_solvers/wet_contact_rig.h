// Sheets on a slope, under a ceiling and at a plate that is free, in any of Bullet's worlds, for the tests of wet
// friction and cling.
#pragma once

#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <memory>

#include "bullet/world/worlds.h"
#include "world/scene_world.h"

namespace drench::test {

constexpr double gravity = 9.81;  // m/s2
constexpr double slope = 20 * 3.14159265358979 / 180;

inline btVector3 centre(const btSoftBody& body) {
    btVector3 sum(0, 0, 0);
    for (int n = 0; n < body.m_nodes.size(); ++n) sum += body.m_nodes[n].m_x;
    return sum / btScalar(body.m_nodes.size());
}

// One sheet of half a metre with its cloth, in a world of its own, in air that moves along with it.
class WetContactRig {
  public:
    WetContactRig(std::unique_ptr<demo::SceneWorld> world, int nodes, const Fabric& fabric)
        : world_(std::move(world)), fabric_(fabric) {
        sheet_ = levelSheet(world_->worldInfo(), fabric, 0.5, nodes, 0);
        world_->addSoftBody(*sheet_);
    }
    ~WetContactRig() {
        cloth_.reset();
        if (plate_ && world_) world_->world().removeRigidBody(plate_.get());
        if (world_) world_->removeSoftBody(*sheet_);
    }
    WetContactRig(const WetContactRig&) = delete;
    WetContactRig& operator=(const WetContactRig&) = delete;

    demo::SceneWorld& world() { return *world_; }
    btSoftBody& sheet() { return *sheet_; }
    btScalar margin() const { return sheet_->getCollisionShape()->getMargin(); }
    WetCloth& cloth() { return *cloth_; }
    std::unique_ptr<WetCloth>& owner() { return cloth_; }

    // Water that neither dries nor runs.
    WetCloth& cover(double saturation, Stepping stepping = Stepping::byWorld) {
        SheetSettings settings;
        settings.waterSpeed = 0;
        settings.stepping = stepping;
        cloth_ = std::make_unique<WetCloth>(world_->world(), *sheet_, fabric_, settings);
        if (saturation > 0) cloth_->soakPores(saturation * fabric_.poreCapacity());
        return *cloth_;
    }

    // The sheet on a slope; the velocity with which it slides down is away from x.
    btRigidBody& layOnSlope() {
        const btQuaternion turn({0, 0, 1}, btScalar(slope));
        btRigidBody& box = world_->addBox({0, 0, 0}, {8, btScalar(0.5), 2}, turn);
        box.setFriction(btScalar(0.5));
        world_->world().updateAabbs();
        const btTransform transform(turn, {0, 0, 0});
        sheet_->transform(btTransform(turn, transform * btVector3(6, btScalar(0.5) + margin(), 0)));
        down_ = transform.getBasis() * btVector3(-1, 0, 0);
        return box;
    }
    double speedDown() const { return double(momentum(*sheet_).dot(down_)) / mass(*sheet_); }
    double distanceDown(const btVector3& from) const { return double((centre(*sheet_) - from).dot(down_)); }

    // The sheet under a box whose underside is at y = 0, on its way up.
    btRigidBody& pressAgainstCeiling() {
        sheet_->translate({0, -margin(), 0});
        setVelocity(*sheet_, {0, btScalar(0.2), 0});
        return world_->addBox({0, btScalar(0.5), 0}, {1, btScalar(0.5), 1});
    }

    // The sheet under a plate that is free, which it touches.
    btRigidBody& pressAgainstPlate(double plateMass) {
        const btVector3 half(btScalar(0.3), btScalar(0.05), btScalar(0.3));
        plateShape_ = std::make_unique<btBoxShape>(half);
        btVector3 inertia;
        plateShape_->calculateLocalInertia(btScalar(plateMass), inertia);
        plate_ = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(
            btScalar(plateMass), nullptr, plateShape_.get(), inertia));
        plate_->setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, half.y() + margin(), 0}));
        plate_->setInterpolationWorldTransform(plate_->getWorldTransform());
        plate_->setActivationState(DISABLE_DEACTIVATION);
        world_->world().addRigidBody(plate_.get());
        plate_->setGravity({0, 0, 0});
        setVelocity(*sheet_, {0, btScalar(0.1), 0});
        return *plate_;
    }

    void run(double time, int substepsPerSecond) {
        const int steps = static_cast<int>(std::lround(time * substepsPerSecond));
        for (int i = 0; i < steps; ++i) {
            if (cloth_) {
                const btVector3 velocity = momentum(*sheet_) / btScalar(mass(*sheet_));
                cloth_->air().wind = {double(velocity.x()), double(velocity.y()), double(velocity.z())};
            }
            world_->step(1.0 / substepsPerSecond, 1);
        }
    }

    // The world ends before the rest of this.
    void endWorld() { world_.reset(); }

  private:
    std::unique_ptr<btCollisionShape> plateShape_;
    std::unique_ptr<btRigidBody> plate_;
    std::unique_ptr<demo::SceneWorld> world_;
    Fabric fabric_;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
    btVector3 down_ = btVector3(0, 0, 0);
};

// Cotton whose bonds hold so much of the weight that it has at 60 % of its pores' capacity.
inline Fabric cottonThatClings(double fraction) {
    constexpr double reach = 0.01;  // of bonds in a coarse mesh, m
    Fabric fabric = fabrics::cottonPlain();
    fabric.clingEnergy = fraction * (fabric.arealDensity + 0.6 * fabric.poreCapacity()) * gravity * reach;
    return fabric;
}

}  // namespace drench::test
