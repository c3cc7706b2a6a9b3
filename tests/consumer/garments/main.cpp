// A wardrobe: garments of one mesh in several fabrics come and go while the world runs, and steam wets them.
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#include <drench/drench.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <list>
#include <memory>
#include <string>

#include "triangle_mesh.h"

namespace {

// A source of the application's own: what is near it condenses steam.
class Steamer final : public drench::Source {
  public:
    explicit Steamer(const Eigen::Vector3d& position) : position_(position) {}
    std::string name() const override { return "steamer"; }
    void supply(const drench::SheetPose& sheet, double dt, drench::Supply& supply) override {
        constexpr double reach = 0.5;  // m
        constexpr double rate = 0.1;   // kg per s and m2 of cloth
        for (std::size_t node = 0; node < sheet.mesh.size(); ++node) {
            const double mass = rate * sheet.mesh.areas[node] * dt;
            if (mass > 0 && (sheet.positions[node] - position_).norm() < reach) supply.addPores(node, mass);
        }
    }

  private:
    Eigen::Vector3d position_;
};

// One garment in one world: comes with its constructor and goes with its destructor.
class Garment {
  public:
    Garment(btSoftRigidDynamicsWorld& world, const TriangleMesh& mesh, const drench::Fabric& fabric,
            const btVector3& position)
        : world_(world),
          body_(btSoftBodyHelpers::CreateFromTriMesh(world.getWorldInfo(), mesh.coordinates.data(),
                                                     mesh.corners.data(), mesh.triangles(), inMeshOrder)) {
        body_->translate(position);
        body_->getCollisionShape()->setMargin(btScalar(0.01));
        body_->m_cfg.kDP = 1;
        pinWaist();

        // Cloth that is sewn into a tube: its weft runs along the axis, its warp around.
        drench::SheetSettings settings;
        settings.faceCoordinates = drench::wrappedCoordinates(*body_, {0, 1, 0});
        cloth_ = std::make_unique<drench::WetCloth>(world_, *body_, fabric, settings);
        world_.addSoftBody(body_.get());
    }
    ~Garment() {
        cloth_.reset();
        world_.removeSoftBody(body_.get());
    }
    Garment(const Garment&) = delete;
    Garment& operator=(const Garment&) = delete;

    drench::WetCloth& cloth() { return *cloth_; }
    double waist() const { return waist_; }
    double hem() const {
        double height = waist_;
        for (int i = 0; i < body_->m_nodes.size(); ++i)
            height = std::min(height, double(body_->m_nodes[i].m_x.y()));
        return height;
    }

  private:
    static constexpr bool inMeshOrder = false;

    void pinWaist() {
        waist_ = body_->m_nodes[0].m_x.y();
        for (int i = 0; i < body_->m_nodes.size(); ++i)
            waist_ = std::max(waist_, double(body_->m_nodes[i].m_x.y()));
        for (int i = 0; i < body_->m_nodes.size(); ++i)
            if (body_->m_nodes[i].m_x.y() > waist_ - 0.01) body_->setMass(i, 0);
    }

    btSoftRigidDynamicsWorld& world_;
    std::unique_ptr<btSoftBody> body_;
    std::unique_ptr<drench::WetCloth> cloth_;
    double waist_ = 0;
};

// The world of the wardrobe: gravity, and Drench's solver.
class Wardrobe {
  public:
    Wardrobe() {
        world_.setGravity({0, btScalar(-9.81), 0});
        world_.getWorldInfo().m_gravity = world_.getGravity();
        world_.getWorldInfo().m_sparsesdf.setDefaultVoxelsz(btScalar(0.02));
        world_.getWorldInfo().m_sparsesdf.Reset();
    }
    btSoftRigidDynamicsWorld& world() { return world_; }
    void run(double time) {
        for (int frame = 0; frame < time * 60; ++frame) world_.stepSimulation(btScalar(1) / 60);
    }

  private:
    drench::SmallStepSolver solver_;
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver constraints_;
    btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &constraints_, &configuration_, &solver_};
};

bool expect(bool holds, const char* what) {
    if (!holds) std::printf("not so: %s\n", what);
    return holds;
}

bool isWhole(Garment& garment) {
    const drench::SheetHealth health = garment.cloth().health();
    return health.finite && health.largestStrain < 0.1 &&
           std::abs(garment.cloth().ledger().imbalance()) < 1e-9;
}

// Hangs up skirts, steams one, takes one away for another. @return whether all went well
bool changeClothes(const TriangleMesh& skirt) {
    Wardrobe wardrobe;
    std::list<Garment> garments;
    const drench::Fabric fabrics[] = {drench::fabrics::cottonPlain(), drench::fabrics::denim(),
                                      drench::fabrics::silk()};
    for (const drench::Fabric& fabric : fabrics)
        garments.emplace_back(wardrobe.world(), skirt, fabric, btVector3(btScalar(garments.size()), 1, 0));
    wardrobe.run(0.5);
    bool good = expect(std::all_of(garments.begin(), garments.end(), isWhole), "all three hang well");

    Garment& cotton = garments.front();
    const double dryHem = cotton.hem();
    const drench::Source& steamer = cotton.cloth().add(Steamer({0, 0.5, 0.3}));
    wardrobe.run(1);
    cotton.cloth().remove(steamer);
    const double steamed = cotton.cloth().waterMass();
    good &= expect(steamed > 0.01, "the steamer has wetted the cotton skirt");
    good &= expect(cotton.hem() < dryHem, "its hem is lower");

    garments.pop_back();  // the silk goes, a jersey comes
    garments.emplace_back(wardrobe.world(), skirt, drench::fabrics::jersey(), btVector3(3, 1, 0));
    garments.back().cloth().soakPores(0.1);
    wardrobe.run(0.5);
    good &= expect(std::all_of(garments.begin(), garments.end(), isWhole),
                   "the three that are there now hang well");
    good &= expect(garments.back().cloth().waterMass() > 0.01, "the jersey is wet");

    garments.clear();
    wardrobe.run(0.1);
    std::printf("hem of cotton at %.4f m dry, %.1f g of steam on it\n", dryHem, 1000 * steamed);
    return good;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::printf("usage: garments MESH.obj\n");
        return 2;
    }
    try {
        return changeClothes(readObj(arguments[1])) ? 0 : 1;
    } catch (const std::exception& error) {  // of the mesh, or what Drench does not take
        std::printf("%s\n", error.what());
        return 2;
    }
}
