// An application that was there before Drench: a soft-rigid world with a solver, a pre-tick callback and soft bodies
// of its own. Two sheets on a line are new in it, one dry, one wet; everything else goes on as before.
#include <BulletSoftBody/btDefaultSoftBodySolver.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#include <drench/drench.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace {

// The application's solver: Bullet's own, which also counts what it is given to do.
class CountingSolver final : public btDefaultSoftBodySolver {
  public:
    void solveConstraints(btScalar substep) override {
        btDefaultSoftBodySolver::solveConstraints(substep);
        bodiesSolved_ += m_softBodySet.size();
    }
    int bodiesSolved() const { return bodiesSolved_; }

  private:
    int bodiesSolved_ = 0;
};

// The application's world: a ground, and on it a jelly that a breeze pushes along.
class Yard {
  public:
    Yard() {
        world_.setGravity({0, btScalar(-9.81), 0});
        world_.getWorldInfo().m_gravity = world_.getGravity();
        world_.getWorldInfo().m_sparsesdf.setDefaultVoxelsz(btScalar(0.05));
        world_.getWorldInfo().m_sparsesdf.Reset();
        world_.addRigidBody(&ground_);

        constexpr int jellyNodes = 100;
        jelly_.reset(btSoftBodyHelpers::CreateEllipsoid(world_.getWorldInfo(), {2, btScalar(0.6), 0},
                                                        {btScalar(0.3), btScalar(0.3), btScalar(0.3)},
                                                        jellyNodes));
        jelly_->getCollisionShape()->setMargin(btScalar(0.05));
        jelly_->m_cfg.kPR = 20;
        jelly_->m_cfg.kDF = 1;
        jelly_->setTotalMass(1, true);
        world_.addSoftBody(jelly_.get());

        constexpr bool beforeEachSubstep = true;
        world_.setInternalTickCallback(blow, this, beforeEachSubstep);
    }
    ~Yard() {
        world_.removeSoftBody(jelly_.get());
        world_.removeRigidBody(&ground_);
    }

    btSoftRigidDynamicsWorld& world() { return world_; }
    int bodiesSolved() const { return solver_.bodiesSolved(); }
    int breezes() const { return breezes_; }
    btVector3 jellyCentre() const {
        btVector3 sum(0, 0, 0);
        for (int i = 0; i < jelly_->m_nodes.size(); ++i) sum += jelly_->m_nodes[i].m_x;
        return sum / btScalar(jelly_->m_nodes.size());
    }

  private:
    static btRigidBody makeGround(btCollisionShape& shape) {
        btRigidBody::btRigidBodyConstructionInfo settings(0, nullptr, &shape);
        settings.m_startWorldTransform.setIdentity();
        settings.m_startWorldTransform.setOrigin({0, btScalar(-0.5), 0});
        return btRigidBody(settings);
    }

    static void blow(btDynamicsWorld* world, btScalar) {
        auto* yard = static_cast<Yard*>(world->getWorldUserInfo());
        yard->jelly_->addForce({btScalar(0.02), 0, 0});
        ++yard->breezes_;
    }

    CountingSolver solver_;
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver constraints_;
    btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &constraints_, &configuration_, &solver_};
    btBoxShape groundShape_{{10, btScalar(0.5), 10}};
    btRigidBody ground_ = makeGround(groundShape_);
    std::unique_ptr<btSoftBody> jelly_;
    int breezes_ = 0;
};

// A square metre of linen that hangs from a line by its two upper corners.
class Laundry {
  public:
    Laundry(btSoftRigidDynamicsWorld& world, btScalar position)
        : world_(world),
          sheet_(drench::makeSheet(world.getWorldInfo(), drench::fabrics::linen(),
                                   drench::flatCorners({position, 2, 0}, {1, 0, 0}, {0, -1, 0}), nodes,
                                   nodes)) {
        sheet_->m_nodes[0].m_im = 0;
        sheet_->m_nodes[nodes - 1].m_im = 0;
        sheet_->m_cfg.kDP = btScalar(0.002);
        world_.addSoftBody(sheet_.get());
        cloth_ = std::make_unique<drench::WetCloth>(world_, *sheet_, drench::fabrics::linen());
    }
    ~Laundry() {
        cloth_.reset();
        world_.removeSoftBody(sheet_.get());
    }
    Laundry(const Laundry&) = delete;
    Laundry& operator=(const Laundry&) = delete;

    drench::WetCloth& cloth() { return *cloth_; }
    // Height of the middle of its lower edge, m.
    double lowerEdge() const { return sheet_->m_nodes[nodes * (nodes - 1) + nodes / 2].m_x.y(); }

  private:
    static constexpr int nodes = 9;

    btSoftRigidDynamicsWorld& world_;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<drench::WetCloth> cloth_;
};

// The stock solver gives cloth its weight in substeps that are as short as its links ask for.
constexpr int frames = 120;
constexpr int substepsAFrame = 20;

void run(Yard& yard) {
    constexpr btScalar frame = btScalar(1) / 60;
    for (int i = 0; i < frames; ++i)
        yard.world().stepSimulation(frame, substepsAFrame + 1, frame / substepsAFrame);
}

// Drench says what it cannot do by exceptions of the standard library.
bool refusesSpray(drench::WetCloth& cloth, double rate) {
    try {
        cloth.add(drench::Spray({0, 2, 0}, {0, -1, 0}, rate));
    } catch (const std::invalid_argument& error) {
        std::printf("as it should be: %s\n", error.what());
        return true;
    }
    return false;
}

bool expect(bool holds, const char* what) {
    if (!holds) std::printf("not so: %s\n", what);
    return holds;
}

}  // namespace

int main() {
    Yard before;
    run(before);

    Yard yard;
    Laundry dry(yard.world(), -3);
    Laundry wet(yard.world(), -1);
    wet.cloth().soakPores(0.2);
    drench::Spray& hose = wet.cloth().add(drench::Spray({-0.5, 1.5, 2}, {0, 0, -1}, 0.01));
    run(yard);
    hose.rate = 0;
    run(yard);
    run(before);

    const drench::Ledger water = wet.cloth().ledger();
    std::printf("lower edges at %.4f m dry and %.4f m wet; %.4f kg supplied, %.4f held\n", dry.lowerEdge(),
                wet.lowerEdge(), water.supplied, water.held);

    bool good = true;
    good &= expect(refusesSpray(dry.cloth(), -1), "a hose that sucks is refused");
    good &= expect(1.0 / 60 / substepsAFrame < wet.cloth().stepBound(), "the substeps are short enough");
    good &= expect(wet.lowerEdge() < dry.lowerEdge() - 1e-3, "the wet sheet hangs lower");
    good &= expect(water.supplied > 0.2, "the hose has brought water");
    good &= expect(std::abs(water.imbalance()) < 1e-9, "no water is lost");
    good &= expect(yard.breezes() == before.breezes(), "the callback runs once a substep");
    good &= expect(yard.bodiesSolved() == 3 * before.bodiesSolved(),
                   "the solver has three bodies instead of one");
    good &=
        expect(yard.jellyCentre() == before.jellyCentre(), "the jelly is where it was without the sheets");
    return good ? 0 : 1;
}
