// Writes the mass of cloth and water to a body's nodes.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <array>
#include <vector>

#include "bullet/sheet/rest_shape.h"
#include "cloth/mesh_edges.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Water that has arrived at a node since the last substep.
struct Arrival {
    double carried = 0;                       // water that moves with the node, kg
    double mass = 0;                          // water with a velocity of its own, kg
    btVector3 momentum = btVector3(0, 0, 0);  // of that water, kg m/s
};

// Each unpinned node takes up the momentum of the water that arrived: v <- (m v + dm u) / (m + dm). Water
// that leaves takes its own momentum with it, so a node that only loses mass keeps its velocity. Clears
// `arrivals`.
// @param masses  of the nodes before the water arrived, kg
void takeUpMomentum(btSoftBody& body, const std::vector<double>& masses, std::vector<Arrival>& arrivals);

// Sets inverse masses; pins stay pins.
void writeMasses(btSoftBody& body, const std::vector<double>& masses);

// Gives a new body the mass of dry cloth: a third of each face, in the present positions, to each of its
// nodes.
// @tparam Sum   type in which masses are added up
// @param check  called with the index and the area, m2, of each face; throws for an unsuitable one
template <typename Sum, typename Check>
void writeClothMasses(btSoftBody& body, Sum arealDensity, Check check) {
    std::vector<Sum> masses(static_cast<std::size_t>(body.m_nodes.size()), Sum(0));
    for (int f = 0; f < body.m_faces.size(); ++f) {
        const btSoftBody::Face& face = body.m_faces[f];
        const btScalar area = areaOf(face);
        check(f, area);
        addThirds({indexOf(body, face.m_n[0]), indexOf(body, face.m_n[1]), indexOf(body, face.m_n[2])},
                  arealDensity * Sum(area), masses);
    }
    for (int n = 0; n < body.m_nodes.size(); ++n)
        body.m_nodes[n].m_im = btScalar(1 / masses[static_cast<std::size_t>(n)]);
    body.updateLinkConstants();
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
