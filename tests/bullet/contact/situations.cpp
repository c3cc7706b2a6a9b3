#include "bullet/contact/situations.h"

#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/CollisionShapes/btScaledBvhTriangleMeshShape.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#include <drench/drench.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bullet/world/worlds.h"

namespace drench::test {
namespace {

constexpr btScalar frame = btScalar(1) / 60;
constexpr double solidMass = 1;  // of a dynamic solid, kg
constexpr int side = 13;         // nodes
constexpr btScalar length = btScalar(0.5);

btTransform at(const btVector3& place) {
    return btTransform(btQuaternion::getIdentity(), place);
}

// Depth inside a box of those half extents, m; negative outside.
double depthInBox(const btVector3& p, const btVector3& half) {
    return double(
        std::min({half.x() - std::abs(p.x()), half.y() - std::abs(p.y()), half.z() - std::abs(p.z())}));
}

const btVector3 boxHalf(btScalar(0.2), btScalar(0.1), btScalar(0.2));

// A shape with what it is made of, and a closed form of it.
struct Form {
    virtual ~Form() = default;
    virtual btCollisionShape& shape() = 0;
    // Depth of a point, in the coordinates of the shape, m.
    virtual double depth(const btVector3& p) const = 0;
    virtual btScalar top() const { return boxHalf.y(); }
    virtual btScalar halfWidth() const { return boxHalf.x(); }
};

struct Ball final : Form {
    btSphereShape ball{btScalar(0.2)};
    btCollisionShape& shape() override { return ball; }
    double depth(const btVector3& p) const override { return 0.2 - double(p.length()); }
    btScalar top() const override { return btScalar(0.2); }
};

struct Box final : Form {
    btBoxShape box{boxHalf};
    btCollisionShape& shape() override { return box; }
    double depth(const btVector3& p) const override { return depthInBox(p, boxHalf); }
};

struct Capsule final : Form {
    btCapsuleShapeX capsule{btScalar(0.1), btScalar(0.2)};
    btCollisionShape& shape() override { return capsule; }
    double depth(const btVector3& p) const override {
        const btVector3 axis(std::clamp(p.x(), btScalar(-0.1), btScalar(0.1)), 0, 0);
        return 0.1 - double((p - axis).length());
    }
};

struct Hull final : Form {
    btConvexHullShape hull;
    Hull() {
        for (int axis = 0; axis < 3; ++axis)
            for (const int sign : {-1, 1}) {
                btVector3 corner(0, 0, 0);
                corner[axis] = btScalar(sign) * size()[axis];
                hull.addPoint(corner);
            }
        hull.setMargin(0);
    }
    static btVector3 size() { return {btScalar(0.2), btScalar(0.15), btScalar(0.2)}; }
    btCollisionShape& shape() override { return hull; }
    double depth(const btVector3& p) const override {
        const btVector3 normal(1 / size().x(), 1 / size().y(), 1 / size().z());
        return double((1 - p.absolute().dot(normal)) / normal.length());
    }
    btScalar top() const override { return size().y(); }
};

struct Cylinder final : Form {
    btCylinderShape cylinder{{btScalar(0.2), btScalar(0.1), btScalar(0.2)}};
    btCollisionShape& shape() override { return cylinder; }
    double depth(const btVector3& p) const override {
        return std::min(0.2 - std::hypot(double(p.x()), double(p.z())), 0.1 - std::abs(double(p.y())));
    }
};

// Two boxes side by side, one of them in a compound of its own.
struct Compound final : Form {
    btBoxShape half{{btScalar(0.1), btScalar(0.1), btScalar(0.2)}};
    btCompoundShape inner, all;
    Compound() {
        inner.addChildShape(at({btScalar(0.1), 0, btScalar(0.05)}), &half);
        all.addChildShape(at({btScalar(-0.1), 0, 0}), &half);
        all.addChildShape(at({0, 0, btScalar(-0.05)}), &inner);
    }
    btCollisionShape& shape() override { return all; }
    double depth(const btVector3& p) const override { return depthInBox(p, boxHalf); }
};

// The surface of a box of those half extents, each face of 4 x 4 cells.
void addBox(btTriangleMesh& mesh, const btVector3& half) {
    constexpr int cells = 4;
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1})
            for (int i = 0; i < cells; ++i)
                for (int j = 0; j < cells; ++j) {
                    const auto corner = [&](int di, int dj) {
                        btVector3 place;
                        place[axis] = btScalar(sign) * half[axis];
                        place[(axis + 1) % 3] = half[(axis + 1) % 3] * (btScalar(2 * (i + di)) / cells - 1);
                        place[(axis + 2) % 3] = half[(axis + 2) % 3] * (btScalar(2 * (j + dj)) / cells - 1);
                        return place;
                    };
                    const int one = sign > 0 ? 1 : 0;  // corners in the order that faces outward
                    mesh.addTriangle(corner(0, 0), corner(one, 1 - one), corner(1, 1));
                    mesh.addTriangle(corner(0, 0), corner(1, 1), corner(1 - one, one));
                }
}

