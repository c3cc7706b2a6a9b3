// The nearest points of a node and a face, and of two edges.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace drench {

// The point of a face that is nearest to a node.
struct NearestOnFace {
    Eigen::Vector3f weights;  // barycentric coordinates
    Eigen::Vector3f apart;    // from that point to the node, m
};

// After Ericson, "Real-Time Collision Detection" (2005), section 5.1.5: the region of the face, its edges or its
// corners in which the node lies.
NearestOnFace nearestOnFace(const Eigen::Vector3f& node, const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                            const Eigen::Vector3f& c);

// The nearest points of two edges.
struct NearestOfEdges {
    float along, alongOther;  // how far along each edge they are, 0 to 1
    Eigen::Vector3f apart;    // from the point of the other edge to that of this one, m
    bool areInside;           // whether neither point is an end of its edge, where nodes and faces meet
};

// None for parallel edges.
std::optional<NearestOfEdges> nearestOfEdges(const Eigen::Vector3f& from, const Eigen::Vector3f& to,
                                             const Eigen::Vector3f& otherFrom,
                                             const Eigen::Vector3f& otherTo);

}  // namespace drench
