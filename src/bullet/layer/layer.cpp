#include "bullet/layer/layer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "bullet/bullet_solvers/contact_order.h"
#include "bullet/bullet_solvers/link_constants.h"
#include "bullet/repair/pieces.h"
#include "bullet/sheet/border_checks.h"
#include "bullet/world/gravity.h"
#include "bullet/world/stop_watch.h"
#include "bullet/world/vectors.h"
#include "checks/checks.h"
#include "drench/drying.h"
#include "drench/water.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

double checkedWaterSpeed(const char* name, double waterSpeed) {
    if (waterSpeed >= 0 && waterSpeed <= 1e5) return waterSpeed;
    refuse(name, " is ", waterSpeed, "; give a value from 0 to 100000");
}

// Fraction of the momentum of arriving water that acts on the body: the water runs faster than the body's
// time, but only the water of the body's own time may push it.
double momentumFraction(double waterSpeed) {
    return std::min(1.0, 1 / waterSpeed);
}

RestShape checkedShape(const btCollisionWorld& world, const btSoftBody& body) {
    checkBody(body);
    RestShape shape = restShapeOf(body);
    checkDuplicates(shape);
    checkContacts(body, shape);
    checkPlanes(world, body);
    return shape;
}

void checkCount(const char* setting, std::size_t given, const char* parts, std::size_t wanted) {
    if (given == wanted) return;
    refuse("WetCloth: SheetSettings::", setting, " has ", given, " material coordinates for ", wanted, " ",
           parts, "; give as many, or none");
}

ClothMesh checkedMesh(const SheetSettings& settings, const btSoftBody& body, const RestShape& shape) {
    ClothMesh mesh;
    if (!settings.faceCoordinates.empty()) {
        if (!settings.materialCoordinates.empty())
            refuse(
                "WetCloth: SheetSettings has materialCoordinates and faceCoordinates; give one "
                "of them");
        checkCount("faceCoordinates", settings.faceCoordinates.size(), "faces", shape.triangles.size());
        mesh = {shape.nodeAreas, shape.triangles, settings.faceCoordinates};
    } else if (!settings.materialCoordinates.empty()) {
        checkCount("materialCoordinates", settings.materialCoordinates.size(), "nodes",
                   shape.nodeAreas.size());
        mesh = clothMesh(shape, settings.materialCoordinates);
    } else {
        mesh = clothMesh(shape, flattened(body));
    }
    checkShape(shape, mesh);
    return mesh;
}

SheetMechanics checkedMechanics(const btCollisionWorld& world, const btSoftBody& body, const Fabric& fabric,
                                const SheetSettings& settings, Diagnostics& diagnostics) {
    validate(fabric);
    RestShape shape = checkedShape(world, body);
    ClothMesh mesh = checkedMesh(settings, body, shape);
    if (!settings.mayBeInPieces) reportPieces(body, shape, diagnostics);
    return {fabric, std::move(shape), std::move(mesh)};
}

}  // namespace

