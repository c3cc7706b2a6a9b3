#include "node_masses.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

void takeUpMomentum(btSoftBody& body, const std::vector<double>& masses, std::vector<Arrival>& arrivals) {
    for (std::size_t n = 0; n < arrivals.size(); ++n) {
        if (arrivals[n].mass == 0) continue;
        btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        const btScalar mass = btScalar(masses[n]), arrived = btScalar(arrivals[n].mass);
        if (node.m_im > 0) node.m_v = (node.m_v * mass + arrivals[n].momentum) / (mass + arrived);
        arrivals[n] = Arrival();
    }
}

void writeMasses(btSoftBody& body, const std::vector<double>& masses) {
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        btSoftBody::Node& node = body.m_nodes[n];
        const double mass = masses[static_cast<std::size_t>(n)];
        if (node.m_im > 0 && mass > 0) node.m_im = btScalar(1 / mass);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