struct Mesh final : Form {
    btTriangleMesh triangles;
    std::unique_ptr<btBvhTriangleMeshShape> mesh;
    Mesh() {
        addBox(triangles, boxHalf);
        mesh = std::make_unique<btBvhTriangleMeshShape>(&triangles, true);
    }
    btCollisionShape& shape() override { return *mesh; }
    double depth(const btVector3& p) const override { return depthInBox(p, boxHalf); }
};

struct ScaledMesh final : Form {
    btTriangleMesh triangles;
    std::unique_ptr<btBvhTriangleMeshShape> mesh;
    std::unique_ptr<btScaledBvhTriangleMeshShape> scaled;
    ScaledMesh() {
        addBox(triangles, {1, 1, 1});
        mesh = std::make_unique<btBvhTriangleMeshShape>(&triangles, true);
        scaled = std::make_unique<btScaledBvhTriangleMeshShape>(mesh.get(), boxHalf);
    }
    btCollisionShape& shape() override { return *scaled; }
    double depth(const btVector3& p) const override { return depthInBox(p, boxHalf); }
};

struct Gimpact final : Form {
    btTriangleMesh triangles;
    std::unique_ptr<btGImpactMeshShape> mesh;
    Gimpact() {
        addBox(triangles, boxHalf);
        mesh = std::make_unique<btGImpactMeshShape>(&triangles);
        mesh->updateBound();
    }
    btCollisionShape& shape() override { return *mesh; }
    double depth(const btVector3& p) const override { return depthInBox(p, boxHalf); }
};

// A roof wider than the sheet: height 0.1 - |x| / 4 over 33 x 33 points, of which each triangle is exactly a part.
struct HeightField final : Form {
    static constexpr int points = 33;
    static constexpr btScalar cell = btScalar(0.8) / (points - 1);
    std::vector<btScalar> heights;
    std::unique_ptr<btHeightfieldTerrainShape> field;
    HeightField() {
        for (int j = 0; j < points; ++j)
            for (int i = 0; i < points; ++i) heights.push_back(heightAt(btScalar(i - points / 2) * cell));
        field = std::make_unique<btHeightfieldTerrainShape>(points, points, heights.data(), btScalar(-0.1),
                                                            btScalar(0.1), 1, false);
        field->setLocalScaling({cell, 1, cell});
    }
    static btScalar heightAt(btScalar x) { return btScalar(0.1) - std::abs(x) / 4; }
    btCollisionShape& shape() override { return *field; }
    // It is a surface: what is below it by less than a tenth of a metre has passed it.
    double depth(const btVector3& p) const override {
        if (std::abs(p.x()) > halfWidth() || std::abs(p.z()) > halfWidth()) return -1;
        const double below = double(heightAt(p.x()) - p.y());
        return below < 0.1 ? below : -1;
    }
    btScalar halfWidth() const override { return btScalar(0.4); }
};

std::unique_ptr<Form> make(SolidForm form) {
    switch (form) {
        case SolidForm::ball:
            return std::make_unique<Ball>();
        case SolidForm::box:
            return std::make_unique<Box>();
        case SolidForm::capsule:
            return std::make_unique<Capsule>();
        case SolidForm::hull:
            return std::make_unique<Hull>();
        case SolidForm::cylinder:
            return std::make_unique<Cylinder>();
        case SolidForm::compound:
            return std::make_unique<Compound>();
        case SolidForm::mesh:
            return std::make_unique<Mesh>();
        case SolidForm::scaledMesh:
            return std::make_unique<ScaledMesh>();
        case SolidForm::gimpact:
            return std::make_unique<Gimpact>();
        case SolidForm::heightField:
            break;
    }
    return std::make_unique<HeightField>();
}

double speedOf(SolidLoad load) {
    switch (load) {
        case SolidLoad::slow:
            return 1;
        case SolidLoad::fast:
            return 5;
        case SolidLoad::faster:
        case SolidLoad::passing:
            return 20;
        default:
            return 0;
    }
}

