// One gravity for a sheet and its water, wherever Bullet keeps it, in each kind of world.
#include "bullet/world/gravity.h"

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <limits>
#include <string>

#include "bullet/world/any_world.h"
#include "bullet/world/vectors.h"

namespace drench::gravity_test {
namespace {

using test::reportOf;

enum class Kind { softRigid, softRigidSmallSteps, softMultiBody, deformableImplicit, deformableExplicit };

constexpr Kind kinds[] = {Kind::softRigid, Kind::softRigidSmallSteps, Kind::softMultiBody,
                          Kind::deformableImplicit, Kind::deformableExplicit};
constexpr Kind movedByInfo[] = {Kind::softRigid, Kind::softRigidSmallSteps, Kind::softMultiBody};
constexpr Kind deformableKinds[] = {Kind::deformableImplicit, Kind::deformableExplicit};

const btVector3 alongZ(0, 0, btScalar(-9.81)), alongX(btScalar(-9.81), 0, 0), alongY(0, btScalar(-9.81), 0),
    none(0, 0, 0);

// A world as Bullet's constructors leave it, with a free sheet far from everything.
class Rig {
  public:
    explicit Rig(Kind kind, const SheetSettings& settings = {}) : kind_(kind) {
        make();
        sheet_ = test::levelSheet(info(), fabrics::cottonPlain(), 0.5, 9, 0);
        addBody();
        cloth_ = std::make_unique<WetCloth>(*world_, *sheet_, fabrics::cottonPlain(), settings);
    }
    ~Rig() {
        cloth_.reset();
        world_->removeCollisionObject(sheet_.get());
    }
    Rig(const Rig&) = delete;
    Rig& operator=(const Rig&) = delete;

    btDiscreteDynamicsWorld& world() { return *world_; }
    btSoftBodyWorldInfo& info() { return *info_; }
    btSoftBody& sheet() { return *sheet_; }
    WetCloth& cloth() { return *cloth_; }

    // Has the body fall by a force of gravity. @pre the world is deformable
    btDeformableGravityForce& addForce(const btVector3& gravity) {
        force_ = std::make_unique<btDeformableGravityForce>(gravity);
        static_cast<btDeformableMultiBodyDynamicsWorld&>(*world_).addForce(sheet_.get(), force_.get());
        return *force_;
    }
    // Sets the place that moves the body.
    void setOfBody(const btVector3& gravity) {
        if (!isDeformable(*world_))
            info().m_gravity = gravity;
        else if (force_)
            force_->m_gravity = gravity;
        else
            addForce(gravity);
    }
    void run(int substeps) {
        const btScalar dt = btScalar(substep());
        for (int i = 0; i < substeps; ++i) world_->stepSimulation(dt, 0);
    }
    // Acceleration of the sheet's middle in the next few substeps, in air that hardly counts yet, m/s2.
    btVector3 acceleration() {
        constexpr int few = 4;
        const btVector3 before = meanVelocity();
        run(few);
        return (meanVelocity() - before) / btScalar(few * substep());
    }
    // Where up is for the water, as sources are told.
    Eigen::Vector3d up() { return toldBy_ ? toldBy_->up : Eigen::Vector3d::Constant(7); }
    double strength() { return toldBy_ ? toldBy_->strength : -1; }
    void listen() { toldBy_ = &cloth_->add(Listener()).told(); }

  private:
    struct Told {
        Eigen::Vector3d up = {7, 7, 7};
        double strength = -1;
    };
    class Listener final : public Source {
      public:
        std::string name() const override { return "listener"; }
        void supply(const SheetPose& sheet, double dt, Supply&) override {
            if (dt > 0) *told_ = {sheet.up, sheet.gravity};
        }
        Told& told() { return *told_; }

      private:
        std::shared_ptr<Told> told_ = std::make_shared<Told>();
    };

