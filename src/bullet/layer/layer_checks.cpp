// Checks and repairs of a layer before each substep: topology of the body, valid numbers.
#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "bullet/layer/layer.h"
#include "bullet/repair/recut.h"
#include "bullet/repair/repair.h"
#include "bullet/repair/units.h"
#include "bullet/sheet/border_checks.h"
#include "bullet/world/gravity.h"
#include "bullet/world/stop_watch.h"
#include "bullet/world/vectors.h"
#include "checks/checks.h"
#include "drench/drying.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Whether each node has cloth, or a link to a node that has.
std::vector<bool> areHeld(const RestShape& shape) {
    std::vector<bool> held;
    for (const double area : shape.nodeAreas) held.push_back(area > 0);
    for (const LinkNodes& link : shape.links)
        for (std::size_t end = 0; end < 2; ++end)
            if (shape.nodeAreas[static_cast<std::size_t>(link.nodes[1 - end])] > 0)
                held[static_cast<std::size_t>(link.nodes[end])] = true;
    return held;
}

// Makes a body valid for Bullet after a cut: masses, areas, rest lengths and link constants.
void writeCut(btSoftBody& body, const SheetMechanics& mechanics, std::size_t oldNodes) {
    forgetContacts(body);
    double mass = 0;
    for (const double nodeMass : mechanics.masses) mass += nodeMass / double(mechanics.masses.size());
    // New nodes of Bullet have 1 kg. A loose end without cloth gets the mean mass. Nodes without any link to
    // cloth, which Bullet leaves behind, would fall forever, so they are fixed.
    const std::vector<bool> held = areHeld(mechanics.shape);
    for (std::size_t n = oldNodes; n < mechanics.masses.size(); ++n) {
        btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        if (node.m_im > 0) node.m_im = held[n] ? btScalar(1 / mass) : 0;
        if (!held[n]) node.m_v.setZero();
    }
    writeMasses(body, mechanics.masses);
    for (int f = 0; f < body.m_faces.size(); ++f)
        body.m_faces[f].m_ra = btScalar(2 * mechanics.shape.triangleAreas[static_cast<std::size_t>(f)]);
    writeRestLengths(body, mechanics.shape);
    body.m_bUpdateRtCst = false;
    body.updateLinkConstants();
}

}  // namespace

bool WetCloth::Layer::fits() const {
    return mechanics.fits && hasCountsOf(body, mechanics.shape);
}

bool WetCloth::Layer::fitToBody() {
    topology.follow(body);
    if (mechanics.fits && topology.isAsItWas(body, mechanics.shape)) return true;
    repairUnfitBody();
    // Each topology is tried only once, because that takes a while.
    if (mechanics.fits || refused != countsOf(body)) try {
            refused = countsOf(body);
            refit();
            return true;
        } catch (const std::invalid_argument& problem) {
            whyRefused = reasonOf(problem);
        }
    diagnostics.note(
        Trouble::topology,
        "the body's nodes, links or faces have changed to what the WetCloth cannot follow (" + whyRefused +
            "); append and cut so that old nodes keep their index and faces have an area, or destroy the "
            "WetCloth before the change and make another after");
    detach();
    return false;
}

// Repairs that are possible whatever the topology is.
void WetCloth::Layer::repairUnfitBody() {
    repairSettings(body, diagnostics);
    repairGravity(body, gravityOfInfo, diagnostics);
    if (mechanics.fits) unfitPositions = pose.positionsInWorld();
    repairNodes(body, unfitPositions, {}, diagnostics);
    unfitPositions = positionsOf(body);
}

void WetCloth::Layer::detach() {
    mechanics.fits = mechanics.movedBySmallSteps = false;
    prime(body);
    keepFaceTree(body);
}

// Replaces all data per node, link and face; the state of the sheet as a whole is kept.
void WetCloth::Layer::refit() {
    Recut cut = recutOf(body, mechanics.shape, mesh, moisture);
    const std::vector<double> oldAreas = mesh.areas;
    // From here on nothing throws.
    moisture.recut(fabric, cut.mesh, std::move(cut.poreMass), std::move(cut.filmMass));
    mechanics.recut(fabric, std::move(cut.shape), std::move(cut.mesh));
    savedState.recut(body, mechanics, oldAreas, dryMasses());
    coordinates = nodeCoordinates(mesh);
    totalArea = std::accumulate(mesh.areas.begin(), mesh.areas.end(), 0.0);
    layers = ClothLayers(fabric, mesh.size(), mechanics.lightPressure);
    winds = WindAtNodes(mesh);
    submersion = Submersion(mesh.size());
    fluidForces = FluidForces(mechanics.shape, fabric);
    pose = Pose(mesh);
    contacts.resize(mesh.size());
    arrivals.resize(mesh.size());
    mechanics.evaluate(laws, moisture);
    writeCut(body, mechanics, oldAreas.size());
    if (deformable)
        deformable->recut(world, body, mechanics, dryMasses(), std::max(1.0, double(fabric.wetStretchRatio)),
                          std::max(1.0, double(fabric.wetBendingRatio)));
    topology.follow(body);
    ++refits;
}

