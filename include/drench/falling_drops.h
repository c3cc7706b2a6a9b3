// Drops on their way down: from a sheet to another sheet, a body or the ground.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "drench/drop.h"
#include "drench/export.h"
#include "drench/precision.h"
#include "drench/state.h"
#include "drench/wet_cloth.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Takes the drops of some sheets, lets them fall freely, and wets the sheet on which they land, with their
/// momentum, in its account "drops". Drops of a sheet whose water runs faster than mechanics fall as often as
/// that, but push only as in mechanical time. Optional: an application may as well draw the drops of
/// WetCloth::takeDrops itself, or ignore them.
class DRENCH_API FallingDrops {
  public:
    /// Drops that fall together.
    struct Flight {
        Eigen::Vector3d position;  ///< m
        Eigen::Vector3d velocity;  ///< m/s
        double mass;               ///< of each drop, kg
        std::int64_t count;        ///< of drops
        double age;                ///< since they let go, s
    };
    /// Drops that landed together on something other than a sheet of these.
    struct Landing {
        Eigen::Vector3d position;         ///< m
        double mass;                      ///< of all of them, kg
        const btCollisionObject* object;  ///< what it landed on
    };

    /// @param world  that the sheets are in; must outlive this
    /// @throws std::invalid_argument for a world without soft bodies
    explicit FallingDrops(btDiscreteDynamicsWorld& world);
    ~FallingDrops();
    FallingDrops(const FallingDrops&) = delete;
    FallingDrops& operator=(const FallingDrops&) = delete;

    /// Drops fall from this sheet from now on, and land on it. It may end at any time. @pre its world is this one's
    void add(WetCloth& cloth);

    /// Takes new drops and moves all for `dt` seconds; call it once a frame, after the world's step. Solid
    /// bodies are met by Bullet's ray test, sheets face by face. A drop that has fallen for 20 s is lost.
    /// @throws std::invalid_argument for a dt that is negative or not finite
    void step(double dt);

    /// Drops in the air, oldest first.
    const std::vector<Flight>& inFlight() const { return flights_; }
    /// What landed in the last step elsewhere than on a sheet.
    const std::vector<Landing>& landed() const { return landed_; }
    /// What landed on sheets, of all drops that were taken, kg.
    double massOnSheets() const { return massOnSheets_; }
    /// What landed elsewhere, kg.
    double massElsewhere() const { return massElsewhere_; }
    /// What was lost, kg.
    double massLost() const { return massLost_; }

    /// Writes down the drops in the air and what has become of the others; `landed` starts anew. They go with snapshots
    /// of the sheets, of the same moment.
    void save(StateWriter& writer) const;
    /// Takes that up, where the same sheets were added in the same order.
    /// @throws std::runtime_error for what `save` cannot have written, or drops of a sheet that is not here; all is
    ///     then as before
    void load(StateReader& reader);

  private:
    struct DRENCH_LOCAL Sheets;
    struct DRENCH_LOCAL Origins;

    void takeDrops();
    bool land(std::size_t flight, const Eigen::Vector3d& to);

    btDiscreteDynamicsWorld& world_;
    std::unique_ptr<Sheets> sheets_;
    std::unique_ptr<Origins> origins_;  // where the flights began, one each
    std::vector<Flight> flights_;
    std::vector<Landing> landed_;
    double massOnSheets_ = 0;
    double massElsewhere_ = 0;
    double massLost_ = 0;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
