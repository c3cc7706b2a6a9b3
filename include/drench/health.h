// Diagnostics of a sheet: its mechanical state, problems that were found and repaired, and computing times.
#pragma once

#include <cstdint>
#include <string>

#include "drench/config.h"

namespace drench {

/// Computing times of the steps of one sheet, totals since its WetCloth was made, s of a steady clock. To get the time
/// of a frame, subtract the totals before it from those after it. Measuring takes about a microsecond per substep.
/// Time spent on all sheets of a world together is divided equally among them.
struct StepTimes {
    double supply = 0;    ///< sources
    double water = 0;     ///< evaporation, absorption, wicking, film flow, dripping
    double laws = 0;      ///< masses and stiffness, computed from the water
    double air = 0;       ///< wind at the nodes, forces of air and pools
    double contacts = 0;  ///< with solids and sheets; without a SmallStepSolver only friction and adhesion
    double solver = 0;    ///< links, bending and motion in small steps; 0 without a SmallStepSolver
    std::int64_t substeps = 0;  ///< number of Bullet's substeps
    /// The part of `contacts` that is with the sheet itself and with other cloth; 0 without a SmallStepSolver.
    double clothContacts = 0;
};

inline namespace DRENCH_BULLET_NAMESPACE {

/// What a WetCloth does when it finds a problem (see `Trouble`) while the world runs.
enum class OnTrouble {
    /// It repairs or ignores the faulty value, continues, and reports it in `WetCloth::troubles`. Default.
    carryOn,
    /// stepSimulation or `WetCloth::preSubstep` throws std::runtime_error, with the sheet unchanged, until the
    /// application has removed the cause; for `Trouble::pieces` the constructor does. For development and tests.
    throwError
};

/// Problems that a WetCloth finds, and how it repairs them. docs/health.md says more.
enum class Trouble {
    /// The position of a node was not finite or more than 1e7 m from the origin: it was reset to its last valid
    /// position, with velocity 0.
    position,
    /// The velocity of a node was not finite or above 1e6 m/s along an axis: it was set to 0.
    velocity,
    /// The force on a node was not finite: it was ignored.
    force,
    /// The inverse mass of a node was not finite or negative: it was set to that of its cloth and water.
    mass,
    /// The small steps of a substep produced a position that is not finite or more than 1e7 m from the origin: the
    /// sheet stayed where it was, with velocity 0.
    motion,
    /// The gravity of the world info was not finite or above 1e4 m/s2: it was reset to its last valid value. Or that
    /// of the world or of the body's btDeformableGravityForce was: the last valid one was used for the water.
    gravity,
    /// A setting in the body's m_cfg, or its rest length scale, was out of range: it was set to Bullet's default.
    bodySetting,
    /// `WetCloth::air` was out of range, or its wind field returned an invalid velocity or threw an exception: the
    /// last valid air was used.
    air,
    /// A source threw an exception: that call of `supply` ended; the water that it had already added stays.
    source,
    /// The body's nodes, links or faces changed to something that is not a valid cloth: Drench no longer simulates the
    /// body, and its water is frozen.
    topology,
    /// The places where Bullet keeps gravity differ by more than 5 %: `SheetSettings::ownGravity` says which was used.
    gravityPlaces,
    /// Size or gravity look like another unit than metres, kilograms and seconds; found at the first substep. Nothing
    /// was changed. See `SheetSettings::unusualScale`.
    units,
    /// The sheet was in several pieces, which neither faces nor links join, when the WetCloth was made, and
    /// `SheetSettings::mayBeInPieces` was not set: it will fall apart. Mostly the mesh has split vertices; see `weld`.
    /// Nothing is changed. Reported once, by the constructor; with OnTrouble::throwError the constructor throws.
    /// Pieces that are cut later are not reported.
    pieces,
    /// For a second faces of the sheet have crossed: found by looking every half second. With a SmallStepSolver, any
    /// that cross faces of the sheet itself or of another sheet from which it is kept apart, and that the solver did
    /// not get apart. With other solvers, where nothing keeps a sheet apart from itself, pairs of its own faces that
    /// are more than 1 % of their number. Not reported for what `SheetSettings::meetsItself` and
    /// `SheetSettings::meetsSheets` allow to pass. Nothing is changed.
    crossing
};

/// All occurrences of one kind of problem since the WetCloth was made or `WetCloth::clearTroubles` was called.
struct TroubleReport {
    Trouble what;         ///< kind of problem
    std::string message;  ///< latest occurrence: what, where, and how to prevent it
    int node;             ///< latest occurrence: its node, the first of several; -1 if not tied to a node
    double value;         ///< latest occurrence: the invalid value; 0 if there is none
    double since;         ///< time of the first occurrence, s of the body's time since the WetCloth was made
    double last;          ///< time of the latest occurrence, s
    std::int64_t firstSubstep;  ///< substep of the first occurrence, counted from 0
    std::int64_t lastSubstep;   ///< substep of the latest occurrence
    std::int64_t substeps;      ///< number of substeps in which it occurred
};

/// Mechanical diagnostics, at the time of the call.
struct SheetHealth {
    /// Whether all positions and velocities of the body are finite. If not, the next step repairs them or throws; see
    /// `OnTrouble`.
    bool finite;
    /// Largest |length / rest length - 1| of all stretch and shear links, dimensionless.
    double largestStrain;
    /// Largest depth of a node inside a solid that it touched in the last substep, m; 0 if none is inside.
    double deepestPenetration;
    /// `WetCloth::stepBound`, s.
    double stepBound;
    /// Number of small steps of the last substep; 0 without a SmallStepSolver.
    int smallSteps;
    /// Number of substeps with `Trouble::motion` since the WetCloth was made. 0 unless forces or obstacles are extreme.
    int heldSubsteps;
    /// Whether the WetCloth is up to date with the topology of the body. If not, strain and penetration are 0, and the
    /// next step adapts the WetCloth; see docs/health.md.
    bool fits;
    /// Number of times that the WetCloth was adapted to a body that had been cut, refined or extended.
    int refits;
    /// Number of reports in `WetCloth::troubles`.
    int troubles;
    /// Number of pairs of faces of the sheet that cross; to touch is to cross, and faces that share a node do not count.
    /// 0 unless `WetCloth::health` was asked for crossings.
    int crossings;
    /// The same of a face of the sheet and one of another sheet of the world, that is of another body with a WetCloth.
    int crossingsWithOthers;
    /// Whether crossings were asked for, and all were counted. False if the count ended early, and for a sheet that is
    /// not `finite` or does not fit.
    bool crossingsAreAll;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
