// Finds the nodes and faces, and the pairs of edges, of two clothes or of one that are near each other.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bullet/cloth_contact/near_points.h"
#include "bullet/cloth_contact/surface_tree.h"

namespace drench {

// A node near a face.
struct NearFace {
    int node;
    int face;  // in the order of its tree
    float distance;
    NearestOnFace nearest;
};

// Two edges that are near each other.
struct NearEdges {
    int edge, other;  // in the order of their trees
    float distance;
    NearestOfEdges nearest;
};

class NearPairs {
  public:
    struct Distances {
        float ofFaces, ofEdges;  // of what is near, m
    };

    // Of two clothes. @param offset  of the origin of the other from that of this one, m
    void find(const SurfaceTree& cloth, const SurfaceTree& other, const Eigen::Vector3f& offset,
              const Distances& near);
    // Of one cloth with itself; its pairs are in `nodes` and `edges`.
    void findWithin(const SurfaceTree& cloth, const Distances& near);

    // Nodes of the first cloth near faces of the other, and the reverse; in ascending order of nodes, and then of
    // distance.
    const std::vector<NearFace>& nodes() const { return nodes_; }
    const std::vector<NearFace>& nodesOfOther() const { return nodesOfOther_; }
    const std::vector<NearEdges>& edges() const { return edges_; }

  private:
    using Box = SurfaceTree::Box;

    void begin(const SurfaceTree& cloth, const SurfaceTree& other, const Eigen::Vector3f& offset,
               const Distances& near);
    void finish();
    void within(int branch);
    void between(int branch, int other);
    void betweenLeaves(int leaf, int other);
    bool areApart(const Box& box, const Box& other) const;
    bool isSkipped(int branch, int other) const;
    bool areLevel(int branch, int other) const;
    // @param ofLeaf  the box of the faces, m
    void nodesNearFaces(const SurfaceTree& ofNodes, const SurfaceTree::Leaf& nodes,
                        const SurfaceTree& ofFaces, const SurfaceTree::Leaf& faces, const Box& ofLeaf,
                        const Eigen::Vector3f& offset, std::vector<NearFace>& found);
    struct NearEdge {
        int edge;
        Eigen::Array3f low, high;  // of its box, m
    };
    void edgesNear(const SurfaceTree& cloth, const SurfaceTree::Leaf& leaf, const Box& box,
                   const Eigen::Vector3f& offset, std::vector<NearEdge>& found) const;
    void edgesNearEdges(const SurfaceTree::Leaf& edges, const Box& ofEdges, const SurfaceTree::Leaf& others,
                        const Box& ofOthers, bool onlyBorders);
    void edgeNearEdge(int edge, int other);

    const SurfaceTree* cloth_ = nullptr;
    const SurfaceTree* other_ = nullptr;
    Eigen::Vector3f offset_ = Eigen::Vector3f::Zero();
    Distances near_ = {0, 0};
    std::vector<NearFace> nodes_, nodesOfOther_;
    std::vector<NearEdges> edges_;
    // Of the present pair of leaves.
    std::vector<int> candidates_;
    std::vector<NearEdge> nearEdges_, nearOthers_;
};

}  // namespace drench
