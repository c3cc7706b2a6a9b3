#include "drench/small_step_solver.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletSoftBody/btSoftBody.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <vector>

#include "bullet/contact/solids.h"
#include "bullet/sheet/face_tree.h"
#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/simd/denormals.h"
#include "bullet/small_steps/mesh_pairs.h"
#include "bullet/small_steps/moving_sheet.h"
#include "bullet/small_steps/surface_contacts.h"
#include "bullet/small_steps/touch_lists.h"
#include "bullet/world/body_watch.h"
#include "bullet/world/stop_watch.h"
#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// A solid that moves in this substep.
struct MovingSolid {
    Bounds reported;  // around the pose at which Bullet's collision detection finds it
    Bounds swept;     // around its whole path
};

namespace {

const SmallStepSettings& checked(const SmallStepSettings& settings) {
    if (settings.count < 0 || settings.count > 1000)
        refuse("SmallStepSettings::count is ", settings.count, "; give 1 to 1000, or 0 to have it chosen");
    if (!(settings.stretchTolerance >= 1e-5 && settings.stretchTolerance <= 1))
        refuse("SmallStepSettings::stretchTolerance is ", settings.stretchTolerance, "; give 1e-5 to 1");
    return settings;
}

// The mechanics of a body if small steps move it; null if Bullet solves it.
SheetMechanics* mechanicsOf(btSoftBody& body) {
    if (body.m_pose.m_bframe && body.m_cfg.kMT > 0) return nullptr;
    SheetMechanics* const mechanics = BodyWatch::mechanicsOf(body);
    return mechanics && mechanics->fits && hasCountsOf(body, mechanics->shape) ? mechanics : nullptr;
}

// The same, if small steps have begun to move the body in this substep.
SheetMechanics* movedHere(btSoftBody& body) {
    SheetMechanics* const mechanics = mechanicsOf(body);
    const bool hasBegun = mechanics && mechanics->moving && mechanics->movedBySmallSteps;
    return hasBegun && mechanics->moving->nodes == &body.m_nodes[0] ? mechanics : nullptr;
}

bool isMovedHere(btSoftBody& body) {
    return movedHere(body) != nullptr;
}

// Whether the application has changed the topology of a body since then.
bool isCut(btSoftBody& body) {
    const SheetMechanics* const mechanics = BodyWatch::mechanicsOf(body);
    return mechanics && mechanics->movedBySmallSteps && !movedHere(body);
}

// Members that Bullet's predictMotion sets for other code.
void writeStepState(btSoftBody& body, btScalar substep) {
    body.m_sst.sdt = substep * body.m_cfg.timescale;
    body.m_sst.isdt = 1 / body.m_sst.sdt;
    body.m_sst.velmrg = body.m_sst.sdt * 3;
    body.m_sst.radmrg = body.getCollisionShape()->getMargin();
    body.m_sst.updmrg = body.m_sst.radmrg * btScalar(0.25);
}

Bounds boundsAt(const btCollisionObject& object, const btTransform& pose) {
    Bounds bounds;
    object.getCollisionShape()->getAabb(pose, bounds.low, bounds.high);
    return bounds;
}

// Finds the solids that Bullet is about to move.
class MovingSolidSearch final : public btBroadphaseAabbCallback {
  public:
    MovingSolidSearch(std::vector<MovingSolid>& movers, btScalar substep)
        : movers_(movers), substep_(substep) {}

    bool process(const btBroadphaseProxy* proxy) override {
        const auto& object = *static_cast<const btCollisionObject*>(proxy->m_clientObject);
        if (!movesInStep(object)) return true;
        const Twist motion = velocitiesOf(object) * substep_;
        if (motion.isZero()) return true;
        const Bounds now = boundsAt(object, object.getWorldTransform());
        Bounds swept = now;
        swept.take({now.low + motion.linear, now.high + motion.linear});
        swept.grow(std::min(motion.angular.length(), btScalar(2)) * now.halfDiagonal());
        movers_.push_back({now, swept});
        return true;
    }

