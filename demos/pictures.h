// Bullet's bodies as the viewer wants them.
#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <drench/drench.h>

#include "viewer/picture.h"

namespace drench::demo {

Eigen::Vector3f toEigen(const btVector3& v);

/// A wet sheet as it is now: where it is, and coloured by its water.
viewer::SheetMesh sheetMesh(const btSoftBody& body, const WetCloth& cloth);

/// A sheet without water as it is now, all of one colour.
viewer::SheetMesh sheetMesh(const btSoftBody& body, const Eigen::Vector3f& albedo);

/// A rigid ball as it is now. @pre its shape is a btSphereShape
viewer::Ball ball(const btRigidBody& body);

/// A rigid box as it is now. @pre its shape is a btBoxShape
viewer::Box box(const btRigidBody& body);

}  // namespace drench::demo
