#include "drench/wet_cloth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "bullet/bullet_solvers/link_constants.h"
#include "bullet/layer/layer.h"
#include "bullet/repair/health.h"
#include "bullet/world/vectors.h"
#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

constexpr int maxCrossings = 1000000;

}  // namespace

WetCloth::WetCloth(btDiscreteDynamicsWorld& world, btSoftBody& sheet, const Fabric& fabric,
                   const SheetSettings& settings)
    : layer_(std::make_shared<Layer>(world, sheet, fabric, settings)) {}

WetCloth::~WetCloth() = default;

Air& WetCloth::air() {
    return layer_->air;
}
const Air& WetCloth::air() const {
    return layer_->air;
}

void WetCloth::setSurface(const btCollisionObject& solid, SurfaceKind kind) {
    layer_->mechanics.sheetFriction.setSurface(solid, kind);
}

void WetCloth::setSurface(const btCollisionObject& solid, const Surface& surface) {
    layer_->mechanics.sheetFriction.setSurface(solid, surface);
}

void WetCloth::clearSurface(const btCollisionObject& solid) {
    layer_->mechanics.sheetFriction.clearSurface(solid);
}

void WetCloth::setWaterSpeed(double speed) {
    layer_->setWaterSpeed(speed);
}

double WetCloth::waterSpeed() const {
    return layer_->waterSpeed;
}

void WetCloth::addSource(std::unique_ptr<Source> source) {
    layer_->add(std::move(source));
}

void WetCloth::remove(const Source& source) {
    layer_->remove(source);
}

Supply& WetCloth::account(const std::string& name) {
    return layer_->account(name);
}

std::vector<Drop> WetCloth::takeDrops() {
    std::vector<Drop> taken(layer_->drops.begin(), layer_->drops.end());
    layer_->drops.clear();
    return taken;
}

void WetCloth::addWater(int node, double mass, const btVector3& velocity) {
    layer_->application.addFilm(layer_->checkedNode(node), mass, toEigen(velocity));
}

void WetCloth::addWater(int node, double mass) {
    layer_->application.addFilm(layer_->checkedNode(node), mass);
}

void WetCloth::soakFilm(double massPerArea) {
    const std::vector<double> masses = layer_->spread(massPerArea);
    for (std::size_t n = 0; n < masses.size(); ++n)
        if (masses[n] > 0) layer_->application.addFilm(n, masses[n]);
}

void WetCloth::soakPores(double massPerArea) {
    const std::vector<double> masses = layer_->spread(massPerArea);
    for (std::size_t n = 0; n < masses.size(); ++n)
        if (masses[n] > 0) layer_->application.addPores(n, masses[n]);
}

double WetCloth::waterMass() const {
    return layer_->moisture.totalPoreMass() + layer_->moisture.totalFilmMass();
}

double WetCloth::dryMass() const {
    double mass = 0;
    for (const double area : layer_->mesh.areas) mass += layer_->laws.mass(area, 0);
    return mass;
}

double WetCloth::nodeMass(int node) const {
    const std::size_t n = layer_->checkedNode(node);
    const Moisture& water = layer_->moisture;
    return layer_->laws.mass(water.area(n), water.poreMass()[n] + water.filmMass()[n]);
}

double WetCloth::saturation(int node) const {
    return layer_->moisture.saturation(layer_->checkedNode(node));
}
double WetCloth::moistureContent(int node) const {
    return layer_->moisture.moistureContent(layer_->checkedNode(node));
}
Colour WetCloth::albedo(int node) const {
    return layer_->laws.albedo(saturation(node));
}

double WetCloth::transmittance(int node) const {
    return layer_->laws.transmittance(saturation(node));
}

double WetCloth::gloss(int node) const {
    return WetLaws::gloss(layer_->moisture.filmThickness(layer_->checkedNode(node)));
}

const Fabric& WetCloth::fabric() const {
    return layer_->fabric;
}
const Moisture& WetCloth::moisture() const {
    return layer_->moisture;
}
Ledger WetCloth::ledger() const {
    return layer_->moisture.ledger();
}
const std::vector<Eigen::Vector2d>& WetCloth::materialCoordinates() const {
    return layer_->coordinates;
}

double WetCloth::stepBound() const {
    if (layer_->deformable) return layer_->deformable->stepBound();
    const SheetMechanics& mechanics = layer_->mechanics;
    double bound = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < mechanics.shape.links.size(); ++i) {
        if (mechanics.dryStiffness[i].kind == LinkKind::bending) continue;
        double inverseMass = 0;
        for (const int node : mechanics.shape.links[i].nodes) inverseMass += 1 / nodeMass(node);
        bound = std::min(bound, std::sqrt(resolvedStiffness / (inverseMass * mechanics.stiffness(i))));
    }
    return bound;
}

Snapshot WetCloth::snapshot() const {
    return layer_->snapshot();
}

void WetCloth::restore(const Snapshot& snapshot) {
    layer_->restore(snapshot);
}

SheetHealth WetCloth::health(int mostCrossings) const {
    if (mostCrossings < 0 || mostCrossings > maxCrossings)
        refuse("WetCloth::health is asked for ", mostCrossings, " crossings; give 0 to ", maxCrossings);
    if (!layer_->watch.bodyIsAlive()) return {};
    const btSoftBody& body = layer_->body;
    const SheetMechanics& mechanics = layer_->mechanics;
    const bool fits = layer_->fits() && !layer_->topology.hasMoved(body);
    SheetHealth health = {isFinite(body),
                          fits ? largestStrain(body, mechanics) : 0.0,
                          fits ? deepestPenetration(body) : 0.0,
                          stepBound(),
                          mechanics.smallSteps,
                          mechanics.heldSubsteps,
                          fits,
                          layer_->refits,
                          static_cast<int>(layer_->diagnostics.reports().size()),
                          0,
                          0,
                          false};
    if (mostCrossings == 0 || !fits || !health.finite) return health;
    const CrossingCount found = layer_->countCrossings(mostCrossings);
    health.crossings = found.ofItself;
    health.crossingsWithOthers = found.withOthers;
    health.crossingsAreAll = found.areAll;
    return health;
}

const std::vector<TroubleReport>& WetCloth::troubles() const {
    return layer_->diagnostics.reports();
}

void WetCloth::clearTroubles() {
    layer_->diagnostics.clear();
}

StepTimes WetCloth::times() const {
    return layer_->mechanics.times;
}

void WetCloth::jumped() {
    layer_->mechanics.hasJumped = true;
}

void WetCloth::preSubstep(btScalar dt) {
    if (layer_->stepping == Stepping::byWorld)
        refuse<std::logic_error>(
            "preSubstep is the application's to call only with Stepping::byApplication; this "
            "WetCloth is stepped by its world");
    if (layer_->watch.bodyIsAlive() && layer_->body.getBroadphaseHandle()) layer_->substep(dt);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
