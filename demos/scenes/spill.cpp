#include "spill.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include "../angles.h"
#include "scene_texts.h"

namespace drench::demo {

namespace {

constexpr double settlingTime = 1.5;  // s, dry
constexpr double pouringTime = 3;     // s
constexpr double pouredMass = 0.045;  // kg; three times that would soak more cloth than lies on the table
constexpr double stained = 0.1;       // saturation from which on cloth counts as stained
constexpr double deepestAllowed = 0.01;
constexpr int framesPerRow = 120;

/// The source "jug" of a scene.
const SprayDescription& jugOf(const SceneDescription& scene) {
    return std::get<SprayDescription>(scene.sources.front().water);
}

}  // namespace

double Spill::Stain::radius() const {
    return std::sqrt(area / pi);
}

double Spill::Stain::roundness() const {
    return extentWeft > 0 ? extentWarp / extentWeft : std::numeric_limits<double>::quiet_NaN();
}

Spill::Spill(const SceneOptions& options)
    : StagedScene(fitted(sceneFile("spill"), options), {framesPerRow, 2 * framesPerRow}),
      table_(solidNamed(sceneFile("spill"), "table")),
      spout_(jugOf(sceneFile("spill")).origin) {}

void Spill::direct() {
    pouringRate_ = pourNow();
    if (stage().hasWater()) std::get<SprayDescription>(stage().source("jug").water).rate = pouringRate_;
}

/// Pours until the cloth has got what was in the jug: nodes fill the round stream only roughly, so that a little of it
/// misses the cloth. The last frame pours no more than is left.
double Spill::pourNow() {
    const double left = pouredMass - poured();
    if (time() < settlingTime - frameTime / 2 || emptyAt_ > 0) return 0;
    if (left < 1e-4 * pouredMass) {
        emptyAt_ = time();
        return 0;
    }
    // The jug runs with the water: in its time the stream is slower.
    const double steady = pouredMass / waterTime(pouringTime);
    return std::min(steady, left / waterTime(frameTime));
}

void Spill::measure() {
    if (pouringRate_ > 0 || emptyAt_ == 0) return;
    const double area = stain().area;
    if (largestStain_ > 0) largestShrinkage_ = std::max(largestShrinkage_, 1 - area / largestStain_);
    largestStain_ = std::max(largestStain_, area);
}

Spill::Stain Spill::stain() const {
    const Moisture& moisture = cloth().wet().moisture();
    const auto& places = cloth().wet().materialCoordinates();
    Stain stain;
    double held = 0, capacity = 0;
    Eigen::Vector2d sum(0, 0), squares(0, 0);
    for (std::size_t n = 0; n < moisture.size(); ++n) {
        if (!(moisture.saturation(n) > stained)) continue;
        const double area = moisture.area(n);
        stain.area += area;
        sum += area * places[n];
        squares += area * places[n].cwiseProduct(places[n]);
        held += moisture.poreMass()[n];
        capacity += moisture.poreCapacity(n);
    }
    if (!(stain.area > 0)) return stain;
    const Eigen::Vector2d middle = sum / stain.area;
    const Eigen::Vector2d spread = squares / stain.area - middle.cwiseProduct(middle);
    stain.extentWarp = 2 * std::sqrt(std::max(0.0, spread.x()));
    stain.extentWeft = 2 * std::sqrt(std::max(0.0, spread.y()));
    stain.meanSaturation = held / capacity;
    return stain;
}

/// How far the deepest node would have to move, up or aside, to be out of the space of the table and below
/// it, m; 0 if none is there. Cloth that hangs from an edge may swing under it a little.
double Spill::deepestInTable() const {
    double deepest = 0;
    const double top = table_.position.y() + table_.halfExtents.y();
    for (int n = 0; n < cloth().body().m_nodes.size(); ++n) {
        const btVector3& place = cloth().body().m_nodes[n].m_x;
        const double toEdge =
            table_.halfExtents.x() - std::max(std::abs(double(place.x())), std::abs(double(place.z())));
        deepest = std::max(deepest, std::min(toEdge, top - double(place.y())));
    }
    return deepest;
}

std::vector<Column> Spill::columns() const {
    return {{"stain_radius_m", 4}, {"roundness", 3}};
}

std::vector<double> Spill::row() const {
    const Stain now = stain();
    return {now.radius(), now.roundness()};
}

std::vector<Column> Spill::reportColumns() const {
    return {{"time_s", 2},    {"water_time_s", 0},      {"poured_g", 2}, {"stain_radius_m", 4},
            {"roundness", 3}, {"saturation_within", 3}, {"dripped_g", 3}};
}

std::vector<double> Spill::reportRow() const {
    const Stain now = stain();
    return {time(),
            waterTime(time()),
            1e3 * poured(),
            now.radius(),
            now.roundness(),
            now.meanSaturation,
            1e3 * cloth().wet().ledger().dripped};
}

std::string Spill::status() const {
    return (time() < settlingTime ? "the cloth comes to rest, "
            : emptyAt_ > 0        ? "the stain spreads, "
                                  : "the jug pours, ") +
           timeText(1);
}

void Spill::adorn(viewer::Picture& picture) const {
    if (pouringRate_ > 0) showJug(picture);
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << 1e3 * poured() << " g poured; stain of "
         << 100 * stain().radius() << " cm radius";
    if (emptyAt_ > 0) text << ", " << waterTime(time() - emptyAt_) / 60 << " min after";
    picture.caption.push_back(text.str());
}

void Spill::showJug(viewer::Picture& picture) const {
    const Eigen::Vector3f china(0.75f, 0.74f, 0.70f), spout = spout_.cast<float>();
    const auto piece = [&](const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius) {
        picture.rods.push_back({spout + from, spout + to, radius, china, viewer::Material::paint});
    };
    piece({0.08f, 0.02f, 0}, {0.20f, 0.09f, 0}, 0.055f);
    piece({0.02f, 0.01f, 0}, {0.10f, 0.02f, 0}, 0.016f);
    // The thread of water, as one drop that is drawn out over all of its way while the picture is exposed.
    const float fall = spout.y() - float(table_.position.y() + table_.halfExtents.y());
    picture.drops.push_back({spout - Eigen::Vector3f(0, fall / 2, 0), {0, -120 * fall, 0}, 0.005f});
}

std::optional<std::string> Spill::moment() const {
    const bool afterSettling = frames() == int(std::lround(settlingTime / frameTime));
    const bool pouring = frames() == int(std::lround((settlingTime + 1) / frameTime));
    return afterSettling || pouring ? momentName() : StagedScene::moment();
}

std::string Spill::remarks() const {
    std::ostringstream text;
    text << "The air is sealed off; water runs " << cloth().waterSpeed()
         << " times as fast as the cloth moves. Stained is what is more than a tenth saturated.\nThe jug was "
         << (emptyAt_ > 0 ? "empty" : "not empty") << " after " << std::fixed << std::setprecision(2)
         << std::max(0.0, (emptyAt_ > 0 ? emptyAt_ : time()) - settlingTime) << " s.\n";
    return text.str();
}

void Spill::check(std::vector<std::string>& list) const {
    const auto expect = [&](bool good, const std::string& what, double value) {
        if (!good) list.push_back(what + ": " + std::to_string(value));
    };
    expect(deepestInTable() < deepestAllowed, "the cloth is inside the table, m", deepestInTable());
    const Ledger ledger = cloth().wet().ledger();
    expect(std::abs(ledger.supplied - poured()) <= 1e-9, "something besides the jug brought, kg",
           ledger.supplied - poured());
    if (emptyAt_ == 0) return;
    expect(std::abs(poured() - pouredMass) < 0.01 * pouredMass,
           "the cloth did not get what was in the jug, but, kg", poured());
    expect(largestShrinkage_ < 0.01, "the stain shrank by the share", largestShrinkage_);
    // In a fabric that wicks better one way a stain is an ellipse.
    const double expected = std::sqrt(cloth().fabric().permeabilityWarp / cloth().fabric().permeabilityWeft);
    const double round = stain().roundness() / expected;
    expect(round > 0.85 && round < 1.18, "the stain is not as round as the fabric wicks", round);
}

}  // namespace drench::demo
