#include "air_forces.h"

#include "drench/water.h"
#include "independent_blocks.h"
#include "vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

AirForces::AirForces(const RestShape& shape)
    : nodeAreas_(shape.nodeAreas),
      positions_(shape.nodeAreas.size() + 1, MovingNode{0, 0, 0, 0}),
      velocities_(positions_),
      forces_(positions_) {
    const auto spare = static_cast<std::int32_t>(nodeAreas_.size());
    for (const IndependentBlock& chosen : independentBlocks(shape.triangles, nodeAreas_.size())) {
        FaceBlock& block = faces_.emplace_back();
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            const bool isUsed = chosen[lane] >= 0;
            const auto face = static_cast<std::size_t>(isUsed ? chosen[lane] : 0);
            for (std::size_t corner = 0; corner < 3; ++corner)
                block.nodes[corner][lane] = isUsed ? shape.triangles[face][corner] : spare;
            block.restArea[lane] = isUsed ? float(shape.triangleAreas[face]) : 0;
        }
    }
}

void AirForces::add(btSoftBody& body, const WetLaws& laws, const Air& air, const SheetMechanics& mechanics,
                    const Pose& pose, double dt) {
    evaluate(laws, air, mechanics, pose, dt);
    for (int n = 0; n < body.m_nodes.size(); ++n)
        body.m_nodes[n].m_f += vectorOf(forces_[static_cast<std::size_t>(n)]);
}

void AirForces::push(btSoftBody& body, const WetLaws& laws, const Air& air, const SheetMechanics& mechanics,
                     const Pose& pose, double dt) {
    evaluate(laws, air, mechanics, pose, dt);
    for (int n = 0; n < body.m_nodes.size(); ++n)
        body.m_nodes[n].m_v +=
            vectorOf(forces_[static_cast<std::size_t>(n)]) * (body.m_nodes[n].m_im * btScalar(dt));
}

void AirForces::evaluate(const WetLaws& laws, const Air& air, const SheetMechanics& mechanics,
                         const Pose& pose, double dt) {
    const float wind[3] = {float(air.wind.x()), float(air.wind.y()), float(air.wind.z())};
    for (std::size_t n = 0; n < nodeAreas_.size(); ++n) {
        const MovingNode &place = pose.places[n], &speed = pose.speeds[n];
        const double massPerArea = nodeAreas_[n] > 0 ? mechanics.masses[n] / nodeAreas_[n] : 0.0;
        positions_[n] = {place.x, place.y, place.z, float(massPerArea)};
        velocities_[n] = {speed.x - wind[0], speed.y - wind[1], speed.z - wind[2],
                          float(laws.drag(mechanics.saturations[n]).permeability)};
        forces_[n] = {0, 0, 0, 0};
    }
    const AirDrag drag = laws.drag(0);  // of its members only the permeability depends on the water
    bestKernels().pushByAir(
        forces_.data(), faces_.data(), positions_.data(), velocities_.data(),
        {float(0.5 * airDensity * drag.normal), float(0.5 * airDensity * drag.tangential), float(dt)},
        faces_.size());
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
