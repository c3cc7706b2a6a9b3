#include "drench/sheet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "bullet/sheet/link_order.h"
#include "bullet/sheet/node_masses.h"
#include "bullet/world/vectors.h"
#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

struct Grid {
    int nodesWarp;
    int nodesWeft;

    int node(int i, int j) const { return i + j * nodesWarp; }
    int size() const { return nodesWarp * nodesWeft; }
};

struct PlannedLink {
    int a;
    int b;
    bool bending;
};

void check(const Fabric& fabric, const Corners& corners, const Grid& grid) {
    validate(fabric);
    for (const int count : {grid.nodesWarp, grid.nodesWeft})
        if (count < 2 || count > 10000)
            refuse("makeSheet was asked for ", grid.nodesWarp, " x ", grid.nodesWeft,
                   " nodes; give 2 to 10000 in each direction");
    for (const btVector3* corner : {&corners.origin, &corners.warpEnd, &corners.weftEnd, &corners.opposite})
        for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite((*corner)[axis]))
                refuse("makeSheet was given a corner at ", *corner, "; give finite positions, in metres");
    const btVector3 warp = corners.warpEnd - corners.origin, weft = corners.weftEnd - corners.origin;
    if (warp.cross(weft).length() <= btScalar(1e-9))
        refuse(
            "makeSheet was given corners that enclose no area; warpEnd and weftEnd must lie in "
            "different directions from origin");
}

std::vector<btVector3> positionsOf(const Corners& c, const Grid& grid) {
    std::vector<btVector3> positions;
    positions.reserve(static_cast<std::size_t>(grid.size()));
    for (int j = 0; j < grid.nodesWeft; ++j) {
        const btScalar v = btScalar(j) / btScalar(grid.nodesWeft - 1);
        const btVector3 from = c.origin.lerp(c.weftEnd, v), to = c.warpEnd.lerp(c.opposite, v);
        for (int i = 0; i < grid.nodesWarp; ++i)
            positions.push_back(from.lerp(to, btScalar(i) / btScalar(grid.nodesWarp - 1)));
    }
    return positions;
}

// Bullet inserts the nodes into its tree one after the other. In row order the tree becomes very deep: a
// million nodes take minutes. So nodes are inserted in a random order, and then nodes and leaves are moved
// back to their own order.
std::unique_ptr<btSoftBody> bodyOfNodes(btSoftBodyWorldInfo& worldInfo,
                                        const std::vector<btVector3>& positions) {
    std::vector<int> order(positions.size());
    std::minstd_rand random;  // gives the same order with every standard library
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = static_cast<int>(i);
        std::swap(order[i], order[random() % (i + 1)]);
    }
    std::vector<btVector3> shuffled;
    shuffled.reserve(positions.size());
    for (const int node : order) shuffled.push_back(positions[static_cast<std::size_t>(node)]);
    auto body =
        std::make_unique<btSoftBody>(&worldInfo, static_cast<int>(order.size()), shuffled.data(), nullptr);

    std::vector<btDbvtNode*> leaves;
    leaves.reserve(positions.size());
    for (int i = 0; i < body->m_nodes.size(); ++i) leaves.push_back(body->m_nodes[i].m_leaf);
    for (std::size_t i = 0; i < order.size(); ++i) {
        btSoftBody::Node& node = body->m_nodes[order[i]];
        node.m_x = node.m_q = body->m_X[order[i]] = shuffled[i];
        node.m_leaf = leaves[i];
        node.m_leaf->data = &node;
    }
    return body;
}

// All cells are cut along the same diagonal, so that every inner node has six triangles and the area of one
// cell.
void appendFaces(btSoftBody& body, const Grid& grid) {
    for (int j = 0; j + 1 < grid.nodesWeft; ++j)
        for (int i = 0; i + 1 < grid.nodesWarp; ++i) {
            const int a = grid.node(i, j), b = grid.node(i + 1, j);
            const int c = grid.node(i + 1, j + 1), d = grid.node(i, j + 1);
            body.appendFace(a, b, c);
            body.appendFace(a, c, d);
        }
}

