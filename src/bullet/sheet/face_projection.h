// The point on a face of one soft body that is nearest to a node of another.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <BulletSoftBody/btSoftBody.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The nearest point on a triangle to a given point, for triangles of any size. (Bullet's own search treats
// triangles below 1.7 cm2 as points, and finds nothing on them.)
class FaceProjection {
  public:
    struct Nearest {
        btVector3 weights;  // barycentric coordinates
        btVector3 apart;    // from the nearest point to the given point, m
    };

    Nearest of(const btVector3& point, const btVector3& a, const btVector3& b, const btVector3& c);

  private:
    btVoronoiSimplexSolver simplex_;
};

// A contact for code that reads Bullet's lists; Bullet does not resolve it.
btSoftBody::SContact silentContact(btSoftBody::Node& node, btSoftBody::Face& face, const btVector3& weights,
                                   const btVector3& normal, btScalar margin, btScalar friction);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
