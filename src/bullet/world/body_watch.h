// Knows whether a soft body still exists.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <memory>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

struct SheetMechanics;

// Bullet does not say when a soft body is deleted, but the body owns its collision shape and deletes it. So
// for as long as it watches, the body has a collision shape of ours in place of its own, with the same
// margin and user data; the body gets its own shape back at the end.
class BodyWatch {
  public:
    // @param mechanics  of the body, for solvers that meet it; stays where it is
    // @throws std::invalid_argument if the body is being watched already.
    BodyWatch(btSoftBody& body, SheetMechanics& mechanics);
    ~BodyWatch();
    BodyWatch(const BodyWatch&) = delete;
    BodyWatch& operator=(const BodyWatch&) = delete;

    bool bodyIsAlive() const { return *alive_; }

    // The mechanics of a body that is being watched; none for any other.
    static SheetMechanics* mechanicsOf(btSoftBody& body);

  private:
    btSoftBody& body_;
    std::shared_ptr<bool> alive_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
