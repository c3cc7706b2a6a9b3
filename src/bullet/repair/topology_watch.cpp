#include "bullet/repair/topology_watch.h"

#include <cstdint>

#include "bullet/sheet/face_tree.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

constexpr std::size_t callsForAll = 64;

template <typename Element>
const Element* firstElement(const btAlignedObjectArray<Element>& array) {
    return array.size() > 0 ? &array[0] : nullptr;
}

// Whether `isRight(i)` is true for all indices in the given one of callsForAll parts of `count` elements.
template <typename IsRight>
bool holdsForPart(std::size_t count, std::size_t part, IsRight isRight) {
    for (std::size_t i = count * part / callsForAll; i < count * (part + 1) / callsForAll; ++i)
        if (!isRight(i)) return false;
    return true;
}

// Computed from addresses only, because the old array has been freed.
void moveAnchors(btSoftBody& body, const btSoftBody::Node* from) {
    const auto start = reinterpret_cast<std::uintptr_t>(from);
    for (int i = 0; i < body.m_deformableAnchors.size(); ++i) {
        btSoftBody::Node*& node = body.m_deformableAnchors[i].m_node;
        const std::uintptr_t index =
            (reinterpret_cast<std::uintptr_t>(node) - start) / sizeof(btSoftBody::Node);
        const bool isNew = node >= &body.m_nodes[0] && node < &body.m_nodes[0] + body.m_nodes.size();
        if (!isNew && index < static_cast<std::uintptr_t>(body.m_nodes.size()))
            node = &body.m_nodes[static_cast<int>(index)];
    }
}

}  // namespace

void TopologyWatch::follow(btSoftBody& body) {
    if (nodes_ && hasMoved(body)) {
        forgetContacts(body);
        moveAnchors(body, nodes_);
    }
    nodes_ = firstElement(body.m_nodes);
    links_ = firstElement(body.m_links);
    faces_ = firstElement(body.m_faces);
}

bool TopologyWatch::hasMoved(const btSoftBody& body) const {
    return nodes_ != firstElement(body.m_nodes) || links_ != firstElement(body.m_links) ||
           faces_ != firstElement(body.m_faces);
}

bool TopologyWatch::isAsItWas(const btSoftBody& body, const RestShape& shape) {
    if (!hasCountsOf(body, shape)) return false;
    part_ = (part_ + 1) % callsForAll;
    const btSoftBody::Node* const nodes = &body.m_nodes[0];
    const auto linkIsRight = [&](std::size_t i) {
        const btSoftBody::Link& link = body.m_links[static_cast<int>(i)];
        return link.m_n[0] == nodes + shape.links[i].nodes[0] &&
               link.m_n[1] == nodes + shape.links[i].nodes[1];
    };
    const auto faceIsRight = [&](std::size_t i) {
        const btSoftBody::Face& face = body.m_faces[static_cast<int>(i)];
        for (std::size_t corner = 0; corner < 3; ++corner)
            if (face.m_n[corner] != nodes + shape.triangles[i][corner]) return false;
        return true;
    };
    return holdsForPart(shape.links.size(), part_, linkIsRight) &&
           holdsForPart(shape.triangles.size(), part_, faceIsRight);
}

void forgetContacts(btSoftBody& body) {
    body.m_rcontacts.clear();
    body.m_scontacts.clear();
    body.m_nodeRigidContacts.clear();
    body.m_faceNodeContacts.clear();
    body.m_faceRigidContacts.clear();
    body.m_faceNodeContactsCCD.clear();
    dropFaceTree(body);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
