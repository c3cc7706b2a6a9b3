#include "bullet/sheet/node_masses.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

void takeUpMomentum(btSoftBody& body, const std::vector<double>& masses, std::vector<Arrival>& arrivals) {
    for (std::size_t n = 0; n < arrivals.size(); ++n) {
        const Arrival& arrival = arrivals[n];
        btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        if (arrival.mass > 0 && node.m_im > 0) {
            const double before = masses[n] + arrival.carried;
            node.m_v = (node.m_v * btScalar(before) + arrival.momentum) / btScalar(before + arrival.mass);
        }
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
