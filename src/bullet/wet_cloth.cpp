#include "drench/wet_cloth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "air_forces.h"
#include "body_watch.h"
#include "border_checks.h"
#include "link_constants.h"
#include "node_masses.h"
#include "pre_tick.h"
#include "rest_shape.h"
#include "taken_over.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

double checkedWaterSpeed(double waterSpeed) {
    if (waterSpeed >= 0 && waterSpeed <= 1e5) return waterSpeed;
    throw std::invalid_argument("drench: SheetSettings::waterSpeed is " + std::to_string(waterSpeed) +
                                "; give a value from 0 to 100000");
}

RestShape checkedShape(btSoftRigidDynamicsWorld& world, const btSoftBody& body) {
    checkBody(body);
    RestShape shape = restShapeOf(body);
    checkDuplicates(shape);
    checkContacts(body, shape);
    checkPlanes(world, body);
    return shape;
}

std::vector<Eigen::Vector2d> checkedCoordinates(const std::vector<Eigen::Vector2d>& given,
                                                const btSoftBody& body, const RestShape& shape) {
    const std::vector<Eigen::Vector2d> coordinates = given.empty() ? flattened(body) : given;
    checkShape(shape, coordinates);
    return coordinates;
}

}  // namespace

/// Everything behind a WetCloth, in the order of the step.
struct WetCloth::Layer final : PreTickListener {
    Layer(btSoftRigidDynamicsWorld& world, btSoftBody& sheet, const Fabric& fabric,
          const SheetSettings& settings);
    ~Layer();
    Layer(const Layer&) = delete;
    Layer& operator=(const Layer&) = delete;

    std::size_t checkedNode(int node) const;
    void receive(std::size_t node, double mass);
    void preTick(btScalar dt) override;
    void substep(btScalar dt);
    void checkBeforeStep(btScalar dt) const;
    void evaluateLaws();

    btSoftRigidDynamicsWorld& world;  // known to exist during its own pre-tick only
    btSoftBody& body;                 // exists while the watch says so
    const Stepping stepping;
    const double waterSpeed;
    int objectsChecked = 0;  // collision objects in the world when it was last looked through for planes
    Air air;

    RestShape shape;
    std::vector<Eigen::Vector2d> coordinates;
    WetLaws laws;
    Moisture moisture;
    BodyWatch watch;
    TakenOver taken;
    std::vector<LinkStiffness> dryStiffness;
    AirForces airForces;

    std::vector<Arrival> arrivals;      // since the last substep
    std::vector<double> masses;         // kg, as last written to the body
    std::vector<double> saturations;    // of each node, as of this substep
    std::vector<double> stretchRatios;  // of each node, wet over dry
    std::vector<double> bendingRatios;  // of each node, wet over dry
    std::vector<double> stiffness;      // N/m, of each link, as of this substep
};

WetCloth::Layer::Layer(btSoftRigidDynamicsWorld& aWorld, btSoftBody& sheet, const Fabric& fabric,
                       const SheetSettings& settings)
    : world(aWorld),
      body(sheet),
      stepping(settings.stepping),
      waterSpeed(checkedWaterSpeed(settings.waterSpeed)),
      shape(checkedShape(world, body)),
      coordinates(checkedCoordinates(settings.materialCoordinates, body, shape)),
      laws(fabric),
      moisture(fabric, shape.nodeAreas),
      // From here on nothing refuses, and the body may change.
      watch(body),
      taken(body, shape),
      dryStiffness(linkStiffness(fabric, coordinates, shape.triangles, shape.links)),
      airForces(shape),
      arrivals(shape.nodeAreas.size()),
      masses(shape.nodeAreas.size()),
      saturations(shape.nodeAreas.size()),
      stretchRatios(shape.nodeAreas.size()),
      bendingRatios(shape.nodeAreas.size()),
      stiffness(shape.links.size()) {
    evaluateLaws();
    writeMasses(body, masses);
    body.updateLinkConstants();  // fit for the masses, until the first substep brings those of the fabric
    if (stepping == Stepping::byWorld) listenToPreTick(world, *this);
}

WetCloth::Layer::~Layer() {
    if (stepping == Stepping::byWorld) stopListeningToPreTick(world, *this);
    if (!watch.bodyIsAlive()) return;
    std::vector<double> dryMasses;
    for (const double area : shape.nodeAreas) dryMasses.push_back(laws.mass(area, 0));
    taken.giveBack(body, dryMasses);
}

std::size_t WetCloth::Layer::checkedNode(int node) const {
    if (node >= 0 && node < static_cast<int>(masses.size())) return static_cast<std::size_t>(node);
    throw std::out_of_range("drench: node " + std::to_string(node) + " of a sheet with " +
                            std::to_string(masses.size()) + " nodes; give 0 to " +
                            std::to_string(masses.size() - 1));
}

void WetCloth::Layer::receive(std::size_t node, double mass) {
    moisture.addFilm(node, mass);
    if (mass > 0 && watch.bodyIsAlive()) body.activate();
}

void WetCloth::Layer::preTick(btScalar dt) {
    const auto& bodies = world.getSoftBodyArray();
    if (!watch.bodyIsAlive() || bodies.findLinearSearch(&body) == bodies.size()) return;
    if (objectsChecked != world.getNumCollisionObjects()) checkPlanes(world, body);
    objectsChecked = world.getNumCollisionObjects();
    substep(dt);
}

