// Vectors and turns as Bullet has them, and back.
#pragma once

#include <LinearMath/btQuaternion.h>
#include <LinearMath/btVector3.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace drench::demo {

template <typename Vector>
btVector3 bulletVector(const Eigen::MatrixBase<Vector>& v) {
    return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

inline Eigen::Vector3d plainVector(const btVector3& v) {
    return {double(v.x()), double(v.y()), double(v.z())};
}

/// As pictures have it.
inline Eigen::Vector3f pictureVector(const btVector3& v) {
    return {float(v.x()), float(v.y()), float(v.z())};
}

inline btQuaternion bulletTurn(const Eigen::Quaterniond& q) {
    return {btScalar(q.x()), btScalar(q.y()), btScalar(q.z()), btScalar(q.w())};
}

inline Eigen::Quaterniond plainTurn(const btQuaternion& q) {
    return {double(q.w()), double(q.x()), double(q.y()), double(q.z())};
}

}  // namespace drench::demo
