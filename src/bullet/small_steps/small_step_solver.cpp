#include "drench/small_step_solver.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletSoftBody/btSoftBody.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <vector>

#include "bullet/contact/solids.h"
#include "bullet/sheet/face_tree.h"
#include "bullet/sheet/sheet_mechanics.h"
#include "bullet/small_steps/moving_sheet.h"
#include "bullet/small_steps/soft_contacts.h"
#include "bullet/world/body_watch.h"
#include "bullet/world/stop_watch.h"
#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

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

// Widens the bounds of a sheet by fast approaching solids. Bullet knows only their present positions, and
// would report them only once they are inside.
class SolidsToCome final : public btBroadphaseAabbCallback {
  public:
    SolidsToCome(btVector3& low, btVector3& high, btScalar substep)
        : low_(low), high_(high), substep_(substep) {}

    bool process(const btBroadphaseProxy* proxy) override {
        const auto* const object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
        const btRigidBody* const body = movingBody(*object);
        if (!body) return true;
        const btVector3 motion = body->getLinearVelocity() * substep_;
        btVector3 from = proxy->m_aabbMin + motion, to = proxy->m_aabbMax + motion;
        from.setMin(proxy->m_aabbMin);
        to.setMax(proxy->m_aabbMax);
        if (!TestAabbAgainstAabb2(from, to, low_, high_)) return true;
        low_.setMin(proxy->m_aabbMax);
        high_.setMax(proxy->m_aabbMin);
        return true;
    }

  private:
    btVector3& low_;
    btVector3& high_;
    btScalar substep_;
};

// Broadphase bounds around the present and possible positions of the nodes.
void writeBounds(btSoftBody& body, const SmallStepSheet& cloth) {
    Bounds all = cloth.bounds()[0];
    for (const Bounds& bounds : cloth.bounds()) {
        all.take(bounds.low);
        all.take(bounds.high);
    }
    all.grow(2 * body.getCollisionShape()->getMargin());
    body.m_bounds[0] = all.low;
    body.m_bounds[1] = all.high;
    if (!body.getBroadphaseHandle()) return;
    btBroadphaseInterface& broadphase = *body.m_worldInfo->m_broadphase;
    constexpr auto everywhere = btScalar(1e18);
    SolidsToCome solids(body.m_bounds[0], body.m_bounds[1], body.m_sst.sdt);
    broadphase.aabbTest({-everywhere, -everywhere, -everywhere}, {everywhere, everywhere, everywhere},
                        solids);
    broadphase.setAabb(body.getBroadphaseHandle(), body.m_bounds[0], body.m_bounds[1],
                       body.m_worldInfo->m_dispatcher);
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

    void predict(btSoftBody& body, SheetMechanics& mechanics, btScalar substep);
    int chooseSteps() const;
    void begin(btScalar substep);
    void smallStep(double smallStepOfWorld);
    void finish(btScalar substep);
    // Adds up computing time that sheets share.
    void share(double StepTimes::*stage, double seconds);

    const SmallStepSettings settings;
    Solids solids;
    SoftContacts softContacts;
    std::vector<Solving> sheets;  // during a solve
    std::vector<SoftContacts::Sheet> softSheets;
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
    state_->solids.clear();
    state_->softContacts.clear();
    for (int i = 0; i < m_softBodySet.size(); ++i) {
        btSoftBody& body = *m_softBodySet[i];
        state_->softContacts.remember(body);
        if (!body.isActive()) continue;
        if (SheetMechanics* const mechanics = mechanicsOf(body))
            state_->predict(body, *mechanics, substep);
        else
            body.predictMotion(substep);
    }
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
    sheet.cloth.begin(body, mechanics, double(body.m_sst.sdt));
    sheet.contacts.clear();
    while (body.m_rcontacts.size() > 0) body.m_rcontacts.pop_back();
    body.m_scontacts.resize(0);
    writeBounds(body, sheet.cloth);
    if (!body.m_fdbvt.empty()) prepareFaceTree(body, sheet.cloth);
    mechanics.times.solver += watch.lap();
}

void SmallStepSolver::processCollision(btSoftBody* body, const btCollisionObjectWrapper* solid) {
    SheetMechanics* const mechanics = movedHere(*body);
    if (!mechanics) return btDefaultSoftBodySolver::processCollision(body, solid);
    using Collision = btSoftBody::fCollision;
    if ((body->m_cfg.collisions & Collision::RVSmask) != Collision::SDF_RS || !body->isActive()) return;
    if (!areNear(*body, *solid->getCollisionObject())) return;
    MovingSheet& sheet = *mechanics->moving;
    StopWatch watch;
    sheet.contacts.find(*body, sheet.cloth, mechanics->sheetFriction, *solid, double(body->m_sst.sdt),
                        state_->solids);
    mechanics->times.contacts += watch.lap();
}

