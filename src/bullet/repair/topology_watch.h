// Detects changes of the nodes, links and faces of a body by the application.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <cstddef>

#include "bullet/sheet/rest_shape.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class TopologyWatch {
  public:
    // Stores the addresses of the body's arrays. Removes what points into the old arrays: contacts and the
    // tree of faces. Pointers of anchors of the deformable world, which Bullet does not update, are
    // corrected.
    void follow(btSoftBody& body);
    // Whether Bullet has moved the arrays in memory since, as it does when elements are appended. Contacts
    // and the tree of faces then have dangling pointers.
    bool hasMoved(const btSoftBody& body) const;

    // Whether a body has the topology of a shape. The numbers of nodes, links and faces are compared in each
    // call, their node indices only in parts: a permutation, as by randomizeConstraints, is detected within
    // 64 calls.
    bool isAsItWas(const btSoftBody& body, const RestShape& shape);

  private:
    const btSoftBody::Node* nodes_ = nullptr;
    const void* links_ = nullptr;
    const void* faces_ = nullptr;
    std::size_t part_ = 0;  // part to compare next
};

// Removes contacts and the tree of faces.
void forgetContacts(btSoftBody& body);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
