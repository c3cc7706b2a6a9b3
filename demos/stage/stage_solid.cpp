#include "stage/stage_solid.h"

#include "world/vectors.h"

namespace drench::demo {

namespace {

btRigidBody& addTo(SceneWorld& world, const SolidDescription& solid) {
    const btVector3 position = toBullet(solid.position);
    const btQuaternion turn = toBullet(solid.turn);
    switch (solid.shape) {
        case SolidDescription::Shape::box:
            return world.addBox(position, toBullet(solid.halfExtents), turn, solid.mass);
        case SolidDescription::Shape::capsule:
            return world.addCapsule(position, solid.radius, solid.length, turn, solid.mass);
        case SolidDescription::Shape::ground:
            return world.addGround(solid.position.y());
        case SolidDescription::Shape::ball:
            break;
    }
    return world.addBall(position, solid.radius, solid.mass);
}

// Sets colour and material, if given.
template <typename Thing>
Thing dressed(Thing thing, const SolidDescription& solid) {
    if (solid.colour) thing.albedo = solid.colour->cast<float>();
    if (solid.material) thing.material = *solid.material;
    return thing;
}

}  // namespace

StageSolid::StageSolid(SceneWorld& world, const SolidDescription& description) : description_(description) {
    if (!description_.touches) return;
    body_ = &addTo(world, description_);
    body_->setFriction(btScalar(description_.friction));
    if (!(description_.mass > 0) || description_.shape == SolidDescription::Shape::ground) return;
    if (description_.shape == SolidDescription::Shape::ball) {
        btTransform transform = body_->getWorldTransform();
        transform.setRotation(toBullet(description_.turn));
        body_->setWorldTransform(transform);
        body_->setInterpolationWorldTransform(transform);
        body_->updateInertiaTensor();
    }
    body_->setLinearVelocity(toBullet(description_.velocity));
    body_->setAngularVelocity(toBullet(description_.spin));
    body_->setActivationState(DISABLE_DEACTIVATION);
}

SolidDescription StageSolid::describe() const {
    SolidDescription now = description_;
    if (!body_ || now.shape == SolidDescription::Shape::ground) return now;
    now.position = toEigen(body_->getWorldTransform().getOrigin());
    now.turn = toEigen(body_->getWorldTransform().getRotation());
    now.velocity = toEigen(body_->getLinearVelocity());
    now.spin = toEigen(body_->getAngularVelocity());
    return now;
}

void StageSolid::show(viewer::Picture& picture) const {
    if (!description_.seen) return;
    const SolidDescription now = describe();
    const Eigen::Vector3f position = now.position.cast<float>();
    const Eigen::Quaternionf turn = now.turn.cast<float>();
    switch (now.shape) {
        case SolidDescription::Shape::ball:
            picture.balls.push_back(dressed(viewer::Ball{position, float(now.radius), turn}, now));
            break;
        case SolidDescription::Shape::box:
            picture.boxes.push_back(dressed(viewer::Box{position, now.halfExtents.cast<float>(), turn}, now));
            break;
        case SolidDescription::Shape::capsule: {
            const Eigen::Vector3f half = turn * Eigen::Vector3f(0, float(now.length) / 2, 0);
            picture.rods.push_back(
                dressed(viewer::Rod{position - half, position + half, float(now.radius)}, now));
            break;
        }
        case SolidDescription::Shape::ground:
            picture.groundHeight = position.y();
            break;
    }
}

}  // namespace drench::demo
