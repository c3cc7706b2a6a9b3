#include "bullet/cloth_contact/near_points.h"

#include <algorithm>

namespace drench {

namespace {

// How far along an edge the nearest point is, from both products along it; 0 for an edge without length.
float fraction(float of, float whole) {
    return whole > 0 ? std::clamp(of / whole, 0.0f, 1.0f) : 0.0f;
}

Eigen::Vector3f nearestWeights(const Eigen::Vector3f& node, const Eigen::Vector3f& a,
                               const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
    const Eigen::Vector3f ab = b - a, ac = c - a, fromA = node - a, fromB = node - b, fromC = node - c;
    const float abA = ab.dot(fromA), acA = ac.dot(fromA);
    if (abA <= 0 && acA <= 0) return {1, 0, 0};
    const float abB = ab.dot(fromB), acB = ac.dot(fromB);
    if (abB >= 0 && acB <= abB) return {0, 1, 0};
    const float areaC = abA * acB - abB * acA;
    if (areaC <= 0 && abA >= 0 && abB <= 0) {
        const float to = fraction(abA, abA - abB);
        return {1 - to, to, 0};
    }
    const float abC = ab.dot(fromC), acC = ac.dot(fromC);
    if (acC >= 0 && abC <= acC) return {0, 0, 1};
    const float areaB = abC * acA - abA * acC;
    if (areaB <= 0 && acA >= 0 && acC <= 0) {
        const float to = fraction(acA, acA - acC);
        return {1 - to, 0, to};
    }
    const float areaA = abB * acC - abC * acB;
    const float towardsC = acB - abB, towardsB = abC - acC;
    if (areaA <= 0 && towardsC >= 0 && towardsB >= 0) {
        const float to = fraction(towardsC, towardsC + towardsB);
        return {0, 1 - to, to};
    }
    const float whole = areaA + areaB + areaC;
    if (!(whole > 0)) return {1, 0, 0};
    return {areaA / whole, areaB / whole, areaC / whole};
}

}  // namespace

NearestOnFace nearestOnFace(const Eigen::Vector3f& node, const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                            const Eigen::Vector3f& c) {
    const Eigen::Vector3f weights = nearestWeights(node, a, b, c);
    return {weights, (node - a) * weights[0] + (node - b) * weights[1] + (node - c) * weights[2]};
}

std::optional<NearestOfEdges> nearestOfEdges(const Eigen::Vector3f& from, const Eigen::Vector3f& to,
                                             const Eigen::Vector3f& otherFrom,
                                             const Eigen::Vector3f& otherTo) {
    const Eigen::Vector3f edge = to - from, other = otherTo - otherFrom, offset = from - otherFrom;
    const float square = edge.dot(edge), otherSquare = other.dot(other), both = edge.dot(other);
    const float across = square * otherSquare - both * both;
    constexpr float parallel = 1e-4f;
    if (!(across > parallel * square * otherSquare)) return std::nullopt;
    const float ofEdge = edge.dot(offset), ofOther = other.dot(offset);
    const float along = (both * ofOther - ofEdge * otherSquare) / across;
    const float alongOther = (square * ofOther - both * ofEdge) / across;
    const bool areInside = along > 0 && along < 1 && alongOther > 0 && alongOther < 1;
    const float on = std::clamp(along, 0.0f, 1.0f), onOther = std::clamp(alongOther, 0.0f, 1.0f);
    return NearestOfEdges{on, onOther, offset + edge * on - other * onOther, areInside};
}

}  // namespace drench
