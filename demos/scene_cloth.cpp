#include "scene_cloth.h"

#include <algorithm>

namespace drench::demo {

SceneCloth::SceneCloth(std::string name, SceneWorld& world, const Fabric& fabric, const Corners& corners,
                       int nodesWarp, int nodesWeft)
    : name_(std::move(name)),
      world_(world),
      nodesWarp_(nodesWarp),
      nodesWeft_(nodesWeft),
      body_(makeSheet(world.worldInfo(), fabric, corners, nodesWarp, nodesWeft)),
      wet_(std::make_unique<WetCloth>(world.world(), *body_, fabric)) {
    world_.addSoftBody(*body_);
}

SceneCloth::~SceneCloth() {
    wet_.reset();
    world_.removeSoftBody(*body_);
}

void SceneCloth::place(int i, int j, const btVector3& position) {
    node(i, j).m_x = position;
    node(i, j).m_q = position;
}

double SceneCloth::mass() const {
    return wet_->dryMass() + wet_->waterMass();
}

double SceneCloth::lowest() const {
    btScalar y = body_->m_nodes[0].m_x.y();
    for (int n = 1; n < body_->m_nodes.size(); ++n) y = std::min(y, body_->m_nodes[n].m_x.y());
    return double(y);
}

double SceneCloth::highest() const {
    btScalar y = body_->m_nodes[0].m_x.y();
    for (int n = 1; n < body_->m_nodes.size(); ++n) y = std::max(y, body_->m_nodes[n].m_x.y());
    return double(y);
}

double SceneCloth::largestStretch() const {
    double largest = 0;
    for (int l = 0; l < body_->m_links.size(); ++l) {
        const btSoftBody::Link& link = body_->m_links[l];
        const long first = link.m_n[0] - &body_->m_nodes[0], second = link.m_n[1] - &body_->m_nodes[0];
        const bool shears =
            first % nodesWarp_ != second % nodesWarp_ && first / nodesWarp_ != second / nodesWarp_;
        if (link.m_bbending || shears) continue;
        largest = std::max(largest, double((link.m_n[1]->m_x - link.m_n[0]->m_x).length() / link.m_rl) - 1);
    }
    return largest;
}

double SceneCloth::meanSpeed() const {
    double sum = 0;
    for (int n = 0; n < body_->m_nodes.size(); ++n) sum += double(body_->m_nodes[n].m_v.length());
    return sum / body_->m_nodes.size();
}

btVector3 SceneCloth::centre() const {
    btVector3 sum(0, 0, 0);
    for (int n = 0; n < body_->m_nodes.size(); ++n) sum += body_->m_nodes[n].m_x;
    return sum / btScalar(body_->m_nodes.size());
}

}  // namespace drench::demo
