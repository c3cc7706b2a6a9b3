#include "bullet/cloth_contact/surface_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "cloth/mesh_edges.h"

namespace drench {

namespace {

constexpr std::size_t facesOfLeaf = 8;

// How far apart nodes have to be along the cloth to be kept apart, as a multiple of the distance that contacts keep:
// cloth that is bent less sharply than in a circle of that diameter does not touch itself.
constexpr float waysNotNearer = 1.5f;

Eigen::Vector3f centreOf(const SurfaceTree::Corners& corners) {
    return (corners[0] + corners[1] + corners[2]) / 3;
}

// The axis along which places differ most.
int longestAxis(const std::vector<SurfaceTree::Face>& faces, std::size_t first, std::size_t end,
                const std::vector<Eigen::Vector3f>& places) {
    Eigen::Array3f low = places[static_cast<std::size_t>(faces[first].index)], high = low;
    for (std::size_t f = first; f < end; ++f) {
        low = low.min(places[static_cast<std::size_t>(faces[f].index)].array());
        high = high.max(places[static_cast<std::size_t>(faces[f].index)].array());
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
}

// A neighbouring node, and how far it is at rest, m.
struct Way {
    int to;
    float length;
};

CompressedRows<Way> waysAlongEdges(const std::vector<SurfaceTree::Face>& faces, std::size_t nodes,
                                   const std::vector<SurfaceTree::Corners>& corners) {
    return {nodes, [&](const auto& add) {
                for (const SurfaceTree::Face& face : faces)
                    for (std::size_t i = 0; i < 3; ++i)
                        for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3}) {
                            const auto& at = corners[static_cast<std::size_t>(face.index)];
                            add(static_cast<std::size_t>(face.nodes[i]),
                                Way{face.nodes[j], (at[i] - at[j]).norm()});
                        }
            }};
}

// Rows of values in ascending order, each once.
CompressedRows<int> sortedRows(std::vector<std::vector<int>>& rows) {
    for (std::vector<int>& row : rows) {
        std::sort(row.begin(), row.end());
        row.erase(std::unique(row.begin(), row.end()), row.end());
    }
    return {rows.size(), [&](const auto& add) {
                for (std::size_t r = 0; r < rows.size(); ++r)
                    for (const int value : rows[r]) add(r, value);
            }};
}

}  // namespace

SurfaceTree::SurfaceTree(const std::vector<std::array<int, 3>>& triangles, std::size_t nodes,
                         const std::vector<Corners>& corners, float distance)
    : positions_(nodes, Eigen::Vector3f::Zero()), ways_(positions_) {
    std::vector<Eigen::Vector3f> places;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        faces_.push_back({triangles[t], static_cast<int>(t)});
        places.push_back(centreOf(corners[t]));
    }
    if (!faces_.empty()) makeBranch(faces_, 0, faces_.size(), places);
    normals_.assign(faces_.size(), Eigen::Vector3f::Zero());
    boxes_.resize(branches_.size());
    orientFaces();
    giveNodesAndEdgesToLeaves();
    findCloseNodes(corners, distance);
    findAdjacentLeaves();
    findCloseFaces();
    findCloseEdges();
}

int SurfaceTree::makeBranch(std::vector<Face>& faces, std::size_t first, std::size_t end,
                            const std::vector<Eigen::Vector3f>& places) {
    const auto branch = static_cast<int>(branches_.size());
    branches_.push_back({{-1, -1}, -1});
    if (end - first <= facesOfLeaf) {
        branches_.back().leaf = static_cast<int>(leaves_.size());
        leaves_.push_back({static_cast<int>(first), static_cast<int>(end), 0, 0, 0, 0, false, branch});
        return branch;
    }
    const int axis = longestAxis(faces, first, end, places);
    // Whole leaves, so that few are half empty.
    const std::size_t leaves = (end - first + facesOfLeaf - 1) / facesOfLeaf;
    const std::size_t middle = first + (leaves + 1) / 2 * facesOfLeaf;
    const auto at = [&](std::size_t f) { return faces.begin() + static_cast<std::ptrdiff_t>(f); };
    std::nth_element(at(first), at(middle), at(end), [&](const Face& a, const Face& b) {
        const float one = places[static_cast<std::size_t>(a.index)][axis],
                    other = places[static_cast<std::size_t>(b.index)][axis];
        return std::tie(one, a.index) < std::tie(other, b.index);
    });
    const int low = makeBranch(faces, first, middle, places), high = makeBranch(faces, middle, end, places);
    branches_[static_cast<std::size_t>(branch)].children[0] = low;
    branches_[static_cast<std::size_t>(branch)].children[1] = high;
    return branch;
}