void SmallStepSolver::processCollision(btSoftBody* body, btSoftBody* other) {
    SheetMechanics* const mechanics = movedHere(*body);
    SheetMechanics* const others = movedHere(*other);
    if (!mechanics && !others) return btDefaultSoftBodySolver::processCollision(body, other);
    using Collision = btSoftBody::fCollision;
    if (body == other || !(body->m_cfg.collisions & other->m_cfg.collisions & Collision::VF_SS)) return;
    if (!areNear(*body, *other)) return;
    StopWatch watch;
    for (SheetMechanics* const each : {mechanics, others}) {
        btSoftBody& of = each == mechanics ? *body : *other;
        if (!each || !of.m_fdbvt.empty()) continue;
        makeFaceTree(of);
        prepareFaceTree(of, each->moving->cloth);
    }
    const auto clothOf = [](const SheetMechanics* of) { return of ? &of->moving->cloth : nullptr; };
    const auto frictionOf = [](const SheetMechanics* of) { return of ? &of->sheetFriction : nullptr; };
    state_->softContacts.find(*body, *other, clothOf(mechanics), frictionOf(mechanics));
    state_->softContacts.find(*other, *body, clothOf(others), frictionOf(others));
    const double took = watch.lap();
    const bool both = mechanics && others;
    for (SheetMechanics* const each : {mechanics, others})
        if (each) each->times.contacts += both ? took / 2 : took;
}

void SmallStepSolver::solveConstraints(btScalar substep) {
    state_->sheets.clear();
    for (int i = 0; i < m_softBodySet.size(); ++i) {
        btSoftBody& body = *m_softBodySet[i];
        if (!body.isActive()) continue;
        if (SheetMechanics* const mechanics = movedHere(body))
            state_->sheets.push_back({&body, mechanics, mechanics->moving.get()});
        else if (isCut(body))
            state_->softContacts.clear();  // of removed nodes; the cloth is held
        else
            body.solveConstraints();
    }
    state_->steps = state_->sheets.empty() ? 0 : state_->chooseSteps();
    if (state_->steps == 0) return;
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
    for (const Solving& each : sheets) each.sheet->anchors.find(*each.body, solids);
    solids.begin(double(substep));
    softSheets.clear();
    for (const Solving& each : sheets) {
        each.sheet->cloth.divide(*each.mechanics, steps);
        softSheets.push_back({each.body, &each.sheet->cloth, &each.mechanics->sheetFriction});
    }
    share(&StepTimes::solver, watch.lap());
    softContacts.begin(softSheets, double(substep), steps);
    share(&StepTimes::contacts, watch.lap());
    for (const Solving& each : sheets) {
        each.sheet->contacts.begin(*each.body, each.sheet->cloth, solids);
        each.sheet->anchors.begin(*each.body, each.sheet->cloth, solids);
        if (settings.tethers)
            each.sheet->tethers.begin(*each.body, *each.mechanics, settings.stretchTolerance);
    }
    softContacts.allowOverlap();
    share(&StepTimes::solver, watch.lap());
}

void SmallStepSolver::State::smallStep(double smallStepOfWorld) {
    StopWatch watch;
    solids.advance(smallStepOfWorld);
    softContacts.advance();
    for (const Solving& each : sheets) {
        each.sheet->cloth.advance();
        each.sheet->cloth.solveCloth();
        if (settings.tethers) each.sheet->tethers.solve(each.sheet->cloth);
        each.sheet->anchors.solve(each.sheet->cloth, solids);
        each.mechanics->times.solver += watch.lap();
    }
    softContacts.solve();
    for (const Solving& each : sheets) {
        each.sheet->contacts.solve(each.sheet->cloth, solids);
        each.mechanics->times.contacts += watch.lap();
    }
}

void SmallStepSolver::State::finish(btScalar substep) {
    StopWatch watch;
    for (const Solving& each : sheets) {
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
    softContacts.finish(softSheets);
    share(&StepTimes::contacts, watch.lap());
}

void SmallStepSolver::State::share(double StepTimes::*stage, double seconds) {
    for (const Solving& each : sheets) each.mechanics->times.*stage += seconds / double(sheets.size());
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
