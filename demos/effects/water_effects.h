// Rain, drops and spray as the eye sees them.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <drench/drench.h>

#include <Eigen/Geometry>
#include <optional>
#include <random>
#include <vector>

#include "effects/nozzle.h"
#include "effects/open_ground.h"
#include "effects/sheet_cells.h"
#include "effects/wet_spots.h"
#include "viewer/picture/picture.h"

namespace drench::demo {

// How much there may be of everything at one time, and the seed of what is random.
struct WaterEffectsLimits {
    unsigned seed = 1;
    std::size_t streaks = 3000;  // drops of rain on their way
    std::size_t drops = 1200;    // in flight, of splashes and of sprays, each
    std::size_t puffs = 160;     // of mist
    std::size_t spots = 2000;    // that are wet, at least 1
};

// What water does besides wetting sheets: it falls, splashes, drifts as mist, and wets rigid bodies, where it dries
// again. Only for the eye: it reads the world and changes nothing in it. The same calls show the same picture.
class WaterEffects {
  public:
    // @param world  must outlive this; its rigid bodies stop water and get wet, its soft bodies only stop it
    // @throws std::invalid_argument for no room for any wet spot
    explicit WaterEffects(const btCollisionWorld& world, const WaterEffectsLimits& limits = {});

    // Lets it rain through a region from now on, as dense as rain of that intensity is (Marshall & Palmer
    // 1948), as far as the limits allow; what is on its way falls on.
    // @param intensity  mm/h, at least 0; 0 ends it
    // @param velocity   of the drops, m/s, downwards
    // @param region     from where drops begin to be seen down to where none falls on
    // @throws std::invalid_argument for what is out of range, not finite or upwards, and an empty region
    void rain(double intensity, const Eigen::Vector3d& velocity, const Eigen::AlignedBox3d& region);
    // Sprays during the next step; call it for each nozzle before each step.
    // @throws std::invalid_argument for what is out of range or not finite
    void spray(const Nozzle& nozzle);
    // Shows drops as they are now, and what landed in their last step; call it after each of their steps.
    void follow(const FallingDrops& drops);
    // Says where water stands: drops splash on its surface and are not seen below. Replaces what was said
    // before.
    void setPools(std::vector<Eigen::AlignedBox3d> pools) { pools_ = std::move(pools); }

    // Moves everything by one frame; call it after the world's step.
    // @param frameTime   s, at least 0
    // @param air         dries the wet spots, and carries the mist
    // @param waterSpeed  how much faster than the clock they dry
    // @throws std::invalid_argument for a frame time or speed that is negative or not finite, and for such air
    // as `validate` refuses
    void step(double frameTime, const Air& air, double waterSpeed = 1);

    // Adds all that there is to see.
    void show(viewer::Picture& picture) const;

    const WetSpots& spots() const { return spots_; }

  private:
    struct Shower {
        double intensity = 0;  // mm/h
        Eigen::Vector3d velocity{0, -6.5, 0};
        Eigen::AlignedBox3d region;
        double owed = 0;  // drops to begin, a part of one
    };
    // A drop of rain, and where on a body its way ends.
    struct RainDrop {
        Eigen::Vector3d position;
        Eigen::Vector3d velocity;
        double left;                    // s, until it ends
        const btCollisionObject* body;  // that it ends on, or none
        double mass;                    // kg, that it stands for
    };
    // A drop that flies freely.
    struct Bead {
        Eigen::Vector3d position;
        Eigen::Vector3d velocity;
        double radius;  // m
        double mass;    // kg, that it wets with; 0 in splashes, which wet nothing
        double left;    // s
    };
    struct Puff {
        Eigen::Vector3d centre;
        Eigen::Vector3d velocity;
        double age;      // s
        double life;     // s
        double radius;   // m, at first
        double density;  // at first
    };
    // Where a way through the air ends.
    struct Hit {
        Eigen::Vector3d position;
        const btCollisionObject* body;  // none for a sheet or a pool
    };

    double random();
    double random(double from, double to) { return from + (to - from) * random(); }
    Eigen::Vector3d randomDirection();
    std::optional<Hit> hitBody(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
    std::optional<Hit> hitAnything(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
    const Eigen::AlignedBox3d* poolRound(const Eigen::Vector3d& position) const;
    void findSheets();
    void beginRain(double frameTime);
    void beginDrop(double mass, double age);
    void fallRain(double frameTime);
    void emit(const Nozzle& nozzle, double frameTime);
    void showJet(const Nozzle& nozzle);
    bool sprayEnds(Bead& drop, double time);
    void flySplashes(double frameTime);
    void drift(double frameTime, const Air& air);
    void splash(const Eigen::Vector3d& position, double vigour);
    void wet(const Hit& hit, double mass);
    void addPuff(const Eigen::Vector3d& centre, const Eigen::Vector3d& velocity, double radius,
                 double density);

    const btCollisionWorld& world_;
    WaterEffectsLimits limits_;
    std::mt19937 generator_;
    Shower shower_;
    std::vector<Nozzle> nozzles_;
    std::vector<Eigen::AlignedBox3d> pools_;
    std::vector<SheetCells> sheets_;
    std::vector<RainDrop> rain_;
    std::vector<Bead> spray_;
    std::vector<viewer::Streak> jets_;
    std::vector<Bead> splashes_;
    std::vector<Puff> puffs_;
    std::vector<viewer::WaterDrop> falling_;
    WetSpots spots_;
    OpenGround openGround_;
};

}  // namespace drench::demo
