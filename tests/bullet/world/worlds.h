// Small real worlds for the tests.
#pragma once

#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <drench/drench.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "world/bullet_world.h"

namespace drench::test {

// A sheet of side x side metres, hanging in the plane z = 0 from its upper edge at y = 0; warp along x, weft
// downwards.
inline std::unique_ptr<btSoftBody> hangingSheet(btSoftBodyWorldInfo& info, const Fabric& fabric, double side,
                                                int nodes) {
    auto sheet =
        makeSheet(info, fabric,
                  flatCorners({btScalar(-side / 2), 0, 0}, {btScalar(side), 0, 0}, {0, btScalar(-side), 0}),
                  nodes, nodes);
    for (int i = 0; i < nodes; ++i) sheet->m_nodes[i].m_im = 0;
    return sheet;
}

// A world with one soft body in it, which leaves the world before it goes.
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

// A level square metre of free cloth without gravity, 11 x 11 nodes, whose layer the test steps itself.
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

// A world whose sheets a SmallStepSolver moves, and the sheets and their cloth, which leave it before it goes.
class SmallStepWorld {
  public:
    explicit SmallStepWorld(const SmallStepSettings& steps = {}) : solver_(steps), bullet_(&solver_) {}
    ~SmallStepWorld() {
        cloths_.clear();
        for (const auto& body : bodies_) bullet_.world().removeSoftBody(body.get());
    }
    SmallStepWorld(const SmallStepWorld&) = delete;
    SmallStepWorld& operator=(const SmallStepWorld&) = delete;

    SmallStepSolver& solver() { return solver_; }
    demo::BulletWorld& bullet() { return bullet_; }
    btSoftRigidDynamicsWorld& world() { return bullet_.world(); }
    btSoftBodyWorldInfo& info() { return bullet_.world().getWorldInfo(); }

    // For rigid and soft bodies.
    void setGravity(const btVector3& gravity) {
        world().setGravity(gravity);
        info().m_gravity = gravity;
    }

    btSoftBody& add(std::unique_ptr<btSoftBody> body) {
        world().addSoftBody(body.get());
        bodies_.push_back(std::move(body));
        return *bodies_.back();
    }
    WetCloth& cover(btSoftBody& body, const Fabric& fabric, const SheetSettings& settings = {}) {
        cloths_.push_back(std::make_unique<WetCloth>(world(), body, fabric, settings));
        return *cloths_.back();
    }

    // In the order in which bodies were covered.
    WetCloth& clothOf(std::size_t index) { return *cloths_.at(index); }

    // Runs for so long in frames of `frameTime`, each one substep of Bullet's.
    void run(double time, double frameTime = 1.0 / 60) {
        const auto frames = static_cast<int>(std::lround(time / frameTime));
        for (int i = 0; i < frames; ++i) bullet_.step(frameTime, 1);
    }

  private:
    SmallStepSolver solver_;
    demo::BulletWorld bullet_;
    std::vector<std::unique_ptr<btSoftBody>> bodies_;
    std::vector<std::unique_ptr<WetCloth>> cloths_;
};

// Settings of a WetCloth whose work the test leaves undone after the first: no air, and water that stays.
inline SheetSettings withoutAir() {
    SheetSettings settings;
    settings.stepping = Stepping::byApplication;
    return settings;
}

// Settings of a WetCloth that throws where something goes wrong.
inline SheetSettings throwing() {
    SheetSettings settings;
    settings.onTrouble = OnTrouble::throwError;
    return settings;
}

// A level square sheet around (0, height, 0); warp along x, weft along z.
inline std::unique_ptr<btSoftBody> levelSheet(btSoftBodyWorldInfo& info, const Fabric& fabric, double side,
                                              int nodes, double height) {
    return makeSheet(info, fabric,
                     flatCorners({btScalar(-side / 2), btScalar(height), btScalar(-side / 2)},
                                 {btScalar(side), 0, 0}, {0, 0, btScalar(side)}),
                     nodes, nodes);
}

// A sheet whose half is folded over the other, a few margins above it.
inline std::unique_ptr<btSoftBody> foldedSheet(btSoftBodyWorldInfo& info, double side, int nodes) {
    auto sheet = levelSheet(info, fabrics::cottonPlain(), side, nodes, 0);
    const double radius = 2.5 * double(sheet->getCollisionShape()->getMargin()), arc = 3.14159265 * radius;
    for (int n = 0; n < sheet->m_nodes.size(); ++n) {
        btVector3& x = sheet->m_nodes[n].m_x;
        const double along = double(x.x()), angle = std::clamp(along / radius, 0.0, arc / radius);
        const double beyond = std::max(along - arc, 0.0);
        x.setX(btScalar(along < 0 ? along : radius * std::sin(angle) - beyond));
        x.setY(btScalar(radius * (1 - std::cos(angle)) + 0.02));
        sheet->m_nodes[n].m_q = x;
    }
    return sheet;
}

// Material coordinates of the sheet before it was folded.
inline std::vector<Eigen::Vector2d> levelCoordinates(double side, int nodes) {
    std::vector<Eigen::Vector2d> all;
    for (int row = 0; row < nodes; ++row)
        for (int column = 0; column < nodes; ++column)
            all.emplace_back(side * column / (nodes - 1), side * row / (nodes - 1));
    return all;
}

inline void setVelocity(btSoftBody& body, const btVector3& velocity) {
    for (int n = 0; n < body.m_nodes.size(); ++n) body.m_nodes[n].m_v = velocity;
}

inline double mass(const btSoftBody::Node& node) {
    return node.m_im > 0 ? 1 / double(node.m_im) : 0.0;
}

// Momentum of the nodes that are free, kg m/s.
inline btVector3 momentum(const btSoftBody& body) {
    btVector3 sum(0, 0, 0);
    for (int n = 0; n < body.m_nodes.size(); ++n)
        sum += body.m_nodes[n].m_v * btScalar(mass(body.m_nodes[n]));
    return sum;
}

// Mass of the nodes that are free, kg.
inline double mass(const btSoftBody& body) {
    double sum = 0;
    for (int n = 0; n < body.m_nodes.size(); ++n) sum += mass(body.m_nodes[n]);
    return sum;
}

inline double fastest(const btSoftBody& body) {
    double speed = 0;
    for (int n = 0; n < body.m_nodes.size(); ++n)
        speed = std::max(speed, double(body.m_nodes[n].m_v.length()));
    return speed;
}

inline double lowest(const btSoftBody& body) {
    double height = 1e9;
    for (int n = 0; n < body.m_nodes.size(); ++n) height = std::min(height, double(body.m_nodes[n].m_x.y()));
    return height;
}

using demo::meanStrain;

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

// Bullet's own patch, 0.6 m square and level, with its default links and iterations.
inline std::unique_ptr<btSoftBody> patch(btSoftBodyWorldInfo& info) {
    info.m_sparsesdf.setDefaultVoxelsz(btScalar(0.02));
    info.m_sparsesdf.Reset();
    std::unique_ptr<btSoftBody> body(btSoftBodyHelpers::CreatePatch(
        info, {btScalar(-0.3), 1, btScalar(-0.3)}, {btScalar(0.3), 1, btScalar(-0.3)},
        {btScalar(-0.3), 1, btScalar(0.3)}, {btScalar(0.3), 1, btScalar(0.3)}, 17, 17, 1 + 2, true));
    body->getCollisionShape()->setMargin(btScalar(0.01));
    return body;
}

// A body from a list of triangles: an irregular hexagonal piece of cloth, 0.4 m across, through
// CreateFromTriMesh.
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
