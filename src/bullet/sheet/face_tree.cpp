#include "bullet/sheet/face_tree.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

using Leaves = std::vector<btDbvtNode*>;

// Allocated by Bullet, which frees it.
btDbvtNode* newNode() {
    auto* const node = new (btAlignedAlloc(sizeof(btDbvtNode), 16)) btDbvtNode();
    node->parent = nullptr;
    node->childs[0] = node->childs[1] = nullptr;
    return node;
}

btDbvtNode* newLeaf(const btDbvtVolume& volume, void* part) {
    btDbvtNode* const leaf = newNode();
    leaf->volume = volume;
    leaf->data = part;
    return leaf;
}

btDbvtVolume boundsOf(const btSoftBody::Face& face) {
    const btVector3* corners[] = {&face.m_n[0]->m_x, &face.m_n[1]->m_x, &face.m_n[2]->m_x};
    return btDbvtVolume::FromPoints(corners, 3);
}

// The axis along which the leaves are spread widest.
int longestAxis(Leaves::const_iterator begin, Leaves::const_iterator end) {
    btVector3 low = (*begin)->volume.Center(), high = low;
    for (auto leaf = begin; leaf != end; ++leaf) {
        low.setMin((*leaf)->volume.Center());
        high.setMax((*leaf)->volume.Center());
    }
    return (high - low).maxAxis();
}

// Divides the leaves in half recursively.
btDbvtNode* treeOf(Leaves::iterator begin, Leaves::iterator end) {
    if (end - begin == 1) return *begin;
    const int axis = longestAxis(begin, end);
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [axis](const btDbvtNode* a, const btDbvtNode* b) {
        return a->volume.Center()[axis] < b->volume.Center()[axis];
    });
    btDbvtNode* const node = newNode();
    node->childs[0] = treeOf(begin, middle);
    node->childs[1] = treeOf(middle, end);
    for (btDbvtNode* const child : node->childs) child->parent = node;
    Merge(node->childs[0]->volume, node->childs[1]->volume, node->volume);
    return node;
}

void fill(btDbvt& tree, Leaves leaves) {
    if (leaves.empty()) return;
    tree.m_root = treeOf(leaves.begin(), leaves.end());
    tree.m_leaves = static_cast<int>(leaves.size());
}

// Bullet's leaves of nodes are as wide as the margin at the time when they were made, 0.25 m by default, and
// never shrink.
void makeNodeTree(btSoftBody& body) {
    body.m_ndbvt.clear();
    Leaves leaves;
    leaves.reserve(static_cast<std::size_t>(body.m_nodes.size()));
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        btSoftBody::Node& node = body.m_nodes[n];
        leaves.push_back(node.m_leaf = newLeaf(btDbvtVolume::FromCR(node.m_x, 0), &node));
    }
    fill(body.m_ndbvt, std::move(leaves));
}

btDbvntNode* withNormals(const btDbvtNode& from) {
    auto* const node = new btDbvntNode(&from);
    if (from.isleaf()) return node;
    for (int child = 0; child < 2; ++child) node->childs[child] = withNormals(*from.childs[child]);
    return node;
}

}  // namespace

void dropFaceTree(btSoftBody& body) {
    body.m_fdbvt.clear();
    delete body.m_fdbvnt;
    body.m_fdbvnt = nullptr;
    for (int f = 0; f < body.m_faces.size(); ++f) body.m_faces[f].m_leaf = nullptr;
}

void makeFaceTree(btSoftBody& body) {
    dropFaceTree(body);
    makeNodeTree(body);
    Leaves leaves;
    leaves.reserve(static_cast<std::size_t>(body.m_faces.size()));
    for (int f = 0; f < body.m_faces.size(); ++f) {
        btSoftBody::Face& face = body.m_faces[f];
        leaves.push_back(face.m_leaf = newLeaf(boundsOf(face), &face));
    }
    if (leaves.empty()) return;
    fill(body.m_fdbvt, std::move(leaves));
    body.m_fdbvnt = withNormals(*body.m_fdbvt.m_root);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
