// Drops that have left a sheet and fall onto another sheet, a body or the ground.
#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "drench/config.h"
#include "drench/state.h"
#include "drench/wet_cloth.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// Simulates the drops of a group of sheets in free fall, without drag. A sheet on which drops land gets their water,
/// in its ledger account "drops", and their momentum. With a `SheetSettings::waterSpeed` above 1 more drops fall, and
/// their momentum is divided by it. Optional: an application may draw the drops of `WetCloth::takeDrops` itself, or
/// ignore them.
class DRENCH_API FallingDrops {
  public:
    /// Drops that fall together, as one.
    struct Flight {
        Eigen::Vector3d position;  ///< m
        Eigen::Vector3d velocity;  ///< m/s
        double mass;               ///< of each drop, kg
        std::int64_t count;        ///< number of drops
        double age;                ///< time since they left the cloth, s
    };
    /// Drops that landed together on something other than one of the sheets.
    struct Landing {
        Eigen::Vector3d position;         ///< m
        double mass;                      ///< of all of them together, kg
        const btCollisionObject* object;  ///< what they landed on
    };

    /// @param world  world of the sheets; must outlive this object
    /// @throws std::invalid_argument for a world without soft bodies
    explicit FallingDrops(btDiscreteDynamicsWorld& world);
    ~FallingDrops();
    FallingDrops(const FallingDrops&) = delete;
    FallingDrops& operator=(const FallingDrops&) = delete;

    /// Adds a sheet: its drops are taken from now on, and drops may land on it. It may be destroyed at any time.
    /// @pre it is in the world given to the constructor
    void add(WetCloth& cloth);

    /// Takes new drops and moves all drops by `dt` seconds. Call it once per frame, after the world's step. Hits on
    /// bodies are found by Bullet's ray test, hits on sheets face by face. A drop is lost after 20 s.
    /// @throws std::invalid_argument for a dt that is negative or not finite
    void step(double dt);

    /// Drops in the air, oldest first.
    const std::vector<Flight>& inFlight() const { return flights_; }
    /// Drops that landed in the last step, but not on one of the sheets.
    const std::vector<Landing>& landed() const { return landed_; }
    /// Total mass of drops that landed on the sheets so far, kg.
    double massOnSheets() const { return massOnSheets_; }
    /// Total mass that landed elsewhere, kg.
    double massElsewhere() const { return massElsewhere_; }
    /// Total mass that was lost, kg.
    double massLost() const { return massLost_; }

    /// Saves the drops in flight and the totals, but not `landed`. To be used together with snapshots of the sheets at
    /// the same moment.
    void save(StateWriter& writer) const;
    /// Loads what `save` has written. The same sheets must have been added in the same order.
    /// @throws std::runtime_error if `save` cannot have written it, or a drop belongs to a sheet that was not added;
    ///     nothing is then changed
    void load(StateReader& reader);

  private:
    struct DRENCH_LOCAL Sheets;
    struct DRENCH_LOCAL Origins;

    void takeDrops();
    bool land(std::size_t flight, const Eigen::Vector3d& to);

    btDiscreteDynamicsWorld& world_;
    std::unique_ptr<Sheets> sheets_;
    std::unique_ptr<Origins> origins_;  // of each flight
    std::vector<Flight> flights_;
    std::vector<Landing> landed_;
    double massOnSheets_ = 0;
    double massElsewhere_ = 0;
    double massLost_ = 0;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
