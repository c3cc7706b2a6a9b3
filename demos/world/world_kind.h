// Kinds of worlds and solvers.
#pragma once

namespace drench::demo {

// Bullet's worlds for soft bodies.
enum class WorldKind { softRigid, deformable };

// Solvers of the sheets in a soft-rigid world; the deformable world has its own.
enum class SolverKind { smallStep, stock };

}  // namespace drench::demo
