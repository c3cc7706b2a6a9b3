#include "drape_meter.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <random>
#include <sstream>

#include "../angles.h"
#include "../cloth_disc.h"
#include "../pictures.h"

namespace drench::demo {

namespace {

constexpr double discRadius = 0.15;      // m
constexpr double pedestalRadius = 0.09;  // m
constexpr double pedestalHeight = 0.12;  // m
constexpr double aside = 0.18;           // m, of each pedestal's axis from the middle
constexpr double roughness = 5e-5;       // m, of the cloth as it lies; without it nothing would fold
constexpr double fallDamping = 2;        // 1/s, for the air
constexpr double slowest = 5e-4;         // m/s, mean speed below which a disc is at rest
constexpr double shortest = 1;           // s
constexpr int stillFrames = 15;          // in a row
constexpr int mostSubsteps = 40;

// How silhouettes are looked at.
constexpr int pixels = 1024;
constexpr double reach = 1.05 * discRadius;
constexpr int directions = 720;
constexpr double prominence = 3e-3;  // m, that a fold stands out
constexpr int highestOrder = 12;

double ringArea(double outer) {
    return pi * (outer * outer - pedestalRadius * pedestalRadius);
}

int nodesAcross(const SceneOptions& options) {
    return options.resolution > 0 ? options.resolution : 48;
}

/// With the solver's own choice links this short act as soft as m / h^2, softer than the cloth shears. With four
/// to a node across the disc, twice as many change the drape by less than a point.
SmallSteps smallSteps(const SceneOptions& options) {
    SmallSteps chosen;
    chosen.count = std::min(999, 4 * nodesAcross(options));
    return chosen;
}

/// The upright side of a cylinder.
viewer::SheetMesh cylinder(const Eigen::Vector3f& foot, float radius, float height,
                           const Eigen::Vector3f& colour) {
    constexpr std::uint32_t corners = 64;
    viewer::SheetMesh mesh;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const float angle = 2 * float(pi) * float(i) / float(corners);
        const Eigen::Vector3f place = foot + radius * Eigen::Vector3f(std::cos(angle), 0, std::sin(angle));
        const std::uint32_t next = (i + 1) % corners;
        mesh.positions.push_back(place);
        mesh.positions.push_back(place + Eigen::Vector3f(0, height, 0));
        mesh.triangles.push_back({2 * i, 2 * i + 1, 2 * next + 1});
        mesh.triangles.push_back({2 * i, 2 * next + 1, 2 * next});
    }
    mesh.albedo.assign(mesh.positions.size(), colour);
    mesh.gloss.assign(mesh.positions.size(), 0.1f);
    return mesh;
}

/// A plate on a foot, which the cloth may hang round.
void showPedestal(viewer::Picture& picture, float x) {
    constexpr float thickness = 0.004f, clear = 0.001f;
    constexpr auto top = float(pedestalHeight), radius = float(pedestalRadius) - clear;
    const Eigen::Vector3f metal(0.25f, 0.25f, 0.27f);
    picture.sheets.push_back(cylinder({x, top - clear - thickness, 0}, radius, thickness, metal));
    constexpr float foot = 0.02f;
    picture.rods.push_back({{x, 0, 0}, {x, top - thickness - foot, 0}, foot, metal, viewer::Material::metal});
}

}  // namespace

/// One disc on its pedestal.
struct DrapeMeter::Disc {
    std::string name;
    SceneWorld& world;
    double x;  // m, of the pedestal's axis
    std::unique_ptr<btSoftBody> sheet;
    std::unique_ptr<WetCloth> cloth;

    ~Disc() {
        cloth.reset();
        world.removeSoftBody(*sheet);
    }

    /// Root mean square of the nodes' speeds, m/s.
    double speed() const {
        double sum = 0;
        for (int n = 0; n < sheet->m_nodes.size(); ++n) sum += double(sheet->m_nodes[n].m_v.length2());
        return std::sqrt(sum / sheet->m_nodes.size());
    }

