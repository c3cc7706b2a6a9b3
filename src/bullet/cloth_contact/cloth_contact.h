// A contact of a node of cloth with a face of cloth, or of two edges, in small steps.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "bullet/simd/nodes.h"

namespace drench {

// The forces of a contact, as they go on in the next small step, or in the contact that takes its place.
struct ContactForces {
    float push = 0;                                  // along the normal, N
    Eigen::Vector3f drag = Eigen::Vector3f::Zero();  // of friction, N
};

// Both sides are points of cloth with a plane between them. For a node and a face the weights are 1 and minus the
// barycentric coordinates; for two edges those of the ends of one, and minus those of the other. Small steps go through
// contacts in blocks, which see.
struct ClothContact {
    std::array<int, 4> nodes;
    std::array<const MovingNode*, 4> moved;
    Eigen::Vector4f weights;
    std::array<Eigen::Vector3f, 3>
        offsets;                // of the other nodes from the first, at the start of the substep, m
    Eigen::Vector3f normal;     // from the face to the node, or from the other edge to this one
    Eigen::Vector3f renewedAt;  // displacement apart for which the plane was found, m
    float distance;             // that contact keeps, m
    float gap;                  // then, beyond that distance, m
    float response;             // to an impulse along the normal, 1/kg
    float friction;             // coefficient
    float adhesion = 0;         // N
    float reach = 0;            // of adhesion, m
    float side = 0;             // on which the node is: 1 for that of the face's normal, -1; 0 if unknown
    bool isOfEdges = false;
    bool isActive = true;   // false for edges while the nearest point is an end of one
    bool isTilted = false;  // whether the nearest point is on the border of the cloth, or on a sharp fold
    bool adheres = false;
    bool touched = false;  // in the substep
    float push = 0;        // in the last small step, as the distance that it moves both, m
    ContactForces forces;  // of the last small step

    // How far both points have moved apart since the start of the substep, m.
    Eigen::Vector3f apart() const;
    float gapAt(const Eigen::Vector3f& apart) const { return gap + normal.dot(apart - renewedAt); }
    // Position of a corner, relative to that of the first at the start of the substep, m.
    Eigen::Vector3f at(std::size_t corner) const;
    // To be called when the weights are set.
    void findResponses();
    // Finds the plane again. That through a point on the border of the cloth has no end: a node far ahead of a border that
    // slides along would meet it, and stop the cloth.
    void renew();

    // Friction acts where the node is, a distance above the face: on a point that the face carries along as it turns.
    // With the mere nearest point, cloth that turns would slide on cloth that turns with it, and friction would keep no
    // angular momentum. For edges these are the nearest points, and the line between them turns.
    Eigen::Vector4f slipWeights;
    Eigen::Vector3f axis;  // normal of the face, or of both edges
    // How far the upper point slides, where a corner moves along the axis: the last two corners of a face, of which the
    // first has minus the sum; or the second end of either edge, of which the first has minus that.
    std::array<Eigen::Vector3f, 2> turning;

  private:
    void findSlipWeights();
    void findTurningOfFace();
    void findTurningOfEdges();
    void renewPlane(const Eigen::Vector4f& to, const Eigen::Vector3f& between);
    void renewFace();
    void renewEdges();
    void followFace();
};

}  // namespace drench