  private:
    std::vector<MovingSolid>& movers_;
    btScalar substep_;
};

// Widens the bounds of a sheet so that Bullet reports a solid that comes to it. Bullet knows only the present
// position, and would report it only once it is inside.
void widen(Bounds& bounds, const MovingSolid& mover) {
    if (!mover.swept.meets(bounds)) return;
    bounds.low.setMin(mover.reported.high);
    bounds.high.setMax(mover.reported.low);
}

// Broadphase bounds around the present and possible positions of the nodes.
void writeBounds(btSoftBody& body, const SheetMechanics& mechanics, const std::vector<MovingSolid>& movers) {
    Bounds all = mechanics.moving->cloth.allBounds();
    all.grow(2 * body.getCollisionShape()->getMargin());
    for (const MovingSolid& mover : movers) widen(all, mover);
    mechanics.near.forEachMoving([&](const btCollisionObject& object, const SolidPath& path) {
        Bounds swept = boundsAt(object, path.start);
        const Bounds end = boundsAt(object, path.end);
        swept.take(end);
        swept.grow(path.motion().angular.length() * end.halfDiagonal());
        widen(all, {boundsAt(object, object.getWorldTransform()), swept});
    });
    body.m_bounds[0] = all.low;
    body.m_bounds[1] = all.high;
    if (body.getBroadphaseHandle())
        body.m_worldInfo->m_broadphase->setAabb(body.getBroadphaseHandle(), all.low, all.high,
                                                body.m_worldInfo->m_dispatcher);
}

// Carries a sheet along that is anchored to a solid that has jumped.
void followJump(btSoftBody& body, SmallStepSheet& cloth, const SheetMechanics& mechanics, double substep) {
    for (int i = 0; i < body.m_anchors.size(); ++i) {
        const SolidPath* const jump = mechanics.near.jumpOf(*body.m_anchors[i].m_body);
        if (!jump || !cloth.isWhereItWas(body)) continue;
        cloth.carry(body, jump->start, jump->end);
        cloth.begin(body, mechanics, substep);
        return;
    }
}

// Bullet also reports solids that were near earlier, for an arbitrary time.
bool areNear(const btSoftBody& body, const btCollisionObject& solid) {
    const btBroadphaseProxy *const one = body.getBroadphaseHandle(), *const other =
                                                                         solid.getBroadphaseHandle();
    return !one || !other ||
           TestAabbAgainstAabb2(one->m_aabbMin, one->m_aabbMax, other->m_aabbMin, other->m_aabbMax);
}

}  // namespace

struct SmallStepSolver::State {
    explicit State(const SmallStepSettings& theSettings) : settings(checked(theSettings)) {}

    struct Solving {
        btSoftBody* body;
        SheetMechanics* mechanics;
        MovingSheet* sheet;
    };

    void findMovers(btSoftBody& body, btScalar substep);
    void predict(btSoftBody& body, SheetMechanics& mechanics, btScalar substep);
    int chooseSteps() const;
    void begin(btScalar substep);
    void beginSheet(const Solving& each);
    void smallStep(double smallStepOfWorld);
    bool mayBeMoved(std::size_t sheet) const;
    void meetCloth();
    void finish(btScalar substep);
    // Adds up computing time that sheets share.
    void share(double StepTimes::*stage, double seconds);
    void shareClothContacts(double seconds);

    const SmallStepSettings settings;
    std::vector<MovingSolid> movers;
    MeshPairs meshPairs{isMovedHere};
    Solids solids;
    SurfaceContacts surfaceContacts;
    std::vector<Solving> sheets;  // during a solve
    std::vector<SurfaceContacts::Sheet> meetingSheets;
    std::vector<TouchingSheet> touchingSheets;
    std::vector<SheetMechanics*> sleepingSheets;
    int steps = 0;
};

