// Where a node of one soft body is nearest to a face of another.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <BulletSoftBody/btSoftBody.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// The point of a triangle that is nearest to another point, however small the triangle is. (Bullet's own search takes
// those of less than 1.7 cm2 for points, and finds nothing on them.)
class FaceProjection {
  public:
    struct Nearest {
        btVector3 weights;  // of the corners
        btVector3 apart;    // from there to the point, m
    };

    Nearest of(const btVector3& point, const btVector3& a, const btVector3& b, const btVector3& c);

  private:
    btVoronoiSimplexSolver simplex_;
};

// A contact that Bullet does nothing about, for those who look through its lists.
btSoftBody::SContact silentContact(btSoftBody::Node& node, btSoftBody::Face& face, const btVector3& weights,
                                   const btVector3& normal, btScalar margin, btScalar friction);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