    double substep() const { return kind_ == Kind::deformableExplicit ? 1.0 / 4000 : 1.0 / 240; }
    btVector3 meanVelocity() const {
        btVector3 sum(0, 0, 0);
        for (int n = 0; n < sheet_->m_nodes.size(); ++n) sum += sheet_->m_nodes[n].m_v;
        return sum / btScalar(sheet_->m_nodes.size());
    }
    void make() {
        if (kind_ == Kind::softMultiBody) {
            auto world = std::make_unique<btSoftMultiBodyDynamicsWorld>(
                &dispatcher_, &broadphase_, &multiBodyConstraints_, &configuration_, nullptr);
            info_ = &world->getWorldInfo();
            world_ = std::move(world);
        } else if (kind_ == Kind::deformableImplicit || kind_ == Kind::deformableExplicit) {
            deformableConstraints_.setDeformableSolver(&deformableSolver_);
            auto world = std::make_unique<btDeformableMultiBodyDynamicsWorld>(
                &dispatcher_, &broadphase_, &deformableConstraints_, &configuration_, &deformableSolver_);
            world->setImplicit(kind_ == Kind::deformableImplicit);
            world->setUseProjection(kind_ == Kind::deformableImplicit);
            info_ = &world->getWorldInfo();
            world_ = std::move(world);
        } else {
            auto world = std::make_unique<btSoftRigidDynamicsWorld>(
                &dispatcher_, &broadphase_, &constraints_, &configuration_,
                kind_ == Kind::softRigidSmallSteps ? &smallSteps_ : nullptr);
            info_ = &world->getWorldInfo();
            world_ = std::move(world);
        }
        info_->m_sparsesdf.setDefaultVoxelsz(btScalar(0.02));
        info_->m_sparsesdf.Reset();
    }
    void addBody() {
        if (kind_ == Kind::softMultiBody)
            static_cast<btSoftMultiBodyDynamicsWorld&>(*world_).addSoftBody(sheet_.get());
        else if (isDeformable(*world_))
            static_cast<btDeformableMultiBodyDynamicsWorld&>(*world_).addSoftBody(sheet_.get());
        else
            static_cast<btSoftRigidDynamicsWorld&>(*world_).addSoftBody(sheet_.get());
    }
    static bool isDeformable(const btDiscreteDynamicsWorld& world) {
        return world.getWorldType() == BT_DEFORMABLE_MULTIBODY_DYNAMICS_WORLD;
    }

