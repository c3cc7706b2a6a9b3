// A cloth as it meets other cloth within a substep: a sheet, or a soft body that Bullet moves.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <vector>

#include "bullet/cloth_contact/surface_tree.h"
#include "bullet/contact/friction.h"
#include "bullet/simd/nodes.h"
#include "bullet/small_steps/contact_memory.h"
#include "bullet/small_steps/guest_cloth.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Contacts are found for the whole substep, as each node is expected to go on: straight, within a distance. Only if one
// leaves its way they have to be found again.
struct MeetingCloth {
    // To be called at the start of a substep, when the first steps are known.
    void startMotion(int steps);
    // Looks at how the nodes have moved. To be called after each small step.
    // @return whether all are still on their ways after another step like this one
    bool isOnItsWay();
    // Expects that all nodes go on as in the last step.
    void expectMotion();
    // Takes the tree to where the nodes are.
    void followNodes();

    btSoftBody* body;
    Friction* sheetFriction;  // null for guests
    GuestCloth* guest;        // null for sheets
    SurfaceTree* tree;
    ContactMemory* memory;
    btVector3 origin;  // of start, m
    const MovingNode* start;
    MovingNode* moved;
    MovingNode* reference;  // see ContactGroup
    const char* isCarried;
    float margin;            // m
    float cell;              // a fraction of the length of its links, or its margin, m
    float adhesiveReach;     // m; 0 if nothing adheres
    std::size_t firstIndex;  // of its nodes among those of all cloths
    bool isMet;              // whether it is near itself or another
    bool crosses;            // whether it crosses itself or another
    bool isOffItsWay;        // whether a node has left its way in this small step
    bool touches;            // whether a contact has acted in this small step
    bool hasTouchedOthers;   // whether one with other cloth has touched

    std::vector<MovingNode> steps;  // displacements in the last small step, m; first those that are expected
    std::vector<MovingNode> movedBefore;  // displacements at its end, m
    std::vector<MovingNode> from;         // and where the ways begin, m
    std::vector<MovingNode> waySteps;     // per small step, m
    int stepsOfWay;                       // since then
    int horizon;                          // for how many steps that is expected
    int seenAt;                           // step of the way at which the nodes were looked at last
    int stepsUnseen;                      // until they are looked at again
    int stepsLeft;                        // in the substep
    bool isFollowed;                      // whether the tree is where the nodes are
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
