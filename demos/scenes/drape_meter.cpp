#include "scenes/drape_meter.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>

#include "checks/text.h"
#include "scenes/makers.h"
#include "scenes/scene_texts.h"
#include "world/angles.h"
#include "world/cloth_disc.h"

namespace drench::demo {

namespace {

constexpr double clothRadius = 0.15;      // m
constexpr double pedestalRadius = 0.09;   // m
constexpr double pedestalHeight = 0.12;   // m
constexpr double axes[] = {-0.18, 0.18};  // m, x of the pedestals'
constexpr double roughness = 5e-5;        // m, of the cloth at the start; without it the cloth would not fold
constexpr double fallDamping = 2;         // 1/s, for the air
constexpr double slowest = 5e-4;          // m/s, speed of a disc below which it counts as at rest
constexpr double shortest = 1;            // s
constexpr int stillFrames = 15;           // in a row

// Parameters of the evaluation of silhouettes.
constexpr int pixels = 1024;
constexpr double pictureReach = 1.05 * clothRadius;
constexpr int directionsRound = 720;
constexpr double prominence = 3e-3;  // m, smallest height of a fold
constexpr int highestOrder = 12;

double ringArea(double outer) {
    return pi * (outer * outer - pedestalRadius * pedestalRadius);
}

int nodesAcross(const SceneOptions& options) {
    return options.resolution > 0 ? options.resolution : 48;
}

// With the automatic number of steps, links this short are softer than the shear stiffness of the cloth. With
// four steps per node across the disc, twice as many change the drape coefficient by less than a point.
SceneDescription described(const SceneOptions& options) {
    SceneDescription scene = fitted(sceneFile("drape-meter"), options);
    if (!options.smallSteps) scene.solver.smallSteps = std::min(999, 4 * nodesAcross(options));
    return scene;
}

// The lateral surface of a cylinder.
viewer::SheetMesh cylinder(const Eigen::Vector3f& foot, float radius, float height,
                           const Eigen::Vector3f& colour) {
    constexpr std::uint32_t corners = 64;
    viewer::SheetMesh mesh;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const float angle = 2 * float(pi) * float(i) / float(corners);
        const Eigen::Vector3f position = foot + radius * Eigen::Vector3f(std::cos(angle), 0, std::sin(angle));
        const std::uint32_t next = (i + 1) % corners;
        mesh.positions.push_back(position);
        mesh.positions.emplace_back(position + Eigen::Vector3f(0, height, 0));
        mesh.triangles.push_back({2 * i, 2 * i + 1, 2 * next + 1});
        mesh.triangles.push_back({2 * i, 2 * next + 1, 2 * next});
    }
    mesh.albedo.assign(mesh.positions.size(), colour);
    mesh.gloss.assign(mesh.positions.size(), 0.1f);
    return mesh;
}

// A plate on a foot, around which the cloth may hang.
void showPedestal(viewer::Picture& picture, float x) {
    constexpr float thickness = 0.004f, clear = 0.001f;
    constexpr auto top = float(pedestalHeight), radius = float(pedestalRadius) - clear;
    const Eigen::Vector3f metal(0.25f, 0.25f, 0.27f);
    picture.sheets.push_back(cylinder({x, top - clear - thickness, 0}, radius, thickness, metal));
    constexpr float foot = 0.02f;
    picture.rods.push_back({{x, 0, 0}, {x, top - thickness - foot, 0}, foot, metal, viewer::Material::metal});
}

// Root mean square of the nodes' speeds, m/s.
double speed(const SceneCloth& disc) {
    double sum = 0;
    for (int n = 0; n < disc.body().m_nodes.size(); ++n) sum += double(disc.body().m_nodes[n].m_v.length2());
    return std::sqrt(sum / disc.body().m_nodes.size());
}

}  // namespace

DrapeMeter::DrapeMeter(const SceneOptions& options)
    : StagedScene(described(options), {0, 0}), isTropical_(options.fabric == "tropical") {
    const SceneDescription scene = described(options);
    const Fabric fabric = fabricDescription(options.fabric.empty() ? "cotton" : options.fabric).fabric();
    addDisc("dry", 0, fabric, scene, nodesAcross(options));
    addDisc("wet", scene.water ? 1 : 0, fabric, scene, nodesAcross(options));
}

void DrapeMeter::addDisc(const std::string& name, double fractionOfSaturation, const Fabric& fabric,
                         const SceneDescription& scene, int nodesAcross) {
    const DiscMesh mesh = discMesh(clothRadius, nodesAcross, pedestalRadius);
    const btVector3 centre(btScalar(axes[discs_.size()]), btScalar(pedestalHeight), 0);
    SheetSettings settings;
    settings.materialCoordinates = mesh.nodes;
    settings.waterSpeed = 0;
    SceneCloth& disc = stage().add(
        std::make_unique<SceneCloth>(stage().world(), name, fabric,
                                     makeDisc(stage().world().worldInfo(), fabric, mesh, centre), settings));
    disc.setDamping(fallDamping);
    disc.wet().soakPores(fractionOfSaturation * fabric.poreCapacity());
    // Between the plates of the instrument the cloth is fixed.
    std::mt19937 random(scene.seed);
    std::uniform_real_distribution<double> offset(-roughness, roughness);
    for (int n = 0; n < disc.body().m_nodes.size(); ++n) {
        btSoftBody::Node& node = disc.body().m_nodes[n];
        const double height = offset(random);
        if (mesh.nodes[std::size_t(n)].norm() < pedestalRadius * (1 + 1e-6))
            node.m_im = 0;
        else
            node.m_x.setY(node.m_x.y() + btScalar(height));
        node.m_q = node.m_x;
    }
    discs_.push_back(&disc);
}