// Turns faces around until each runs along its edges in the opposite sense to its neighbours. What cannot be oriented
// (a Moebius strip) keeps a seam.
void SurfaceTree::orientFaces() {
    std::vector<std::array<int, 3>> triangles;
    for (const Face& face : faces_) triangles.push_back(face.nodes);
    const MeshEdges edges(triangles, positions_.size());
    std::vector<char> isDone(faces_.size(), 0);
    std::vector<std::size_t> open;
    const auto runs = [&](std::size_t f, int from, int to) {
        const auto& nodes = faces_[f].nodes;
        const auto at = static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), from) - nodes.begin());
        return nodes[(at + 1) % 3] == to;
    };
    for (std::size_t first = 0; first < faces_.size(); ++first) {
        if (std::exchange(isDone[first], 1)) continue;
        open.assign(1, first);
        while (!open.empty()) {
            const std::size_t face = open.back();
            open.pop_back();
            for (std::size_t apex = 0; apex < 3; ++apex) {
                const EdgeTriangle* const across = edges.across(face, apex);
                if (!across || std::exchange(isDone[across->triangle], 1)) continue;
                const int from = triangles[face][(apex + 1) % 3], to = triangles[face][(apex + 2) % 3];
                if (runs(face, from, to) == runs(across->triangle, from, to))
                    std::swap(faces_[across->triangle].nodes[1], faces_[across->triangle].nodes[2]);
                open.push_back(across->triangle);
            }
        }
    }
}

void SurfaceTree::giveNodesAndEdgesToLeaves() {
    std::vector<std::array<int, 3>> inOrder;
    for (const Face& face : faces_) inOrder.push_back(face.nodes);
    const MeshEdges edges(inOrder, positions_.size());
    std::vector<char> hasNode(positions_.size(), 0);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto at = edges.trianglesAt(e);
        const int second = at.size() > 1 ? static_cast<int>(at[1].triangle) : -1;
        edges_.push_back({edges.ends()[e], {static_cast<int>(at[0].triangle), second}});
    }
    // The faces of an edge are in the order of the tree, so this is the order of the leaves too.
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const Edge& a, const Edge& b) { return a.faces[0] < b.faces[0]; });
    std::size_t edge = 0;
    for (Leaf& leaf : leaves_) {
        leaf.firstNode = static_cast<int>(nodes_.size());
        for (int f = leaf.firstFace; f < leaf.endFace; ++f)
            for (const int node : faces_[static_cast<std::size_t>(f)].nodes)
                if (!std::exchange(hasNode[static_cast<std::size_t>(node)], 1)) nodes_.push_back(node);
        leaf.endNode = static_cast<int>(nodes_.size());
        leaf.firstEdge = static_cast<int>(edge);
        while (edge < edges_.size() && edges_[edge].faces[0] < leaf.endFace)
            leaf.hasBorder = edges_[edge++].isBorder() || leaf.hasBorder;
        leaf.endEdge = static_cast<int>(edge);
    }
}

// Shortest ways from each node (Dijkstra 1959), as far as that.
void SurfaceTree::findCloseNodes(const std::vector<Corners>& corners, float distance) {
    const std::size_t count = positions_.size();
    const float notNearer = waysNotNearer * distance;
    const CompressedRows<Way> ways = waysAlongEdges(faces_, count, corners);
    std::vector<float> shortest(count, std::numeric_limits<float>::infinity());
    std::vector<std::vector<int>> close(count);
    std::vector<std::pair<float, int>> open;
    float nearestOther = std::numeric_limits<float>::infinity();  // of two nodes that are not close
    for (std::size_t node = 0; node < count; ++node) {
        std::vector<int>& found = close[node];
        found.push_back(static_cast<int>(node));
        shortest[node] = 0;
        open.assign(1, {0.0f, static_cast<int>(node)});
        while (!open.empty()) {
            std::pop_heap(open.begin(), open.end(), std::greater<>());
            const auto [length, at] = open.back();
            open.pop_back();
            for (const Way& way : ways[static_cast<std::size_t>(at)]) {
                float& best = shortest[static_cast<std::size_t>(way.to)];
                const float whole = length + way.length;
                const bool isNeighbour = at == static_cast<int>(node);
                if (!(whole < best)) continue;
                if (!isNeighbour && whole >= notNearer) {
                    nearestOther = std::min(nearestOther, whole);
                    continue;
                }
                if (best == std::numeric_limits<float>::infinity()) found.push_back(way.to);
                best = whole;
                open.emplace_back(whole, way.to);
                std::push_heap(open.begin(), open.end(), std::greater<>());
            }
        }
        for (const int other : found)
            shortest[static_cast<std::size_t>(other)] = std::numeric_limits<float>::infinity();
    }
    close_ = sortedRows(close);
    // The way along edges may be longer than that along the cloth; and a little more, to be sure.
    constexpr float detour = 1.41f, more = 1.2f, atLeast = 0.15f, level = 0.95f;
    oneSided_ = std::clamp(more * distance * detour / nearestOther, atLeast, level);
}