// A solid of any kind that moves and turns at constant velocities.
class Mover {
  public:
    Mover(btMultiBodyDynamicsWorld& world, const Situation& situation, btCollisionShape& shape,
          const btTransform& start, const btVector3& velocity, const btVector3& spin)
        : world_(world), kind_(situation.kind), start_(start), velocity_(velocity), spin_(spin) {
        switch (kind_) {
            case SolidKind::rigid:
            case SolidKind::kinematic:
            case SolidKind::movedStatic:
                addRigid(shape, situation.load == SolidLoad::rest);
                break;
            case SolidKind::multibody:
                addMultiBody(shape, situation.load == SolidLoad::rest);
                break;
            case SolidKind::ghost:
                object_ = std::make_unique<btGhostObject>();
                object_->setCollisionFlags(0);
                object_->setCollisionShape(&shape);
                object_->setWorldTransform(start);
                world_.addCollisionObject(object_.get());
        }
        object_->setFriction(1);
    }
    ~Mover() {
        if (btRigidBody* const body = btRigidBody::upcast(object_.get()))
            world_.removeRigidBody(body);
        else
            world_.removeCollisionObject(object_.get());
        if (multiBody_) world_.removeMultiBody(multiBody_.get());
    }
    Mover(const Mover&) = delete;
    Mover& operator=(const Mover&) = delete;

    // What the application does before a frame.
    void beforeFrame() {
        time_ += frame;
        if (kind_ == SolidKind::kinematic)
            state_.setWorldTransform(poseAt(time_));
        else if (kind_ == SolidKind::ghost || kind_ == SolidKind::movedStatic)
            object_->setWorldTransform(poseAt(time_));
    }

    const btTransform& pose() const { return object_->getWorldTransform(); }
    btVector3 velocity() const {
        if (multiBody_) return multiBody_->getBaseVel();
        const btRigidBody* const body = btRigidBody::upcast(object_.get());
        return body ? body->getLinearVelocity() : btVector3(0, 0, 0);
    }
    bool isDynamic() const { return kind_ == SolidKind::rigid || kind_ == SolidKind::multibody; }

  private:
    btTransform poseAt(btScalar time) const {
        btTransform pose = start_;
        pose.setOrigin(start_.getOrigin() + velocity_ * time);
        if (!spin_.isZero())
            pose.setRotation(btQuaternion(spin_.normalized(), spin_.length() * time) * start_.getRotation());
        return pose;
    }

    void addRigid(btCollisionShape& shape, bool isFixed) {
        const bool isDynamic = kind_ == SolidKind::rigid;
        const btScalar ownMass = isDynamic ? btScalar(isFixed ? 1e4 : solidMass) : 0;
        state_.setWorldTransform(start_);
        btVector3 inertia(0, 0, 0);
        btBoxShape(boxHalf).calculateLocalInertia(ownMass, inertia);
        auto body = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(
            ownMass, isDynamic ? nullptr : &state_, &shape, inertia));
        body->setWorldTransform(start_);
        body->setInterpolationWorldTransform(start_);
        body->setActivationState(DISABLE_DEACTIVATION);
        if (kind_ == SolidKind::kinematic)
            body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        world_.addRigidBody(body.get());
        if (isDynamic) {
            body->setGravity({0, 0, 0});
            body->setLinearVelocity(velocity_);
            body->setAngularVelocity(spin_);
        }
        object_ = std::move(body);
    }

    void addMultiBody(btCollisionShape& shape, bool isFixed) {
        btVector3 inertia;
        btBoxShape(boxHalf).calculateLocalInertia(btScalar(solidMass), inertia);
        multiBody_ = std::make_unique<btMultiBody>(0, btScalar(solidMass), inertia, isFixed, false);
        multiBody_->setLinearDamping(0);
        multiBody_->setAngularDamping(0);
        multiBody_->setBaseWorldTransform(start_);
        multiBody_->finalizeMultiDof();
        multiBody_->setBaseVel(velocity_);
        multiBody_->setBaseOmega(spin_);
        world_.addMultiBody(multiBody_.get());
        auto collider = std::make_unique<btMultiBodyLinkCollider>(multiBody_.get(), -1);
        collider->setCollisionShape(&shape);
        collider->setWorldTransform(start_);
        world_.addCollisionObject(collider.get(), 2, 1 + 2);
        multiBody_->setBaseCollider(collider.get());
        object_ = std::move(collider);
    }

    btMultiBodyDynamicsWorld& world_;
    const SolidKind kind_;
    const btTransform start_;
    const btVector3 velocity_, spin_;
    btScalar time_ = 0;
    btDefaultMotionState state_;
    std::unique_ptr<btMultiBody> multiBody_;
    std::unique_ptr<btCollisionObject> object_;
};

