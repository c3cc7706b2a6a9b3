#include "bullet/cloth_contact/cloth_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "bullet/cloth_contact/near_points.h"

namespace drench {

namespace {

Eigen::Vector3f vector(const MovingNode& node) {
    return {node.x, node.y, node.z};
}

// A node moves at most so many times as far as its contact asks for. Where it is the only one that is free, at the far
// end of a face, it would have to move by any multiple.
constexpr float longestLever = 4;

// Moves both sides apart, so that their momentum stays.
void moveApart(ClothContact& contact, const Eigen::Vector3f& by) {
    for (int i = 0; i < 4; ++i) {
        MovingNode& node = *contact.moved[static_cast<std::size_t>(i)];
        const float share = contact.weights[i] * node.inverseMass / contact.response;
        node.x += by.x() * share;
        node.y += by.y() * share;
        node.z += by.z() * share;
    }
}

// Shifts a node without a change of velocity.
void place(ClothContact& contact, std::size_t i, const Eigen::Vector3f& by) {
    for (MovingNode* const node : {contact.moved[i], contact.reference[i]}) {
        node->x += by.x();
        node->y += by.y();
        node->z += by.z();
    }
}

// Moves both sides apart without a change of velocity. Nodes that a solid carries stay: it would push them back, and
// that would become velocity.
void placeApart(ClothContact& contact, const Eigen::Vector3f& by) {
    std::array<float, 4> shares;
    float response = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const float weight = contact.weights[static_cast<int>(i)];
        shares[i] = *contact.isCarried[i] ? 0 : weight * contact.moved[i]->inverseMass;
        response += shares[i] * weight;
    }
    for (const float share : shares) response = std::max(response, std::abs(share) / longestLever);
    if (!(response > 0)) return;
    for (std::size_t i = 0; i < 4; ++i) place(contact, i, by * (shares[i] / response));
}

Eigen::Vector3f alongPlane(const Eigen::Vector3f& of, const Eigen::Vector3f& normal) {
    return of - normal * normal.dot(of);
}

// Takes over new nearest points, unless they are too near to tell a direction.
void renewPlane(ClothContact& contact, const Eigen::Vector4f& weights, const Eigen::Vector3f& between) {
    const float distance = between.norm();
    constexpr float none = 1e-5f;
    if (!(distance > none * contact.distance && distance < std::numeric_limits<float>::max())) return;
    contact.normal = between / distance;
    contact.weights = weights;
    contact.findResponse();
    contact.renewedAt = contact.apart();
    contact.gap = distance - contact.distance;
}

using Positions = std::array<Eigen::Vector3f, 4>;

void renewFace(ClothContact& contact, const Positions& at) {
    const NearestOnFace nearest = nearestOnFace(at[0], at[1], at[2], at[3]);
    const Eigen::Vector3f up = (at[2] - at[1]).cross(at[3] - at[1]);
    // Behind the face the node would be deep inside at once, and be thrown.
    if (!(nearest.apart.dot(contact.normal) > 0 && nearest.apart.dot(up) * contact.side >= 0)) return;
    renewPlane(contact, {1, -nearest.weights[0], -nearest.weights[1], -nearest.weights[2]}, nearest.apart);
}

void renewEdges(ClothContact& contact, const Positions& at) {
    const auto nearest = nearestOfEdges(at[0], at[1], at[2], at[3]);
    const bool wasActive = std::exchange(contact.isActive, nearest && nearest->areInside);
    if (!contact.isActive) {
        contact.forces = {};
        contact.renewedAt = contact.apart();
        return;
    }
    // Edges that have come across each other were on the side where they are now.
    if (wasActive && nearest->apart.dot(contact.normal) < 0) return;
    const float along = nearest->along, alongOther = nearest->alongOther;
    renewPlane(contact, {1 - along, along, alongOther - 1, -alongOther}, nearest->apart);
}

// The plane through a point on the border of the cloth has no end. A node far ahead of a border that slides along
// would meet it, and stop the cloth. So the nearest points are found again when they have moved.
void renew(ClothContact& contact) {
    Positions at;
    for (std::size_t i = 0; i < 4; ++i)
        at[i] = vector(*contact.moved[i]) + (i > 0 ? contact.offsets[i - 1] : Eigen::Vector3f::Zero());
    if (contact.isOfEdges)
        renewEdges(contact, at);
    else
        renewFace(contact, at);
}

}  // namespace

Eigen::Vector3f ClothContact::apart() const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int i = 0; i < 4; ++i) sum += vector(*moved[static_cast<std::size_t>(i)]) * weights[i];
    return sum;
}

