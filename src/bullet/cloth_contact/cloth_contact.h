// A contact of a node of cloth with a face of cloth, or of two edges, in small steps.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "bullet/simd/nodes.h"

namespace drench {

// The forces of a contact, as they go on in the next small step, or in the contact that takes its place.
struct ContactForces {
    float push = 0;                                  // along the normal, N
    Eigen::Vector3f drag = Eigen::Vector3f::Zero();  // of friction, N
};

// Both sides are points of cloth with a plane between them. For a node and a face the weights are 1 and minus the
// barycentric coordinates; for two edges those of the ends of one, and minus those of the other.
struct ClothContact {
    std::array<MovingNode*, 4> moved;
    std::array<MovingNode*, 4> reference;  // from which their velocity counts: a shift of both adds none
    std::array<const char*, 4> isCarried;  // by a solid
    Eigen::Vector4f weights;
    std::array<Eigen::Vector3f, 3>
        offsets;                 // of the other nodes from the first, at the start of the substep, m
    Eigen::Vector3f normal;      // from the face to the node, or from the other edge to this one
    Eigen::Vector3f renewedAt;   // displacement apart for which the plane was found, m
    Eigen::Vector3f before;      // displacement apart at the start of the small step, m
    Eigen::Vector3f slidBefore;  // and slid, m
    float distance;              // that contact keeps, m
    float gap;                   // then, beyond that distance, m
    float response;              // to an impulse along the normal, 1/kg
    float friction;              // coefficient
    float adhesion = 0;          // N
    float reach = 0;             // of adhesion, m
    float side = 0;              // on which the node is: 1 for that of the face's normal, -1; 0 if unknown
    bool isOfEdges = false;
    bool isActive = true;   // false for edges while the nearest point is an end of one
    bool isTilted = false;  // whether the nearest point is on the border of the cloth, or on a sharp fold
    bool adheres = false;
    bool touched = false;

    float gapBefore = 0;              // at the start of the small step, m
    Eigen::Vector3f referenceBefore;  // displacement apart of the reference when settling begins, m
    float notSettled = 0;             // of what it was placed, m
    float placed = 0;                 // how far it was placed apart in the small step, m
    float push = 0;                   // in the small step, as the distance that it moves both, m
    Eigen::Vector3f drag =
        Eigen::Vector3f::Zero();  // of friction in the small step, its force times time squared, kg m
    ContactForces forces;         // of the last small step

    // How far both points have moved apart since the start of the substep, m.
    Eigen::Vector3f apart() const { return between(moved); }
    // The same of the reference.
    Eigen::Vector3f referenceApart() const { return between(reference); }
    float gapAt(const Eigen::Vector3f& apart) const { return gap + normal.dot(apart - renewedAt); }
    // How far one side has slid along the other since the start of the substep, m; it may have a part along the normal.
    Eigen::Vector3f slid() const;
    // Position of a corner, relative to that of the first at the start of the substep, m.
    Eigen::Vector3f at(std::size_t corner) const;
    // To be called when the weights are set.
    void findResponses();

    // Friction acts where the node is, a distance above the face: on a point that the face carries along as it turns.
    // With the mere nearest point, cloth that turns would slide on cloth that turns with it, and friction would keep no
    // angular momentum. For edges these are the nearest points, and the line between them turns.
    Eigen::Vector4f slipWeights;
    Eigen::Vector3f axis;  // normal of the face, or of both edges
    std::array<Eigen::Vector3f, 4>
        turning;  // how far the upper point slides, where a corner moves along the axis
    // To an impulse along a direction in the plane, 1/kg.
    float slipResponse(const Eigen::Vector3f& direction) const;

  private:
    Eigen::Vector3f between(const std::array<MovingNode*, 4>& nodes) const;
    void findSlipWeights();
    void findTurningOfFace();
    void findTurningOfEdges();
};

// One small step of contacts.
//
// Forces go on from step to step (warm starting), so that a stack of layers carries its weight although each step
// corrects each contact only a few times. Where layers overlap, they are moved apart without velocity, with a time
// constant and no faster than a limit. Where the cloth pulls them back at once, that is no velocity either. So errors do
// not become motion, and layers at rest stay at rest.
class ContactStep {
  public:
    // @param length  of the step, s
    explicit ContactStep(float length);

    // Of all contacts, in this order: the first two before the nodes move; then once; then in each sweep; and the last
    // three, of which the second several times, when everything else has moved the nodes as well.
    void separate(ClothContact& contact) const;
    void begin(ClothContact& contact) const;
    void goOn(ClothContact& contact) const;
    // @return by how much it has moved both sides, as a fraction of the distance
    float solve(ClothContact& contact) const;
    void beginSettling(ClothContact& contact) const;
    void settle(ClothContact& contact) const;
    void finish(ClothContact& contact) const;

  private:
    float rub(ClothContact& contact, float most) const;

    float square_;   // of the length, s2
    float closing_;  // fraction of an overlap that a step resolves
    float fastest_;  // and its limit, as a fraction of the distance
};

}  // namespace drench
