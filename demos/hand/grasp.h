// Holds a part of a sheet for the mouse.
#pragma once

#include <vector>

#include "hand/graspable.h"
#include "hand/pointer.h"

namespace drench::demo {

// Holds the nodes around a point of a sheet and moves them with the pointer, in the plane through that point
// that faces the camera. Held nodes are pinned, so that the effect is the same with every solver. The hand
// follows at up to 6 m/s, stops at solids, and yields when the links around it are stretched by a fifth. So
// it cannot tear cloth off its pegs or make it unstable, wherever the mouse jumps.
class Grasp {
  public:
    // Starts to hold. Nodes that are already pinned stay where they are.
    Grasp(const ClothHit& hit, const Pointer& pointer);

    // Whether the sheet still exists among these; if not, there is nothing left to release.
    bool holdsOneOf(const std::vector<Graspable>& sheets) const;
    // Sets the velocity of the held nodes for the next frame, s.
    void follow(const Pointer& pointer, double frameTime);
    // Releases the nodes; they keep their velocity, up to 3 m/s.
    void release();

  private:
    struct Held {
        int node;
        btVector3 offset;  // from the middle of the hold, m
        btScalar inverseMass;
    };
    // The state of the links at the border of the held part.
    struct Pull {
        btVector3 following = btVector3(0, 0, 0);  // mean velocity of their far ends, m/s
        double strain = 0;                         // of the most stretched link
        double length = 0;                         // mean rest length, m
        btVector3 towards = btVector3(0, 0, 0);    // unit length, or zero
    };

    btVector3 target(const Pointer& pointer) const;
    Pull pull() const;
    btVector3 keptFromSolids(const btVector3& velocity, double frameTime) const;
    bool isHeld(const btSoftBody::Node* node) const;

    Graspable sheet_;
    int nodes_;  // number of nodes of the body, to recognise it
    std::vector<Held> held_;
    std::vector<char> isHeld_;  // of each node
    btVector3 centre_;          // m
    double depth_;              // of the plane, from the eye, m
    btVector3 velocity_ = btVector3(0, 0, 0);
};

}  // namespace drench::demo
