// How a sheet does, what has gone wrong with it, and what Drench does about that.
#pragma once

#include <cstdint>
#include <string>

#include "drench/precision.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

/// What a WetCloth does where something goes wrong with its sheet while the world runs. docs/health.md lists
/// what that can be.
enum class OnTrouble {
    /// It mends what it can, leaves the rest out, goes on, and says so in `WetCloth::troubles`. Default.
    carryOn,
    /// The step throws, out of stepSimulation or `WetCloth::preSubstep`, until the application has mended it: for
    /// development and tests. Nothing of the sheet has then changed.
    throwError
};

/// What can go wrong with a sheet.
enum class Trouble {
    /// A node was nowhere finite, or over 1e7 m off: it went back, at rest, to its last place.
    position,
    /// The velocity of a node was not finite, or over 1e6 m/s along an axis: the node came to rest.
    velocity,
    /// The force on a node was not finite: it was left out.
    force,
    /// The inverse mass of a node was not finite, or negative: it got that of its cloth and water.
    mass,
    /// The small steps of a substep took a node nowhere finite, or over 1e7 m off: the sheet stayed where it was, at rest.
    motion,
    /// Gravity was not finite, or over 1e4 m/s2: the world info got the last usable one.
    gravity,
    /// A setting of the body, in m_cfg or its rest length scale, was out of range: it got Bullet's default.
    bodySetting,
    /// WetCloth::air was out of range, or its field: the last usable air counted instead.
    air,
    /// A source threw: it brought no more in that substep.
    source,
    /// The body's nodes, links or faces changed to what is no cloth: the sheet is Bullet's, its water stands still.
    topology
};

/// One kind of trouble of one sheet, since its WetCloth was made or its reports were cleared.
struct TroubleReport {
    Trouble what;         ///< its kind
    std::string message;  ///< what, where, and how to mend it, as of the last time
    int node;             ///< that had it the last time, the first of several; -1 where it is not of one node
    double value;         ///< the offending one of the last time; 0 where there is none
    double since;         ///< when it came first, s of the body's time since the WetCloth was made
    double last;          ///< when it came last, s
    std::int64_t firstSubstep;  ///< number of the substep in which it came first, from 0
    std::int64_t lastSubstep;   ///< and last
    std::int64_t substeps;      ///< in how many substeps it came
};

/// How a sheet does mechanically, as of now.
struct SheetHealth {
    /// Whether all positions and velocities of the body are finite. If not, the next step mends that, or throws;
    /// see `OnTrouble`.
    bool finite;
    /// The largest |length / rest length - 1| of a stretch or shear link, 1.
    double largestStrain;
    /// How deep the deepest node is in a solid that it touched in the last substep, m; 0 if none is inside.
    double deepestPenetration;
    /// `WetCloth::stepBound`, s.
    double stepBound;
    /// Small steps of the last substep; 0 where no SmallStepSolver moves the sheet.
    int smallSteps;
    /// Substeps, since the WetCloth was made, whose small steps took a node nowhere finite, or over 1e7 m off, so that the
    /// sheet stayed where it was, at rest. 0 but for forces or obstacles beyond all measure.
    int heldSubsteps;
    /// Whether the body is the cloth that the WetCloth knows. If not, strain and penetration are 0, and the next
    /// step fits the WetCloth to it; see `WetCloth`.
    bool fits;
    /// How many times it has been fitted to a body that was cut.
    int refits;
    /// Kinds of trouble there have been; see `WetCloth::troubles`.
    int troubles;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