    Kind kind_;
    SmallStepSolver smallSteps_;
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver constraints_;
    btMultiBodyConstraintSolver multiBodyConstraints_;
    btDeformableBodySolver deformableSolver_;
    btDeformableMultiBodyConstraintSolver deformableConstraints_;
    std::unique_ptr<btDeformableGravityForce> force_;
    std::unique_ptr<btDiscreteDynamicsWorld> world_;
    btSoftBodyWorldInfo* info_ = nullptr;
    std::unique_ptr<btSoftBody> sheet_;
    std::unique_ptr<WetCloth> cloth_;
    const Told* toldBy_ = nullptr;
};

// The sheet falls and its water runs along a gravity, from the next substep on.
void expectGravity(Rig& rig, const btVector3& gravity) {
    rig.listen();
    const btVector3 seen = rig.acceleration();
    EXPECT_LT(double((seen - gravity).length()), 0.02 * double(gravity.length()) + 2e-3)
        << seen.x() << ' ' << seen.y() << ' ' << seen.z();
    EXPECT_NEAR(rig.strength(), double(gravity.length()), 1e-5);
    const Eigen::Vector3d down = -rig.strength() * rig.up();
    EXPECT_LT((down - toEigen(gravity)).norm(), 1e-5);
}

int troublesOf(Rig& rig, Trouble what) {
    int found = 0;
    for (const TroubleReport& report : rig.cloth().troubles()) found += report.what == what ? 1 : 0;
    return found;
}

// The report names both values and the call.
void expectReport(Rig& rig, const char* one, const char* other, const char* call) {
    const std::string message = reportOf(rig.cloth(), Trouble::gravityPlaces).message;
    for (const char* part : {one, other, call, "SheetSettings::ownGravity"})
        EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

TEST(Gravity, SetEverywhereItIsOne) {
    for (const Kind kind : kinds)
        for (const btVector3& gravity : {alongZ, alongX, none, btVector3(0, 0, btScalar(1.62))}) {
            SCOPED_TRACE(static_cast<int>(kind));
            Rig rig(kind);
            rig.world().setGravity(gravity);
            rig.info().m_gravity = gravity;
            rig.setOfBody(gravity);
            expectGravity(rig, gravity);
            EXPECT_TRUE(rig.cloth().troubles().empty());
        }
}

TEST(Gravity, InADeformableWorldTheWorldInfoNeedsNotBeSet) {
    for (const Kind kind : deformableKinds) {
        Rig rig(kind);
        rig.world().setGravity(alongZ);
        rig.addForce(alongZ);
        expectGravity(rig, alongZ);
        EXPECT_TRUE(rig.cloth().troubles().empty());
    }
}

TEST(Gravity, SetForTheWorldAloneItIsThatOfTheSheet) {
    for (const Kind kind : movedByInfo)
        for (const btVector3& gravity : {alongZ, none}) {
            SCOPED_TRACE(static_cast<int>(kind));
            Rig rig(kind);
            rig.world().setGravity(gravity);
            expectGravity(rig, gravity);
            expectReport(rig, gravity.isZero() ? "(0, 0, 0)" : "(0, 0, -9.81)", "(0, -10, 0)",
                         "body.getWorldInfo()->m_gravity");
            EXPECT_EQ(rig.info().m_gravity, btVector3(0, -10, 0)) << "other bodies fall as they did";
        }
}

TEST(Gravity, SetInTheWorldInfoAloneItIsThat) {
    for (const Kind kind : movedByInfo) {
        SCOPED_TRACE(static_cast<int>(kind));
        Rig rig(kind);
        rig.info().m_gravity = alongZ;
        expectGravity(rig, alongZ);
        expectReport(rig, "(0, 0, -9.81)", "(0, -10, 0)", "world.setGravity");
    }
}

TEST(Gravity, SetForTheForceAloneItIsThat) {
    for (const Kind kind : deformableKinds) {
        Rig rig(kind);
        rig.addForce(alongZ);
        expectGravity(rig, alongZ);
        expectReport(rig, "(0, 0, -9.81)", "(0, -10, 0)", "world.setGravity");
    }
}

TEST(Gravity, TwoThatWereSetAreReportedAndBulletsMovesTheBody) {
    for (const Kind kind : kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        Rig rig(kind);
        rig.world().setGravity(alongX);
        rig.setOfBody(alongZ);
        expectGravity(rig, alongZ);
        expectReport(rig, "(0, 0, -9.81)", "(-9.81, 0, 0)", "world.setGravity");
    }
}

TEST(Gravity, AWorldInfoThatMovesNothingIsReportedIfItWasSet) {
    for (const Kind kind : deformableKinds) {
        Rig rig(kind);
        rig.world().setGravity(alongZ);
        rig.addForce(alongZ);
        rig.info().m_gravity = alongX;
        expectGravity(rig, alongZ);
        expectReport(rig, "(0, 0, -9.81)", "(-9.81, 0, 0)", "getWorldInfo()->m_gravity");
    }
}

TEST(Gravity, WithoutAForceOnlyTheWaterFalls) {
    Rig rig(Kind::deformableExplicit);
    rig.world().setGravity(alongZ);
    rig.listen();
    EXPECT_LT(double(rig.acceleration().length()), 1e-4);
    EXPECT_NEAR(rig.up().z(), 1, 1e-6);
    expectReport(rig, "(0, 0, -9.81)", "no btDeformableGravityForce", "world.addForce");
}

TEST(Gravity, ConventionalValuesDoNotDisagree) {
    for (const Kind kind : kinds)
        for (const double strength : {9.8, 9.80665, 9.81, 10.0}) {
            SCOPED_TRACE(static_cast<int>(kind));
            Rig rig(kind);
            rig.setOfBody({0, btScalar(-strength), 0});
            expectGravity(rig, {0, btScalar(-strength), 0});
            EXPECT_TRUE(rig.cloth().troubles().empty());
        }
}

TEST(Gravity, OfItsOwnASheetMayHaveAnyAndZeroWithoutSayingSo) {
    SheetSettings own;
    own.ownGravity = true;
    for (const Kind kind : kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        own.onTrouble = OnTrouble::throwError;
        Rig half(kind, own);
        half.world().setGravity(alongY);
        half.setOfBody(alongY * btScalar(0.5));
        expectGravity(half, alongY * btScalar(0.5));

        Rig asBulletHasIt(kind, own);
        asBulletHasIt.world().setGravity(none);
        asBulletHasIt.setOfBody({0, -10, 0});
        expectGravity(asBulletHasIt, {0, -10, 0});

        Rig kite(kind, test::throwing());
        kite.world().setGravity(alongY);
        kite.setOfBody(none);
        expectGravity(kite, none);
    }
    Rig light(Kind::deformableExplicit, test::throwing());
    light.world().setGravity(alongY);
    light.addForce(alongY);
    light.sheet().setGravityFactor(btScalar(0.5));
    expectGravity(light, alongY * btScalar(0.5));
}

TEST(Gravity, AWorldInfoOfItsOwnIsThatOfTheBody) {
    for (const Kind kind : movedByInfo) {
        Rig rig(kind);
        btSoftBodyWorldInfo its = rig.info();
        its.m_gravity = none;
        rig.world().setGravity(alongY);
        rig.info().m_gravity = alongY;
        rig.sheet().m_worldInfo = &its;
        expectGravity(rig, none);
        rig.sheet().m_worldInfo = &rig.info();
    }
}

TEST(Gravity, ChangedWhileRunningItWorksAtOnce) {
    for (const Kind kind : kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        Rig rig(kind);
        for (const btVector3& gravity : {alongZ, alongX, alongZ}) {
            rig.world().setGravity(gravity);
            rig.setOfBody(gravity);
            expectGravity(rig, gravity);
        }
        EXPECT_TRUE(rig.cloth().troubles().empty());
    }
    for (const Kind kind : movedByInfo) {
        SCOPED_TRACE(static_cast<int>(kind));
        Rig rig(kind);  // its world info is never touched
        for (const btVector3& gravity : {alongZ, alongX, alongZ}) {
            rig.world().setGravity(gravity);
            expectGravity(rig, gravity);
        }
    }
}

TEST(Gravity, DisagreementIsOneReportThatFollowsTheValues) {
    Rig rig(Kind::softRigidSmallSteps);
    rig.world().setGravity(alongX);
    rig.setOfBody(alongZ);
    rig.run(5);
    EXPECT_EQ(troublesOf(rig, Trouble::gravityPlaces), 1);
    EXPECT_EQ(reportOf(rig.cloth(), Trouble::gravityPlaces).substeps, 5);
    EXPECT_EQ(reportOf(rig.cloth(), Trouble::gravityPlaces).lastSubstep, 4);
    rig.world().setGravity({0, 3, 0});
    rig.run(1);
    expectReport(rig, "(0, 0, -9.81)", "(0, 3, 0)", "world.setGravity");
    EXPECT_EQ(reportOf(rig.cloth(), Trouble::gravityPlaces).substeps, 6);
    rig.cloth().clearTroubles();
    rig.run(1);
    EXPECT_EQ(reportOf(rig.cloth(), Trouble::gravityPlaces).substeps, 1);
    rig.world().setGravity(alongZ);
    rig.cloth().clearTroubles();
    rig.run(3);
    EXPECT_TRUE(rig.cloth().troubles().empty());
}

TEST(Gravity, DisagreementIsThrownUntilItIsMended) {
    for (const Kind kind : kinds) {
        Rig rig(kind, test::throwing());
        rig.world().setGravity(alongX);
        rig.setOfBody(alongZ);
        for (int i = 0; i < 2; ++i) EXPECT_THROW(rig.run(1), std::runtime_error);
        rig.world().clearForces();
        rig.world().setGravity(alongZ);
        EXPECT_NO_THROW(rig.run(1));
    }
}

TEST(Gravity, ThatOfAWorldOrAForceThatIsNoNumberMovesNoWater) {
    const btVector3 invalid(0, std::numeric_limits<btScalar>::quiet_NaN(), 0);
    for (const Kind kind : movedByInfo) {
        Rig rig(kind);
        rig.info().m_gravity = alongZ;
        rig.world().setGravity(invalid);
        expectGravity(rig, alongZ);
        expectReport(rig, "(0, 0, -9.81)", "NaN", "world.setGravity");
    }
    Rig rig(Kind::deformableImplicit);
    rig.world().setGravity(alongZ);
    rig.addForce(alongZ);
    rig.listen();
    rig.run(2);
    rig.setOfBody(invalid);
    rig.run(2);
    EXPECT_NEAR(rig.up().z(), 1, 1e-6);
    EXPECT_NE(reportOf(rig.cloth(), Trouble::gravity).message.find("btDeformableGravityForce"),
              std::string::npos);
    EXPECT_EQ(troublesOf(rig, Trouble::gravityPlaces), 0);
}

TEST(Gravity, DropsFallByIt) {
    for (const Kind kind : kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        Rig rig(kind);
        rig.world().setGravity(alongZ);
        if (kind == Kind::deformableImplicit || kind == Kind::deformableExplicit) rig.addForce(alongZ);
        for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) rig.sheet().m_nodes[n].m_im = 0;
        FallingDrops drops(rig.world());
        drops.add(rig.cloth());
        rig.cloth().soakFilm(2);
        for (int i = 0; i < 20000 && drops.inFlight().empty(); ++i) {
            rig.run(1);
            drops.step(0);
        }
        ASSERT_FALSE(drops.inFlight().empty());
        const Eigen::Vector3d from = drops.inFlight()[0].position;
        drops.step(0.1);
        const Eigen::Vector3d fell = drops.inFlight()[0].position - from;
        EXPECT_NEAR(fell.z(), -9.81 * 0.01 / 2, 1e-6);
        EXPECT_NEAR(fell.y(), 0, 1e-6);
    }
}

// In each kind of world, with z up, water of a sheet that stands upright runs down along z.
TEST(Gravity, WaterRunsDownAlongZ) {
    for (const Kind kind : kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        Rig rig(kind);
        rig.world().setGravity(alongZ);
        if (kind == Kind::deformableImplicit || kind == Kind::deformableExplicit) rig.addForce(alongZ);
        for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) rig.sheet().m_nodes[n].m_im = 0;
        // The level sheet lies in x and z, so it stands upright in this world.
        rig.cloth().setWaterSpeed(20);
        rig.cloth().soakFilm(0.4);
        rig.run(kind == Kind::deformableExplicit ? 1700 : 100);
        double moment = 0, mass = 0;
        for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) {
            const double water = rig.cloth().nodeMass(n);
            moment += water * double(rig.sheet().m_nodes[n].m_x.z());
            mass += water;
        }
        EXPECT_LT(moment / mass, -0.005);
    }
}

// Where gravity is put right by forces, a snapshot restores to the same bits.
TEST(Gravity, SnapshotsGoOnBitIdenticallyWhereTheWorldInfoWasForgotten) {
    for (const Kind kind : movedByInfo) {
        SCOPED_TRACE(static_cast<int>(kind));
        const auto positions = [](Rig& rig) {
            std::vector<btVector3> all;
            for (int n = 0; n < rig.sheet().m_nodes.size(); ++n) all.push_back(rig.sheet().m_nodes[n].m_x);
            return all;
        };
        Rig rig(kind);
        rig.world().setGravity(alongZ);
        rig.cloth().soakFilm(0.3);
        rig.run(20);
        const Snapshot kept = rig.cloth().snapshot();
        rig.run(20);
        const auto expected = positions(rig);
        rig.cloth().restore(kept);
        rig.run(20);
        EXPECT_TRUE(expected == positions(rig));
        Rig other(kind);
        other.world().setGravity(alongZ);
        other.cloth().restore(kept);
        other.run(20);
        EXPECT_TRUE(expected == positions(other));
    }
}

}  // namespace
}  // namespace drench::gravity_test
