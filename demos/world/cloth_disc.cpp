#include "world/cloth_disc.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "world/angles.h"

namespace drench::demo {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Sine of the smallest angle of a triangle; negative if it is flipped.
double quality(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const double doubledArea = cross(b - a, c - a);
    const double edges[] = {(b - a).norm(), (c - b).norm(), (a - c).norm()};
    const double shortest = *std::min_element(std::begin(edges), std::end(edges));
    const double product = edges[0] * edges[1] * edges[2];
    return product > 0 ? doubledArea * shortest / product : -1;
}

// The part of a square grid that lies inside a circle with some distance.
class Grid {
  public:
    Grid(DiscMesh& mesh, double cell, double radius) : mesh_(mesh), cell_(cell), radius_(radius) {
        reach_ = int(std::ceil(radius / cell));
    }

    void fill() {
        for (int j = -reach_; j <= reach_; ++j)
            for (int i = -reach_; i <= reach_; ++i) addCell(i, j);
    }

  private:
    // -1 outside.
    int node(int i, int j) {
        const Eigen::Vector2d position(i * cell_, j * cell_);
        if (position.norm() > radius_) return -1;
        const auto [found, isNew] = index_.emplace(std::array<int, 2>{i, j}, int(mesh_.nodes.size()));
        if (isNew) mesh_.nodes.push_back(position);
        return found->second;
    }

    // Half a cell if one corner is outside.
    void addCell(int i, int j) {
        const std::array<int, 4> corners{node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)};
        const auto outside = std::count(corners.begin(), corners.end(), -1);
        if (outside > 1) return;
        if (outside == 0) {
            mesh_.triangles.push_back({corners[0], corners[1], corners[2]});
            mesh_.triangles.push_back({corners[0], corners[2], corners[3]});
            mesh_.links.push_back({corners[1], corners[3]});  // the diagonal that is not an edge
            return;
        }
        std::array<int, 3> triangle;
        std::copy_if(corners.begin(), corners.end(), triangle.begin(),
                     [](int corner) { return corner >= 0; });
        mesh_.triangles.push_back(triangle);
    }

    DiscMesh& mesh_;
    double cell_, radius_;
    int reach_;
    std::map<std::array<int, 2>, int> index_;
};

// Removes unreferenced nodes.
void dropLoneNodes(DiscMesh& mesh) {
    std::vector<int> newIndex(mesh.nodes.size(), -1);
    std::vector<Eigen::Vector2d> kept;
    for (auto& triangle : mesh.triangles)
        for (int& corner : triangle) {
            int& index = newIndex[std::size_t(corner)];
            if (index < 0) {
                index = int(kept.size());
                kept.push_back(mesh.nodes[std::size_t(corner)]);
            }
            corner = index;
        }
    for (auto& link : mesh.links)
        for (int& end : link) end = newIndex[std::size_t(end)];
    mesh.nodes = kept;
}

// The border of the triangles, anticlockwise.
std::vector<int> borderOf(const DiscMesh& mesh) {
    std::map<int, int> next;
    std::set<std::array<int, 2>> edges;
    for (const auto& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) edges.insert({triangle[k], triangle[(k + 1) % 3]});
    for (const auto& [from, to] : edges)
        if (edges.count({to, from}) == 0) next[from] = to;
    std::vector<int> loop{next.begin()->first};
    while (next.at(loop.back()) != loop.front()) loop.push_back(next.at(loop.back()));
    if (loop.size() != next.size()) throw std::logic_error("the grid of a disc has several borders");
    return loop;
}