WetCloth::Layer::Layer(btDiscreteDynamicsWorld& aWorld, btSoftBody& sheet, const Fabric& aFabric,
                       const SheetSettings& settings)
    : world(checkedSoftWorld(aWorld)),
      body(sheet),
      stepping(settings.stepping),
      waterSpeed(checkedWaterSpeed("SheetSettings::waterSpeed", settings.waterSpeed)),
      ownGravity(settings.ownGravity),
      unusualScale(settings.unusualScale),
      diagnostics(settings.onTrouble),
      fabric(aFabric),
      mechanics(checkedMechanics(world, body, fabric, settings, diagnostics)),
      mesh(mechanics.mesh),
      coordinates(nodeCoordinates(mesh)),
      totalArea(std::accumulate(mesh.areas.begin(), mesh.areas.end(), 0.0)),
      laws(fabric),
      moisture(fabric, mesh),
      // From here on nothing throws, and the body may be changed.
      watch(body, mechanics),
      savedState(body, mechanics),
      layers(fabric, mesh.size(), mechanics.lightPressure),
      shelter(world),
      shelterOfSheet(shelter, layers, mesh.areas),
      winds(mesh),
      submersion(mesh.size()),
      fluidForces(mechanics.shape, fabric),
      application({moisture, arrivals, submersion, body, watch}, 0, 1, 0),
      pose(mesh),
      contacts(mesh.size()),
      arrivals(mesh.size()),
      ticks(world, *this) {
    mechanics.touchableWater = this;
    mechanics.meetsItself = settings.meetsItself;
    mechanics.meetsSheets = settings.meetsSheets;
    mechanics.evaluate(laws, moisture);
    writeMasses(body, mechanics.masses);
    body.updateLinkConstants();  // for these masses, until the first substep sets those of the fabric
    if (isDeformable(world))
        deformable = std::make_unique<DeformableSheet>(world, body, mechanics, dryMasses(),
                                                       std::max(1.0, double(fabric.wetStretchRatio)),
                                                       std::max(1.0, double(fabric.wetBendingRatio)));
    if (const btVector3 gravity = gravityOf(world, body, ownGravity).value; isValidGravity(gravity))
        mechanics.gravity = gravity;
    pose.gather(body, mesh, mechanics.gravity);
    topology.follow(body);
    mechanics.near.observe(body);
    if (stepping == Stepping::byWorld) ticks.hearPreTicks();
}

WetCloth::Layer::~Layer() {
    const bool bodyIsAlive = watch.bodyIsAlive();
    if (bodyIsAlive && topology.hasMoved(body)) topology.follow(body);  // cut since the last substep
    if (bodyIsAlive) keepFaceTree(body);                                // from here on Bullet needs it
    if (bodyIsAlive) savedState.restore(body, dryMasses());
    if (!deformable) return;
    if (bodyIsAlive) deformable->restore(body);
    deformable->end(bodyIsAlive ? &body : nullptr);
}

std::vector<double> WetCloth::Layer::dryMasses() const {
    std::vector<double> masses;
    for (const double area : mesh.areas) masses.push_back(laws.mass(area, 0));
    return masses;
}

std::size_t WetCloth::Layer::checkedNode(int node) const {
    if (node >= 0 && node < static_cast<int>(mesh.size())) return static_cast<std::size_t>(node);
    refuse<std::out_of_range>("node ", node, " of a sheet with ", mesh.size(), " nodes; give 0 to ",
                              mesh.size() - 1);
}

// Water on each node, kg, for an even distribution of massPerArea, kg/m2.
std::vector<double> WetCloth::Layer::spread(double massPerArea) const {
    if (!(massPerArea >= 0 && massPerArea <= 1e3))
        refuse("soaking with ", massPerArea, " kg/m2; give a value from 0 to 1000");
    std::vector<double> spreadMasses;
    for (const double area : mesh.areas) spreadMasses.push_back(massPerArea * area);
    return spreadMasses;
}

bool WetCloth::Layer::isInWorld() const {
    if (!watch.bodyIsAlive()) return false;
    const auto& bodies = softBodiesOf(world);
    return bodies.findLinearSearch(&body) != bodies.size();
}

SheetPose WetCloth::Layer::sheetPose() const {
    return {mesh,
            pose.positions,
            pose.velocities,
            pose.trianglesAround,
            moisture.poreMass(),
            moisture.filmMass(),
            moisture.poreCapacityPerArea(),
            moisture.wettingTime(),
            pose.up,
            pose.gravity,
            totalArea,
            shelterOfSheet,
            &body,
            fluidForces.floatingFraction()};
}

