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

struct MeetingCloth {
    // To be called at the start of a substep; the tree follows.
    void startMotion();
    // Measures how the nodes have moved. To be called after each small step.
    void measureMotion();
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
    MovingNode* reference;  // see ClothContact
    const char* isCarried;
    float margin;            // m
    float slack;             // how far nodes may deviate before contacts are found again, m
    float adhesiveReach;     // m; 0 if nothing adheres
    std::size_t firstIndex;  // of its nodes among those of all cloths
    bool touches;            // whether a contact has acted in this small step
    bool hasTouchedOthers;   // whether one with other cloth has touched

    // Since the start of the substep.
    Eigen::Vector3f way;                  // sum of the mean displacements of the small steps, m
    Eigen::Vector3f meanStep;             // the last of them, m
    float deviations;                     // sum of the largest differences of any node from them, m
    float growth;                         // the last of them, m
    std::vector<MovingNode> movedBefore;  // displacements at the end of the last small step
    bool isFollowed;                      // whether the tree is where the nodes are
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
