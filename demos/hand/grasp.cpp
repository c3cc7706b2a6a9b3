#include "hand/grasp.h"

#include <algorithm>

#include "world/vectors.h"

namespace drench::demo {

namespace {

constexpr double holdReach = 0.05;     // m, around the point that was picked
constexpr double fastest = 6;          // m/s, of the hand
constexpr double fastestReleased = 3;  // m/s
constexpr double maxStrain = 0.2;      // of the links at the border of the held part
constexpr double clearance = 0.015;    // m, from solids
constexpr double followingFrames = 2;  // number of frames in which the hand reaches a resting pointer

btVector3 limited(const btVector3& v, double max) {
    const double length = double(v.length());
    return length > max ? v * btScalar(max / length) : v;
}

}  // namespace

Grasp::Grasp(const ClothHit& hit, const Pointer& pointer)
    : sheet_(hit.sheet),
      nodes_(hit.sheet.body->m_nodes.size()),
      isHeld_(static_cast<std::size_t>(nodes_), 0),
      centre_(hit.point),
      depth_(double((hit.point - toBullet(pointer.ray.origin.cast<double>()))
                        .dot(toBullet(pointer.forward.cast<double>())))) {
    btSoftBody& body = *sheet_.body;
    const btSoftBody::Face& face = body.m_faces[hit.face];
    for (int n = 0; n < nodes_; ++n) {
        btSoftBody::Node& node = body.m_nodes[n];
        const bool ofFace = &node == face.m_n[0] || &node == face.m_n[1] || &node == face.m_n[2];
        if (!(node.m_im > 0) || !(ofFace || double((node.m_x - centre_).length()) < holdReach)) continue;
        held_.push_back({n, node.m_x - centre_, node.m_im});
        isHeld_[static_cast<std::size_t>(n)] = 1;
        node.m_im = 0;
        node.m_v.setZero();
    }
}

bool Grasp::holdsOneOf(const std::vector<Graspable>& sheets) const {
    return std::any_of(sheets.begin(), sheets.end(), [&](const Graspable& sheet) {
        return sheet.body == sheet_.body && sheet.cloth == sheet_.cloth &&
               sheet.body->m_nodes.size() == nodes_;
    });
}

btVector3 Grasp::target(const Pointer& pointer) const {
    constexpr float grazing = 0.05f;
    const float along = std::max(grazing, pointer.ray.direction.dot(pointer.forward));
    return toBullet((pointer.ray.origin + float(depth_) / along * pointer.ray.direction).cast<double>());
}

bool Grasp::isHeld(const btSoftBody::Node* node) const {
    return isHeld_[static_cast<std::size_t>(node - &sheet_.body->m_nodes[0])] != 0;
}

Grasp::Pull Grasp::pull() const {
    Pull pull;
    int links = 0;
    const btSoftBody& body = *sheet_.body;
    for (int l = 0; l < body.m_links.size(); ++l) {
        const btSoftBody::Link& link = body.m_links[l];
        const bool first = isHeld(link.m_n[0]);
        if (link.m_bbending || first == isHeld(link.m_n[1])) continue;
        const btVector3 offset = (link.m_n[1]->m_x - link.m_n[0]->m_x) * btScalar(first ? 1 : -1);
        const double strain = double(offset.length() / link.m_rl) - 1;
        pull.strain = std::max(pull.strain, strain);
        if (strain > 0) pull.towards += offset.normalized() * btScalar(strain);
        pull.length = double(link.m_rl);
        pull.following += link.m_n[first ? 1 : 0]->m_v;
        ++links;
    }
    if (links > 0) pull.following /= btScalar(links);
    if (!pull.towards.fuzzyZero()) pull.towards.normalize();
    return pull;
}

btVector3 Grasp::keptFromSolids(const btVector3& velocity, double frameTime) const {
    const btVector3 offset = velocity * btScalar(frameTime);
    const double length = double(offset.length());
    if (!(length > 1e-6)) return velocity;
    const btVector3 beyond = offset * btScalar((length + clearance) / length);
    const auto solid = firstSolid(*sheet_.world, centre_, centre_ + beyond);
    if (!solid) return velocity;
    const btScalar into = velocity.dot(solid->normal);
    return into < 0 ? velocity - solid->normal * into : velocity;
}

void Grasp::follow(const Pointer& pointer, double frameTime) {
    const btVector3 offset = target(pointer) - centre_;
    btVector3 velocity = limited(offset / btScalar(followingFrames * frameTime), fastest);
    const Pull by = pull();
    const double slack = (maxStrain - by.strain) * by.length / frameTime;
    // No faster than the cloth around can follow, and less if that cloth is already stretched.
    velocity = by.following + limited(velocity - by.following, maxStrain * by.length / frameTime);
    const btScalar away = -velocity.dot(by.towards);
    if (double(away) > slack) velocity += by.towards * btScalar(double(away) - slack);
    velocity_ = limited(keptFromSolids(velocity, frameTime), fastest);
    centre_ += velocity_ * btScalar(frameTime);
    for (const Held& held : held_) {
        btSoftBody::Node& node = sheet_.body->m_nodes[held.node];
        node.m_im = 0;
        node.m_v = limited((centre_ + held.offset - node.m_x) / btScalar(frameTime), fastest);
    }
    sheet_.body->activate();
}

void Grasp::release() {
    for (const Held& held : held_) {
        btSoftBody::Node& node = sheet_.body->m_nodes[held.node];
        node.m_im = held.inverseMass;
        node.m_v = limited(velocity_, fastestReleased);
    }
    sheet_.body->activate();
}

}  // namespace drench::demo
