// Enumerates the contacts that Bullet has found for a soft body, and sorts them in a reproducible order.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletSoftBody/btSoftBody.h>
#include <LinearMath/btAlignedObjectArray.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Calls `use(node, contact)` for each contact of a node with a rigid object; `contact` is a btSoftBody::sCti.
template <typename Use>
void forEachSolidContact(const btSoftBody& body, Use use) {
    for (int i = 0; i < body.m_rcontacts.size(); ++i)
        use(body.m_rcontacts[i].m_node, body.m_rcontacts[i].m_cti);
    for (int i = 0; i < body.m_nodeRigidContacts.size(); ++i)  // in the deformable world
        use(body.m_nodeRigidContacts[i].m_node, body.m_nodeRigidContacts[i].m_cti);
}

// Calls `use(node, face, weights)` for each contact of a node of the body with a face of another body or of
// its own, with the given weights of the corners of the face.
template <typename Use>
void forEachSoftContact(const btSoftBody& body, Use use) {
    for (int i = 0; i < body.m_scontacts.size(); ++i)
        use(body.m_scontacts[i].m_node, body.m_scontacts[i].m_face, body.m_scontacts[i].m_weights);
    for (int i = 0; i < body.m_faceNodeContacts.size(); ++i)  // in the deformable world
        use(body.m_faceNodeContacts[i].m_node, body.m_faceNodeContacts[i].m_face,
            body.m_faceNodeContacts[i].m_bary);
}

// Bullet finds contacts in the order of its trees and of its list of pairs, which depends on earlier
// positions and on addresses in memory. Contacts are solved one after the other, so their order affects the
// result. Here they are sorted by node or face, and then by the index of the solid in the world.
class ContactOrder {
  public:
    // @param ownerOf  returns the node or face of a contact, as an index into the arrays of its body
    template <typename Contact, typename OwnerOf>
    void sort(btAlignedObjectArray<Contact>& contacts, OwnerOf ownerOf) {
        keys_.clear();
        for (int i = 0; i < contacts.size(); ++i)
            keys_.emplace_back(ownerOf(contacts[i]), contacts[i].m_cti.m_colObj->getWorldArrayIndex(), i);
        if (std::is_sorted(keys_.begin(), keys_.end())) return;
        std::sort(keys_.begin(), keys_.end());
        for (int i = 0; i < contacts.size(); ++i) place(contacts, i);
    }

  private:
    using Key = std::tuple<const void*, int, int>;  // owner, solid and position: unique

    // Contacts are large, so each is moved only once, along the cycles of the permutation.
    template <typename Contact>
    void place(btAlignedObjectArray<Contact>& contacts, int start) {
        const auto sourceOf = [&](int at) -> int& {
            return std::get<2>(keys_[static_cast<std::size_t>(at)]);
        };
        if (sourceOf(start) == start) return;
        const Contact first = contacts[start];
        int at = start;
        while (sourceOf(at) != start) {
            const int next = sourceOf(at);
            contacts[at] = contacts[next];
            sourceOf(at) = at;
            at = next;
        }
        contacts[at] = first;
        sourceOf(at) = at;
    }

    std::vector<Key> keys_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