void WetCloth::Layer::add(std::unique_ptr<Source> source) {
    if (!source) refuse("there is no source to add; give one");
    if (watch.bodyIsAlive()) {
        // A source checks its settings in every step; with a dt of 0 it does nothing else.
        if (fits()) {
            pose.gather(body, mesh, mechanics.gravity);
            pose.gatherMotion(body);
        }
        NoSupply trial;
        source->supply(sheetPose(), 0, trial);
    }
    const std::size_t number = moisture.openAccount(source->name());
    // Floating cloth may fall asleep while its last pores fill more and more slowly, and wakes as it gets
    // heavier.
    const double noticeable = 1e-3 * laws.mass(totalArea, 0);
    auto supply =
        std::make_unique<AccountSupply>(AccountSupply::Sheet{moisture, arrivals, submersion, body, watch},
                                        number, momentumFraction(waterSpeed), noticeable);
    suppliers.push_back({std::move(source), std::move(supply)});
}

void WetCloth::Layer::remove(const Source& source) {
    for (Supplier& supplier : suppliers) {
        if (supplier.source.get() != &source) continue;
        removed.push_back(std::move(supplier));
        if (!supplying) forgetRemoved();
        return;
    }
    refuse("the source to remove is not one of this WetCloth's; give one that was added to it");
}

void WetCloth::Layer::setWaterSpeed(double speed) {
    waterSpeed = checkedWaterSpeed("the water speed", speed);
    for (Supplier& supplier : suppliers) supplier.supply->setMomentumFraction(momentumFraction(speed));
}

void WetCloth::Layer::forgetRemoved() {
    suppliers.erase(std::remove_if(suppliers.begin(), suppliers.end(),
                                   [](const Supplier& supplier) { return !supplier.source; }),
                    suppliers.end());
    removed.clear();
}

Supply& WetCloth::Layer::account(const std::string& name) {
    for (NamedAccount& known : accounts)
        if (known.name == name) return known.supply;
    const std::size_t number = moisture.openAccount(name);
    accounts.push_back({name, AccountSupply({moisture, arrivals, submersion, body, watch}, number, 1, 0)});
    return accounts.back().supply;
}

void WetCloth::Layer::preTick(btScalar dt) {
    if (!isInWorld()) return;
    if (objectsChecked != world.getNumCollisionObjects()) checkPlanes(world, body);
    objectsChecked = world.getNumCollisionObjects();
    substep(dt);
}

void WetCloth::Layer::substep(btScalar dt) {
    if (!(dt > 0) || !std::isfinite(dt)) refuse("a substep of ", dt, " s; give a positive finite time");
    diagnostics.begin(time, mechanics.times.substeps);
    if (!fitToBody()) {
        time += bodyStepOf(dt);
        ++mechanics.times.substeps;
        return;
    }
    checkBeforeStep(dt);
    keepPrimed(body, mechanics.shape,
               deformable || (!mechanics.movedBySmallSteps && meetsSoftBodies(world, body)));
    savedState.silenceAero(body);
    mechanics.motors.read(world);
    const double bodyStep = bodyStepOf(dt);
    time += bodyStep;

    surroundings.heights = pose.heights;
    StopWatch watchOfStages;
    layers.read(mechanics.touches, mesh.areas, bodyStep);
    supply(bodyStep * waterSpeed);
    mechanics.times.supply += watchOfStages.lap();
    touchSolids();
    touchCloth(bodyStep * waterSpeed);
    moveWater(bodyStep * waterSpeed);
    collectDrops();
    mechanics.times.water += watchOfStages.lap();
    takeUpMomentum(body, mechanics.masses, arrivals);
    writeBack(bodyStep);
    mechanics.times.laws += watchOfStages.lap();
    pushByFluid(bodyStep);
    mechanics.times.air += watchOfStages.lap();
    if (deformable) deformable->write(body);
    ++mechanics.times.substeps;
    ticks.awaitPostTick();
}

