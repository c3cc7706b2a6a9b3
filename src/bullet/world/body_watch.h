// Detects the destruction of a soft body.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <memory>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

struct SheetMechanics;

// Bullet does not report when a soft body is deleted, but the body owns its collision shape and deletes it.
// So while a body is watched, it has a collision shape of ours in place of its own, with the same margin and
// user data. The destructor restores the body's own shape.
class BodyWatch {
  public:
    // @param mechanics  of the body, for solvers that find it; must outlive this
    // @throws std::invalid_argument if the body is already being watched
    BodyWatch(btSoftBody& body, SheetMechanics& mechanics);
    ~BodyWatch();
    BodyWatch(const BodyWatch&) = delete;
    BodyWatch& operator=(const BodyWatch&) = delete;

    bool bodyIsAlive() const { return *alive_; }

    // The mechanics of a watched body; null for any other.
    static SheetMechanics* mechanicsOf(btSoftBody& body);

  private:
    btSoftBody& body_;
    std::shared_ptr<bool> alive_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
