#include "bullet/bullet_solvers/link_constants.h"

#include <algorithm>
#include <cmath>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

double linkConstant(double inverseMass, double stiffness, double dt, int sweeps) {
    const double stiff = inverseMass * stiffness * dt * dt;  // stiffness relative to inertia
    if (sweeps <= 1) return inverseMass * std::max(1.0, 0.5 + 1 / stiff);
    return -inverseMass / std::expm1(-std::log1p(stiff) / sweeps);
}

void writeLinkConstants(btSoftBody& body, const SheetMechanics& mechanics, double dt) {
    // Nothing moves between two pins. Bullet divides by the constant nevertheless, so it must not be 0.
    constexpr btScalar betweenPins = 1;
    // The softest link that single precision can represent; it has practically no effect.
    constexpr double softest = 1e30;
    for (int i = 0; i < body.m_links.size(); ++i) {
        btSoftBody::Link& link = body.m_links[i];
        const double inverseMass = double(link.m_n[0]->m_im) + double(link.m_n[1]->m_im);
        link.m_c0 =
            inverseMass > 0
                ? btScalar(std::min(
                      softest, linkConstant(inverseMass, mechanics.stiffness(static_cast<std::size_t>(i)), dt,
                                            body.m_cfg.piterations)))
                : betweenPins;
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
