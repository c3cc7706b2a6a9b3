// Situations of games and robots: a sheet and a solid of each kind, shape and motion, in real worlds.
#pragma once

#include <string>
#include <vector>

namespace drench::test {

// Who moves the solid: Bullet as a dynamic rigid body or as a btMultiBody, or the application.
enum class SolidKind { rigid, kinematic, multibody, ghost, movedStatic };

enum class SolidForm { ball, box, capsule, hull, cylinder, compound, mesh, scaledMesh, gimpact, heightField };

// What it does: the sheet is laid on it; it comes up under the sheet at 1, 5 or 20 m/s; it spins at 15 rad/s while
// the sheet comes down on it; it passes the sheet's edge at 20 m/s, a centimetre beyond the distance at which cloth rests.
enum class SolidLoad { rest, slow, fast, faster, spin, passing };

// Who moves the sheet: a SmallStepSolver or Bullet's own in a btSoftMultiBodyDynamicsWorld, or a
// btDeformableMultiBodyDynamicsWorld in explicit steps.
enum class StepWorld { smallSteps, stock, deformable };

struct Situation {
    SolidKind kind;
    SolidForm form;
    SolidLoad load;
    StepWorld world = StepWorld::smallSteps;
};

struct Outcome {
    double deepest = 0;  // of any node inside the solid after any frame, by the closed form of the shape, m
    double speed = 0;    // root mean square of the nodes' velocities at the end, m/s
    double momentum =
        0;  // change of the momentum of sheet and solid over that of the solid; 0 where others act
    bool touched = false;
    bool finite = true;
};

Outcome play(const Situation& situation);

const std::vector<SolidKind>& allKinds();
const std::vector<SolidForm>& allForms();
const std::vector<SolidLoad>& allLoads();
std::string nameOf(SolidKind kind);
std::string nameOf(SolidForm form);
std::string nameOf(SolidLoad load);

}  // namespace drench::test