// Nodes at equal distances along the circle, the first at an angle in rad.
std::vector<int> addRing(DiscMesh& mesh, double radius, int count, double firstAngle) {
    std::vector<int> ring;
    for (int i = 0; i < count; ++i) {
        const double angle = firstAngle + 2 * pi * i / count;
        ring.push_back(int(mesh.nodes.size()));
        mesh.nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return ring;
}

// Fills the strip between two loops with triangles, such that the sum of the lengths of the connecting edges
// is smallest and no triangle is too thin.
class Strip {
  public:
    Strip(DiscMesh& mesh, const std::vector<int>& inner, const std::vector<int>& outer)
        : mesh_(mesh), inner_(inner), outer_(outer), costs_((inner.size() + 1) * (outer.size() + 1)) {}

    void fill() {
        for (std::size_t i = 0; i <= inner_.size(); ++i)
            for (std::size_t o = 0; o <= outer_.size(); ++o) at(i, o) = costOf(i, o);
        std::size_t i = inner_.size(), o = outer_.size();
        while (i + o > 0) {
            const bool fromInner = i > 0 && (o == 0 || throughInner(i, o) < throughOuter(i, o));
            mesh_.triangles.push_back(fromInner ? innerTriangle(i, o) : outerTriangle(i, o));
            fromInner ? --i : --o;
        }
    }

  private:
    int innerNode(std::size_t i) const { return inner_[i % inner_.size()]; }
    int outerNode(std::size_t o) const { return outer_[o % outer_.size()]; }
    double& at(std::size_t i, std::size_t o) { return costs_[i * (outer_.size() + 1) + o]; }

    std::array<int, 3> innerTriangle(std::size_t i, std::size_t o) const {
        return {innerNode(i - 1), outerNode(o), innerNode(i)};
    }
    std::array<int, 3> outerTriangle(std::size_t i, std::size_t o) const {
        return {innerNode(i), outerNode(o - 1), outerNode(o)};
    }
    double throughInner(std::size_t i, std::size_t o) { return at(i - 1, o) + cost(innerTriangle(i, o)); }
    double throughOuter(std::size_t i, std::size_t o) { return at(i, o - 1) + cost(outerTriangle(i, o)); }
    double costOf(std::size_t i, std::size_t o) {
        if (i + o == 0) return 0;
        if (i == 0) return throughOuter(i, o);
        if (o == 0) return throughInner(i, o);
        return std::min(throughInner(i, o), throughOuter(i, o));
    }

    double cost(const std::array<int, 3>& triangle) const {
        const auto& position = [&](std::size_t k) { return mesh_.nodes[std::size_t(triangle[k])]; };
        const double good = quality(position(0), position(1), position(2));
        return good > 0.02 ? 1 / good : 1e6 * (1 - good);
    }

    DiscMesh& mesh_;
    const std::vector<int>& inner_;
    const std::vector<int>& outer_;
    std::vector<double> costs_;
};

// Moves the nodes that are nearest to a circle onto it.
void moveOnto(DiscMesh& mesh, double radius, double reach) {
    for (Eigen::Vector2d& node : mesh.nodes)
        if (std::abs(node.norm() - radius) < reach) node *= radius / node.norm();
}

}  // namespace

DiscMesh discMesh(double radius, int nodesAcross, double innerRadius) {
    const double cell = 2 * radius / (nodesAcross - 1);
    DiscMesh mesh;
    Grid(mesh, cell, radius - 0.7 * cell).fill();
    dropLoneNodes(mesh);
    const std::vector<int> border = borderOf(mesh);
    const Eigen::Vector2d& first = mesh.nodes[std::size_t(border.front())];
    const std::vector<int> rim =
        addRing(mesh, radius, int(std::lround(2 * pi * radius / cell)), std::atan2(first.y(), first.x()));
    Strip(mesh, border, rim).fill();
    moveOnto(mesh, innerRadius, 0.3 * cell);
    const auto edges =
        edgesOf(TriangleMesh{std::vector<Eigen::Vector3d>(mesh.nodes.size()), mesh.triangles, {}});
    mesh.links.insert(mesh.links.end(), edges.begin(), edges.end());
    return mesh;
}

std::unique_ptr<btSoftBody> makeDisc(btSoftBodyWorldInfo& worldInfo, const Fabric& fabric,
                                     const DiscMesh& mesh, const btVector3& centre) {
    std::vector<btVector3> positions;
    positions.reserve(mesh.nodes.size());
    for (const Eigen::Vector2d& node : mesh.nodes)
        positions.push_back(centre + btVector3(btScalar(node.x()), 0, btScalar(node.y())));
    auto body = std::make_unique<btSoftBody>(&worldInfo, int(positions.size()), positions.data(), nullptr);
    std::vector<double> masses(mesh.nodes.size(), 0);
    double area = 0;
    for (const auto& triangle : mesh.triangles) {
        body->appendFace(triangle[0], triangle[2],
                         triangle[1]);  // clockwise from above, because y is up
        const Eigen::Vector2d& origin = mesh.nodes[std::size_t(triangle[0])];
        const double faceArea = cross(mesh.nodes[std::size_t(triangle[1])] - origin,
                                      mesh.nodes[std::size_t(triangle[2])] - origin) /
                                2;
        for (const int corner : triangle) masses[std::size_t(corner)] += fabric.arealDensity * faceArea / 3;
        area += faceArea;
    }
    for (const auto& link : mesh.links) body->appendLink(link[0], link[1]);
    for (int n = 0; n < body->m_nodes.size(); ++n)
        body->m_nodes[n].m_im = btScalar(1 / masses[std::size_t(n)]);
    body->updateLinkConstants();

    const auto cell = btScalar(std::sqrt(area / double(mesh.nodes.size())));
    body->getCollisionShape()->setMargin(cell / 4);
    body->m_cfg.kDF = btScalar(fabric.plateFrictionDry);
    if (worldInfo.m_sparsesdf.m_defaultVoxelsz > cell) {
        worldInfo.m_sparsesdf.setDefaultVoxelsz(cell / 2);
        worldInfo.m_sparsesdf.Reset();
    }
    return body;
}

}  // namespace drench::demo
