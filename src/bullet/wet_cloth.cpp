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
#include "link_order.h"
#include "node_masses.h"
#include "pre_tick.h"
#include "rest_shape.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

/// What the layer takes over of a body and gives back.
struct TakenOver {
    std::vector<btScalar> inverseMasses;
    std::vector<btScalar> linkConstants;  // in the layer's order
    std::vector<int> linkOrder;           // the application's link at each place
    btScalar dragCoefficient = 0;
    btScalar liftCoefficient = 0;
};

std::vector<int> orderOfColours(const RestShape& shape) {
    std::vector<std::array<int, 2>> links;
    links.reserve(shape.links.size());
    for (const LinkNodes& link : shape.links) links.push_back(link.nodes);
    return colouredOrder(links, static_cast<int>(shape.nodeAreas.size()));
}

TakenOver takeOver(btSoftBody& body, const RestShape& shape) {
    TakenOver taken;
    taken.linkOrder = orderOfColours(shape);
    reorderLinks(body, taken.linkOrder);
    for (int n = 0; n < body.m_nodes.size(); ++n) taken.inverseMasses.push_back(body.m_nodes[n].m_im);
    for (int i = 0; i < body.m_links.size(); ++i) taken.linkConstants.push_back(body.m_links[i].m_c0);
    taken.dragCoefficient = body.m_cfg.kDG;
    taken.liftCoefficient = body.m_cfg.kLF;
    body.m_cfg.kDG = 0;
    body.m_cfg.kLF = 0;
    return taken;
}

void giveBack(btSoftBody& body, const TakenOver& taken) {
    const int nodes = std::min(body.m_nodes.size(), static_cast<int>(taken.inverseMasses.size()));
    for (int n = 0; n < nodes; ++n) {
        btScalar& inverseMass = body.m_nodes[n].m_im;
        // A pin that the application set or took out in the meantime is its decision.
        const btScalar before = taken.inverseMasses[static_cast<std::size_t>(n)];
        if ((inverseMass > 0) == (before > 0)) inverseMass = before;
    }
    if (body.m_links.size() == static_cast<int>(taken.linkConstants.size())) {
        for (int i = 0; i < body.m_links.size(); ++i)
            body.m_links[i].m_c0 = taken.linkConstants[static_cast<std::size_t>(i)];
        reorderLinks(body, inverseOrder(taken.linkOrder));
    }
    body.m_cfg.kDG = taken.dragCoefficient;
    body.m_cfg.kLF = taken.liftCoefficient;
}

double checkedWaterSpeed(double waterSpeed) {
    if (waterSpeed >= 0 && waterSpeed <= 1e5) return waterSpeed;
    throw std::invalid_argument("drench: SheetSettings::waterSpeed is " + std::to_string(waterSpeed) +
                                "; give a value from 0 to 100000");
}

