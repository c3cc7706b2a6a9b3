#include "bullet/sheet/pose.h"

#include "bullet/world/limits.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

Pose::Pose(const ClothMesh& mesh)
    : relativePositions(mesh.size() + 1, PackedVector{0, 0, 0, 0}),
      speeds(mesh.size() + 1, PackedVector{0, 0, 0, 0}),
      heights(mesh.size()),
      positions(mesh.size()),
      velocities(mesh.size()),
      trianglesAround(mesh.size()),
      newRelativePositions_(relativePositions) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int node : mesh.triangles[t])
            trianglesAround[static_cast<std::size_t>(node)].push_back(static_cast<int>(t));
}

bool Pose::gather(const btSoftBody& body, const ClothMesh& mesh, const btVector3& gravityOfBody) {
    const Eigen::Vector3d down = toEigen(gravityOfBody);
    gravity = down.norm();
    up = gravity > 0 ? Eigen::Vector3d(-down / gravity) : Eigen::Vector3d::Zero();
    const btVector3 first = body.m_nodes[0].m_x, direction = toBullet(up);
    btVector3 momentum(0, 0, 0), farthest(0, 0, 0), fastest(0, 0, 0);
    btScalar area = 0, sum = 0, lightest = 0;
    for (std::size_t n = 0; n < heights.size(); ++n) {
        const btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        const btVector3 position = node.m_x - first, &velocity = node.m_v;
        newRelativePositions_[n] = {float(position.x()), float(position.y()), float(position.z()), 0};
        speeds[n] = {float(velocity.x()), float(velocity.y()), float(velocity.z()), 0};
        heights[n] = float(position.dot(direction));
        momentum += velocity * btScalar(mesh.areas[n]);
        area += btScalar(mesh.areas[n]);
        farthest.setMax(node.m_x.absolute());
        fastest.setMax(velocity.absolute());
        lightest = node.m_im < lightest ? node.m_im : lightest;
        const btVector3 all = node.m_x + velocity + node.m_f;
        sum += (all.x() + all.y() + all.z() + node.m_im) * 0;  // NaN if a value is not finite
    }
    const bool isSound = sum == 0 && lightest >= 0 &&
                         double(farthest[farthest.maxAxis()]) <= farthestPosition &&
                         double(fastest[fastest.maxAxis()]) <= fastestNode;
    if (isSound) {
        origin = first;
        relativePositions.swap(newRelativePositions_);
    }
    meanVelocity = area > 0 ? toEigen(momentum / area) : Eigen::Vector3d(Eigen::Vector3d::Zero());
    return isSound;
}

std::vector<btVector3> Pose::positionsInWorld() const {
    std::vector<btVector3> all;
    for (std::size_t n = 0; n < heights.size(); ++n) all.push_back(origin + vectorOf(relativePositions[n]));
    return all;
}

void Pose::gatherMotion(const btSoftBody& body) {
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        positions[static_cast<std::size_t>(n)] = toEigen(body.m_nodes[n].m_x);
        velocities[static_cast<std::size_t>(n)] = toEigen(body.m_nodes[n].m_v);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
