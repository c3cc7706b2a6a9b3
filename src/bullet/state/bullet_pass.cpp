#include "bullet/state/bullet_pass.h"

#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

void BulletPass::vector(btVector3& value, double max) {
    btScalar parts[3] = {value.x(), value.y(), value.z()};
    for (btScalar& part : parts) number(part, -max, max);
    if (restores()) value.setValue(parts[0], parts[1], parts[2]);
}

void BulletPass::matrix(btMatrix3x3& value) {
    for (int row = 0; row < 3; ++row) vector(value[row], unlimited);
}

void BulletPass::nameAll() {
    const auto& all = world_.getCollisionObjectArray();
    for (int i = 0; i < all.size(); ++i) indices_.emplace(all[i], i);
}

const btCollisionObject* BulletPass::object(const btCollisionObject* now, Which which) {
    if (!saves()) return readObject(which);
    const auto found = indices_.find(now);
    std::int32_t index = found == indices_.end() ? -1 : found->second;
    number(index);
    return now;
}

const btCollisionObject* BulletPass::readObject(Which which) {
    const auto index = reader().read<std::int32_t>();
    const auto& all = world_.getCollisionObjectArray();
    if (index == -1) return nullptr;
    if (index < 0 || index >= all.size())
        refuse<std::runtime_error>("the snapshot's sheet touches object ", index,
                                   " of its world, and this world has ", all.size(),
                                   "; add the same objects in the same order");
    const bool isSoft = all[index]->getInternalType() == btCollisionObject::CO_SOFT_BODY;
    if (isSoft != (which == Which::soft))
        refuse<std::runtime_error>("object ", index, " of this world is ",
                                   isSoft ? "a soft body, where the snapshot's is none"
                                          : "no soft body, where the snapshot's is one",
                                   "; add the same objects in the same order");
    return all[index];
}

const btSoftBody* BulletPass::ownerOf(const btSoftBody::Face* face) const {
    const auto& all = world_.getCollisionObjectArray();
    for (int i = 0; i < all.size(); ++i) {
        const btSoftBody* const body = btSoftBody::upcast(all[i]);
        if (!body || body->m_faces.size() == 0) continue;
        const btSoftBody::Face* const first = &body->m_faces[0];
        if (face >= first && face < first + body->m_faces.size()) return body;
    }
    return nullptr;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
