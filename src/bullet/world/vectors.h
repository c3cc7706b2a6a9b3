// Conversions between the vectors of Bullet, Eigen and packed nodes.
#pragma once

#include <LinearMath/btVector3.h>

#include <Eigen/Core>

#include "bullet/simd/nodes.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

inline Eigen::Vector3d toEigen(const btVector3& v) {
    return {double(v.x()), double(v.y()), double(v.z())};
}

inline btVector3 toBullet(const Eigen::Vector3d& v) {
    return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

inline Eigen::Vector3f toFloat(const btVector3& v) {
    return {float(v.x()), float(v.y()), float(v.z())};
}

inline btVector3 fromFloat(const Eigen::Vector3f& v) {
    return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

// Of a packed node of any type.
template <typename Node>
btVector3 vectorOf(const Node& node) {
    return {btScalar(node.x), btScalar(node.y), btScalar(node.z)};
}

inline void shift(MovingNode& node, const btVector3& by) {
    node.x += float(by.x());
    node.y += float(by.y());
    node.z += float(by.z());
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
