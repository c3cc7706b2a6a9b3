// An application in Bullet's deformable world: a ball lies in an awning, beside a block of rubber. Then it rains.
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>
#include <drench/drench.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace {

// The deformable world as Bullet's examples set it up.
class World {
  public:
    World() {
        constraints_.setDeformableSolver(&solver_);
        world_.setGravity(gravity_.m_gravity);
        world_.getWorldInfo().m_gravity = gravity_.m_gravity;
        world_.getWorldInfo().m_sparsesdf.setDefaultVoxelsz(btScalar(0.02));
        world_.getWorldInfo().m_sparsesdf.Reset();
        world_.setImplicit(false);
    }
    btDeformableMultiBodyDynamicsWorld& operator*() { return world_; }
    btDeformableMultiBodyDynamicsWorld* operator->() { return &world_; }

    void add(btSoftBody& body) {
        world_.addSoftBody(&body);
        world_.addForce(&body, &gravity_);
    }

    // Explicit steps, none longer than the cloth allows.
    void run(double time, const drench::WetCloth& cloth) {
        const int steps = int(std::ceil(time / cloth.stepBound()));
        constexpr int asGiven = 0;
        for (int i = 0; i < steps; ++i) world_.stepSimulation(btScalar(time / steps), asGiven);
    }

  private:
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btDeformableMultiBodyConstraintSolver constraints_;
    btDeformableBodySolver solver_;
    btDeformableGravityForce gravity_{{0, btScalar(-9.81), 0}};
    btDeformableMultiBodyDynamicsWorld world_{&dispatcher_, &broadphase_, &constraints_, &configuration_,
                                              &solver_};
};

// A rigid body of one shape, in a world as long as it lives.
class Solid {
  public:
    Solid(World& world, std::unique_ptr<btCollisionShape> shape, btScalar mass, const btVector3& position)
        : world_(world), shape_(std::move(shape)) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape_->calculateLocalInertia(mass, inertia);
        btRigidBody::btRigidBodyConstructionInfo settings(mass, nullptr, shape_.get(), inertia);
        settings.m_startWorldTransform.setIdentity();
        settings.m_startWorldTransform.setOrigin(position);
        body_ = std::make_unique<btRigidBody>(settings);
        world_->addRigidBody(body_.get());
    }
    ~Solid() { world_->removeRigidBody(body_.get()); }
    Solid(const Solid&) = delete;
    Solid& operator=(const Solid&) = delete;

    double height() const { return body_->getWorldTransform().getOrigin().y(); }

  private:
    World& world_;
    std::unique_ptr<btCollisionShape> shape_;
    std::unique_ptr<btRigidBody> body_;
};

// The application's own deformable: a patch of springs, of which Drench knows nothing.
class Rubber {
  public:
    explicit Rubber(World& world) : world_(world) {
        constexpr btScalar y = btScalar(0.5);
        constexpr int nodes = 5, pinAllCorners = 15;
        body_.reset(btSoftBodyHelpers::CreatePatch(world->getWorldInfo(), {2, y, 0}, {btScalar(2.4), y, 0},
                                                   {2, y, btScalar(0.4)}, {btScalar(2.4), y, btScalar(0.4)},
                                                   nodes, nodes, pinAllCorners, true));
        body_->setTotalMass(btScalar(0.5));
        world_.add(*body_);
        world_->addForce(body_.get(), &springs_);
    }
    ~Rubber() { world_->removeSoftBody(body_.get()); }
    Rubber(const Rubber&) = delete;
    Rubber& operator=(const Rubber&) = delete;

    double middle() const { return body_->m_nodes[body_->m_nodes.size() / 2].m_x.y(); }

  private:
    World& world_;
    btDeformableMassSpringForce springs_{btScalar(30), btScalar(0.1)};
    std::unique_ptr<btSoftBody> body_;
};

// A square metre of polyester, held at its four corners.
class Awning {
  public:
    explicit Awning(World& world)
        : world_(world),
          sheet_(drench::makeSheet(world->getWorldInfo(), drench::fabrics::polyesterPlain(),
                                   drench::flatCorners({0, 1, 0}, {1, 0, 0}, {0, 0, 1}), nodes, nodes)) {
        for (const int corner : {0, nodes - 1, nodes * (nodes - 1), nodes * nodes - 1})
            sheet_->m_nodes[corner].m_im = 0;
        sheet_->m_cfg.collisions = btSoftBody::fCollision::SDF_RD | btSoftBody::fCollision::SDF_RDN;
        sheet_->m_cfg.drag = btScalar(0.001);
        world_.add(*sheet_);
        cloth_ = std::make_unique<drench::WetCloth>(*world_, *sheet_, drench::fabrics::polyesterPlain());
    }
    ~Awning() {
        cloth_.reset();
        world_->removeSoftBody(sheet_.get());
    }
    Awning(const Awning&) = delete;
    Awning& operator=(const Awning&) = delete;

    drench::WetCloth& cloth() { return *cloth_; }
    double lowest() const {
        double height = sheet_->m_nodes[0].m_x.y();
        for (int i = 0; i < sheet_->m_nodes.size(); ++i)
            height = std::min(height, double(sheet_->m_nodes[i].m_x.y()));
        return height;
    }

  private:
    static constexpr int nodes = 13;

    World& world_;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<drench::WetCloth> cloth_;
};

bool expect(bool holds, const char* what) {
    if (!holds) std::printf("not so: %s\n", what);
    return holds;
}

}  // namespace

int main() {
    World world;
    Rubber rubber(world);
    Awning awning(world);
    constexpr double radius = 0.1;
    Solid ball(world, std::make_unique<btSphereShape>(btScalar(radius)), btScalar(0.2),
               {btScalar(0.5), btScalar(1.15), btScalar(0.5)});

    world.run(2, awning.cloth());
    const double dryHeight = ball.height();

    awning.cloth().add(drench::Rain(1000));  // mm/h: a cloudburst
    world.run(2, awning.cloth());

    const drench::Ledger water = awning.cloth().ledger();
    std::printf("the ball lies at %.4f m dry and %.4f m in %.3f kg of rain, the rubber at %.3f m\n",
                dryHeight, ball.height(), water.held, rubber.middle());

    bool good = true;
    good &= expect(dryHeight > awning.lowest() && dryHeight < 1.1, "the ball lies in the awning");
    good &= expect(ball.height() < dryHeight - 1e-3, "the rain presses it lower");
    good &=
        expect(std::abs(water.supplied - 1000.0 / 3600 * 2) < 0.12, "as much rain has come as was asked for");
    good &= expect(std::abs(water.imbalance()) < 1e-9, "no water is lost");
    good &= expect(awning.cloth().health().finite, "the awning is whole");
    good &= expect(rubber.middle() < 0.5 && rubber.middle() > 0, "the rubber hangs in its corners");
    return good ? 0 : 1;
}
