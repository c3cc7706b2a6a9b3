// A hold on a piece of cloth.
#pragma once

#include <vector>

#include "hand/graspable.h"
#include "hand/pointer.h"

namespace drench::demo {

// Holds the nodes around a point of a sheet and takes them along with the pointer, in the plane through that
// point that faces the camera. Held nodes are pins meanwhile, so that it is alike with any solver. The hand
// follows at 6 m/s at most, stops at solids, and gives way when the links around it are strained by a
// fifth, so it cannot tear cloth off its pegs or blow it up, wherever the mouse jumps.
class Grasp {
  public:
    // Takes hold. Nodes that are pinned already stay where they are.
    Grasp(const ClothHit& hit, const Pointer& pointer);

    // Whether the sheet is still one of these; if not, the hold is lost, and there is nothing to let go.
    bool holdsOneOf(const std::vector<Graspable>& sheets) const;
    // Sets the velocity of what is held for the frame that comes, s.
    void follow(const Pointer& pointer, double frameTime);
    // Lets go; what was held keeps its velocity, up to 3 m/s.
    void release();

  private:
    struct Held {
        int node;
        btVector3 offset;  // from the middle of the hold, m
        btScalar inverseMass;
    };
    // How the links that leave the hold pull at it.
    struct Pull {
        btVector3 following = btVector3(0, 0, 0);  // mean velocity of their far ends, m/s
        double strain = 0;                         // of the most strained one
        double length = 0;                         // of one at rest, m
        btVector3 towards = btVector3(0, 0, 0);    // unit length, or zero
    };

    btVector3 target(const Pointer& pointer) const;
    Pull pull() const;
    btVector3 keptFromSolids(const btVector3& velocity, double frameTime) const;
    bool isHeld(const btSoftBody::Node* node) const;

    Graspable sheet_;
    int nodes_;  // of the body, by which to know it again
    std::vector<Held> held_;
    std::vector<char> isHeld_;  // of each node
    btVector3 centre_;          // m
    double depth_;              // of the plane, from the eye, m
    btVector3 velocity_ = btVector3(0, 0, 0);
};

}  // namespace drench::demo