void SurfaceTree::findAdjacentLeaves() {
    std::vector<std::vector<int>> leavesOf(positions_.size());
    for (std::size_t l = 0; l < leaves_.size(); ++l)
        for (int f = leaves_[l].firstFace; f < leaves_[l].endFace; ++f)
            for (const int node : faces_[static_cast<std::size_t>(f)].nodes) {
                std::vector<int>& of = leavesOf[static_cast<std::size_t>(node)];
                if (of.empty() || of.back() != static_cast<int>(l)) of.push_back(static_cast<int>(l));
            }
    std::vector<std::vector<int>> corners(leaves_.size());
    for (std::size_t node = 0; node < positions_.size(); ++node)
        for (const int leaf : leavesOf[node])
            corners[static_cast<std::size_t>(leaf)].push_back(static_cast<int>(node));
    corners_ = sortedRows(corners);
    std::vector<std::vector<int>> adjacent(leaves_.size());
    for (std::size_t node = 0; node < positions_.size(); ++node)
        for (const int other : close_[node])
            for (const int leaf : leavesOf[node]) {
                std::vector<int>& row = adjacent[static_cast<std::size_t>(leaf)];
                const std::vector<int>& more = leavesOf[static_cast<std::size_t>(other)];
                row.insert(row.end(), more.begin(), more.end());
            }
    adjacent_ = sortedRows(adjacent);
}

namespace {

// Collects the bits of leaves for one row after the other.
template <typename Bits>
class BitsOfLeaves {
  public:
    explicit BitsOfLeaves(std::size_t leaves) : bits_(leaves, 0) {}
    void add(int leaf, Bits bit) {
        Bits& bits = bits_[static_cast<std::size_t>(leaf)];
        if (bits == 0) leaves_.push_back(leaf);
        bits |= bit;
    }
    // Calls a function with each leaf and its bits, and forgets them.
    template <typename Function>
    void take(Function function) {
        for (const int leaf : leaves_)
            function(leaf, std::exchange(bits_[static_cast<std::size_t>(leaf)], 0));
        leaves_.clear();
    }

  private:
    std::vector<Bits> bits_;
    std::vector<int> leaves_;
};

}  // namespace

void SurfaceTree::findCloseFaces() {
    std::vector<std::vector<std::pair<int, Bits>>> facesOf(positions_.size());  // leaf, and bit in it
    for (std::size_t l = 0; l < leaves_.size(); ++l)
        for (int f = leaves_[l].firstFace; f < leaves_[l].endFace; ++f)
            for (const int node : faces_[static_cast<std::size_t>(f)].nodes)
                facesOf[static_cast<std::size_t>(node)].emplace_back(static_cast<int>(l),
                                                                     Bits(1) << (f - leaves_[l].firstFace));
    BitsOfLeaves<Bits> row(leaves_.size());
    closeFaces_ = {positions_.size(), [&](const auto& add) {
                       for (std::size_t node = 0; node < positions_.size(); ++node) {
                           for (const int other : close_[node])
                               for (const auto& [leaf, bit] : facesOf[static_cast<std::size_t>(other)])
                                   row.add(leaf, bit);
                           row.take([&](int leaf, Bits bits) { add(node, OfLeaf{leaf, bits}); });
                       }
                   }};
}

void SurfaceTree::findCloseEdges() {
    std::vector<std::vector<std::pair<int, Bits>>> edgesOf(positions_.size());
    for (std::size_t l = 0; l < leaves_.size(); ++l)
        for (int e = leaves_[l].firstEdge; e < leaves_[l].endEdge; ++e)
            for (const int node : edges_[static_cast<std::size_t>(e)].nodes)
                edgesOf[static_cast<std::size_t>(node)].emplace_back(static_cast<int>(l),
                                                                     Bits(1) << (e - leaves_[l].firstEdge));
    BitsOfLeaves<Bits> row(leaves_.size());
    closeEdges_ = {edges_.size(), [&](const auto& add) {
                       for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
                           for (const int end : edges_[edge].nodes)
                               for (const int other : close_[static_cast<std::size_t>(end)])
                                   for (const auto& [leaf, bit] : edgesOf[static_cast<std::size_t>(other)])
                                       row.add(leaf, bit);
                           row.take([&](int leaf, Bits bits) { add(edge, OfLeaf{leaf, bits}); });
                       }
                   }};
}

