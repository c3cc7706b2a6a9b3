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

void shift(MovingNode& node, const Eigen::Vector3f& by) {
    node.x += by.x();
    node.y += by.y();
    node.z += by.z();
}

// A node moves at most so many times as far as its contact asks for. Where it is the only one that is free, at the far
// end of a face, it would have to move by any multiple.
constexpr float longestLever = 4;

// Moves both sides apart, so that their momentum stays.
void moveApart(ClothContact& contact, const Eigen::Vector3f& by) {
    for (int i = 0; i < 4; ++i) {
        MovingNode& node = *contact.moved[static_cast<std::size_t>(i)];
        shift(node, by * (contact.weights[i] * node.inverseMass / contact.response));
    }
}

// The same by friction. @param by  force times time squared, kg m
void slide(ClothContact& contact, const Eigen::Vector3f& by) {
    for (std::size_t i = 0; i < 4; ++i) {
        MovingNode& node = *contact.moved[i];
        const Eigen::Vector3f share =
            by * contact.slipWeights[static_cast<int>(i)] + contact.axis * contact.turning[i].dot(by);
        shift(node, share * node.inverseMass);
    }
}

// Shifts a node without a change of velocity.
void place(ClothContact& contact, std::size_t i, const Eigen::Vector3f& by) {
    shift(*contact.moved[i], by);
    shift(*contact.reference[i], by);
}

// How far each node moves where both sides are moved apart by one. Nodes that a solid carries stay: it would push them
// back, and that would become velocity.
std::array<float, 4> sharesOf(const ClothContact& contact) {
    std::array<float, 4> shares;
    float response = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const float weight = contact.weights[static_cast<int>(i)];
        shares[i] = *contact.isCarried[i] ? 0 : weight * contact.moved[i]->inverseMass;
        response += shares[i] * weight;
    }
    for (const float share : shares) response = std::max(response, std::abs(share) / longestLever);
    for (float& share : shares) share = response > 0 ? share / response : 0;
    return shares;
}

// Moves both sides apart without a change of velocity.
void placeApart(ClothContact& contact, const Eigen::Vector3f& by) {
    const std::array<float, 4> shares = sharesOf(contact);
    for (std::size_t i = 0; i < 4; ++i) place(contact, i, by * shares[i]);
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
    contact.findResponses();
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

// The plane of a face turns with it. It goes on beyond the face, to where the next face begins.
void followFace(ClothContact& contact) {
    contact.findResponses();
    constexpr float beyond = 0.5f;
    if (contact.axis.isZero(0) || contact.slipWeights.tail<3>().maxCoeff() > beyond) return;
    const float side = contact.axis.dot(contact.normal) < 0 ? -1.0f : 1.0f;
    const float height = side * contact.axis.dot(contact.at(0) - contact.at(1));
    contact.normal = contact.axis * side;
    contact.weights = contact.slipWeights;
    contact.findResponses();
    contact.renewedAt = contact.apart();
    contact.gap = height - contact.distance;
}

// The plane through a point on the border of the cloth has no end. A node far ahead of a border that slides along
// would meet it, and stop the cloth. So the nearest points are found again when they have moved.
void renew(ClothContact& contact) {
    if (!contact.isOfEdges && !contact.isTilted) return followFace(contact);
    Positions at;
    for (std::size_t i = 0; i < 4; ++i) at[i] = contact.at(i);
    if (contact.isOfEdges)
        renewEdges(contact, at);
    else
        renewFace(contact, at);
}

}  // namespace

Eigen::Vector3f ClothContact::between(const std::array<MovingNode*, 4>& nodes) const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int i = 0; i < 4; ++i) sum += vector(*nodes[static_cast<std::size_t>(i)]) * weights[i];
    return sum;
}

Eigen::Vector3f ClothContact::slid() const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector3f by = vector(*moved[i]);
        sum += by * slipWeights[static_cast<int>(i)] + turning[i] * axis.dot(by);
    }
    return sum;
}

Eigen::Vector3f ClothContact::at(std::size_t corner) const {
    return vector(*moved[corner]) + (corner > 0 ? offsets[corner - 1] : Eigen::Vector3f::Zero());
}

void ClothContact::findResponses() {
    findSlipWeights();
    float sum = 0, largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const float weight = std::abs(weights[static_cast<int>(i)]), share = weight * moved[i]->inverseMass;
        sum += share * weight;
        largest = std::max(largest, share);
    }
    response = std::max(sum, largest / longestLever);
}

float ClothContact::slipResponse(const Eigen::Vector3f& direction) const {
    float sum = 0, largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const float weight = slipWeights[static_cast<int>(i)], turn = turning[i].dot(direction);
        const float square = weight * weight + turn * turn, inverseMass = moved[i]->inverseMass;
        sum += inverseMass * square;
        largest = std::max(largest, inverseMass * inverseMass * square);
    }
    return std::max(sum, std::sqrt(largest) / longestLever);
}

void ClothContact::findSlipWeights() {
    slipWeights = weights;
    axis.setZero();
    turning.fill(Eigen::Vector3f::Zero());
    if (isOfEdges)
        findTurningOfEdges();
    else
        findTurningOfFace();
}

