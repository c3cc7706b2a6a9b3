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
    // Measures how its nodes have moved since contacts were found. Called after each small step.
    void measureMotion();
    // From here on; its tree follows.
    void restartMotion();

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
    bool touches;            // whether it has had contacts in this substep

    // Since contacts were found.
    std::vector<MovingNode> movedAt;  // then
    Eigen::Vector3f mean;             // displacement, m
    Eigen::Vector3f meanStep;         // and in the last small step, m
    float deviation;                  // of any node from the mean, m
    float growth;                     // of that in the last small step, m
    bool isDue;                       // whether they are to be found again
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
