// Water that passes by touch: from a wet body to a sheet, and between two sheets.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <limits>
#include <memory>

#include "drench/precision.h"
#include "drench/source.h"
#include "drench/wet_cloth.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// A collision object whose surface is wet. Where the sheet touches it (btSoftBody::m_rcontacts), the face between takes up a
/// film as thick as that on the body, with a time constant of 0.1 s (assumed). Contacts are those of the last
/// substep.
class WetBody final : public Source {
  public:
    double filmThickness = 0.1e-3;  ///< of the water on the body, m; 0 to 0.01
    double amount =
        std::numeric_limits<double>::infinity();  ///< what is left of it, kg, at least 0; default never ends

    /// @param sheet  that this source is added to
    /// @param body   that is wet; only its address is used, and it may be gone
    WetBody(const btSoftBody& sheet, const btCollisionObject& body) : sheet_(&sheet), body_(&body) {}
    std::string name() const override { return "wet body"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;

  private:
    const btSoftBody* sheet_;
    const btCollisionObject* body_;
};

/// Two sheets that touch, by Bullet's own contacts between soft bodies (btSoftBody::m_scontacts: both need fCollision::VF_SS
/// among their m_cfg.collisions). Water passes between a node and the face that it touches until pores are equally
/// full, with the slower of the two wetting times, and the films of the faces between equally thick, with 0.1 s (both assumed).
/// Add it to one of the two.
class Touch final : public Source {
  public:
    /// @param sheet  that this source is added to
    /// @param other  sheet; when it is gone, nothing passes any more
    Touch(const btSoftBody& sheet, WetCloth& other);
    std::string name() const override { return "touch"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;

  private:
    struct Exchange;

    const btSoftBody* sheet_;
    std::weak_ptr<WetCloth::Layer> other_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
