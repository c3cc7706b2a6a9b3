// Water that passes by touch: from a wet body to a sheet, and between two sheets.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <limits>
#include <memory>
#include <vector>

#include "drench/export.h"
#include "drench/precision.h"
#include "drench/source.h"
#include "drench/wet_cloth.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// A collision object whose surface is wet. Where the sheet touches it (btSoftBody::m_rcontacts, in the
/// deformable world m_nodeRigidContacts), the face between takes up a film of its own as thick as that on the
/// body, with a time constant of 0.1 s (assumed). Contacts are those of the last substep.
class DRENCH_API WetBody final : public Source {
  public:
    double filmThickness = 0.1e-3;  ///< of the water on the body, m; 0 to 0.01
    double amount =
        std::numeric_limits<double>::infinity();  ///< what is left of it, kg, at least 0; default never ends

    /// @param body  that is wet; only its address is used, and it may be gone
    explicit WetBody(const btCollisionObject& body) : body_(&body) {}
    std::string name() const override { return "wet body"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;

  private:
    const btCollisionObject* body_;
};

/// Two sheets that touch, by Bullet's own contacts between soft bodies (btSoftBody::m_scontacts: both need
/// fCollision::VF_SS among their m_cfg.collisions; in the deformable world m_faceNodeContacts and VF_DD). Water
/// passes between a node and the face that it touches until pores are equally full, with the slower of the two
/// wetting times, and the films equally thick, with 0.1 s (both assumed). Faces that touch do not dry. Add it to
/// one of the two.
class DRENCH_API Touch final : public Source {
  public:
    /// @param other  sheet, in the same world; when it is gone, nothing passes any more
    explicit Touch(WetCloth& other);
    std::string name() const override { return "touch"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;

  private:
    struct DRENCH_LOCAL Exchange;
    /// A node here and one there that touch.
    struct Pair {
        std::size_t here, there;
        double weight;
    };

    void findPairs(const btSoftBody& here, const btSoftBody& there);

    std::weak_ptr<WetCloth::Layer> other_;
    std::vector<Pair> pairs_;                         // of this step
    std::vector<double> weightsHere_, weightsThere_;  // of each node, summed over its pairs
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