RestShape checkedShape(btSoftRigidDynamicsWorld& world, const btSoftBody& body) {
    checkBody(body);
    RestShape shape = restShapeOf(body);
    checkWorld(world, body, shape);
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
class WetCloth::Layer final : public PreTickListener {
  public:
    Layer(btSoftRigidDynamicsWorld& world, btSoftBody& sheet, const Fabric& fabric,
          const SheetSettings& settings);
    ~Layer();
    Layer(const Layer&) = delete;
    Layer& operator=(const Layer&) = delete;

    void addWater(int node, double mass, const btVector3& velocity);
    void preTick(btScalar dt) override { substep(dt); }
    void substep(btScalar dt);

    Air air;

    btSoftRigidDynamicsWorld& world;
    btSoftBody& body;
    const Stepping stepping;
    const double waterSpeed;

    RestShape shape;
    std::vector<Eigen::Vector2d> coordinates;
    WetLaws laws;
    std::vector<LinkStiffness> dryStiffness;

    Moisture moisture;
    std::vector<Arrival> arrivals;    // since the last substep
    std::vector<double> masses;       // kg, as last written to the body
    std::vector<double> saturations;  // as of this substep
    std::vector<double> stiffness;    // N/m, of each link, as of this substep

    BodyWatch watch;
    TakenOver taken;

    bool bodyIsInWorld() const { return watch.bodyIsAlive() && body.getBroadphaseHandle() != nullptr; }

  private:
    void checkBeforeStep(btScalar dt) const;
    void evaluateLaws();
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
      arrivals(shape.nodeAreas.size()),
      masses(shape.nodeAreas.size()),
      saturations(shape.nodeAreas.size()),
      stiffness(shape.links.size()),
      watch(body) {
    prime(body);
    taken = takeOver(body, shape);
    shape = restShapeOf(body);  // the links have changed places
    dryStiffness = linkStiffness(fabric, coordinates, shape.triangles, shape.links);
    evaluateLaws();
    writeMasses(body, masses);
    if (stepping == Stepping::byWorld) listenToPreTick(world, *this);
}

WetCloth::Layer::~Layer() {
    // A body in a world proves that the world still exists: a world that ends puts out the handles of its
    // bodies.
    if (stepping == Stepping::byWorld) stopListeningToPreTick(world, *this, bodyIsInWorld());
    if (watch.bodyIsAlive()) giveBack(body, taken);
}

void WetCloth::Layer::addWater(int node, double mass, const btVector3& velocity) {
    if (!std::isfinite(velocity.x()) || !std::isfinite(velocity.y()) || !std::isfinite(velocity.z()))
        throw std::invalid_argument("drench: water for node " + std::to_string(node) +
                                    " arrives with a velocity that is not finite; give m/s");
    const auto n =
        static_cast<std::size_t>(node);  // a negative node becomes too large, which addFilm refuses
    moisture.addFilm(n, mass);
    arrivals[n].mass += mass;
    arrivals[n].momentum += velocity * btScalar(mass);
    if (mass > 0 && watch.bodyIsAlive()) body.activate();
}

void WetCloth::Layer::checkBeforeStep(btScalar dt) const {
    if (!(dt > 0) || !std::isfinite(dt))
        throw std::invalid_argument("drench: a substep of " + std::to_string(dt) +
                                    " s; give a positive finite time");
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
    }
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
        const auto& nodes = shape.links[i].nodes;
        const double content = 0.5 * (moisture.content(static_cast<std::size_t>(nodes[0])) +
                                      moisture.content(static_cast<std::size_t>(nodes[1])));
        const double ratio = dryStiffness[i].kind == LinkKind::bending ? laws.bendingRatio(content)
                                                                       : laws.stretchRatio(content);
        stiffness[i] = dryStiffness[i].dry * ratio;
    }
}

void WetCloth::Layer::substep(btScalar dt) {
    if (!bodyIsInWorld()) return;
    checkBeforeStep(dt);
    keepRestLengths(body, shape);

    moisture.step(double(dt) * waterSpeed);
    takeUpMomentum(body, masses, arrivals);

    evaluateLaws();
    writeMasses(body, masses);
    const double bodyStep = double(dt) * double(body.m_cfg.timescale);
    writeLinkConstants(body, stiffness, bodyStep);
    // Bullet uses up the forces of bodies that are awake only; for one asleep they would pile up.
    if (body.isActive()) addAirForces(body, shape, laws, air, masses, saturations, bodyStep);
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
    layer_->addWater(node, mass, velocity);
}

void WetCloth::addWater(int node, double mass) {
    const bool known = layer_->watch.bodyIsAlive() && node >= 0 && node < layer_->body.m_nodes.size();
    layer_->addWater(node, mass, known ? layer_->body.m_nodes[node].m_v : btVector3(0, 0, 0));
}

void WetCloth::soak(double massPerArea) {
    for (std::size_t n = 0; n < layer_->masses.size(); ++n)
        if (layer_->shape.nodeAreas[n] > 0)
            addWater(static_cast<int>(n), massPerArea * layer_->shape.nodeAreas[n]);
}

double WetCloth::waterMass() const {
    return layer_->moisture.totalPoreMass() + layer_->moisture.totalFilmMass();
}

double WetCloth::dryMass() const {
    double mass = 0;
    for (const double area : layer_->shape.nodeAreas) mass += layer_->laws.mass(area, 0);
    return mass;
}

double WetCloth::nodeMass(int node) const {
    const auto n = static_cast<std::size_t>(node);
    const Moisture& water = layer_->moisture;
    return layer_->laws.mass(water.area(n), water.poreMass()[n] + water.filmMass()[n]);
}

double WetCloth::saturation(int node) const {
    return layer_->moisture.saturation(static_cast<std::size_t>(node));
}
double WetCloth::content(int node) const {
    return layer_->moisture.content(static_cast<std::size_t>(node));
}
Colour WetCloth::albedo(int node) const {
    return layer_->laws.albedo(saturation(node));
}

double WetCloth::gloss(int node) const {
    return WetLaws::gloss(layer_->moisture.filmThickness(static_cast<std::size_t>(node)));
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
    layer_->substep(dt);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
