#include "world/bullet_world.h"

#include <algorithm>
#include <cmath>

namespace drench::demo {

BulletWorld::BulletWorld(btSoftBodySolver* solver)
    : dispatcher_(&configuration_),
      world_(&dispatcher_, &broadphase_, &constraintSolver_, &configuration_, solver) {
    const btVector3 gravity(0, btScalar(-9.81), 0);
    world_.setGravity(gravity);
    world_.getWorldInfo().m_gravity = gravity;  // soft bodies use this copy
}

int BulletWorld::substepsFor(double frameTime, double stepBound, int max) const {
    return std::clamp(int(std::ceil(frameTime / stepBound)), 1, max);
}

void BulletWorld::damp(btSoftBody& sheet, double rate, double substep) const {
    sheet.m_cfg.kDP = btScalar(rate * substep);  // fraction per substep
}

std::string BulletWorld::stepsName() const {
    return "Substeps per frame of 1/60 s, one sweep each, as many as the stiffness of the links needs";
}

}  // namespace drench::demo
