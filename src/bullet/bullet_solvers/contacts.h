// What touches a soft body, from wherever its world keeps that.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include "drench/precision.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Calls `use(node, contact)` for each contact of a node with something solid, `contact` a btSoftBody::sCti.
template <typename Use>
void forEachSolidContact(const btSoftBody& body, Use use) {
    for (int i = 0; i < body.m_rcontacts.size(); ++i)
        use(body.m_rcontacts[i].m_node, body.m_rcontacts[i].m_cti);
    for (int i = 0; i < body.m_nodeRigidContacts.size(); ++i)  // of the deformable world
        use(body.m_nodeRigidContacts[i].m_node, body.m_nodeRigidContacts[i].m_cti);
}

/// Calls `use(node, face, weights)` for each contact of a node of the body with a face of another, or of its
/// own, at the given weights of the face's corners.
template <typename Use>
void forEachSoftContact(const btSoftBody& body, Use use) {
    for (int i = 0; i < body.m_scontacts.size(); ++i)
        use(body.m_scontacts[i].m_node, body.m_scontacts[i].m_face, body.m_scontacts[i].m_weights);
    for (int i = 0; i < body.m_faceNodeContacts.size(); ++i)  // of the deformable world
        use(body.m_faceNodeContacts[i].m_node, body.m_faceNodeContacts[i].m_face,
            body.m_faceNodeContacts[i].m_bary);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
