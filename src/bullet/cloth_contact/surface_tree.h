// The faces, edges and nodes of one cloth in a tree of boxes, to find what is near.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "bullet/simd/nodes.h"
#include "cloth/compressed_rows.h"

namespace drench {

// Made once for a cloth; its boxes follow the nodes. The tree is made in material coordinates, so that a box holds
// one piece of cloth, however that is folded. Besides its extent each box holds that of the unit normals of its
// faces: cloth whose normals all point to one side does not meet itself (Volino and Magnenat-Thalmann, "Efficient
// self-collision detection on smoothly discretized surface animations", 1994).
class SurfaceTree {
  public:
    struct Face {
        std::array<int, 3>
            nodes;  // neighbours in the same sense, so that their normals point to the same side
        int index;  // in the body
    };
    struct Edge {
        std::array<int, 2> nodes;
        std::array<int, 2> faces;  // at it, in the order of the tree; the second is -1 at the border

        bool isBorder() const { return faces[1] < 0; }
    };
    struct Box {
        Eigen::Array3f low, high;              // m
        Eigen::Array3f lowWay, highWay;        // of the ways of nodes, m
        Eigen::Array3f lowNormal, highNormal;  // of unit normals
    };
    // A box with two smaller ones in it, or with a few faces.
    struct Branch {
        int children[2];  // -1 for a leaf
        int leaf;         // -1 if it has children
    };
    // Ranges of faces, and of the nodes and edges that this is the first leaf to have.
    struct Leaf {
        int firstFace, endFace;
        int firstNode, endNode;  // in nodes()
        int firstEdge, endEdge;
        bool hasBorder;  // whether an edge of the leaf is at the border of the cloth
        int branch;
    };

    // Material coordinates of the corners of a face, m; the third is 0 for a sheet.
    using Corners = std::array<Eigen::Vector3f, 3>;

    // @param triangles   node indices of each face of the body
    // @param distance    that contacts keep, m
    SurfaceTree(const std::vector<std::array<int, 3>>& triangles, std::size_t nodes,
                const std::vector<Corners>& corners, float distance);

    // How the nodes go on: each on a straight way, and no farther from it than some distance.
    struct Motion {
        const MovingNode* perStep;  // m
        float steps;
        float deviation;  // m
    };
    // Takes over the positions of the nodes: their start and their displacement, m; and their ways from there.
    void follow(const MovingNode* start, const MovingNode* moved, const Motion& motion);
    // The same of nodes that stay there.
    void follow(const MovingNode* start, const MovingNode* moved) { follow(start, moved, {moved, 0, 0}); }

    // Whether two nodes are neighbours, or have a way along edges that is hardly longer than the distance that contacts
    // keep. They are as near by nature, and are not to be kept apart.
    bool areClose(int node, int other) const;
    // Faces of a leaf that have a node close to one, or edges that have one close to an end of one: one bit each.
    using Bits = std::uint32_t;
    Bits closeFaces(int node, int leaf) const { return bitsOf(closeFaces_, node, leaf); }
    Bits closeEdges(int edge, int leaf) const { return bitsOf(closeEdges_, edge, leaf); }

    std::size_t nodeCount() const { return positions_.size(); }
    const std::vector<Eigen::Vector3f>& positions() const { return positions_; }
    const std::vector<Eigen::Vector3f>& ways() const { return ways_; }
    float deviation() const { return deviation_; }
    const std::vector<Face>& faces() const { return faces_; }
    const std::vector<Eigen::Vector3f>& normals() const { return normals_; }
    const std::vector<Edge>& edges() const { return edges_; }
    const std::vector<int>& nodes() const { return nodes_; }
    const std::vector<Branch>& branches() const { return branches_; }
    const std::vector<Box>& boxes() const { return boxes_; }
    const std::vector<Leaf>& leaves() const { return leaves_; }
    // Whether two leaves are neighbours on cloth that does not bend back there: they have nodes that are close, or other
    // leaves have nodes that are close to those of both; and all these are one-sided.
    bool areOneSidedNeighbours(int leaf, int other) const;
    // Whether the normals in a box are so near some direction that the cloth does not come as near to itself as contacts
    // keep it. Cloth whose normals are within an angle of some direction, at two points that are so far apart along it,
    // has them at least that times the cosine apart.
    bool isOneSided(const Box& box) const { return pointToOneSide(box, oneSided_); }

    // Whether all normals in a box are within an angle of some direction. @param cosine  of the angle
    static bool pointToOneSide(const Box& box, float cosine);
    static Box together(const Box& one, const Box& other);

    // Goes from two branches that are not both leaves, of this tree and of another, to those below the larger one: calls a
    // function with each pair.
    template <typename Between>
    void descend(const SurfaceTree& other, int branch, int otherBranch, Between between) const {
        const auto size = [](const Box& box) { return (box.high - box.low).matrix().squaredNorm(); };
        const auto at = static_cast<std::size_t>(branch), at2 = static_cast<std::size_t>(otherBranch);
        const Branch &one = branches_[at], &two = other.branches_[at2];
        const bool splitsOther =
            one.leaf >= 0 || (two.leaf < 0 && size(other.boxes_[at2]) > size(boxes_[at]));
        for (int child = 0; child < 2; ++child)
            if (splitsOther)
                between(branch, two.children[child]);
            else
                between(one.children[child], otherBranch);
    }

  private:
    int makeBranch(std::vector<Face>& faces, std::size_t first, std::size_t end,
                   const std::vector<Eigen::Vector3f>& places);
    void orientFaces();
    void giveNodesAndEdgesToLeaves();
    void findCloseNodes(const std::vector<Corners>& corners, float distance);
    void findAdjacentLeaves();
    void findCloseFaces();
    void findCloseEdges();
    struct OfLeaf {
        int leaf;
        Bits bits;
    };
    static Bits bitsOf(const CompressedRows<OfLeaf>& rows, int row, int leaf);
    Box boxOf(std::size_t leaf) const;

    std::vector<Face> faces_;
    std::vector<Edge> edges_;
    std::vector<int> nodes_;
    std::vector<Branch> branches_;  // each before its children
    std::vector<Leaf> leaves_;
    float oneSided_;                // cosine of that angle
    CompressedRows<int> corners_;   // all nodes of the faces of each leaf
    CompressedRows<int> adjacent_;  // leaves that have nodes that are close, itself among them
    CompressedRows<int> close_;     // nodes; both in ascending order
    CompressedRows<OfLeaf> closeFaces_, closeEdges_;
    std::vector<Eigen::Vector3f> positions_;
    std::vector<Eigen::Vector3f> ways_;
    float deviation_ = 0;
    std::vector<Eigen::Vector3f> normals_;  // of the faces, of unit length
    std::vector<Box> boxes_;                // of the branches
};

}  // namespace drench
