// Which worlds and solvers there are.
#pragma once

namespace drench::demo {

// Bullet's worlds for soft bodies.
enum class WorldKind { softRigid, deformable };

// What moves the sheets of a soft-rigid world; the deformable one has its own solver.
enum class SolverKind { smallStep, stock };

}  // namespace drench::demo
