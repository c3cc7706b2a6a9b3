#include "bullet/sheet/face_projection.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

FaceProjection::Nearest FaceProjection::of(const btVector3& point, const btVector3& a, const btVector3& b,
                                           const btVector3& c) {
    btSubSimplexClosestResult nearest;
    simplex_.closestPtPointTriangle(point, a, b, c, nearest);
    const btScalar* const weights = nearest.m_barycentricCoords;
    return {{weights[0], weights[1], weights[2]}, point - nearest.m_closestPointOnSimplex};
}

btSoftBody::SContact silentContact(btSoftBody::Node& node, btSoftBody::Face& face, const btVector3& weights,
                                   const btVector3& normal, btScalar margin, btScalar friction) {
    btSoftBody::SContact contact;
    contact.m_node = &node;
    contact.m_face = &face;
    contact.m_weights = weights;
    contact.m_normal = normal;
    contact.m_margin = margin;
    contact.m_friction = friction;
    contact.m_cfm[0] = contact.m_cfm[1] = 0;
    return contact;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
