#include "bullet/world/body_watch.h"

#include <BulletSoftBody/btSoftBodyInternals.h>

#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Recognised by its address, not by RTTI, because Bullet may have been built without it.
const char* const watchedShapeName = "DrenchSheet";

void copyUserData(const btCollisionShape& from, btCollisionShape& to) {
    to.setMargin(from.getMargin());
    to.setUserPointer(from.getUserPointer());
    to.setUserIndex(from.getUserIndex());
    to.setUserIndex2(from.getUserIndex2());
}

class WatchedShape final : public btSoftBodyCollisionShape {
  public:
    WatchedShape(btSoftBody& body, btCollisionShape* own, std::shared_ptr<bool> alive,
                 SheetMechanics& mechanics)
        : btSoftBodyCollisionShape(&body), own_(own), alive_(std::move(alive)), mechanics_(mechanics) {
        copyUserData(*own_, *this);
    }
    ~WatchedShape() override { *alive_ = false; }
    WatchedShape(const WatchedShape&) = delete;
    WatchedShape& operator=(const WatchedShape&) = delete;

    const char* getName() const override { return watchedShapeName; }

    SheetMechanics& mechanics() { return mechanics_; }

    btCollisionShape* restore() {
        copyUserData(*this, *own_);
        return own_.release();
    }

  private:
    std::unique_ptr<btCollisionShape> own_;
    std::shared_ptr<bool> alive_;
    SheetMechanics& mechanics_;
};

bool isWatched(const btSoftBody& body) {
    return body.getCollisionShape()->getName() == watchedShapeName;
}

// btSoftBody hides the setter of its base class.
void setShape(btSoftBody& body, btCollisionShape* shape) {
    body.btCollisionObject::setCollisionShape(shape);
}

}  // namespace

BodyWatch::BodyWatch(btSoftBody& body, SheetMechanics& mechanics)
    : body_(body), alive_(std::make_shared<bool>(true)) {
    if (isWatched(body))
        refuse(
            "this soft body has a WetCloth already; use that one, or destroy it before making "
            "another");
    setShape(body, new WatchedShape(body, body.getCollisionShape(), alive_, mechanics));
}

BodyWatch::~BodyWatch() {
    if (!*alive_) return;
    auto* shape = static_cast<WatchedShape*>(body_.getCollisionShape());
    setShape(body_, shape->restore());
    delete shape;
}

SheetMechanics* BodyWatch::mechanicsOf(btSoftBody& body) {
    if (!isWatched(body)) return nullptr;
    return &static_cast<WatchedShape*>(body.getCollisionShape())->mechanics();
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
