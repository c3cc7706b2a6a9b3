// Small real worlds for the tests.
#pragma once

#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <drench/drench.h>

#include <cmath>
#include <memory>
#include <vector>

#include "bullet_world.h"

namespace drench::test {

/// A sheet of side x side metres, hanging in the plane z = 0 from its upper edge at y = 0; warp along x, weft
/// downwards.
inline std::unique_ptr<btSoftBody> hangingSheet(btSoftBodyWorldInfo& info, const Fabric& fabric, double side,
                                                int nodes) {
    auto sheet =
        makeSheet(info, fabric,
                  flatCorners({btScalar(-side / 2), 0, 0}, {btScalar(side), 0, 0}, {0, btScalar(-side), 0}),
                  nodes, nodes);
    for (int i = 0; i < nodes; ++i) sheet->m_nodes[i].m_im = 0;
    return sheet;
}

/// A world with one soft body in it, which leaves the world before it goes.
class SheetWorld {
  public:
    explicit SheetWorld(std::unique_ptr<btSoftBody> (*make)(btSoftBodyWorldInfo&))
        : sheet_(make(bullet_.world().getWorldInfo())) {
        bullet_.world().addSoftBody(sheet_.get());
    }
    ~SheetWorld() { bullet_.world().removeSoftBody(sheet_.get()); }
    SheetWorld(const SheetWorld&) = delete;
    SheetWorld& operator=(const SheetWorld&) = delete;

    demo::BulletWorld& bullet() { return bullet_; }
    btSoftRigidDynamicsWorld& world() { return bullet_.world(); }
    btSoftBody& sheet() { return *sheet_; }

  private:
    demo::BulletWorld bullet_;
    std::unique_ptr<btSoftBody> sheet_;
};

/// A level square metre of free cloth without gravity, 11 x 11 nodes, whose layer the test steps itself.
class FreeSheet {
  public:
    explicit FreeSheet(const Fabric& fabric) {
        bullet_.world().getWorldInfo().m_gravity.setZero();
        sheet_ = makeSheet(bullet_.world().getWorldInfo(), fabric,
                           flatCorners({0, 0, 0}, {1, 0, 0}, {0, 0, 1}), 11, 11);
        bullet_.world().addSoftBody(sheet_.get());
        SheetSettings settings;
        settings.stepping = Stepping::byApplication;
        cloth_ = std::make_unique<WetCloth>(bullet_.world(), *sheet_, fabric, settings);
    }
    ~FreeSheet() { bullet_.world().removeSoftBody(sheet_.get()); }
    FreeSheet(const FreeSheet&) = delete;
    FreeSheet& operator=(const FreeSheet&) = delete;

    WetCloth& cloth() { return *cloth_; }
    btSoftBody& sheet() { return *sheet_; }

  private:
    demo::BulletWorld bullet_;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
};

inline double mass(const btSoftBody::Node& node) {
    return node.m_im > 0 ? 1 / double(node.m_im) : 0.0;
}

inline bool isFinite(const btSoftBody& body) {
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const btVector3 sum = body.m_nodes[n].m_x + body.m_nodes[n].m_v;
        if (!std::isfinite(sum.x() + sum.y() + sum.z())) return false;
    }
    return true;
}

inline double largestStrain(const btSoftBody& body) {
    double largest = 0;
    for (int i = 0; i < body.m_links.size(); ++i) {
        const btSoftBody::Link& link = body.m_links[i];
        const double length = double((link.m_n[1]->m_x - link.m_n[0]->m_x).length());
        largest = std::max(largest, std::abs(length / double(link.m_rl) - 1));
    }
    return largest;
}

inline std::unique_ptr<btSoftBody> smallSheet(btSoftBodyWorldInfo& info) {
    return hangingSheet(info, fabrics::cottonPlain(), 0.5, 17);
}

/// Bullet's own patch, 0.6 m square and level, with its default links and iterations.
inline std::unique_ptr<btSoftBody> patch(btSoftBodyWorldInfo& info) {
    info.m_sparsesdf.setDefaultVoxelsz(btScalar(0.02));
    info.m_sparsesdf.Reset();
    std::unique_ptr<btSoftBody> body(btSoftBodyHelpers::CreatePatch(
        info, {btScalar(-0.3), 1, btScalar(-0.3)}, {btScalar(0.3), 1, btScalar(-0.3)},
        {btScalar(-0.3), 1, btScalar(0.3)}, {btScalar(0.3), 1, btScalar(0.3)}, 17, 17, 1 + 2, true));
    body->getCollisionShape()->setMargin(btScalar(0.01));
    return body;
}

/// A body from a list of triangles: an irregular hexagonal piece of cloth, 0.4 m across, through
/// CreateFromTriMesh.
inline std::unique_ptr<btSoftBody> triangleMesh(btSoftBodyWorldInfo& info) {
    info.m_sparsesdf.setDefaultVoxelsz(btScalar(0.02));
    info.m_sparsesdf.Reset();
    constexpr int rings = 6;
    std::vector<btScalar> vertices{0, 1, 0};
    std::vector<int> triangles;
    const auto vertex = [](int ring, int step) {
        return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + step % (6 * ring);
    };
    for (int ring = 1; ring <= rings; ++ring)
        for (int step = 0; step < 6 * ring; ++step) {
            const double angle = 2 * 3.14159265358979 * (step + 0.13 * ring) / (6 * ring),
                         radius = 0.2 * ring / rings;
            vertices.insert(vertices.end(),
                            {btScalar(radius * std::cos(angle)), 1, btScalar(radius * std::sin(angle))});
        }
    for (int ring = 1; ring <= rings; ++ring)
        for (int sector = 0; sector < 6; ++sector)
            for (int k = 0; k < ring; ++k) {
                const int inner = (ring - 1) * sector + k, outer = ring * sector + k;
                triangles.insert(triangles.end(),
                                 {vertex(ring - 1, inner), vertex(ring, outer), vertex(ring, outer + 1)});
                if (k + 1 < ring)
                    triangles.insert(triangles.end(), {vertex(ring - 1, inner), vertex(ring, outer + 1),
                                                       vertex(ring - 1, inner + 1)});
            }
    std::unique_ptr<btSoftBody> body(btSoftBodyHelpers::CreateFromTriMesh(
        info, vertices.data(), triangles.data(), static_cast<int>(triangles.size() / 3), false));
    body->getCollisionShape()->setMargin(btScalar(0.005));
    body->m_nodes[0].m_im = 0;
    return body;
}

}  // namespace drench::test