// A world of the kind that robots use.
class RobotWorld {
  public:
    virtual ~RobotWorld() = default;
    virtual btMultiBodyDynamicsWorld& world() = 0;
    virtual btSoftBodyWorldInfo& info() = 0;
    virtual void add(btSoftBody& body) = 0;
    virtual void remove(btSoftBody& body) = 0;
    virtual void setGravity(const btVector3& gravity) {
        world().setGravity(gravity);
        info().m_gravity = gravity;
    }
    // Goes on by a frame.
    virtual void step(const WetCloth& cloth) = 0;
};

class SoftRigid final : public RobotWorld {
  public:
    explicit SoftRigid(btSoftBodySolver* own)
        : world_(&dispatcher_, &broadphase_, &solver_, &configuration_, own) {}
    btMultiBodyDynamicsWorld& world() override { return world_; }
    btSoftBodyWorldInfo& info() override { return world_.getWorldInfo(); }
    void add(btSoftBody& body) override { world_.addSoftBody(&body); }
    void remove(btSoftBody& body) override { world_.removeSoftBody(&body); }
    void step(const WetCloth&) override { world_.stepSimulation(frame, 1, frame); }

  private:
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btMultiBodyConstraintSolver solver_;
    btSoftMultiBodyDynamicsWorld world_;
};

class SmallSteps final : public RobotWorld {
  public:
    btMultiBodyDynamicsWorld& world() override { return softRigid_.world(); }
    btSoftBodyWorldInfo& info() override { return softRigid_.info(); }
    void add(btSoftBody& body) override { softRigid_.add(body); }
    void remove(btSoftBody& body) override { softRigid_.remove(body); }
    void step(const WetCloth& cloth) override { softRigid_.step(cloth); }

  private:
    SmallStepSolver solver_;
    SoftRigid softRigid_{&solver_};
};

class Deformable final : public RobotWorld {
  public:
    Deformable() {
        solver_.setDeformableSolver(&bodySolver_);
        world_.setImplicit(false);
    }
    btMultiBodyDynamicsWorld& world() override { return world_; }
    btSoftBodyWorldInfo& info() override { return world_.getWorldInfo(); }
    void add(btSoftBody& body) override {
        world_.addSoftBody(&body);
        world_.addForce(&body, &gravity_);
    }
    void remove(btSoftBody& body) override { world_.removeSoftBody(&body); }
    void setGravity(const btVector3& gravity) override {
        RobotWorld::setGravity(gravity);
        gravity_.m_gravity = gravity;
    }
    // Explicit steps, none longer than the cloth allows.
    void step(const WetCloth& cloth) override {
        const int steps = static_cast<int>(std::ceil(double(frame) / cloth.stepBound()));
        world_.stepSimulation(frame, steps, frame / btScalar(steps));
    }

  private:
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btDeformableMultiBodyConstraintSolver solver_;
    btDeformableBodySolver bodySolver_;
    btDeformableGravityForce gravity_{btVector3(0, 0, 0)};
    btDeformableMultiBodyDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_,
                                              &bodySolver_};
};

std::unique_ptr<RobotWorld> make(StepWorld kind) {
    switch (kind) {
        case StepWorld::smallSteps:
            return std::make_unique<SmallSteps>();
        case StepWorld::stock:
            return std::make_unique<SoftRigid>(nullptr);
        case StepWorld::deformable:
            break;
    }
    return std::make_unique<Deformable>();
}

// The sheet lies level above the solid, or hangs beside the way on which the solid passes.
std::unique_ptr<btSoftBody> sheetFor(RobotWorld& rig, const Situation& situation, const Form& form) {
    const Fabric fabric = fabrics::cottonPlain();
    const btScalar margin = length / (side - 1) / 4;
    if (situation.load != SolidLoad::passing) {
        const btScalar height = form.top() + margin + btScalar(0.01);
        return makeSheet(rig.info(), fabric,
                         flatCorners({-length / 2, height, -length / 2}, {length, 0, 0}, {0, 0, length}),
                         side, side);
    }
    const btScalar edge = form.halfWidth() + margin + btScalar(0.01);
    return makeSheet(rig.info(), fabric, flatCorners({edge, length / 2, 0}, {length, 0, 0}, {0, -length, 0}),
                     side, side);
}

double depthOf(const btSoftBody& sheet, const Form& form, const btTransform& pose) {
    double deepest = 0;
    for (int n = 0; n < sheet.m_nodes.size(); ++n)
        deepest = std::max(deepest, form.depth(pose.invXform(sheet.m_nodes[n].m_x)));
    return deepest;
}

}  // namespace

