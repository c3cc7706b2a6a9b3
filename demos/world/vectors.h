// Conversions of vectors and rotations between Bullet, descriptions and pictures.
#pragma once

#include <LinearMath/btQuaternion.h>

#include <Eigen/Geometry>

#include "bullet/world/vectors.h"

namespace drench::demo {

using drench::toBullet;
using drench::toEigen;

// As an Eigen vector for pictures.
inline Eigen::Vector3f pictureVector(const btVector3& v) {
    return {float(v.x()), float(v.y()), float(v.z())};
}

inline btQuaternion toBullet(const Eigen::Quaterniond& q) {
    return {btScalar(q.x()), btScalar(q.y()), btScalar(q.z()), btScalar(q.w())};
}

inline Eigen::Quaterniond toEigen(const btQuaternion& q) {
    return {double(q.w()), double(q.x()), double(q.y()), double(q.z())};
}

}  // namespace drench::demo
