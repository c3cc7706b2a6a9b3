// Between Bullet's vectors and Eigen's.
#pragma once

#include <LinearMath/btVector3.h>

#include <Eigen/Core>

#include "drench/precision.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

inline Eigen::Vector3d toEigen(const btVector3& v) {
    return {double(v.x()), double(v.y()), double(v.z())};
}

inline btVector3 toBullet(const Eigen::Vector3d& v) {
    return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
