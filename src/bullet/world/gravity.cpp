#include "bullet/world/gravity.h"

#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>

#include <algorithm>

#include "bullet/world/limits.h"
#include "bullet/world/soft_world.h"
#include "bullet/world/vectors.h"
#include "checks/text.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

using Place = GravityPlace;

bool areAlike(const btVector3& one, const btVector3& two) {
    constexpr double tolerance = 0.05;
    return strengthOfGravity(one - two) <=
           tolerance * std::max(strengthOfGravity(one), strengthOfGravity(two));
}

// Whether it is what Bullet's constructors set.
bool isUntouched(const btVector3& gravity) {
    return gravity == btVector3(0, -10, 0);
}
bool isUntouchedInDeformable(const btVector3& ofInfo) {
    return isUntouched(ofInfo) || ofInfo == btVector3(0, btScalar(-9.8), 0);
}

Gravity agreed(const btVector3& value, Place place) {
    return {value, place, false, value, place};
}

// In a world whose soft bodies are moved by their world info.
Gravity choose(const btVector3& ofInfo, const btVector3& ofWorld, bool isOwn) {
    if (isOwn || ofInfo.isZero() || areAlike(ofInfo, ofWorld)) return agreed(ofInfo, Place::worldInfo);
    if (isUntouched(ofInfo) && isValidGravity(ofWorld))
        return {ofWorld, Place::world, true, ofInfo, Place::worldInfo};
    return {ofInfo, Place::worldInfo, true, ofWorld, Place::world};
}

// The force that moves a body in a deformable world; null if there is none. An implicit world moves all its
// bodies by the last force in its list, whichever bodies that was added for. If there is no `body`: the last.
const btDeformableGravityForce* forceOn(const btSoftBody* body, btDiscreteDynamicsWorld& world) {
    const auto& forces = *deformableSolverOf(world).getLagrangianForceArray();
    const bool isForAll = !body || deformableModeOf(world).implicit;
    const btDeformableGravityForce* found = nullptr;
    for (int i = 0; i < forces.size(); ++i) {
        if (forces[i]->getForceType() != BT_GRAVITY_FORCE) continue;
        const auto& bodies = forces[i]->m_softBodies;
        if (isForAll || bodies.findLinearSearch(const_cast<btSoftBody*>(body)) != bodies.size())
            found = static_cast<const btDeformableGravityForce*>(forces[i]);
    }
    return found;
}

// In a deformable world, whose world info moves nothing: only a value that somebody has written there counts,
// and zero is not one that could mislead.
Gravity chooseDeformable(const btDeformableGravityForce* force, btScalar factor, const btVector3& ofInfo,
                         const btVector3& ofWorld, bool isOwn) {
    const bool infoIsSet = !isUntouchedInDeformable(ofInfo);
    if (force) {
        const btVector3& ofForce = force->m_gravity;
        const btVector3 value = ofForce * factor;
        if (isOwn || ofForce.isZero()) return agreed(value, Place::force);
        if (!areAlike(ofForce, ofWorld)) return {value, Place::force, true, ofWorld, Place::world};
        if (infoIsSet && !ofInfo.isZero() && !areAlike(ofForce, ofInfo))
            return {value, Place::force, true, ofInfo, Place::worldInfo};
        return agreed(value, Place::force);
    }
    const btVector3 none(0, 0, 0);
    if (isOwn) return agreed(none, Place::nowhere);
    if (isUntouched(ofWorld) && infoIsSet) {
        if (ofInfo.isZero()) return agreed(ofInfo, Place::worldInfo);
        return {ofInfo, Place::worldInfo, true, none, Place::nowhere};
    }
    if (ofWorld.isZero()) return agreed(ofWorld, Place::world);
    return {ofWorld, Place::world, true, none, Place::nowhere};
}

// What sets the gravity of a place.
const char* callFor(Place place) {
    switch (place) {
        case Place::world:
            return "world.setGravity(...)";
        case Place::worldInfo:
            return "body.getWorldInfo()->m_gravity = ...";
        case Place::force:
            return "force.m_gravity = ...";
        default:
            return "world.addForce(&body, &force) with a btDeformableGravityForce";
    }
}

}  // namespace

Gravity gravityOf(btDiscreteDynamicsWorld& world, const btSoftBody& body, bool isOwn) {
    const btVector3 &ofInfo = body.m_worldInfo->m_gravity, ofWorld = world.getGravity();
    if (!isDeformable(world)) return choose(ofInfo, ofWorld, isOwn);
    return chooseDeformable(forceOn(&body, world), body.m_gravityFactor, ofInfo, ofWorld, isOwn);
}

Gravity gravityOf(btDiscreteDynamicsWorld& world) {
    const btVector3 &ofInfo = worldInfoOf(world).m_gravity, ofWorld = world.getGravity();
    if (!isDeformable(world)) return choose(ofInfo, ofWorld, false);
    return chooseDeformable(forceOn(nullptr, world), 1, ofInfo, ofWorld, false);
}

// Not std::hypot, which some libraries let return 0 for (0, NaN, 0).
double strengthOfGravity(const btVector3& gravity) {
    return toEigen(gravity).norm();
}

bool isValidGravity(const btVector3& gravity) {
    return strengthOfGravity(gravity) <= strongestGravity;
}

const char* nameOf(GravityPlace place) {
    switch (place) {
        case Place::world:
            return "the gravity of world.setGravity";
        case Place::worldInfo:
            return "the gravity of the body's world info";
        case Place::force:
            return "the gravity of the body's btDeformableGravityForce";
        default:
            return "the gravity that moves the body, which has no btDeformableGravityForce,";
    }
}

std::string disagreementOf(const Gravity& gravity) {
    return textOf(nameOf(gravity.place), " is ", sixDigits(gravity.value), " m/s2, which is used, and ",
                  nameOf(gravity.otherPlace), " is ", sixDigits(gravity.otherValue),
                  " m/s2; make them equal, with ", callFor(gravity.otherPlace), " or ",
                  callFor(gravity.place),
                  ", or set SheetSettings::ownGravity if the body is meant to have a gravity of its own");
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
