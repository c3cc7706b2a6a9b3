#include "cloth/welding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <utility>

#include "cloth/mesh_edges.h"
#include "cloth/second_layer.h"

namespace drench {

namespace {

using Triangle = std::array<int, 3>;

// Keeps the suitable triangles of a mesh, with the given vertices until `finish` numbers its nodes.
class Cleaning {
  public:
    Cleaning(const TriangleMesh& mesh, const std::vector<int>& sameAs) : given_(mesh), sameAs_(sameAs) {
        for (const Triangle& triangle : mesh.triangles) joined_.push_back(joined(triangle));
        for (std::size_t t = 0; t < joined_.size(); ++t)
            if (hasArea(joined_[t]))
                kept_.push_back(t);
            else
                welded_.degenerateTriangles.push_back(static_cast<int>(t));
    }

    WeldedMesh finish() {
        leaveOut(repeatedTriangles(keptTriangles()));
        leaveOut(repeatedQuads(keptTriangles(), given_.vertices));
        auto& duplicates = welded_.duplicateTriangles;
        std::sort(duplicates.begin(), duplicates.end());
        numberNodes();
        writeTriangles();
        count();
        return std::move(welded_);
    }

  private:
    int firstOf(int vertex) const {
        return sameAs_.empty() ? vertex : sameAs_[static_cast<std::size_t>(vertex)];
    }

    Triangle joined(const Triangle& triangle) const {
        Triangle nodes;
        for (std::size_t k = 0; k < 3; ++k) nodes[k] = firstOf(triangle[k]);
        return nodes;
    }

    // A triangle is degenerate if its height is less than a millionth of its longest edge.
    bool hasArea(const Triangle& nodes) const {
        const auto at = [&](std::size_t k) { return given_.vertices[static_cast<std::size_t>(nodes[k])]; };
        const Eigen::Vector3d a = at(1) - at(0), b = at(2) - at(0);
        const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
        return a.cross(b).norm() > 1e-6 * longest;
    }

    std::vector<Triangle> keptTriangles() const {
        std::vector<Triangle> triangles;
        for (const std::size_t t : kept_) triangles.push_back(joined_[t]);
        return triangles;
    }

    void leaveOut(const std::vector<SecondLayer>& layers) {
        std::vector<bool> isOut(kept_.size(), false);
        for (const SecondLayer& layer : layers) isOut[layer.triangle] = true;
        std::vector<std::size_t> rest;
        for (std::size_t i = 0; i < kept_.size(); ++i)
            if (isOut[i])
                welded_.duplicateTriangles.push_back(static_cast<int>(kept_[i]));
            else
                rest.push_back(kept_[i]);
        kept_ = std::move(rest);
    }

    // Nodes are the vertices that triangles use, in their order.
    void numberNodes() {
        std::vector<bool> isUsed(given_.vertices.size(), false);
        for (const std::size_t t : kept_)
            for (const int vertex : given_.triangles[t]) isUsed[static_cast<std::size_t>(vertex)] = true;
        // A vertex that lies with used ones is their node, even if triangles use it only by those.
        for (std::size_t v = 0; v < isUsed.size(); ++v)
            if (isUsed[v]) isUsed[static_cast<std::size_t>(firstOf(static_cast<int>(v)))] = true;
        welded_.nodeOfVertex.assign(isUsed.size(), -1);
        for (std::size_t v = 0; v < isUsed.size(); ++v) {
            if (!isUsed[v]) continue;
            const auto first = static_cast<std::size_t>(firstOf(static_cast<int>(v)));
            if (first == v) {
                welded_.vertexOfNode.push_back(static_cast<int>(v));
                welded_.mesh.vertices.push_back(given_.vertices[v]);
            }
            // The first vertex of a node comes before its others.
            welded_.nodeOfVertex[v] =
                first == v ? static_cast<int>(welded_.vertexOfNode.size()) - 1 : welded_.nodeOfVertex[first];
        }
    }

    void writeTriangles() {
        TriangleMesh& mesh = welded_.mesh;
        for (const std::size_t t : kept_) {
            Triangle nodes = joined_[t];
            for (int& node : nodes) node = welded_.nodeOfVertex[static_cast<std::size_t>(node)];
            mesh.triangles.push_back(nodes);
            if (!given_.textureCoordinates.empty())
                mesh.textureCoordinates.push_back(given_.textureCoordinates[t]);
        }
    }

    void count() {
        const auto& nodes = welded_.nodeOfVertex;
        const auto unused = std::count(nodes.begin(), nodes.end(), -1);
        welded_.unreferencedVertices = static_cast<int>(unused);
        welded_.coincidentVertices =
            static_cast<int>(nodes.size() - welded_.vertexOfNode.size()) - welded_.unreferencedVertices;
        welded_.pieces = static_cast<int>(piecesOf(welded_.mesh).size());
        const MeshEdges edges(welded_.mesh.triangles, welded_.mesh.vertices.size());
        for (std::size_t edge = 0; edge < edges.size(); ++edge)
            if (edges.trianglesAt(edge).size() > 2) ++welded_.nonManifoldEdges;
    }

    const TriangleMesh& given_;
    const std::vector<int>& sameAs_;
    std::vector<Triangle> joined_;   // all triangles, of the first vertices of their nodes
    std::vector<std::size_t> kept_;  // indices of triangles
    WeldedMesh welded_;
};

}  // namespace

WeldedMesh cleaned(const TriangleMesh& mesh, const std::vector<int>& sameAs) {
    return Cleaning(mesh, sameAs).finish();
}

}  // namespace drench