// A face whose corners move along its normal n by u turns so that n changes by minus the sum of u and the gradients of
// the barycentric coordinates.
void ClothContact::findTurningOfFace() {
    const Eigen::Vector3f node = at(0), a = at(1), b = at(2), c = at(3);
    const Eigen::Vector3f across = (b - a).cross(c - a);
    const float square = across.squaredNorm();
    constexpr float thin = 1e-3f;  // of the square of its longest side; such a face turns by chance
    const float longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    if (!(square > thin * thin * longest * longest)) return;
    axis = across / std::sqrt(square);
    const std::array<Eigen::Vector3f, 3> gradients = {
        across.cross(c - b) / square, across.cross(a - c) / square, across.cross(b - a) / square};
    const float height = axis.dot(node - a);
    const float toA = 1 + gradients[0].dot(node - a), toB = gradients[1].dot(node - a);
    slipWeights << 1, -toA, -toB, toA + toB - 1;
    for (std::size_t i = 0; i < 3; ++i) turning[i + 1] = gradients[i] * height;
}

// The normal of both edges stays at right angles to each.
void ClothContact::findTurningOfEdges() {
    const Eigen::Vector3f edge = at(1) - at(0), other = at(3) - at(2);
    const float square = edge.squaredNorm(), otherSquare = other.squaredNorm(), both = edge.dot(other);
    const float across = square * otherSquare - both * both;
    constexpr float parallel = 0.04f;  // sine of 12 degrees, squared; such edges turn by chance
    if (!(across > parallel * square * otherSquare)) return;
    axis = normal;
    const float height = gapAt(apart()) + distance;
    turning[1] = (edge * otherSquare - other * both) * (height / across);
    turning[3] = (other * square - edge * both) * (height / across);
    turning[0] = -turning[1];
    turning[2] = -turning[3];
}

ContactStep::ContactStep(float length) : square_(length * length) {
    constexpr float time = 0.1f;     // in which an overlap is resolved, s (assumed)
    constexpr float perSecond = 10;  // distances, at most (assumed)
    closing_ = std::min(length / time, 1.0f);
    fastest_ = perSecond * length;
}

void ContactStep::separate(ClothContact& contact) const {
    contact.placed = 0;
    if (!contact.isActive) return;
    const float overlap = -contact.gapAt(contact.apart());
    // What is through is only kept from going deeper: in a tangle, pulling it back would stretch the cloth for ever.
    if (!(overlap > 0 && overlap < contact.distance)) return;
    contact.placed = std::min(overlap * closing_, fastest_ * contact.distance);
    placeApart(contact, contact.normal * contact.placed);
}

void ContactStep::begin(ClothContact& contact) const {
    contact.before = contact.apart();
    contact.slidBefore = contact.slid();
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
    contact.drag = contact.forces.drag * square_;
    if (contact.push == 0 && contact.drag.isZero(0)) return;
    moveApart(contact, contact.normal * contact.push);
    if (!contact.drag.isZero(0)) slide(contact, contact.drag);
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
    const float pushed = std::abs(push - contact.push);
    moveApart(contact, contact.normal * (push - contact.push));
    contact.push = push;
    contact.touched = contact.touched || push > 0 || contact.adheres;
    const float dragged = rub(contact, contact.friction * (push + pull) / contact.response);
    return std::max(pushed, dragged) / contact.distance;
}

// @param most  limit of friction, kg m
// @return by how much it has moved both sides, m
float ContactStep::rub(ClothContact& contact, float most) const {
    const Eigen::Vector3f slip = alongPlane(contact.slid() - contact.slidBefore, contact.normal);
    const float distance = slip.norm();
    Eigen::Vector3f drag = contact.drag;
    const float response = distance > 0 ? contact.slipResponse(slip / distance) : 0;
    if (response > 0) drag -= slip / response;
    const float needed = drag.norm();
    if (needed > most) drag *= needed > 0 ? std::max(most, 0.0f) / needed : 0.0f;
    const Eigen::Vector3f by = drag - contact.drag;
    if (by.isZero(0)) return 0;
    slide(contact, by);
    contact.drag = drag;
    return by.norm() * contact.response;
}

void ContactStep::beginSettling(ClothContact& contact) const {
    contact.referenceBefore = contact.referenceApart();
    contact.notSettled = contact.placed;
}

void ContactStep::settle(ClothContact& contact) const {
    if (!(contact.notSettled > 0)) return;
    const Eigen::Vector3f moved =
        contact.apart() - contact.before - (contact.referenceApart() - contact.referenceBefore);
    const float pulledBack = std::min(contact.notSettled, -contact.normal.dot(moved));
    if (!(pulledBack > 0 && contact.response > 0)) return;
    contact.notSettled -= pulledBack;
    for (std::size_t i = 0; i < 4; ++i) {
        const float share =
            contact.weights[static_cast<int>(i)] * contact.moved[i]->inverseMass / contact.response;
        shift(*contact.reference[i], contact.normal * (-pulledBack * share));
    }
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
    contact.forces.drag = contact.drag * ((push > 0 ? goesOn / push : 1.0f) / square_);
    contact.forces.push = goesOn;
    // Where the line between both is not along the normal, a push turns the cloth.
    constexpr float near = 0.1f, nearWherePushed = 0.01f;
    const float farthest = (contact.push > 0 ? nearWherePushed : near) * contact.distance;
    if ((apart - contact.renewedAt).squaredNorm() > farthest * farthest) renew(contact);
}

}  // namespace drench