// A warp link must be first: `WetCloth` takes the direction of the first link as the warp.
std::vector<PlannedLink> planLinks(const Grid& grid) {
    std::vector<PlannedLink> links;
    const auto add = [&](int i, int j, int di, int dj, bool bending) {
        if (i + di < 0 || i + di >= grid.nodesWarp || j + dj >= grid.nodesWeft) return;
        links.push_back({grid.node(i, j), grid.node(i + di, j + dj), bending});
    };
    struct Step {
        int di, dj;
        bool bending;
    };
    constexpr Step steps[] = {{1, 0, false},  {0, 1, false}, {1, 1, false},
                              {-1, 1, false}, {2, 0, true},  {0, 2, true}};
    for (const Step& step : steps)
        for (int j = 0; j < grid.nodesWeft; ++j)
            for (int i = 0; i < grid.nodesWarp; ++i) add(i, j, step.di, step.dj, step.bending);
    return links;
}

void appendLinks(btSoftBody& body, const Grid& grid) {
    const std::vector<PlannedLink> planned = planLinks(grid);
    std::vector<std::array<int, 2>> nodes;
    nodes.reserve(planned.size());
    for (const PlannedLink& link : planned) nodes.push_back({link.a, link.b});
    for (const int i : colouredOrder(nodes, grid.size())) {
        const PlannedLink& link = planned[static_cast<std::size_t>(i)];
        body.appendLink(link.a, link.b);
        if (link.bending) body.m_links[body.m_links.size() - 1].m_bbending = -1;  // a signed bit field
    }
}

void setGridMasses(btSoftBody& body, double arealDensity) {
    writeClothMasses(body, btScalar(arealDensity), [](int face, btScalar area) {
        if (!(area > 0) || !std::isfinite(1 / area))
            refuse("makeSheet was given corners between which face ", face, " has an area of ",
                   sixDigits(double(area)),
                   " m2; set the corners apart, and closer to the origin than a million cells");
    });
}

btScalar cellSize(const Corners& c, const Grid& grid) {
    return std::min((c.warpEnd - c.origin).length() / btScalar(grid.nodesWarp - 1),
                    (c.weftEnd - c.origin).length() / btScalar(grid.nodesWeft - 1));
}

}  // namespace

Corners flatCorners(const btVector3& origin, const btVector3& warpEdge, const btVector3& weftEdge) {
    return {origin, origin + warpEdge, origin + weftEdge, origin + warpEdge + weftEdge};
}

std::unique_ptr<btSoftBody> makeSheet(btSoftBodyWorldInfo& worldInfo, const Fabric& fabric,
                                      const Corners& corners, int nodesWarp, int nodesWeft) {
    const Grid grid{nodesWarp, nodesWeft};
    check(fabric, corners, grid);

    auto body = bodyOfNodes(worldInfo, positionsOf(corners, grid));
    appendFaces(*body, grid);
    appendLinks(*body, grid);
    setGridMasses(*body, fabric.arealDensity);

    const btScalar cell = cellSize(corners, grid);
    body->getCollisionShape()->setMargin(std::min(cell / 4, btScalar(0.02)));
    body->m_cfg.kDF = btScalar(fabric.plateFrictionDry);
    if (worldInfo.m_sparsesdf.m_defaultVoxelsz > cell) {
        worldInfo.m_sparsesdf.setDefaultVoxelsz(cell / 2);
        worldInfo.m_sparsesdf.Reset();
    }
    return body;
}

std::vector<std::array<Eigen::Vector2d, 3>> wrappedCoordinates(const btSoftBody& body,
                                                               const btVector3& axis) {
    const Eigen::Vector3d along = toEigen(axis).normalized();
    if (!along.allFinite() || !(along.norm() > 0.5))
        refuse("the axis that cloth is wrapped around is ", axis, "; give a finite direction");
    std::vector<std::array<Eigen::Vector2d, 3>> coordinates;
    for (int f = 0; f < body.m_faces.size(); ++f) {
        const btSoftBody::Face& face = body.m_faces[f];
        std::array<Eigen::Vector3d, 3> corners;
        for (std::size_t corner = 0; corner < 3; ++corner)
            corners[corner] = toEigen(face.m_n[corner]->m_x - face.m_n[0]->m_x);
        const Eigen::Vector3d normal = corners[1].cross(corners[2]).normalized();
        Eigen::Vector3d weft = along - normal * normal.dot(along);
        constexpr double square = 1e-3;  // sine below which the axis counts as perpendicular to the face
        if (weft.norm() < square) weft = corners[1];
        weft.normalize();
        const Eigen::Vector3d warp = weft.cross(normal);
        auto& flat = coordinates.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner)
            flat[corner] = {corners[corner].dot(warp), corners[corner].dot(weft)};
    }
    return coordinates;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