SmallStepSolver::SmallStepSolver(const SmallStepSettings& settings)
    : state_(std::make_unique<State>(settings)) {}

SmallStepSolver::~SmallStepSolver() = default;

const SmallStepSettings& SmallStepSolver::settings() const {
    return state_->settings;
}

int SmallStepSolver::steps() const {
    return state_->steps;
}

const char* SmallStepSolver::kernels() const {
    return bestKernels().name;
}

void SmallStepSolver::predictMotion(btScalar substep) {
    state_->surfaceContacts.clear();
    const btSoftBody* first = nullptr;  // of those moved here
    for (int i = 0; i < m_softBodySet.size(); ++i) {
        btSoftBody& body = *m_softBodySet[i];
        if (!body.isActive()) continue;
        SheetMechanics* const mechanics = mechanicsOf(body);
        if (!mechanics) {
            body.predictMotion(substep);
            continue;
        }
        if (!first) state_->findMovers(body, substep);
        if (!first) first = &body;
        state_->predict(body, *mechanics, substep);
    }
    if (first) state_->meshPairs.update(*first->m_worldInfo->m_broadphase, *first->m_worldInfo->m_dispatcher);
}

void SmallStepSolver::State::findMovers(btSoftBody& body, btScalar substep) {
    movers.clear();
    constexpr auto everywhere = btScalar(1e18);
    MovingSolidSearch search(movers, substep);
    body.m_worldInfo->m_broadphase->aabbTest({-everywhere, -everywhere, -everywhere},
                                             {everywhere, everywhere, everywhere}, search);
}

void SmallStepSolver::State::predict(btSoftBody& body, SheetMechanics& mechanics, btScalar substep) {
    if (!mechanics.moving) mechanics.moving = std::make_shared<MovingSheet>(mechanics);
    // Made when the sheet first comes near another soft body; see processCollision.
    if (!mechanics.movedBySmallSteps) dropFaceTree(body);
    mechanics.movedBySmallSteps = true;
    MovingSheet& sheet = *mechanics.moving;
    sheet.nodes = &body.m_nodes[0];
    StopWatch watch;
    writeStepState(body, substep);
    if (body.m_cfg.kPR != 0 || body.m_cfg.kVC > 0) body.applyForces();
    const double substepOfBody = double(body.m_sst.sdt);
    const bool hasJumped = mechanics.hasJumped || sheet.cloth.isElsewhere(body);
    mechanics.hasJumped = false;
    if (hasJumped) sheet.cloth.forgetPins();
    sheet.cloth.begin(body, mechanics, substepOfBody);
    mechanics.near.begin(body, sheet.cloth.allBounds(), double(substep), hasJumped);
    followJump(body, sheet.cloth, mechanics, substepOfBody);
    sheet.anchors.find(body, mechanics.near);
    sheet.contacts.clear();
    while (body.m_rcontacts.size() > 0) body.m_rcontacts.pop_back();
    body.m_scontacts.resize(0);
    writeBounds(body, mechanics, movers);
    mechanics.times.solver += watch.lap();
}

void SmallStepSolver::processCollision(btSoftBody* body, const btCollisionObjectWrapper* solid) {
    SheetMechanics* const mechanics = movedHere(*body);
    if (!mechanics) return btDefaultSoftBodySolver::processCollision(body, solid);
    using Collision = btSoftBody::fCollision;
    if ((body->m_cfg.collisions & Collision::RVSmask) != Collision::SDF_RS || !body->isActive()) return;
    if (!areNear(*body, *solid->getCollisionObject())) return;
    mechanics->moving->contacts.meet(*solid->getCollisionObject());
}

