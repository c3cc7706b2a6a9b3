#include "bullet/repair/health.h"

#include <algorithm>
#include <cmath>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

bool isFinite(const btSoftBody& body) {
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const btVector3 sum = body.m_nodes[n].m_x + body.m_nodes[n].m_v;
        if (!std::isfinite(sum.x() + sum.y() + sum.z())) return false;
    }
    return true;
}

double largestStrain(const btSoftBody& body, const SheetMechanics& mechanics) {
    double largest = 0;
    for (int i = 0; i < body.m_links.size(); ++i) {
        if (mechanics.dryStiffness[static_cast<std::size_t>(i)].kind == LinkKind::bending) continue;
        const btSoftBody::Link& link = body.m_links[i];
        const double length = double((link.m_n[1]->m_x - link.m_n[0]->m_x).length());
        largest = std::max(largest, std::abs(length / double(link.m_rl) - 1));
    }
    return largest;
}

double deepestPenetration(const btSoftBody& body) {
    // Bullet measures distances from the position where cloth rests, one margin away from the surface.
    const auto margin = double(body.getCollisionShape()->getMargin());
    double deepest = 0;
    for (int i = 0; i < body.m_rcontacts.size(); ++i) {
        const btSoftBody::RContact& contact = body.m_rcontacts[i];
        const auto distance =
            double(contact.m_cti.m_normal.dot(contact.m_node->m_x) + contact.m_cti.m_offset);
        deepest = std::max(deepest, -(distance + margin));
    }
    for (int i = 0; i < body.m_nodeRigidContacts.size(); ++i)  // in the deformable world
        deepest = std::max(deepest, -(double(body.m_nodeRigidContacts[i].m_cti.m_offset) + margin));
    return deepest;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