    Silhouette silhouette() const { return Silhouette(*sheet, {x, 0}, reach, pixels); }

    Drape drape() const {
        const Silhouette shadow = silhouette();
        const std::vector<double> radii = shadow.radii(directions);
        Drape drape;
        drape.coefficient =
            100 * (shadow.area() - pi * pedestalRadius * pedestalRadius) / ringArea(discRadius);
        drape.nodes = countLobes(radii, prominence);
        drape.dominantOrder = drench::demo::dominantOrder(radii, highestOrder);
        drape.nearest = *std::min_element(radii.begin(), radii.end());
        drape.farthest = *std::max_element(radii.begin(), radii.end());
        return drape;
    }
};

DrapeMeter::DrapeMeter(const SceneOptions& options)
    : TimedScene(options, 20, smallSteps(options)), isTropical_(options.fabric == "tropical") {
    addDisc("dry", -aside, 0, options);
    addDisc("wet", aside, 1, options);
    chooseSubsteps(std::min(discs_[0]->cloth->stepBound(), discs_[1]->cloth->stepBound()), mostSubsteps);
    for (const auto& disc : discs_) damp(*disc->sheet, fallDamping);
}

DrapeMeter::~DrapeMeter() = default;

void DrapeMeter::addDisc(const std::string& name, double x, double shareOfSaturation,
                         const SceneOptions& options) {
    const DiscMesh mesh = discMesh(discRadius, nodesAcross(options), pedestalRadius);
    auto sheet = makeDisc(bullet_->worldInfo(), fabric_, mesh, {btScalar(x), btScalar(pedestalHeight), 0});
    SheetSettings settings;
    settings.materialCoordinates = mesh.nodes;
    settings.waterSpeed = 0;
    bullet_->addSoftBody(*sheet);
    auto cloth = std::make_unique<WetCloth>(bullet_->world(), *sheet, fabric_, settings);
    cloth->presoak(shareOfSaturation * fabric_.poreCapacity());
    // Between the plates of the instrument the cloth cannot move.
    std::mt19937 random(options.seed);
    std::uniform_real_distribution<double> offset(-roughness, roughness);
    for (int n = 0; n < sheet->m_nodes.size(); ++n) {
        btSoftBody::Node& node = sheet->m_nodes[n];
        const double height = offset(random);
        if (mesh.nodes[std::size_t(n)].norm() < pedestalRadius * (1 + 1e-6))
            node.m_im = 0;
        else
            node.m_x.setY(node.m_x.y() + btScalar(height));
        node.m_q = node.m_x;
    }
    discs_.push_back(std::unique_ptr<Disc>(new Disc{name, *bullet_, x, std::move(sheet), std::move(cloth)}));
}

void DrapeMeter::advance() {
    for (const auto& disc : discs_) disc->cloth->air().wind = {0, 0, windSpeed_};
    stepWorld();
    const bool still = discs_[0]->speed() < slowest && discs_[1]->speed() < slowest;
    stillFor_ = still ? stillFor_ + 1 : 0;
}

bool DrapeMeter::atRest() const {
    return stillFor_ >= stillFrames;
}

bool DrapeMeter::finished() const {
    return TimedScene::finished() || (time_ > shortest && atRest());
}

DrapeMeter::Drape DrapeMeter::dry() const {
    return discs_[0]->drape();
}

DrapeMeter::Drape DrapeMeter::wet() const {
    return discs_[1]->drape();
}

std::string DrapeMeter::status() const {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << time_ << " s, still moving at " << std::setprecision(1)
         << 1e3 * std::max(discs_[0]->speed(), discs_[1]->speed()) << " mm/s";
    return text.str();
}