void WetCloth::Layer::postTick(btScalar dt) {
    if (!isInWorld()) return;
    if (topology.hasMoved(body)) {  // because the application has cut the cloth since the substep began
        topology.follow(body);
        keepFaceTree(body);
    }
    if (!body.isActive() || !fits()) return;
    StopWatch watchOfContacts;
    using Mover = ClothContacts::Mover;
    if (deformable) {
        const bool implicit = deformableModeOf(world).implicit;
        clothContacts.solve(world, body, mechanics.sheetFriction,
                            implicit ? Mover::implicitWorld : Mover::explicitWorld, double(dt));
        deformableContacts.rewrite(world, body, mechanics.sheetFriction, dt, implicit);
    } else if (!mechanics.movedBySmallSteps) {
        clothContacts.solve(world, body, mechanics.sheetFriction, Mover::stockSolver, double(body.m_sst.sdt));
        stockContacts.rewrite(world, body, mechanics.sheetFriction);
    }
    mechanics.times.contacts += watchOfContacts.lap();
}

// The deformable world ignores the timescale.
double WetCloth::Layer::bodyStepOf(btScalar dt) const {
    return deformable ? double(dt) : double(dt) * double(body.m_cfg.timescale);
}

void WetCloth::Layer::supply(double waterTime) {
    if (suppliers.empty()) return;
    pose.gatherMotion(body);
    const SheetPose sheet = sheetPose();
    // A source may remove sources, itself included, and add sources, which are called from the next step on.
    struct Supplying {
        explicit Supplying(Layer& itsLayer) : layer(itsLayer) { layer.supplying = true; }
        ~Supplying() {
            layer.supplying = false;
            layer.forgetRemoved();
        }
        Supplying(const Supplying&) = delete;
        Supplying& operator=(const Supplying&) = delete;
        Layer& layer;
    } during(*this);
    const std::size_t count = suppliers.size();
    for (std::size_t i = 0; i < count; ++i) {
        Source* const source = suppliers[i].source.get();
        if (!source) continue;
        try {
            source->supply(sheet, waterTime, *suppliers[i].supply);
        } catch (const std::exception& problem) {
            diagnostics.noteThrown(Trouble::source,
                                   textOf("the source \"", source->name(), "\": ", reasonOf(problem)));
        }
    }
}

// A face in contact with a solid does not dry, and does not drip. Bullet's contacts appear and disappear from
// step to step, so each counts for a while.
void WetCloth::Layer::touchSolids() {
    constexpr double lasting = 0.1;  // s
    constexpr double fromBelow = 0.5;
    const btVector3 upwards = toBullet(pose.up);
    forEachSolidContact(body, [&](const btSoftBody::Node* node, const btSoftBody::sCti& found) {
        Contact& contact = contacts[static_cast<std::size_t>(indexOf(body, node))];
        touchedUntil = contact.touchesUntil = time + lasting;
        if (double(found.m_normal.dot(upwards)) > fromBelow) contact.liesUntil = time + lasting;
    });
    if (touchedUntil < time) return;
    constexpr double oneFace = 0.5;
    for (std::size_t n = 0; n < contacts.size(); ++n) {
        if (contacts[n].touchesUntil < time || !(mesh.areas[n] > 0)) continue;
        moisture.cover(n, oneFace);
        if (contacts[n].liesUntil >= time) moisture.layDown(n);
    }
}

Supply& WetCloth::Layer::touchAccount() {
    if (!touching) {
        // As of sources: sheets that even out more and more slowly may fall asleep.
        const double noticeable = 1e-3 * laws.mass(totalArea, 0);
        touching =
            std::make_unique<AccountSupply>(AccountSupply::Sheet{moisture, arrivals, submersion, body, watch},
                                            moisture.openAccount("touch"), 1, noticeable);
    }
    return *touching;
}

void WetCloth::Layer::touchCloth(double waterTime) {
    const LayerTouches& touches = mechanics.touches;
    const ClothLayers::Sheet sheet = {moisture, mesh.areas, pose.up, pose.gravity};
    layers.press(sheet);
    if (touches.contacts.empty()) return;
    layers.cover(sheet);
    layers.join(sheet, touches);
    for (std::size_t i = 0; i < touches.others.size(); ++i)
        if (touches.others[i]) exchangeWith(static_cast<int>(i) + 1, *touches.others[i], waterTime);
}