void SmallStepSolver::processCollision(btSoftBody* body, btSoftBody* other) {
    SheetMechanics* const mechanics = movedHere(*body);
    SheetMechanics* const others = movedHere(*other);
    if (!mechanics && !others) return btDefaultSoftBodySolver::processCollision(body, other);
    using Collision = btSoftBody::fCollision;
    const bool areSheets = mechanics && others && mechanics->meetsSheets && others->meetsSheets;
    const bool areAllowed =
        areSheets || (body->m_cfg.collisions & other->m_cfg.collisions & Collision::VF_SS) != 0;
    if (body == other || !areAllowed) return;
    if (!areNear(*body, *other)) return;
    state_->surfaceContacts.meet(*body, *other);
}

void SmallStepSolver::solveConstraints(btScalar substep) {
    state_->sheets.clear();
    state_->sleepingSheets.clear();
    for (int i = 0; i < m_softBodySet.size(); ++i) {
        btSoftBody& body = *m_softBodySet[i];
        if (!body.isActive()) {
            if (SheetMechanics* const mechanics = BodyWatch::mechanicsOf(body))
                state_->sleepingSheets.push_back(mechanics);
            continue;
        }
        if (SheetMechanics* const mechanics = movedHere(body))
            state_->sheets.push_back({&body, mechanics, mechanics->moving.get()});
        else if (isCut(body))
            state_->surfaceContacts.clear();  // of removed nodes; the cloth is held
        else
            body.solveConstraints();
    }
    // The application's callbacks may have removed some since Bullet reported them.
    state_->surfaceContacts.forgetUnless(
        [this](btSoftBody* body) { return m_softBodySet.findLinearSearch(body) < m_softBodySet.size(); });
    state_->steps = state_->sheets.empty() ? 0 : state_->chooseSteps();
    if (state_->steps == 0) return;
    const DenormalsAsZero here;
    state_->begin(substep);
    for (int step = 0; step < state_->steps; ++step) state_->smallStep(double(substep) / state_->steps);
    state_->finish(substep);
}

void SmallStepSolver::updateSoftBodies() {
    for (int i = 0; i < m_softBodySet.size(); ++i) {
        btSoftBody& body = *m_softBodySet[i];
        if (!body.isActive()) continue;
        if (const SheetMechanics* const mechanics = movedHere(body))
            mechanics->moving->cloth.writeNormals(body);
        else
            body.integrateMotion();
    }
}

int SmallStepSolver::State::chooseSteps() const {
    if (settings.count > 0) return settings.count;
    constexpr int fewest = 4;
    int max = fewest;
    for (const Solving& each : sheets)
        max = std::max(max, each.sheet->cloth.wantedSteps(*each.mechanics, settings.stretchTolerance));
    return max;
}

void SmallStepSolver::State::begin(btScalar substep) {
    StopWatch watch;
    solids.clear();
    for (const Solving& each : sheets) {
        each.sheet->contacts.addSolids(*each.body, each.mechanics->sheetFriction, each.mechanics->near,
                                       solids);
        each.sheet->anchors.addSolids(*each.body, each.mechanics->near, solids);
    }
    solids.begin(double(substep), sheets[0].mechanics->motors);
    share(&StepTimes::contacts, watch.lap());
    meetingSheets.clear();
    for (const Solving& each : sheets) {
        each.sheet->cloth.divide(*each.mechanics, steps);
        meetingSheets.push_back({each.body, &each.sheet->cloth, &each.mechanics->sheetFriction,
                                 &each.mechanics->treeFor(each.body->getCollisionShape()->getMargin()),
                                 &each.sheet->memory, each.mechanics->meetsItself});
    }
    share(&StepTimes::solver, watch.lap());
    for (const Solving& each : sheets) beginSheet(each);
    watch.lap();
    surfaceContacts.begin(meetingSheets, double(substep), steps);
    shareClothContacts(watch.lap());
}

void SmallStepSolver::State::beginSheet(const Solving& each) {
    StopWatch watch;
    each.sheet->contacts.begin(*each.body, each.sheet->cloth, each.mechanics->sheetFriction, solids);
    each.mechanics->times.contacts += watch.lap();
    each.sheet->anchors.begin(*each.body, each.sheet->cloth, solids);
    if (settings.tethers) each.sheet->tethers.begin(*each.body, *each.mechanics, settings.stretchTolerance);
    each.mechanics->times.solver += watch.lap();
}

