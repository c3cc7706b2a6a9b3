// Wet spots on rigid bodies: they grow, merge and dry.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>

#include <Eigen/Core>
#include <vector>

#include "viewer/picture/picture.h"

namespace drench::demo {

// Thin, roughly round layers of water on bodies; they move and rotate with the bodies. Only for pictures.
class WetSpots {
  public:
    // Water that a surface holds before it spreads or runs off, kg/m2: a layer of 0.15 mm (assumed).
    static constexpr double layer = 0.15;
    // Number of such layers above which water runs off.
    static constexpr double maxLayers = 2;
    // Largest radius, m; a spot of this size only gets wetter.
    static constexpr double largestRadius = 0.15;

    // Appearance of a spot with this much water, kg/m2: 0 (dry) to 1 (dark and glossy).
    static double wetnessOf(double massPerArea);

    // @param max  largest number of spots, at least 1; above it the driest are removed
    // @throws std::invalid_argument for 0
    explicit WetSpots(std::size_t max);

    // Adds water on a body: to an existing spot, or as a new one.
    // @param place    position in the world, m
    // @param mass     kg; nothing happens unless it is above 0
    // @param outline  of a new spot, 0 to 1; see viewer::WetPatch
    void wet(const btCollisionObject& body, const Eigen::Vector3d& position, double mass, float outline);
    // Removes this much water from all spots, kg/m2; dry spots are removed.
    void dry(double massPerArea);
    // Removes the spots on bodies that have left the world.
    void keepOnlyIn(const btCollisionWorld& world);

    std::size_t size() const { return spots_.size(); }
    double mass() const;  // total, kg
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
