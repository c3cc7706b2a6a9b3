#include "bullet/repair/recut.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "bullet/sheet/border_checks.h"
#include "bullet/sheet/face_projection.h"
#include "bullet/world/vectors.h"
#include "checks/text.h"
#include "cloth/mesh_edges.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

using Triangle = std::array<int, 3>;

class Recutter {
  public:
    Recutter(const btSoftBody& body, const RestShape& shape, const ClothMesh& mesh)
        : body_(body), old_(shape), oldMesh_(mesh), oldNodes_(static_cast<int>(mesh.size())) {
        checkBody(body);
        if (body.m_nodes.size() < oldNodes_)
            throw std::invalid_argument(
                textOf("the body has ", body.m_nodes.size(), " nodes of ", oldNodes_));
        facesAround_ = trianglesAround(old_.triangles, mesh.size());
    }

    Recut cut(const Moisture& moisture) {
        readFaces();
        readLinks();
        checkDuplicates(cut_.shape);
        checkShape(cut_.shape, cut_.mesh);
        cut_.poreMass = pour(moisture, moisture.poreMass());
        cut_.filmMass = pour(moisture, moisture.filmMass());
        return std::move(cut_);
    }

  private:
    // A corner of a new face in the old face of which it is a piece: its barycentric coordinates there.
    using Weights = std::array<double, 3>;

    int checkedIndex(const btSoftBody::Node* node, const char* what, int of) const {
        const btSoftBody::Node* const first = &body_.m_nodes[0];
        if (std::less<>()(node, first) || !std::less<>()(node, first + body_.m_nodes.size()))
            throw std::invalid_argument(textOf(what, " ", of, " joins a node that is not the body's"));
        return indexOf(body_, node);
    }

    void readFaces() {
        cut_.shape.nodeAreas.assign(static_cast<std::size_t>(body_.m_nodes.size()), 0.0);
        for (int f = 0; f < body_.m_faces.size(); ++f) {
            Triangle triangle;
            for (std::size_t corner = 0; corner < 3; ++corner)
                triangle[corner] = checkedIndex(body_.m_faces[f].m_n[corner], "face", f);
            addFace(triangle, originOf(static_cast<std::size_t>(f), triangle));
        }
        cut_.mesh.areas = cut_.shape.nodeAreas;
        cut_.mesh.triangles = cut_.shape.triangles;
    }

