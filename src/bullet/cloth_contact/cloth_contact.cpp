#include "bullet/cloth_contact/cloth_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bullet/cloth_contact/near_points.h"
#include "bullet/simd/contact_kernels.h"

namespace drench {

namespace {

Eigen::Vector3f vector(const MovingNode& node) {
    return {node.x, node.y, node.z};
}

}  // namespace

Eigen::Vector3f ClothContact::apart() const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int i = 0; i < 4; ++i) sum += vector(*moved[static_cast<std::size_t>(i)]) * weights[i];
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
    const Eigen::Vector3f ofB = across.cross(a - c) / square, ofC = across.cross(b - a) / square;
    const Eigen::Vector3f above = node - a;
    const float height = axis.dot(above), toB = ofB.dot(above), toC = ofC.dot(above);
    slipWeights << 1, toB + toC - 1, -toB, -toC;
    turning = {ofB * height, ofC * height};
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
    turning[0] = (edge * otherSquare - other * both) * (height / across);
    turning[1] = (other * square - edge * both) * (height / across);
}

// Takes over new nearest points, unless they are too near to tell a direction.
void ClothContact::renewPlane(const Eigen::Vector4f& to, const Eigen::Vector3f& between) {
    const float size = between.norm();
    constexpr float none = 1e-5f;
    if (!(size > none * distance && size < std::numeric_limits<float>::max())) return;
    normal = between / size;
    weights = to;
    renewedAt = apart();
    gap = size - distance;
    findResponses();
}

void ClothContact::renewFace() {
    const Eigen::Vector3f node = at(0), a = at(1), b = at(2), c = at(3);
    const NearestOnFace nearest = nearestOnFace(node, a, b, c);
    const Eigen::Vector3f up = (b - a).cross(c - a);
    // Behind the face the node would be deep inside at once, and be thrown.
    if (!(nearest.apart.dot(normal) > 0 && nearest.apart.dot(up) * side >= 0)) return;
    renewPlane({1, -nearest.weights[0], -nearest.weights[1], -nearest.weights[2]}, nearest.apart);
}

void ClothContact::renewEdges() {
    const auto nearest = nearestOfEdges(at(0), at(1), at(2), at(3));
    const bool wasActive = std::exchange(isActive, nearest && nearest->areInside);
    if (!isActive) {
        forces = {};
        renewedAt = apart();
        return;
    }
    // Edges that have come across each other were on the side where they are now.
    if (wasActive && nearest->apart.dot(normal) < 0) return;
    const float along = nearest->along, alongOther = nearest->alongOther;
    renewPlane({1 - along, along, alongOther - 1, -alongOther}, nearest->apart);
}

// The plane of a face turns with it. It goes on beyond the face, to where the next face begins.
void ClothContact::followFace() {
    findResponses();
    constexpr float beyond = 0.5f;
    if (axis.isZero(0) || slipWeights.tail<3>().maxCoeff() > beyond) return;
    const float onSide = axis.dot(normal) < 0 ? -1.0f : 1.0f;
    const float height = onSide * axis.dot(at(0) - at(1));
    normal = axis * onSide;
    weights = slipWeights;
    findResponses();
    renewedAt = apart();
    gap = height - distance;
}

void ClothContact::renew() {
    if (isOfEdges)
        renewEdges();
    else if (isTilted)
        renewFace();
    else
        followFace();
}

}  // namespace drench