Outcome play(const Situation& situation) {
    const bool isAtRest = situation.load == SolidLoad::rest, isPassing = situation.load == SolidLoad::passing;
    const std::unique_ptr<RobotWorld> owned = make(situation.world);
    RobotWorld& rig = *owned;
    rig.setGravity({0, isAtRest ? btScalar(-9.81) : 0, 0});
    const std::unique_ptr<Form> form = make(situation.form);
    const std::unique_ptr<btSoftBody> sheet = sheetFor(rig, situation, *form);
    rig.add(*sheet);
    const auto speed = btScalar(speedOf(situation.load));
    const btVector3 spin = situation.load != SolidLoad::spin          ? btVector3(0, 0, 0)
                           : situation.form == SolidForm::heightField ? btVector3(0, 15, 0)
                                                                      : btVector3(0, 0, 15);
    const btVector3 velocity = isPassing ? btVector3(0, 0, speed) : btVector3(0, speed, 0);
    const btVector3 start = isPassing ? btVector3(0, 0, btScalar(-1.01)) : btVector3(0, 0, 0);
    Mover solid(rig.world(), situation, form->shape(), at(start), velocity, spin);
    Outcome outcome;
    {
        // What hangs over an edge swings; without air, momentum is kept.
        if (isAtRest) sheet->m_cfg.kDP = 2;
        const SheetSettings settings = isAtRest ? SheetSettings() : withoutAir();
        WetCloth cloth(rig.world(), *sheet, fabrics::cottonPlain(), settings);
        if (situation.load == SolidLoad::spin) setVelocity(*sheet, {0, btScalar(-0.5), 0});
        const btVector3 before = solid.velocity() * btScalar(solidMass);
        // A second takes the deformable world minutes.
        const int toRest = situation.world == StepWorld::deformable ? 60 : 300;
        const int frames = isAtRest ? toRest : isPassing ? 12 : speed > 0 ? 10 + int(60 / speed) : 60;
        for (int f = 0; f < frames; ++f) {
            solid.beforeFrame();
            rig.step(cloth);
            outcome.deepest = std::max(outcome.deepest, depthOf(*sheet, *form, solid.pose()));
            outcome.touched = outcome.touched || sheet->m_rcontacts.size() > 0 ||
                              sheet->m_nodeRigidContacts.size() + sheet->m_faceRigidContacts.size() > 0;
        }
        outcome.finite = cloth.health().finite && cloth.health().heldSubsteps == 0;
        if (solid.isDynamic() && speed > 0 && !isPassing)
            outcome.momentum =
                double((momentum(*sheet) + solid.velocity() * btScalar(solidMass) - before).length() /
                       before.length());
    }
    for (int n = 0; n < sheet->m_nodes.size(); ++n)
        outcome.speed += double(sheet->m_nodes[n].m_v.length2()) / sheet->m_nodes.size();
    outcome.speed = std::sqrt(outcome.speed);
    rig.remove(*sheet);
    return outcome;
}

const std::vector<SolidKind>& allKinds() {
    static const std::vector<SolidKind> kinds = {SolidKind::rigid, SolidKind::kinematic, SolidKind::multibody,
                                                 SolidKind::ghost, SolidKind::movedStatic};
    return kinds;
}

const std::vector<SolidForm>& allForms() {
    static const std::vector<SolidForm> forms = {
        SolidForm::ball,     SolidForm::box,        SolidForm::capsule, SolidForm::hull,
        SolidForm::cylinder, SolidForm::compound,   SolidForm::mesh,    SolidForm::scaledMesh,
        SolidForm::gimpact,  SolidForm::heightField};
    return forms;
}

const std::vector<SolidLoad>& allLoads() {
    static const std::vector<SolidLoad> loads = {SolidLoad::rest,   SolidLoad::slow, SolidLoad::fast,
                                                 SolidLoad::faster, SolidLoad::spin, SolidLoad::passing};
    return loads;
}

std::string nameOf(SolidKind kind) {
    static const char* const names[] = {"rigid", "kinematic", "multibody", "ghost", "moved static"};
    return names[static_cast<int>(kind)];
}

std::string nameOf(SolidForm form) {
    static const char* const names[] = {"ball",     "box",  "capsule",     "hull",    "cylinder",
                                        "compound", "mesh", "scaled mesh", "GImpact", "height field"};
    return names[static_cast<int>(form)];
}

std::string nameOf(SolidLoad load) {
    static const char* const names[] = {"rest", "1 m/s", "5 m/s", "20 m/s", "spin", "passing"};
    return names[static_cast<int>(load)];
}

}  // namespace drench::test
