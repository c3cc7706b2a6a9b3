// Water transfer by contact: from a wet body to a sheet, and between two sheets.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <limits>
#include <memory>
#include <vector>

#include "drench/config.h"
#include "drench/source.h"
#include "drench/wet_cloth.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// A collision object with a wet surface. Where the sheet touches it, the film on the face in contact approaches the
/// film thickness of the body, with a time constant of 0.1 s (assumed). Contacts are those of the last substep
/// (btSoftBody::m_rcontacts, in the deformable world m_nodeRigidContacts).
class DRENCH_API WetBody final : public Source {
  public:
    double filmThickness = 0.1e-3;  ///< of the water film on the body, m; 0 to 0.01; default 0.1e-3
    /// Water left on the body, kg; at least 0; default infinite.
    double amount = std::numeric_limits<double>::infinity();

    /// @param body  the wet body; only its address is used, so it may be destroyed
    explicit WetBody(const btCollisionObject& body) : body_(&body) {}
    std::string name() const override { return "wet body"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;
    void save(StateWriter& writer) const override { writer.write(amount); }
    void load(StateReader& reader) override;

  private:
    const btCollisionObject* body_;
};

/// Water transfer between two sheets that touch, for worlds without a SmallStepSolver. Layers of cloth that such a solver
/// moves pass water by themselves, as `Moisture::joinLayers` describes, and this source then does nothing. Otherwise, between a node and the face that it touches, pore saturations even out
/// with the slower of the two wetting times, and film thicknesses with a time constant of 0.1 s (both assumed). Faces
/// in contact do not dry. Add it to one of the two sheets. Contacts are those that Bullet lists between soft bodies:
/// btSoftBody::m_scontacts, for which both bodies need fCollision::VF_SS in m_cfg.collisions or a SmallStepSolver; in
/// the deformable world m_faceNodeContacts and VF_DD, by which a WetCloth replaces VF_SS.
class DRENCH_API Touch final : public Source {
  public:
    /// @param other  the other sheet, in the same world; once it is destroyed, this source has no effect
    explicit Touch(WetCloth& other);
    std::string name() const override { return "touch"; }
    void supply(const SheetPose& sheet, double dt, Supply& supply) override;

  private:
    struct DRENCH_LOCAL Exchange;
    /// Two nodes in contact, one of each sheet.
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
