#include "world/deformable_world.h"

#include <algorithm>
#include <cmath>

namespace drench::demo {

DeformableWorld::DeformableWorld() : dispatcher_(&configuration_), gravity_({0, btScalar(-9.81), 0}) {
    constraintSolver_.setDeformableSolver(&bodySolver_);
    world_ = std::make_unique<btDeformableMultiBodyDynamicsWorld>(
        &dispatcher_, &broadphase_, &constraintSolver_, &configuration_, &bodySolver_);
    world_->setGravity(gravity_.m_gravity);
    world_->getWorldInfo().m_gravity = gravity_.m_gravity;
    world_->setImplicit(false);
}

DeformableWorld::~DeformableWorld() = default;

void DeformableWorld::addSoftBody(btSoftBody& body) {
    world_->addSoftBody(&body);
    world_->addForce(&body, &gravity_);
}

int DeformableWorld::substepsFor(double frameTime, double stepBound, int) const {
    return std::max(1, int(std::ceil(frameTime / stepBound)));
}

void DeformableWorld::damp(btSoftBody& sheet, double rate, double substep) const {
    sheet.m_cfg.drag = btScalar(rate * substep);  // this world ignores kDP
}

std::string DeformableWorld::stepsName() const {
    return "Substeps per frame of 1/60 s in the deformable world, as many as keep the sheet from blowing up";
}

}  // namespace drench::demo
