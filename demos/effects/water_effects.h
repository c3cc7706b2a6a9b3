// Rain, drops and spray in pictures.
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

// Largest numbers of objects at one time, and the seed of the random numbers.
struct WaterEffectsLimits {
    unsigned seed = 1;
    std::size_t streaks = 3000;  // falling drops of rain
    std::size_t drops = 1200;    // for each of falling drops, splashes and sprays
    std::size_t puffs = 160;     // puffs of mist
    std::size_t spots = 2000;    // wet spots, at least 1
};

// Water outside sheets: it falls, splashes, drifts as mist, and wets rigid bodies, on which it dries again.
// Only for pictures: it reads the world and changes nothing in it. The same calls give the same picture.
class WaterEffects {
  public:
    // @param world  must outlive this; its rigid bodies stop water and get wet, its soft bodies only stop it
    // @throws std::invalid_argument if the limits allow no wet spot
    explicit WaterEffects(const btCollisionWorld& world, const WaterEffectsLimits& limits = {});

    // Simulates rain through a region from now on, as dense as natural rain of that intensity (Marshall &
    // Palmer 1948), within the limits; drops that are already falling continue.
    // @param intensity  mm/h, at least 0; 0 stops the rain
    // @param velocity   of the drops, m/s, downwards
    // @param region     box in which drops are visible, down to where they end
    // @throws std::invalid_argument for values that are out of range or not finite, an upward velocity, and
    //     an empty region
    void rain(double intensity, const Eigen::Vector3d& velocity, const Eigen::AlignedBox3d& region);
    // Sprays during the next step; must be called for each nozzle before each step.
    // @throws std::invalid_argument for values that are out of range or not finite
    void spray(const Nozzle& nozzle);
    // Shows the present drops, and those that landed in their last step; must be called after each of their
    // steps.
    void follow(const FallingDrops& drops);
    // Sets the pools: drops splash on their surface and are not visible below it. Replaces the previous
    // pools.
    void setPools(std::vector<Eigen::AlignedBox3d> pools) { pools_ = std::move(pools); }

    // Advances everything by one frame; must be called after the world's step.
    // @param frameTime   s, at least 0
    // @param air         dries the wet spots and carries the mist
    // @param waterSpeed  ratio of water time to simulated time, for drying
    // @throws std::invalid_argument for a frame time or speed that is negative or not finite, and for air
    //     that `validate` refuses
    void step(double frameTime, const Air& air, double waterSpeed = 1);

    // Adds everything visible to the picture.
    void show(viewer::Picture& picture) const;

    const WetSpots& spots() const { return spots_; }

  private:
    struct Shower {
        double intensity = 0;  // mm/h
        Eigen::Vector3d velocity{0, -6.5, 0};
        Eigen::AlignedBox3d region;
        double owed = 0;  // drops still to be started, with a fraction
    };
    // A drop of rain, and the end of its path on a body.
    struct RainDrop {
        Eigen::Vector3d position;
        Eigen::Vector3d velocity;
        double left;                    // s, until it ends
        const btCollisionObject* body;  // body on which it ends, or null
        double mass;                    // kg, mass of rain that it represents
    };
    // A drop in free flight.
    struct Bead {
        Eigen::Vector3d position;
        Eigen::Vector3d velocity;
        double radius;  // m
        double mass;    // kg, water that wets what it hits; 0 for splashes
        double left;    // s
    };
    struct Puff {
        Eigen::Vector3d centre;
        Eigen::Vector3d velocity;
        double age;      // s
        double life;     // s
        double radius;   // initial radius, m
        double density;  // initial density
    };
    // The end of a path through the air.
    struct Hit {
        Eigen::Vector3d position;
        const btCollisionObject* body;  // null for a sheet or a pool
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
