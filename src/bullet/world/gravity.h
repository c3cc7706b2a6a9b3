// Gravity, which Bullet's worlds keep in several places.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>

#include <string>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Where Bullet keeps it, or does not.
enum class GravityPlace {
    world,      // btDynamicsWorld::setGravity: moves rigid bodies
    worldInfo,  // btSoftBodyWorldInfo::m_gravity: moves soft bodies, except in the deformable world
    force,      // btDeformableGravityForce: moves soft bodies in the deformable world
    nowhere     // in the deformable world: no force of gravity moves the body
};

// Gravity for a body and its water, and the place that says something else.
struct Gravity {
    btVector3 value;     // m/s2; as Bullet has it, so it may be invalid
    GravityPlace place;  // where it was found

    bool disagrees;  // whether another place has another value, and nothing says that this is meant
    btVector3 otherValue;
    GravityPlace otherPlace;
};

// The gravity of a body: that of the place with which Bullet moves it. If nobody has set that place (it has
// Bullet's default, or there is no force), it is the world's. A difference of less than 5 % is none: 9.8, 9.81
// and Bullet's 10 are all in use for the same. Zero at the place of the body is meant.
// @param isOwn  whether the application says that the body's gravity is its own: then no other place counts
// @pre the world has been checked
Gravity gravityOf(btDiscreteDynamicsWorld& world, const btSoftBody& body, bool isOwn);

// The same for what falls without belonging to a body.
Gravity gravityOf(btDiscreteDynamicsWorld& world);

// Its length, m/s2; not a number if a component is not.
double strengthOfGravity(const btVector3& gravity);
// Whether it is finite and at most `strongestGravity`.
bool isValidGravity(const btVector3& gravity);

// Name of a place in messages.
const char* nameOf(GravityPlace place);

// Says what both places have, what was used, and what to call. @pre it disagrees
std::string disagreementOf(const Gravity& gravity);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