    void addFace(const Triangle& triangle, std::size_t origin) {
        const auto& flat = oldMesh_.coordinates[origin];
        auto& coordinates = cut_.mesh.coordinates.emplace_back();
        std::array<Weights, 3> weights;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            weights[corner] = weightsOf(triangle[corner], origin);
            coordinates[corner] =
                flat[0] * weights[corner][0] + flat[1] * weights[corner][1] + flat[2] * weights[corner][2];
        }
        const double area = triangleArea(coordinates) * restOverMaterial(origin);
        constexpr double thinnest = 1e-9;  // of the old area; thinner pieces take too many steps
        if (!(area > thinnest * old_.triangleAreas[origin]))
            throw std::invalid_argument(textOf("face ", cut_.shape.triangles.size(),
                                               " has less than 1e-9 of the area of the face that it is of"));
        cut_.shape.triangles.push_back(triangle);
        cut_.shape.triangleAreas.push_back(area);
        addThirds(triangle, area, cut_.shape.nodeAreas);
        const Weights middle = meanOf(weights);
        constexpr double rounding = 1e-3;
        isSewnOn_.push_back(*std::min_element(middle.begin(), middle.end()) < -rounding);
        origins_.push_back(origin);
        weights_.push_back(weights);
    }

    static Weights meanOf(const std::array<Weights, 3>& corners) {
        Weights mean;
        for (std::size_t k = 0; k < 3; ++k) mean[k] = (corners[0][k] + corners[1][k] + corners[2][k]) / 3;
        return mean;
    }

    double restOverMaterial(std::size_t face) const {
        return old_.triangleAreas[face] / triangleArea(oldMesh_.coordinates[face]);
    }

    // The old face that is equal to a new face, or of which the new face is a piece.
    std::size_t originOf(std::size_t face, const Triangle& triangle) {
        if (face < old_.triangles.size() && old_.triangles[face] == triangle) return face;
        std::vector<std::size_t> candidates;
        for (const int node : triangle) {
            if (node >= oldNodes_) continue;
            const auto around = facesAround_[static_cast<std::size_t>(node)];
            candidates.insert(candidates.end(), around.begin(), around.end());
        }
        for (const std::size_t candidate : candidates)
            if (std::is_permutation(triangle.begin(), triangle.end(), old_.triangles[candidate].begin()))
                return candidate;
        if (candidates.empty())
            for (std::size_t t = 0; t < old_.triangles.size(); ++t) candidates.push_back(t);
        return nearestOf(candidates, triangle);
    }

    std::size_t nearestOf(const std::vector<std::size_t>& candidates, const Triangle& triangle) {
        const btVector3 middle =
            (positionOf(triangle[0]) + positionOf(triangle[1]) + positionOf(triangle[2])) / 3;
        std::size_t nearest = candidates.front();
        btScalar min = std::numeric_limits<btScalar>::infinity();
        for (const std::size_t candidate : candidates) {
            const btScalar distance = projected(middle, candidate).apart.length2();
            if (!(distance < min)) continue;
            min = distance;
            nearest = candidate;
        }
        return nearest;
    }

    const btVector3& positionOf(int node) const { return body_.m_nodes[node].m_x; }

    FaceProjection::Nearest projected(const btVector3& position, std::size_t face) {
        const Triangle& corners = old_.triangles[face];
        return projection_.of(position, positionOf(corners[0]), positionOf(corners[1]),
                              positionOf(corners[2]));
    }

    Weights weightsOf(int node, std::size_t face) {
        Weights weights = {0, 0, 0};
        for (std::size_t corner = 0; corner < 3; ++corner)
            if (old_.triangles[face][corner] == node) {
                weights[corner] = 1;
                return weights;
            }
        return weightsOf(positionOf(node), face);
    }

    // Barycentric coordinates of a point in the plane of an old face; outside the face some are negative.
    Weights weightsOf(const btVector3& position, std::size_t face) const {
        const Triangle& corners = old_.triangles[face];
        const Eigen::Vector3d origin = toEigen(positionOf(corners[0]));
        Eigen::Matrix<double, 3, 2> edges;
        edges << toEigen(positionOf(corners[1])) - origin, toEigen(positionOf(corners[2])) - origin;
        const Eigen::Matrix2d products = edges.transpose() * edges;
        const Eigen::Vector2d along = products.inverse() * (edges.transpose() * (toEigen(position) - origin));
        if (!along.allFinite()) throw std::invalid_argument(textOf("face ", face, " has no area now"));
        return {1 - along.sum(), along.x(), along.y()};
    }

    void readLinks() {
        findOldLengths();
        for (int i = 0; i < body_.m_links.size(); ++i) {
            const btSoftBody::Link& link = body_.m_links[i];
            const std::array<int, 2> nodes = {checkedIndex(link.m_n[0], "link", i),
                                              checkedIndex(link.m_n[1], "link", i)};
            const btScalar length = lengthOf(nodes);
            cut_.shape.restLengths.push_back(length);
            cut_.shape.links.push_back({nodes, link.m_bbending != 0, double(length)});
        }
    }

    void findOldLengths() {
        for (std::size_t i = 0; i < old_.links.size(); ++i)
            lengths_.emplace(pairOf(old_.links[i].nodes[0], old_.links[i].nodes[1]), old_.restLengths[i]);
        for (std::size_t f = 0; f < origins_.size(); ++f) {
            const Triangle& triangle = cut_.shape.triangles[f];
            if (triangle == old_.triangles[origins_[f]]) continue;
            const auto& flat = cut_.mesh.coordinates[f];
            const double scale = std::sqrt(restOverMaterial(origins_[f]));
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::size_t next = (corner + 1) % 3;
                lengths_.emplace(pairOf(triangle[corner], triangle[next]),
                                 btScalar((flat[next] - flat[corner]).norm() * scale));
            }
        }
    }

    btScalar lengthOf(const std::array<int, 2>& nodes) const {
        const auto found = lengths_.find(pairOf(nodes[0], nodes[1]));
        return found != lengths_.end() ? found->second
                                       : (positionOf(nodes[1]) - positionOf(nodes[0])).length();
    }

    // Transfers the water of the old nodes to the new nodes.
    std::vector<double> pour(const Moisture& moisture, const std::vector<double>& masses) const {
        std::vector<double> sums(old_.triangles.size(),
                                 0.0);  // on the pieces of each old face, before scaling
        for (std::size_t f = 0; f < origins_.size(); ++f)
            for (std::size_t corner = 0; corner < 3; ++corner)
                sums[origins_[f]] += share(f, corner, moisture, masses);
        std::vector<double> poured(cut_.shape.nodeAreas.size(), 0.0);
        for (std::size_t f = 0; f < origins_.size(); ++f) {
            const double sum = sums[origins_[f]];
            if (!(sum > 0)) continue;
            double there = 0;
            for (const int node : old_.triangles[origins_[f]])
                there += perArea(node, moisture, masses) * old_.triangleAreas[origins_[f]] / 3;
            for (std::size_t corner = 0; corner < 3; ++corner)
                poured[static_cast<std::size_t>(cut_.shape.triangles[f][corner])] +=
                    share(f, corner, moisture, masses) * (there / sum);
        }
        return poured;
    }

    // Water of a corner of a new face, if it lay on the pieces exactly as on the old face, kg.
    double share(std::size_t face, std::size_t corner, const Moisture& moisture,
                 const std::vector<double>& masses) const {
        if (isSewnOn_[face]) return 0;
        double density = 0;
        for (std::size_t k = 0; k < 3; ++k)
            density +=
                weights_[face][corner][k] * perArea(old_.triangles[origins_[face]][k], moisture, masses);
        return std::max(density, 0.0) * cut_.shape.triangleAreas[face] / 3;
    }

    static double perArea(int node, const Moisture& moisture, const std::vector<double>& masses) {
        const auto n = static_cast<std::size_t>(node);
        return masses[n] / moisture.area(n);
    }

    const btSoftBody& body_;
    const RestShape& old_;
    const ClothMesh& oldMesh_;
    const int oldNodes_;
    FaceProjection projection_;
    CompressedRows<std::size_t> facesAround_;  // indices of the old faces around each old node
    Recut cut_;
    // For each new face.
    std::vector<std::size_t> origins_;
    std::vector<std::array<Weights, 3>> weights_;
    std::vector<bool> isSewnOn_;            // whether it was added beside that old face, and so is dry
    std::map<NodePair, btScalar> lengths_;  // rest lengths, m
};

}  // namespace

Recut recutOf(const btSoftBody& body, const RestShape& shape, const ClothMesh& mesh,
              const Moisture& moisture) {
    return Recutter(body, shape, mesh).cut(moisture);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
