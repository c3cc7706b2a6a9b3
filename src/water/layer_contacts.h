// Contacts of a sheet with cloth and with solids: which part of each node's faces they cover, how they press it, and
// between which nodes water may pass.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "drench/moisture.h"

namespace drench {

// A contact of a sheet with itself, with another one, or with a solid. Points of either side are given by nodes and
// barycentric weights: the first nodes are of the sheet, the others, if any, of what it touches.
struct LayerContact {
    static constexpr int solid = -1, itself = 0;  // above that, the number of another cloth
    int with;
    int ofSheet;  // number of nodes of the sheet: 1 of a node on a face, 2 of two edges, 3 of a face under a node
    std::array<int, 4> nodes;
    std::array<float, 4> weights;  // those of either side add up to 1
    Eigen::Vector3f towards;       // unit vector from the sheet to what it touches
    float area;   // that touches: of the node on a face, m2; 0 for edges, which touch in points
    float force;  // with which both are pressed together, N; at least 0
};

// What touches either side of the nodes of a sheet. A side is known by the directions of its contacts.
class ContactSides {
  public:
    // For a sheet of so many nodes, of which nothing touches any.
    void clear(std::size_t nodes);
    void add(std::size_t node, const Eigen::Vector3f& towards, double area, double force);
    // Nodes that anything touches, in the order in which they were added.
    const std::vector<std::size_t>& nodes() const { return touched_; }
    // Area of the contacts on the side of a node that faces a direction, m2; an area may count more than once.
    double area(std::size_t node, const Eigen::Vector3f& towards) const;
    // Fraction of both faces of a node that contacts cover, 0 to 1. @param area  of the node, m2
    double covered(std::size_t node, double area) const;
    // The force on the side that is pressed more, N.
    double force(std::size_t node) const;

  private:
    struct Sides {
        Eigen::Vector3f first = Eigen::Vector3f::Zero();  // direction of the first contact
        std::array<double, 2> areas = {0, 0};             // on its side and on the other, m2
        std::array<double, 2> forces = {0, 0};            // N
    };
    static std::size_t sideOf(const Sides& sides, const Eigen::Vector3f& towards) {
        return sides.first.dot(towards) > 0 ? 0 : 1;
    }

    std::vector<Sides> sides_;
    std::vector<std::size_t> touched_;
};

// The contacts of a sheet as sides and as pairs of nodes.
class LayerContacts {
  public:
    // Adds all contacts to the sides of the sheet's nodes.
    static void addAll(const std::vector<LayerContact>& contacts, ContactSides& sides);

    // Pairs of nodes of a sheet and of one of its partners whose cloth touches, with the area that they share. Where
    // nodes of either touch faces of the other, contacts cover the same area twice; it counts once.
    // @param with  the partner's number
    // @param areas, areasOfOther  of the nodes of both, m2; the same list for a sheet with itself
    // @param down  unit vector; zero without gravity
    const std::vector<LayerPair>& pairsWith(int with, const std::vector<LayerContact>& contacts,
                                            const std::vector<double>& areas,
                                            const std::vector<double>& areasOfOther,
                                            const Eigen::Vector3d& down);

  private:
    ContactSides here_, there_;
    std::vector<LayerPair> pairs_;
};

}  // namespace drench