void ClothContact::findResponse() {
    float sum = 0, largest = 0;
    for (int i = 0; i < 4; ++i) {
        const float share = std::abs(weights[i]) * moved[static_cast<std::size_t>(i)]->inverseMass;
        sum += share * std::abs(weights[i]);
        largest = std::max(largest, share);
    }
    response = std::max(sum, largest / longestLever);
}

ContactStep::ContactStep(float length) : square_(length * length) {
    constexpr float time = 0.02f;    // in which an overlap is resolved, s (assumed)
    constexpr float perSecond = 10;  // distances, at most (assumed)
    closing_ = std::min(length / time, 1.0f);
    fastest_ = perSecond * length;
}

void ContactStep::separate(ClothContact& contact) const {
    if (!contact.isActive) return;
    const float overlap = -contact.gapAt(contact.apart());
    // What is through is only kept from going deeper: in a tangle, pulling it back would stretch the cloth for ever.
    if (!(overlap > 0 && overlap < contact.distance)) return;
    placeApart(contact, contact.normal * std::min(overlap * closing_, fastest_ * contact.distance));
}

void ContactStep::begin(ClothContact& contact) const {
    contact.before = contact.apart();
    contact.gapBefore = contact.gapAt(contact.before);
    contact.push = 0;
    contact.drag.setZero();
}

void ContactStep::goOn(ClothContact& contact) const {
    constexpr float near = 0.02f;
    const bool touches = contact.adheres || contact.gapBefore < near * contact.distance;
    if (!contact.isActive || !(contact.response > 0) || !touches) return;
    const float perForce = square_ * contact.response;
    contact.push =
        contact.adheres ? contact.forces.push * perForce : std::max(contact.forces.push, 0.0f) * perForce;
    contact.drag = contact.forces.drag * perForce;
    if (contact.push == 0 && contact.drag.isZero(0)) return;
    moveApart(contact, contact.normal * contact.push + contact.drag);
}

float ContactStep::solve(ClothContact& contact) const {
    if (!contact.isActive || !(contact.response > 0)) return 0;
    const Eigen::Vector3f apart = contact.apart();
    const float gap = contact.gapAt(apart);
    if (gap > 0 && contact.push == 0 && !contact.adheres) return 0;
    if (!(std::abs(gap) < std::numeric_limits<float>::max())) return 0;
    contact.adheres = contact.adhesion > 0 && (contact.adheres || gap < 0) && gap < contact.reach;
    const float pull = contact.adheres ? contact.adhesion * square_ * contact.response : 0;
    const float target = std::min(0.0f, -contact.gapBefore);
    const Eigen::Vector3f moved = apart - contact.before;
    const float opened = contact.normal.dot(moved);
    const float push = std::max(contact.push + target - opened, -pull);
    // The part along the plane is not changed by the push.
    const Eigen::Vector3f slip = alongPlane(moved, contact.normal);
    Eigen::Vector3f drag = contact.drag - slip;
    const float most = contact.friction * (push + pull), needed = drag.norm();
    if (needed > most) drag *= needed > 0 ? std::max(most, 0.0f) / needed : 0.0f;
    const Eigen::Vector3f by = contact.normal * (push - contact.push) + (drag - contact.drag);
    moveApart(contact, by);
    contact.push = push;
    contact.drag = drag;
    contact.touched = contact.touched || push > 0 || contact.adheres;
    return by.lpNorm<Eigen::Infinity>() / contact.distance;
}

void ContactStep::finish(ClothContact& contact) const {
    if (!(contact.response > 0)) return;
    const Eigen::Vector3f apart = contact.apart();
    const float perForce = square_ * contact.response;
    // A load goes on, an impact does not: what would hold the nodes at this acceleration may be added in a step.
    constexpr float growth = 1.5f, added = 60;  // m/s2 (assumed)
    const float push = contact.push / perForce;
    const float most = growth * std::max(contact.forces.push, 0.0f) + added / contact.response;
    const float goesOn = std::min(push, most);
    contact.forces.drag = contact.drag * ((push > 0 ? goesOn / push : 1.0f) / perForce);
    contact.forces.push = goesOn;
    constexpr float near = 0.1f;
    const float farthest = near * contact.distance;
    const bool hasEnd = contact.isTilted || contact.isOfEdges;
    if (hasEnd && (apart - contact.renewedAt).squaredNorm() > farthest * farthest) renew(contact);
}

}  // namespace drench
