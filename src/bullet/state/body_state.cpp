#include "bullet/state/body_state.h"

#include "bullet/sheet/face_tree.h"
#include "bullet/world/limits.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

void passVolume(BulletPass& pass, btDbvtVolume& volume) {
    btVector3 low = volume.Mins(), high = volume.Maxs();
    pass.vector(low);
    pass.vector(high);
    if (pass.restores()) volume = btDbvtVolume::FromMM(low, high);
}

// Recomputes the volumes above the leaves.
void refit(btDbvtNode* node) {
    if (!node || node->isleaf()) return;
    refit(node->childs[0]);
    refit(node->childs[1]);
    Merge(node->childs[0]->volume, node->childs[1]->volume, node->volume);
}

}  // namespace

void BodyState::state(BulletPass& pass) {
    nodes(pass);
    linksAndFaces(pass);
    sleep(pass);
    trees(pass);
}

void BodyState::nodes(BulletPass& pass) {
    for (int n = 0; n < body_.m_nodes.size(); ++n) {
        btSoftBody::Node& node = body_.m_nodes[n];
        for (btVector3* position : {&node.m_x, &node.m_q}) pass.vector(*position, farthestPosition);
        pass.vector(node.m_v, fastestNode);
        for (btVector3* vector : {&node.m_f, &node.m_n}) pass.vector(*vector);
        pass.number(node.m_im, 0, BulletPass::farthest);
        if (!isDeformable_) continue;
        for (btVector3* velocity : {&node.m_vn, &node.m_splitv}) pass.vector(*velocity, fastestNode);
        pass.matrix(node.m_effectiveMass);
        pass.matrix(node.m_effectiveMass_inv);
        pass.number(node.m_constrained);
    }
}

void BodyState::linksAndFaces(BulletPass& pass) {
    for (int i = 0; i < body_.m_links.size(); ++i) {
        btSoftBody::Link& link = body_.m_links[i];
        pass.number(link.m_c0);
        pass.number(link.m_c2);
        pass.vector(link.m_c3);
    }
    for (int i = 0; i < body_.m_faces.size(); ++i) pass.vector(body_.m_faces[i].m_normal);
}

void BodyState::sleep(BulletPass& pass) {
    const auto activation =
        pass.value(static_cast<std::int32_t>(body_.getActivationState()), 0, DISABLE_SIMULATION);
    const auto time = pass.value(body_.getDeactivationTime(), 0);
    pass.number(body_.m_maxSpeedSquared, 0);
    pass.flag(body_.m_bUpdateRtCst);
    for (btVector3& corner : body_.m_bounds) pass.vector(corner);
    if (!pass.restores()) return;
    body_.forceActivationState(activation);
    body_.setDeactivationTime(time);
}

void BodyState::trees(BulletPass& pass) {
    const bool hasFaceTree = pass.value(!body_.m_fdbvt.empty());
    if (pass.restores()) restoreFaceTree(hasFaceTree);
    btDbvtVolume scratch = btDbvtVolume::FromCR({0, 0, 0}, 0);
    const auto volumeOf = [&](btDbvtNode* leaf) -> btDbvtVolume& { return leaf ? leaf->volume : scratch; };
    for (int n = 0; n < body_.m_nodes.size(); ++n) passVolume(pass, volumeOf(body_.m_nodes[n].m_leaf));
    refit(pass.restores() ? body_.m_ndbvt.m_root : nullptr);
    if (!hasFaceTree) return;
    for (int f = 0; f < body_.m_faces.size(); ++f) passVolume(pass, volumeOf(body_.m_faces[f].m_leaf));
    refit(pass.restores() ? body_.m_fdbvt.m_root : nullptr);
}

// Building a face tree also rebuilds the tree of nodes, so if there was no face tree there must be none.
void BodyState::restoreFaceTree(bool wanted) {
    if (wanted == !body_.m_fdbvt.empty()) return;
    if (wanted) return makeFaceTree(body_);
    dropFaceTree(body_);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