// Whether anything but its own cloth may move the nodes of a sheet in the next small step.
bool SmallStepSolver::State::mayBeMoved(std::size_t sheet) const {
    return settings.tethers || sheets[sheet].body->m_anchors.size() > 0 ||
           !sheets[sheet].sheet->contacts.isEmpty() || surfaceContacts.meets(sheet);
}

void SmallStepSolver::State::smallStep(double smallStepOfWorld) {
    StopWatch watch;
    for (std::size_t i = 0; i < sheets.size(); ++i) sheets[i].sheet->cloth.setShared(mayBeMoved(i));
    solids.advance(smallStepOfWorld);
    share(&StepTimes::contacts, watch.lap());
    surfaceContacts.beginStep();
    shareClothContacts(watch.lap());
    for (const Solving& each : sheets) {
        each.sheet->cloth.advance();
        each.sheet->cloth.solveCloth();
        if (settings.tethers) each.sheet->tethers.solve(each.sheet->cloth);
        each.sheet->anchors.solve(each.sheet->cloth, solids);
        each.mechanics->times.solver += watch.lap();
    }
    meetCloth();
    watch.lap();
    for (const Solving& each : sheets) {
        each.sheet->contacts.solve(each.sheet->cloth, solids);
        each.mechanics->times.contacts += watch.lap();
    }
    surfaceContacts.endStep();
    shareClothContacts(watch.lap());
}

// Solids take part in between, so that cloth that lies on a solid carries what lies on it.
void SmallStepSolver::State::meetCloth() {
    StopWatch watch;
    const auto carry = [this] {
        for (std::size_t i = 0; i < sheets.size(); ++i)
            if (surfaceContacts.touches(i)) sheets[i].sheet->contacts.carry(sheets[i].sheet->cloth, solids);
    };
    surfaceContacts.goOn();
    // Two do at rest, where forces go on; an impact on many layers needs more.
    constexpr int fewest = 2, most = 8;
    constexpr float settled = 0.05f;
    for (int sweep = 0; sweep < most; ++sweep) {
        carry();
        if (surfaceContacts.solve(sweep % 2 == 0) < settled && sweep + 1 >= fewest) break;
    }
    shareClothContacts(watch.lap());
}

void SmallStepSolver::State::finish(btScalar substep) {
    StopWatch watch;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        const Solving& each = sheets[i];
        if (!each.sheet->contacts.hasTouched() && !surfaceContacts.hasTouchedOthers(i) &&
            each.body->m_anchors.size() == 0)
            each.sheet->cloth.keepAngularMomentum();
        const int off = each.sheet->cloth.finish(*each.body);
        if (off >= 0) {
            ++each.mechanics->heldSubsteps;
            each.mechanics->heldNode = off;
        }
        each.mechanics->smallSteps = steps;
        each.mechanics->times.solver += watch.lap();
        each.sheet->contacts.finish(*each.body, each.mechanics->sheetFriction, solids, double(substep));
        each.mechanics->times.contacts += watch.lap();
    }
    solids.finish(sheets[0].body->m_worldInfo->m_dispatcher);
    share(&StepTimes::contacts, watch.lap());
    surfaceContacts.finish();
    touchingSheets.clear();
    for (const Solving& each : sheets) touchingSheets.push_back({each.body, each.mechanics, each.sheet});
    listTouches(touchingSheets, sleepingSheets, surfaceContacts, solids);
    shareClothContacts(watch.lap());
}

void SmallStepSolver::State::share(double StepTimes::*stage, double seconds) {
    for (const Solving& each : sheets) each.mechanics->times.*stage += seconds / double(sheets.size());
}

void SmallStepSolver::State::shareClothContacts(double seconds) {
    share(&StepTimes::contacts, seconds);
    share(&StepTimes::clothContacts, seconds);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
