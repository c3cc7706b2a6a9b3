// What contacts of cloth leave to those that take their place: sides, forces and slip.
#pragma once

#include <BulletSoftBody/btSoftBody.h>

#include <Eigen/Core>
#include <vector>

#include "bullet/cloth_contact/cloth_contact.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

class BulletPass;

// Of the contacts of one cloth, as owner of the node or of the first edge.
class ContactMemory {
  public:
    struct Contact {
        int node;                    // of the first edge, for edges
        int otherEnd;                // of that edge; -1 for a node and a face
        const btSoftBody* other;     // by address only
        std::array<int, 3> corners;  // of the face; for an edge its ends, and -1
        Eigen::Vector3f normal;
        float
            side;  // of the face on which the node is, 1 or -1; 0 at the border of the cloth, where there are none
        ContactForces forces;
    };

    void clear() { contacts_.clear(); }
    bool isEmpty() const { return contacts_.empty(); }
    void add(const Contact& contact) { contacts_.push_back(contact); }
    // To be called after all were added.
    void sort();
    // The last contact of a node with a face, or else with one that shares a node with that; null for none.
    const Contact* ofFace(int node, const btSoftBody& other, const std::array<int, 3>& corners) const;
    // Calls a function with each of the last contacts of a node with faces of another body.
    template <typename Function>
    void forFacesOf(int node, const btSoftBody& other, Function function) const {
        for (auto each = firstOf(node); each != contacts_.end() && each->node == node; ++each)
            if (each->other == &other && each->otherEnd < 0) function(*each);
    }
    static bool shareNode(const std::array<int, 3>& corners, const std::array<int, 3>& others);
    // The last contact of two edges; null for none.
    const Contact* ofEdges(int node, int otherEnd, const btSoftBody& other, int from, int to) const;

    // Notes whether the cloth crosses itself or other cloth, for so long, s.
    void noteCrossing(bool crosses, double time) { crossing_ = crosses ? crossing_ + time : 0; }
    // How long it has done so, s.
    double crossing() const { return crossing_; }

    void state(BulletPass& pass);

  private:
    std::vector<Contact>::const_iterator firstOf(int node) const;

    std::vector<Contact> contacts_;  // in the order of the nodes
    double crossing_ = 0;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
