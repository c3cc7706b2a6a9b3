#include "bullet/bullet_solvers/met_solids.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <limits>

#include "bullet/contact/solids.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

SurfacePoint nearestPart(const btCollisionShape& shape, const btTransform& transform, const btVector3& point,
                         btSparseSdf<3>& field) {
    SurfacePoint nearest = {std::numeric_limits<btScalar>::infinity(), {0, 0, 0}};
    if (shape.isConvex()) {
        const btVector3 position = transform.invXform(point);
        // Bullet counts voxels with int, without a check for overflow.
        constexpr btScalar maxVoxels = btScalar(1e8);
        if (!(position.length() < maxVoxels * field.voxelsz)) return nearest;
        SurfacePoint found;
        found.distance = field.Evaluate(position, &shape, found.normal, 0);
        found.normal = transform.getBasis() * found.normal;
        return found;
    }
    if (!shape.isCompound()) return nearest;
    const auto& compound = static_cast<const btCompoundShape&>(shape);
    for (int i = 0; i < compound.getNumChildShapes(); ++i) {
        const SurfacePoint found =
            nearestPart(*compound.getChildShape(i), transform * compound.getChildTransform(i), point, field);
        if (found.distance < nearest.distance) nearest = found;
    }
    return nearest;
}

}  // namespace

void MetSolids::begin(const btCollisionWorld& world, const btSoftBody& body, const Friction& sheetFriction) {
    world_ = &world;
    body_ = &body;
    sheetFriction_ = &sheetFriction;
    met_.clear();
    last_ = 0;
}

const MetSolids::Met& MetSolids::at(const btCollisionObject* object) {
    if (last_ < met_.size() && met_[last_].object == object) return met_[last_];
    for (last_ = 0; last_ < met_.size(); ++last_)
        if (met_[last_].object == object) return met_[last_];
    const auto& all = world_->getCollisionObjectArray();
    Met met = {object, false, {}};
    for (int i = 0; i < all.size() && !met.exists; ++i) met.exists = all[i] == object;
    met.exists = met.exists && object->hasContactResponse() &&
                 object->getInternalType() != btCollisionObject::CO_SOFT_BODY;
    if (met.exists) met.surface = sheetFriction_->surfaceAt(*object, body_->m_cfg.kDF);
    met_.push_back(met);
    return met_.back();
}

SurfacePoint nearestSurfaceOf(const btCollisionObject& solid, const btVector3& point, btSparseSdf<3>& field) {
    return nearestPart(*solid.getCollisionShape(), solid.getWorldTransform(), point, field);
}

btVector3 velocityAt(const btCollisionObject& solid, const btVector3& point) {
    const btRigidBody* const body = movingBody(solid);
    if (!body) return {0, 0, 0};
    return body->getVelocityInLocalPoint(point - body->getCenterOfMassPosition());
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
