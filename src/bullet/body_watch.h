// Knows whether a soft body still exists.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <memory>

#include "drench/precision.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Bullet does not say when a soft body is deleted, but the body owns its collision shape and deletes it. So
/// for as long as it watches, the body has a collision shape of ours in place of its own, with the same
/// margin and user data; the body gets its own shape back at the end.
class BodyWatch {
  public:
    /// @throws std::invalid_argument if the body is being watched already.
    explicit BodyWatch(btSoftBody& body);
    ~BodyWatch();
    BodyWatch(const BodyWatch&) = delete;
    BodyWatch& operator=(const BodyWatch&) = delete;

    bool bodyIsAlive() const { return *alive_; }

  private:
    btSoftBody& body_;
    std::shared_ptr<bool> alive_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