void WetCloth::Layer::substep(btScalar dt) {
    checkBeforeStep(dt);
    keepPrimed(body, shape);
    taken.silenceAero(body);
    const double bodyStep = double(dt) * double(body.m_cfg.timescale);

    moisture.step(bodyStep * waterSpeed);
    takeUpMomentum(body, masses, arrivals);

    evaluateLaws();
    writeMasses(body, masses);
    writeLinkConstants(body, stiffness, bodyStep);
    // Bullet uses up the forces of bodies that are awake only; for one asleep they would pile up.
    if (body.isActive()) airForces.add(body, laws, air, masses, saturations, bodyStep);
}

void WetCloth::Layer::checkBeforeStep(btScalar dt) const {
    if (!(dt > 0) || !std::isfinite(dt))
        throw std::invalid_argument("drench: a substep of " + std::to_string(dt) +
                                    " s; give a positive finite time");
    if (!(body.m_cfg.timescale > 0) || !std::isfinite(body.m_cfg.timescale))
        throw std::runtime_error("drench: the body's m_cfg.timescale is " +
                                 std::to_string(body.m_cfg.timescale) + "; give a positive number");
    if (!air.wind.allFinite())
        throw std::runtime_error("drench: the wind is not finite; mend WetCloth::air().wind");
    if (body.m_nodes.size() != static_cast<int>(masses.size()) ||
        body.m_links.size() != static_cast<int>(stiffness.size()) ||
        body.m_faces.size() != static_cast<int>(shape.triangles.size()))
        throw std::runtime_error(
            "drench: the body has got or lost nodes, links or faces since the WetCloth was made; destroy the "
            "WetCloth before changing the body's topology and make another after");
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const btVector3 sum = body.m_nodes[n].m_x + body.m_nodes[n].m_v;
        if (!std::isfinite(sum.x() + sum.y() + sum.z()))
            throw std::runtime_error(
                "drench: node " + std::to_string(n) +
                " has a position or velocity that is not finite; a force or an obstacle of the "
                "application has blown the sheet up before this substep");
    }
}

void WetCloth::Layer::evaluateLaws() {
    for (std::size_t n = 0; n < masses.size(); ++n) {
        masses[n] = laws.mass(shape.nodeAreas[n], moisture.poreMass()[n] + moisture.filmMass()[n]);
        saturations[n] = moisture.saturation(n);
        const double content = moisture.content(n);
        stretchRatios[n] = laws.stretchRatio(content);
        bendingRatios[n] = laws.bendingRatio(content);
    }
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
        const auto a = static_cast<std::size_t>(shape.links[i].nodes[0]);
        const auto b = static_cast<std::size_t>(shape.links[i].nodes[1]);
        const auto& ratios = dryStiffness[i].kind == LinkKind::bending ? bendingRatios : stretchRatios;
        stiffness[i] = dryStiffness[i].dry * 0.5 * (ratios[a] + ratios[b]);
    }
}

WetCloth::WetCloth(btSoftRigidDynamicsWorld& world, btSoftBody& sheet, const Fabric& fabric,
                   const SheetSettings& settings)
    : layer_(std::make_unique<Layer>(world, sheet, fabric, settings)) {}

WetCloth::~WetCloth() = default;

Air& WetCloth::air() {
    return layer_->air;
}
const Air& WetCloth::air() const {
    return layer_->air;
}

void WetCloth::addWater(int node, double mass, const btVector3& velocity) {
    if (!std::isfinite(velocity.x()) || !std::isfinite(velocity.y()) || !std::isfinite(velocity.z()))
        throw std::invalid_argument("drench: water for node " + std::to_string(node) +
                                    " arrives with a velocity that is not finite; give m/s");
    const std::size_t n = layer_->checkedNode(node);
    layer_->receive(n, mass);
    layer_->arrivals[n].mass += mass;
    layer_->arrivals[n].momentum += velocity * btScalar(mass);
}

void WetCloth::addWater(int node, double mass) {
    const std::size_t n = layer_->checkedNode(node);
    layer_->receive(n, mass);
    layer_->arrivals[n].carried += mass;
}

void WetCloth::soak(double massPerArea) {
    if (!(massPerArea >= 0 && massPerArea <= 1e3))
        throw std::invalid_argument("drench: soaking with " + std::to_string(massPerArea) +
                                    " kg/m2; give a value from 0 to 1000");
    for (std::size_t n = 0; n < layer_->shape.nodeAreas.size(); ++n)
        if (layer_->shape.nodeAreas[n] > 0)
            addWater(static_cast<int>(n), massPerArea * layer_->shape.nodeAreas[n]);
}

double WetCloth::waterMass() const {
    return layer_->moisture.ledger().held;
}

double WetCloth::dryMass() const {
    double mass = 0;
    for (const double area : layer_->shape.nodeAreas) mass += layer_->laws.mass(area, 0);
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
double WetCloth::content(int node) const {
    return layer_->moisture.content(layer_->checkedNode(node));
}
Colour WetCloth::albedo(int node) const {
    return layer_->laws.albedo(saturation(node));
}

double WetCloth::gloss(int node) const {
    return WetLaws::gloss(layer_->moisture.filmThickness(layer_->checkedNode(node)));
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
    double bound = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < layer_->stiffness.size(); ++i) {
        if (layer_->dryStiffness[i].kind == LinkKind::bending) continue;
        double inverseMass = 0;
        for (const int node : layer_->shape.links[i].nodes) inverseMass += 1 / nodeMass(node);
        bound = std::min(bound, std::sqrt(resolvedStiffness / (inverseMass * layer_->stiffness[i])));
    }
    return bound;
}

void WetCloth::preSubstep(btScalar dt) {
    if (layer_->stepping == Stepping::byWorld)
        throw std::logic_error(
            "drench: preSubstep is the application's to call only with Stepping::byApplication; this "
            "WetCloth is "
            "stepped by its world");
    if (layer_->watch.bodyIsAlive() && layer_->body.getBroadphaseHandle()) layer_->substep(dt);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