void WetCloth::Layer::checkBeforeStep(btScalar dt) {
    // Errors of the setup, which only the application can correct.
    if (deformable) deformable->check(world, double(dt));
    repairBody();
    reportHeldSubsteps();
    tangles.step(world, body, mechanics, bodyStepOf(dt), diagnostics);
    // Last, because the shelter is kept from step to step.
    readAir(bodyStepOf(dt));
}

// @param most  crossings after which the count ends
CrossingCount WetCloth::Layer::countCrossings(int most) {
    constexpr std::int64_t looksAtAFace = 500;
    const CrossingLimits limits = {most, looksAtAFace * static_cast<std::int64_t>(mesh.triangles.size())};
    std::vector<btSoftBody*> others;
    if (body.getBroadphaseHandle() && isInWorld()) others = sheetsNear(world, body);
    return CrossingSearch().count(body, mechanics, others, limits, true);
}

void WetCloth::Layer::repairBody() {
    repairSettings(body, diagnostics);
    repairRestLengthScale(body, mechanics.shape, diagnostics);
    repairGravity(body, gravityOfInfo, diagnostics);
    gravityOfInfo = body.m_worldInfo->m_gravity;
    readGravity();
    checkScale();
    if (pose.gather(body, mesh, mechanics.gravity)) return;
    repairNodes(body, pose.positionsInWorld(), mechanics.masses, diagnostics);
    pose.gather(body, mesh, mechanics.gravity);
}

void WetCloth::Layer::readGravity() {
    const Gravity found = gravityOf(world, body, ownGravity);
    if (isValidGravity(found.value)) {
        if (found.disagrees) reportGravities(found);
        mechanics.gravity = found.value;
        return;
    }
    diagnostics.note(Trouble::gravity,
                     textOf(nameOf(found.place), " is ", sixDigits(found.value),
                            " m/s2; give a finite one, at most 10000; the last valid one is used"));
}

// The message is written only once, because writing it takes memory in each step.
void WetCloth::Layer::reportGravities(const Gravity& found) {
    const bool isKnown = found.value == reportedGravity && found.otherValue == reportedOther;
    if (isKnown && diagnostics.goesOn(Trouble::gravityPlaces)) return;
    diagnostics.note(Trouble::gravityPlaces, disagreementOf(found));
    reportedGravity = found.value;
    reportedOther = found.otherValue;
}

void WetCloth::Layer::checkScale() {
    if (scaleIsChecked || unusualScale) return;
    const std::string problem = wrongUnit({materialSize(mesh), meanLinkLength(mechanics.shape),
                                           laws.mass(totalArea, 0), double(mechanics.gravity.length())});
    if (!problem.empty()) diagnostics.note(Trouble::units, problem);
    scaleIsChecked = true;
}

void WetCloth::Layer::reportHeldSubsteps() {
    if (std::exchange(heldSubsteps, mechanics.heldSubsteps) == mechanics.heldSubsteps) return;
    diagnostics.note(Trouble::motion,
                     textOf("the small steps of the last substep took node ", mechanics.heldNode,
                            " to a position that is not finite, or over 1e7 m from the origin, so the sheet "
                            "stayed where it was, at rest; look for extreme forces, speeds or obstacles"),
                     mechanics.heldNode);
}

void WetCloth::Layer::readAir(double bodyStep) {
    StopWatch watchOfWind;
    try {
        if (!air.wind.allFinite())
            refuse<std::runtime_error>("the wind in WetCloth::air().wind is ", air.wind,
                                       " m/s; give finite numbers");
        validate(air);
        usedAir = air;
    } catch (const std::exception& problem) {
        diagnostics.noteThrown(Trouble::air, problem.what());
    }
    try {
        winds.evaluate(usedAir, {pose, toEigen(pose.origin), time, bodyStep, world});
    } catch (const std::exception& problem) {
        const std::string why = reasonOf(problem);
        const bool isNamed = why.find("wind field") != std::string::npos;  // in Drench's own messages
        diagnostics.noteThrown(Trouble::air,
                               isNamed ? why : textOf("the wind field in WetCloth::air().field: ", why));
    }
    mechanics.times.air += watchOfWind.lap();
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