viewer::Picture DrapeMeter::picture() const {
    viewer::Picture picture;
    for (const auto& disc : discs_) {
        picture.sheets.push_back(sheetMesh(*disc->sheet, *disc->cloth));
        showPedestal(picture, float(disc->x));
    }
    picture.camera.target = {0, 0.075f, 0};
    picture.camera.distance = 0.62f;
    picture.camera.yaw = 0.05f;
    picture.camera.pitch = 0.5f;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << fabric_.name << ": left dry, drape " << dry().coefficient
         << " %, " << dry().nodes << " nodes; right wet, " << wet().coefficient << " %, " << wet().nodes;
    picture.caption.push_back(text.str());
    return picture;
}

std::optional<std::string> DrapeMeter::moment() const {
    if (finished()) return "drape-meter-at-rest";
    if (frames_ == 6 || frames_ == 15) return momentName("drape-meter");
    return std::nullopt;
}

std::vector<Drawing> DrapeMeter::drawings() const {
    std::vector<Drawing> list;
    for (const auto& disc : discs_)
        list.push_back({"silhouette-" + disc->name, disc->silhouette().image({pedestalRadius, discRadius})});
    return list;
}

std::vector<SceneSheet> DrapeMeter::sheets() {
    std::vector<SceneSheet> list;
    for (const auto& disc : discs_) list.push_back({disc->name, disc->cloth.get()});
    return list;
}

std::optional<Table> DrapeMeter::result() const {
    Table table;
    table.columns = {{"wet", 0},        {"mass_g", 2},         {"drape_%", 1},
                     {"nodes", 0},      {"dominant_order", 0}, {"nearest_mm", 1},
                     {"farthest_mm", 1}};
    for (std::size_t i = 0; i < discs_.size(); ++i) {
        const Drape drape = discs_[i]->drape();
        const double mass = discs_[i]->cloth->dryMass() + discs_[i]->cloth->waterMass();
        table.rows.push_back({double(i), 1e3 * mass, drape.coefficient, double(drape.nodes),
                              double(drape.dominantOrder), 1e3 * drape.nearest, 1e3 * drape.farthest});
    }
    return table;
}

void DrapeMeter::report(std::ostream& out) const {
    print(out, *result());
    out << "\nA disc of 30 cm on a pedestal of 18 cm. Fabric: " << fabric_.name << ". "
        << (atRest() ? "At rest" : "Not at rest") << " after " << std::fixed << std::setprecision(2) << time_
        << " s.\nA node stands out by " << std::setprecision(0) << 1e3 * prominence
        << " mm or more; dominant_order is that of the largest wave in the radius.\n"
        << std::defaultfloat << std::setprecision(6);
    reportSteps(out, std::min(discs_[0]->cloth->stepBound(), discs_[1]->cloth->stepBound()));
}

std::vector<std::string> DrapeMeter::failures() const {
    std::vector<std::string> list;
    for (const auto& disc : discs_) {
        const double coefficient = disc->drape().coefficient;
        if (!(coefficient > 0 && coefficient < 100))
            list.push_back("the " + disc->name + " disc's drape coefficient is " +
                           std::to_string(coefficient) + " %");
    }
    if (!atRest()) list.push_back("it is not at rest after " + std::to_string(time_) + " s");
    if (isTropical_) checkTropical(list);
    return list;
}

/// Measured on real cloth by Matsudaira et al. 2015, whose bending the fabric has.
void DrapeMeter::checkTropical(std::vector<std::string>& list) const {
    constexpr double measured = 50.7, tolerance = 6;
    constexpr int nodes = 5, nodeTolerance = 1;
    const Drape drape = dry();
    if (!(std::abs(drape.coefficient - measured) <= tolerance))
        list.push_back("the dry disc's drape coefficient is " + std::to_string(drape.coefficient) +
                       " % where 50.7 % was measured");
    if (std::abs(drape.nodes - nodes) > nodeTolerance)
        list.push_back("the dry disc has " + std::to_string(drape.nodes) + " nodes where 5 were measured");
}

}  // namespace drench::demo
