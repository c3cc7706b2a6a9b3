// Notices when an application changes the nodes, links and faces of a body.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <cstddef>

#include "bullet/sheet/rest_shape.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class TopologyWatch {
  public:
    // Keeps where Bullet has the parts of the body. Drops what of it points to where they were before, or, as anchors
    // of the deformable world, which Bullet forgets, sets it right.
    void follow(btSoftBody& body);
    // Whether Bullet has moved them in memory since, as it does when some are appended. What points to them,
    // contacts and the tree of faces, then points nowhere.
    bool hasMoved(const btSoftBody& body) const;

    // Whether a body has the parts of a shape, joined as there. Counts are compared each time, what links and
    // faces join only bit by bit: an exchange among parts, such as randomizeConstraints makes, shows after up to
    // 64 calls.
    bool isAsItWas(const btSoftBody& body, const RestShape& shape);

  private:
    const btSoftBody::Node* nodes_ = nullptr;
    const void* links_ = nullptr;
    const void* faces_ = nullptr;
    std::size_t part_ = 0;  // of the parts that come next
};

// Drops contacts and the tree of faces.
void forgetContacts(btSoftBody& body);

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