// The other body is known by its address, and may be gone.
void WetCloth::Layer::exchangeWith(int number, const btSoftBody& other, double waterTime) {
    const auto& bodies = softBodiesOf(world);
    const int at = bodies.findLinearSearch(const_cast<btSoftBody*>(&other));
    SheetMechanics* const others = at < bodies.size() ? BodyWatch::mechanicsOf(*bodies[at]) : nullptr;
    if (!others || !others->touchableWater || !others->fits) return;
    const auto isThere = [&](const LayerContact& contact) {
        return contact.with != number ||
               std::all_of(contact.nodes.begin() + contact.ofSheet, contact.nodes.end(),
                           [&](int node) { return node < static_cast<int>(others->mesh.size()); });
    };
    const std::vector<LayerContact>& all = mechanics.touches.contacts;
    if (!std::all_of(all.begin(), all.end(), isThere)) return;
    TouchableWater& there = *others->touchableWater;
    // Water that both pass must run at one speed.
    const double speed = std::min(waterSpeed, there.speedOfWater());
    const double passing = waterSpeed > 0 ? waterTime * (speed / waterSpeed) : 0.0;
    layers.exchange(
        {moisture, mesh.areas, pose.up, pose.gravity}, touchAccount(), mechanics.touches,
        {number, there, others->mesh.areas, body.getWorldArrayIndex() < bodies[at]->getWorldArrayIndex()},
        passing);
}

void WetCloth::Layer::moveWater(double waterTime) {
    // The rate below the bound maximum divides by 1 - humidity, so the humidity is limited to just below 1.
    constexpr double dampest = 0.999;
    Air around = usedAir;
    around.humidity = std::min(around.humidity, dampest);
    const double speed = std::min((winds.mean() - pose.meanVelocity).norm(), 100.0);
    const double length = std::clamp(std::sqrt(totalArea), 1e-3, 100.0);
    surroundings.gravity = pose.gravity;
    surroundings.humidity = around.humidity;
    surroundings.dryingRate = around.vapourExchange > 0 ? evaporation(around, speed, length).rate : 0.0;
    moisture.step(waterTime, surroundings);
}

void WetCloth::Layer::collectDrops() {
    for (const Moisture::Shed& shed : moisture.shed()) {
        const btSoftBody::Node& node = body.m_nodes[static_cast<int>(shed.node)];
        drops.push_back(
            {toEigen(node.m_x), toEigen(node.m_v), dropMass, shed.drops, time, static_cast<int>(shed.node)});
        if (drops.size() > maxDropsKept) drops.pop_front();
    }
}

void WetCloth::Layer::writeBack(double bodyStep) {
    mechanics.evaluate(laws, moisture);
    writeMasses(body, mechanics.masses);
    if (deformable) return;
    // A SmallStepSolver reads the mechanics itself; Bullet's solvers read them from the links.
    if (!std::exchange(mechanics.movedBySmallSteps, false)) {
        writeLinkConstants(body, mechanics, bodyStep);
        mechanics.smallSteps = 0;
    }
}

// Bullet clears the forces only of bodies that are awake; for a sleeping body they would accumulate.
void WetCloth::Layer::pushByFluid(double bodyStep) {
    const FluidForces::Around around = {laws,    winds.velocities(), submersion, moisture, mechanics, pose,
                                        bodyStep};
    if (!body.isActive() && fluidForces.isLiftedOtherwise(around)) body.activate();
    if (!body.isActive()) {
        fluidForces.rest();
    } else if (deformable) {
        fluidForces.push(body, around);
    } else {
        fluidForces.add(body, around);
        correctWeight();
    }
    submersion.forget();
}

// Bullet will move the body by the gravity of its world info.
void WetCloth::Layer::correctWeight() {
    const btVector3 missing = mechanics.gravity - body.m_worldInfo->m_gravity;
    if (missing.isZero()) return;
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        btSoftBody::Node& node = body.m_nodes[n];
        if (node.m_im > 0) node.m_f += missing / node.m_im;
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
