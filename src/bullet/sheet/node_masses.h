// Writes the mass of cloth and water into a body's nodes.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <array>
#include <vector>

#include "bullet/sheet/rest_shape.h"
#include "cloth/mesh_edges.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Water that has reached a node since the last substep.
struct Arrival {
    double carried = 0;                       // kg that move with the node, whatever its velocity
    double mass = 0;                          // kg that came with a velocity of their own
    btVector3 momentum = btVector3(0, 0, 0);  // of these, kg m/s
};

// Lets each free node take up the momentum of the water that arrived: v <- (m v + dm u) / (m + dm). Water
// that leaves takes its own momentum along, so a node that only loses mass keeps its velocity. Empties
// `arrivals`.
// @param masses  of the nodes before the water came, kg
void takeUpMomentum(btSoftBody& body, const std::vector<double>& masses, std::vector<Arrival>& arrivals);

// Sets inverse masses; pins stay pins.
void writeMasses(btSoftBody& body, const std::vector<double>& masses);

// Gives a new body the mass of cloth alone: of each face, as its nodes are now, a third to each of its nodes.
// @tparam Sum   in which masses are added up
// @param check  is called with the index and the area, m2, of each face, and throws for one that will not do
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
