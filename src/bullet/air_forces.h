// Drag of the air on the faces of a body, in place of Bullet's aero models.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "drench/air.h"
#include "drench/precision.h"
#include "drench/wet_laws.h"
#include "sheet_mechanics.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// The air of one sheet.
class AirForces {
  public:
    explicit AirForces(const RestShape& shape);

    /// Adds to the nodes' forces, per face, F = -1/2 rho A (C_n |u_n| u_n n + C_t |u_t| u_t), u the velocity
    /// of the face against the wind. Air leaks through the cloth: the pressure is that of the speed which is
    /// left after the leak, and the leak that of the pressure. The force is taken at the end of the substep
    /// (linearly implicit on the face's share of its nodes' mass), so it may stop the relative motion but
    /// never reverses it.
    void add(btSoftBody& body, const WetLaws& laws, const Air& air, const SheetMechanics& mechanics,
             double dt);

    /// The same as a change of the nodes' velocities, for a world that ignores forces on nodes.
    void push(btSoftBody& body, const WetLaws& laws, const Air& air, const SheetMechanics& mechanics,
              double dt);

  private:
    struct Node {
        btVector3 position;
        btVector3 velocity;     // against the wind, m/s
        btVector3 force;        // N
        btScalar massPerArea;   // kg/m2
        btScalar permeability;  // m/(s Pa)
    };
    struct Face {
        std::array<int, 3> nodes;
        btScalar restArea;  // m2
    };

    void evaluate(const btSoftBody& body, const WetLaws& laws, const Air& air,
                  const SheetMechanics& mechanics, double dt);
    void gather(const btSoftBody& body, const WetLaws& laws, const Air& air, const SheetMechanics& mechanics);
    btVector3 faceForce(const Face& face, const AirDrag& drag, btScalar dt) const;

    std::vector<double> nodeAreas_;
    std::vector<Node> nodes_;  // side by side, since Bullet's own are spread over four cache lines each
    std::vector<Face> faces_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
