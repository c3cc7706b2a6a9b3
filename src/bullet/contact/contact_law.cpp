#include "bullet/contact/contact_law.h"

#include <BulletSoftBody/btSoftBody.h>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

double usableFriction(double coefficient) {
    constexpr double max = 1e3;
    return coefficient > 0 ? std::min(coefficient, max) : 0;
}

btScalar dryFriction(const btSoftBody& one, const btSoftBody& other) {
    return btScalar(usableFriction(double(std::max(one.m_cfg.kDF, other.m_cfg.kDF))));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