SurfaceTree::Bits SurfaceTree::bitsOf(const CompressedRows<OfLeaf>& rows, int row, int leaf) {
    for (const OfLeaf& of : rows[static_cast<std::size_t>(row)])
        if (of.leaf == leaf) return of.bits;
    return 0;
}

bool SurfaceTree::areClose(int node, int other) const {
    const auto row = close_[static_cast<std::size_t>(node)];
    return std::binary_search(row.begin(), row.end(), other);
}

bool SurfaceTree::areOneSidedNeighbours(int leaf, int other) const {
    const auto boxOfLeaf = [this](int of) -> const Box& {
        return boxes_[static_cast<std::size_t>(leaves_[static_cast<std::size_t>(of)].branch)];
    };
    const auto row = adjacent_[static_cast<std::size_t>(leaf)],
               others = adjacent_[static_cast<std::size_t>(other)];
    Box box = together(boxOfLeaf(leaf), boxOfLeaf(other));
    bool areNeighbours = std::binary_search(row.begin(), row.end(), other);
    if (!areNeighbours)
        for (const int *one = row.begin(), *two = others.begin(); one != row.end() && two != others.end();) {
            if (*one == *two) {
                areNeighbours = true;
                box = together(box, boxOfLeaf(*one));
            }
            (*one < *two ? one : two)++;
        }
    return areNeighbours && isOneSided(box);
}

void SurfaceTree::follow(const MovingNode* start, const MovingNode* moved, const Motion& motion) {
    deviation_ = motion.deviation;
    for (std::size_t n = 0; n < positions_.size(); ++n) {
        positions_[n] = {start[n].x + moved[n].x, start[n].y + moved[n].y, start[n].z + moved[n].z};
        const MovingNode& step = motion.perStep[n];
        ways_[n] = Eigen::Vector3f(step.x, step.y, step.z) * motion.steps;
    }
    constexpr float tiny = 1e-30f;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        const auto& [a, b, c] = faces_[f].nodes;
        const Eigen::Vector3f& origin = positions_[static_cast<std::size_t>(a)];
        const Eigen::Vector3f normal = (positions_[static_cast<std::size_t>(b)] - origin)
                                           .cross(positions_[static_cast<std::size_t>(c)] - origin);
        normals_[f] = normal / std::sqrt(normal.squaredNorm() + tiny);
    }
    for (std::size_t branch = branches_.size(); branch-- > 0;) {
        const Branch& at = branches_[branch];
        boxes_[branch] = at.leaf >= 0 ? boxOf(static_cast<std::size_t>(at.leaf))
                                      : together(boxes_[static_cast<std::size_t>(at.children[0])],
                                                 boxes_[static_cast<std::size_t>(at.children[1])]);
    }
}

SurfaceTree::Box SurfaceTree::boxOf(std::size_t index) const {
    const Leaf& leaf = leaves_[index];
    constexpr float far = std::numeric_limits<float>::infinity();
    Box box;
    box.low = box.lowNormal = box.lowWay = Eigen::Array3f::Constant(far);
    box.high = box.highNormal = box.highWay = Eigen::Array3f::Constant(-far);
    for (int f = leaf.firstFace; f < leaf.endFace; ++f) {
        const auto face = static_cast<std::size_t>(f);
        box.lowNormal = box.lowNormal.min(normals_[face].array());
        box.highNormal = box.highNormal.max(normals_[face].array());
    }
    for (const int node : corners_[index]) {
        box.low = box.low.min(positions_[static_cast<std::size_t>(node)].array());
        box.high = box.high.max(positions_[static_cast<std::size_t>(node)].array());
        box.lowWay = box.lowWay.min(ways_[static_cast<std::size_t>(node)].array());
        box.highWay = box.highWay.max(ways_[static_cast<std::size_t>(node)].array());
    }
    return box;
}

SurfaceTree::Box SurfaceTree::together(const Box& one, const Box& other) {
    return {one.low.min(other.low),
            one.high.max(other.high),
            one.lowWay.min(other.lowWay),
            one.highWay.max(other.highWay),
            one.lowNormal.min(other.lowNormal),
            one.highNormal.max(other.highNormal)};
}

bool SurfaceTree::pointToOneSide(const Box& box, float cosine) {
    const Eigen::Array3f middle = box.lowNormal + box.highNormal;
    const float least = (box.lowNormal * middle).min(box.highNormal * middle).sum();
    return least > cosine * middle.matrix().norm();
}

}  // namespace drench
