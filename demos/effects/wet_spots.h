// Wet places on rigid bodies: they grow, run together and dry.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include <Eigen/Core>
#include <vector>

#include "viewer/picture/picture.h"

namespace drench::demo {

// Thin layers of water on bodies, round by and large, that move and turn with what they are on. Only for the
// eye.
class WetSpots {
  public:
    // Water that a body holds before it spreads or runs off, kg/m2: a layer of 0.15 mm (assumed).
    static constexpr double layer = 0.15;
    // Of these, beyond which water runs off.
    static constexpr double maxLayers = 2;
    // m; a place that is this large only gets wetter.
    static constexpr double largestRadius = 0.15;

    // How wet a place with so much water looks, kg/m2: 0 (dry) to 1 (dark and glossy).
    static double wetnessOf(double massPerArea);

    // @param most  at one time, at least 1; when there are more the driest go
    // @throws std::invalid_argument for none
    explicit WetSpots(std::size_t max);

    // Puts water on a body: into a place that is there already, or into a new one.
    // @param place    in the world, m
    // @param mass     kg; nothing happens unless it is above 0
    // @param outline  of a new place, 0 to 1; see viewer::WetPatch
    void wet(const btCollisionObject& body, const Eigen::Vector3d& position, double mass, float outline);
    // Takes so much water from all of them, kg/m2; those without any are gone.
    void dry(double massPerArea);
    // Forgets the places on bodies that have left the world.
    void keepOnlyIn(const btCollisionWorld& world);

    std::size_t size() const { return spots_.size(); }
    double mass() const;  // kg, of all
    void show(viewer::Picture& picture) const;

  private:
    struct Spot {
        const btCollisionObject* body;
        Eigen::Vector3d inBody;  // m
        double mass;             // kg
        double area;             // m2
        float outline;
    };

    Spot* nearest(const btCollisionObject& body, const Eigen::Vector3d& inBody, double perRadius,
                  double reach);

    std::size_t max_;
    std::vector<Spot> spots_;
};

}  // namespace drench::demo
