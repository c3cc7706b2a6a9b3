// Finds the nodes and faces, and the pairs of edges, of two clothes or of one that are near each other, or come near.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bullet/cloth_contact/leaf_extents.h"
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
        float farthest;  // from which something comes near that is looked for, beyond those distances, m
    };

    // Of two clothes. @param offset  of the origin of the other from that of this one, m
    void find(const SurfaceTree& cloth, const SurfaceTree& other, const Eigen::Vector3f& offset,
              const Distances& near);
    // Of one cloth with itself; its pairs are in `nodes` and `edges`.
    void findWithin(const SurfaceTree& cloth, const Distances& near);

    // Adds the nearest face of the other cloth to each of some nodes, of the first cloth or of the other, that have none
    // yet. To be called afterwards, with nodes in ascending order. @param farthest  m
    void addNearest(const std::vector<int>& nodes, bool areOfOther, float farthest);

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
    void sortByNode(std::vector<NearFace>& found, std::size_t nodes);
    void within(int branch);
    void between(int branch, int other);
    void betweenLeaves(int leaf, int other);
    bool areApart(const Box& box, const Box& other, float near) const;
    float approach(const Box& box, const Box& other) const;
    float approach(const Eigen::Vector3f& way, const SurfaceTree& other, const int* nodes, int count) const;
    bool isSkipped(int branch, int other) const;
    bool areLevel(int branch, int other) const;
    // A leaf of one of both.
    struct Side {
        const SurfaceTree* cloth;
        int index;
        const SurfaceTree::Leaf* leaf;
        const Box* box;
        const LeafExtents* extents;
    };
    void nodesNearFaces(const Side& ofNodes, const Side& ofFaces, const Eigen::Vector3f& offset,
                        float approach, std::vector<NearFace>& found) const;
    void edgesNearEdges(const Side& one, const Side& two, float approach, bool onlyBorders);
    void edgeNearEdge(int edge, int other);
    // The nearest face to a node.
    struct Nearest {
        const SurfaceTree* ofNode;
        const SurfaceTree* ofFace;
        Eigen::Vector3f position;  // as that of the face, m
        NearFace found;
    };
    void findNearest(Nearest& nearest, int branch) const;

    const SurfaceTree* cloth_ = nullptr;
    const SurfaceTree* other_ = nullptr;
    Eigen::Vector3f offset_ = Eigen::Vector3f::Zero();
    Distances near_ = {0, 0, 0};
    float deviation_ = 0;  // of both from their ways, m
    std::vector<NearFace> nodes_, nodesOfOther_;
    std::vector<NearEdges> edges_;
    std::vector<NearFace> added_;
    std::vector<NearFace> unsorted_;
    std::vector<std::size_t> firstOf_;  // of each node, while they are sorted

    // The extents of the leaves that were looked at in the present search.
    class LeafCache {
      public:
        void renew(const SurfaceTree& cloth);
        const LeafExtents& of(int leaf);

      private:
        struct Leaf {
            long madeFor = 0;
            LeafExtents extents;
        };
        const SurfaceTree* cloth_ = nullptr;
        long present_ = 0;  // number of the search
        std::vector<Leaf> leaves_;
    };
    LeafCache ofCloth_, ofOther_;
};

}  // namespace drench