void DrapeMeter::measure() {
    const bool still = speed(*discs_[0]) < slowest && speed(*discs_[1]) < slowest;
    stillFor_ = still ? stillFor_ + 1 : 0;
}

Silhouette DrapeMeter::silhouette(std::size_t disc) const {
    return Silhouette(discs_[disc]->body(), {axes[disc], 0}, pictureReach, pixels);
}

DrapeMeter::Drape DrapeMeter::drape(std::size_t disc) const {
    const Silhouette shadow = silhouette(disc);
    const std::vector<double> radii = shadow.radii(directionsRound);
    Drape drape;
    drape.coefficient = 100 * (shadow.area() - pi * pedestalRadius * pedestalRadius) / ringArea(clothRadius);
    drape.nodes = countLobes(radii, prominence);
    drape.dominantOrder = drench::demo::dominantOrder(radii, highestOrder);
    drape.nearest = *std::min_element(radii.begin(), radii.end());
    drape.farthest = *std::max_element(radii.begin(), radii.end());
    return drape;
}

bool DrapeMeter::atRest() const {
    return stillFor_ >= stillFrames;
}

bool DrapeMeter::finished() const {
    return StagedScene::finished() || (time() > shortest && atRest());
}

std::string DrapeMeter::status() const {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << time() << " s, still moving at " << std::setprecision(1)
         << 1e3 * std::max(speed(*discs_[0]), speed(*discs_[1])) << " mm/s";
    return text.str();
}

void DrapeMeter::annotate(viewer::Picture& picture) const {
    for (const double x : axes) showPedestal(picture, float(x));
    const Drape left = dry(), right = wet();
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << discs_[0]->fabric().name << ": left dry, drape "
         << left.coefficient << " %, " << left.nodes << " nodes; right wet, " << right.coefficient << " %, "
         << right.nodes;
    picture.caption.push_back(text.str());
}

std::optional<std::string> DrapeMeter::moment() const {
    if (finished()) return "drape-meter-at-rest";
    if (frames() == 6 || frames() == 15) return momentName();
    return std::nullopt;
}

std::vector<Drawing> DrapeMeter::drawings() const {
    std::vector<Drawing> list;
    for (std::size_t disc = 0; disc < discs_.size(); ++disc)
        list.push_back(
            {"silhouette-" + discs_[disc]->name(), silhouette(disc).image({pedestalRadius, clothRadius})});
    return list;
}

std::optional<Table> DrapeMeter::result() const {
    Table table;
    table.columns = {{"wet", 0},        {"mass_g", 2},         {"drape_%", 1},
                     {"nodes", 0},      {"dominant_order", 0}, {"nearest_mm", 1},
                     {"farthest_mm", 1}};
    for (std::size_t i = 0; i < discs_.size(); ++i) {
        const Drape drape = this->drape(i);
        table.rows.push_back({double(i), 1e3 * discs_[i]->mass(), drape.coefficient, double(drape.nodes),
                              double(drape.dominantOrder), 1e3 * drape.nearest, 1e3 * drape.farthest});
    }
    return table;
}

void DrapeMeter::report(std::ostream& out) const {
    print(out, *result());
    StagedScene::report(out);
}

std::string DrapeMeter::remarks() const {
    std::ostringstream text;
    text << "A disc of 30 cm on a pedestal of 18 cm. Fabric: " << discs_[0]->fabric().name << ". "
         << (atRest() ? "At rest" : "Not at rest") << " after " << std::fixed << std::setprecision(2)
         << time() << " s.\nA node stands out by " << std::setprecision(0) << 1e3 * prominence
         << " mm or more; dominant_order is that of the largest wave in the radius.\n";
    return text.str();
}

void DrapeMeter::check(std::vector<std::string>& list) const {
    for (std::size_t disc = 0; disc < discs_.size(); ++disc) {
        const double coefficient = drape(disc).coefficient;
        if (!(coefficient > 0 && coefficient < 100))
            list.push_back(textOf("the ", discs_[disc]->name(), " disc's drape coefficient is ",
                                  sixDigits(coefficient), " %"));
    }
    if (!atRest()) list.push_back(textOf("it is not at rest after ", sixDigits(time()), " s"));
    if (isTropical_) checkTropical(list);
}

// Measured on real cloth by Matsudaira et al. 2015; the fabric has the bending properties of that cloth.
void DrapeMeter::checkTropical(std::vector<std::string>& list) const {
    constexpr double measured = 50.7, tolerance = 6;
    constexpr int nodes = 5, nodeTolerance = 1;
    const Drape drape = dry();
    if (!(std::abs(drape.coefficient - measured) <= tolerance))
        list.push_back(textOf("the dry disc's drape coefficient is ", sixDigits(drape.coefficient),
                              " % where 50.7 % was measured"));
    if (std::abs(drape.nodes - nodes) > nodeTolerance)
        list.push_back(textOf("the dry disc has ", drape.nodes, " nodes where 5 were measured"));
}

std::unique_ptr<Scene> makeDrapeMeter(const SceneOptions& options) {
    return std::make_unique<DrapeMeter>(options);
}

}  // namespace drench::demo
