#include "spill.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>

#include "../angles.h"
#include "../pictures.h"

namespace drench::demo {

namespace {

constexpr double tableSide = 0.8;
constexpr double tableHeight = 0.75;  // m, of its top
constexpr double tableThickness = 0.05;
constexpr double clothSide = 1.1;
constexpr double dropHeight = 0.015;  // m, of the cloth above the table
constexpr double restDamping = 3;     // 1/s
constexpr int mostSubsteps = 12;      // the cloth lies; stiffer links would not show
constexpr double waterSpeed = 20;     // ten minutes of wicking in half a minute
constexpr double settlingTime = 1.5;  // s, dry
constexpr double pouringTime = 3;     // s
constexpr double pouredMass = 0.045;  // kg; three times that would soak more cloth than lies on the table
constexpr double jugHeight = 0.3;     // m, of the spout above the table
constexpr double streamHalfAngle = 0.35;
constexpr double streamSpeed = 1;  // m/s
constexpr double stained = 0.1;    // saturation from which on cloth counts as stained
constexpr double deepestAllowed = 0.01;
constexpr int framesPerRow = 120;

}  // namespace

double Spill::Stain::radius() const {
    return std::sqrt(area / pi);
}

double Spill::Stain::roundness() const {
    return extentWeft > 0 ? extentWarp / extentWeft : std::numeric_limits<double>::quiet_NaN();
}

Spill::Spill(const SceneOptions& options) : TimedScene(options, 34) {
    bullet_->addGround(0);
    addTable();
    addCloth(options);
    chooseSubsteps(cloth_->stepBound(), mostSubsteps);
    damp(*sheet_, restDamping);
    rows_.columns = {{"time_s", 2},    {"water_time_s", 0},      {"poured_g", 2}, {"stain_radius_m", 4},
                     {"roundness", 3}, {"saturation_within", 3}, {"dripped_g", 3}};
}

Spill::~Spill() {
    cloth_.reset();
    bullet_->removeSoftBody(*sheet_);
}

void Spill::addTable() {
    table_ =
        &bullet_->addBox({0, btScalar(tableHeight - tableThickness / 2), 0},
                         {btScalar(tableSide / 2), btScalar(tableThickness / 2), btScalar(tableSide / 2)});
}

void Spill::addCloth(const SceneOptions& options) {
    const int nodes = options.resolution > 0 ? options.resolution : 45;
    const Corners corners =
        flatCorners({btScalar(-clothSide / 2), btScalar(tableHeight + dropHeight), btScalar(-clothSide / 2)},
                    {btScalar(clothSide), 0, 0}, {0, 0, btScalar(clothSide)});
    sheet_ = makeSheet(bullet_->worldInfo(), fabric_, corners, nodes, nodes);
    bullet_->addSoftBody(*sheet_);
    SheetSettings settings;
    settings.waterSpeed = waterSpeed;
    cloth_ = std::make_unique<WetCloth>(bullet_->world(), *sheet_, fabric_, settings);
    cloth_->air().vapourExchange = 0;
    jug_ = &cloth_->add(Spray({0, tableHeight + jugHeight, 0}, {0, -1, 0}, 0));
    jug_->halfAngle = streamHalfAngle;
    jug_->speed = streamSpeed;
}

void Spill::advance() {
    pour();
    cloth_->air().wind = {0, 0, windSpeed_};
    stepWorld();
    if (jug_->rate == 0 && emptyAt_ > 0) {
        const double area = stain().area;
        if (largestStain_ > 0) largestShrinkage_ = std::max(largestShrinkage_, 1 - area / largestStain_);
        largestStain_ = std::max(largestStain_, area);
    }
    if (isDue(framesPerRow)) rows_.rows.push_back(reportRow());
}

/// Pours until the cloth has got what was in the jug: nodes fill the round stream only roughly, so that a little of it
/// misses the cloth. The last frame pours no more than is left.
void Spill::pour() {
    jug_->rate = 0;
    const double left = pouredMass - poured();
    if (time_ < settlingTime - frameTime / 2 || emptyAt_ > 0) return;
    if (left < 1e-4 * pouredMass) {
        emptyAt_ = time_;
        return;
    }
    // The jug runs with the water: in its time the stream is slower.
    const double steady = pouredMass / (pouringTime * waterSpeed);
    jug_->rate = std::min(steady, left / (frameTime * waterSpeed));
}

Spill::Stain Spill::stain() const {
    const Moisture& moisture = cloth_->moisture();
    const auto& places = cloth_->materialCoordinates();
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
    for (int n = 0; n < sheet_->m_nodes.size(); ++n) {
        const btVector3& place = sheet_->m_nodes[n].m_x;
        const double toEdge =
            tableSide / 2 - std::max(std::abs(double(place.x())), std::abs(double(place.z())));
        deepest = std::max(deepest, std::min(toEdge, tableHeight - double(place.y())));
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

std::vector<double> Spill::reportRow() const {
    const Stain now = stain();
    return {time_,
            time_ * waterSpeed,
            1e3 * poured(),
            now.radius(),
            now.roundness(),
            now.meanSaturation,
            1e3 * cloth_->ledger().dripped};
}

std::string Spill::status() const {
    return (time_ < settlingTime ? "the cloth comes to rest, "
            : emptyAt_ > 0       ? "the stain spreads, "
                                 : "the jug pours, ") +
           timeText(1);
}

viewer::Picture Spill::picture() const {
    viewer::Picture picture;
    picture.sheets.push_back(sheetMesh(*sheet_, *cloth_));
    showTable(picture);
    if (jug_->rate > 0) showJug(picture);
    picture.camera.target = {0, 0.60f, 0};
    picture.camera.distance = 1.9f;
    picture.camera.yaw = 0.45f;
    picture.camera.pitch = 0.72f;
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << 1e3 * poured() << " g poured; stain of "
         << 100 * stain().radius() << " cm radius";
    if (emptyAt_ > 0) text << ", " << (time_ - emptyAt_) * waterSpeed / 60 << " min after";
    picture.caption.push_back(text.str());
    return picture;
}

void Spill::showTable(viewer::Picture& picture) const {
    const Eigen::Vector3f wood(0.30f, 0.19f, 0.11f);
    viewer::Box top = box(*table_);
    top.albedo = wood;
    top.material = viewer::Material::wood;
    // Cloth bends round the edge in straight pieces, which would let the edge peep through.
    top.halfExtents.array() -= 0.008f;
    picture.boxes.push_back(top);
    const float aside = top.halfExtents.x() - 0.05f;
    for (const float x : {-aside, aside})
        for (const float z : {-aside, aside})
            picture.rods.push_back({{x, 0, z}, {x, top.centre.y(), z}, 0.025f, wood});
}

void Spill::showJug(viewer::Picture& picture) const {
    const Eigen::Vector3f china(0.75f, 0.74f, 0.70f);
    const Eigen::Vector3f spout = jug_->origin.cast<float>();
    picture.rods.push_back({spout + Eigen::Vector3f(0.08f, 0.02f, 0),
                            spout + Eigen::Vector3f(0.20f, 0.09f, 0), 0.055f, china,
                            viewer::Material::paint});
    picture.rods.push_back({spout + Eigen::Vector3f(0.02f, 0.01f, 0),
                            spout + Eigen::Vector3f(0.10f, 0.02f, 0), 0.016f, china,
                            viewer::Material::paint});
    // The thread of water, as one drop that is drawn out over all of its way while the picture is exposed.
    const float fall = spout.y() - float(tableHeight);
    picture.drops.push_back({spout - Eigen::Vector3f(0, fall / 2, 0), {0, -120 * fall, 0}, 0.005f});
}

std::optional<std::string> Spill::moment() const {
    const bool afterSettling = frames_ == int(std::lround(settlingTime / frameTime));
    const bool pouring = frames_ == int(std::lround((settlingTime + 1) / frameTime));
    if (!isDue(2 * framesPerRow) && !afterSettling && !pouring) return std::nullopt;
    return momentName("spill");
}

void Spill::report(std::ostream& out) const {
    print(out, rows_);
    out << "\nThe air is sealed off; water runs " << waterSpeed
        << " times as fast as the cloth moves. Stained is what is more than a tenth saturated.\nThe jug was "
        << (emptyAt_ > 0 ? "empty" : "not empty") << " after " << std::fixed << std::setprecision(2)
        << std::max(0.0, (emptyAt_ > 0 ? emptyAt_ : time_) - settlingTime) << " s.\n";
    reportSteps(out, cloth_->stepBound());
}

std::vector<std::string> Spill::failures() const {
    std::vector<std::string> list;
    const auto check = [&](bool good, const std::string& what, double value) {
        if (!good) list.push_back(what + ": " + std::to_string(value));
    };
    check(deepestInTable() < deepestAllowed, "the cloth is inside the table, m", deepestInTable());
    const Ledger ledger = cloth_->ledger();
    check(std::abs(ledger.imbalance()) <= 1e-6 * ledger.supplied, "the ledger is open by, kg",
          ledger.imbalance());
    check(std::abs(ledger.supplied - poured()) <= 1e-9, "something besides the jug brought, kg",
          ledger.supplied - poured());
    if (emptyAt_ == 0) return list;
    check(std::abs(poured() - pouredMass) < 0.01 * pouredMass,
          "the cloth did not get what was in the jug, but, kg", poured());
    check(largestShrinkage_ < 0.01, "the stain shrank by the share", largestShrinkage_);
    // In a fabric that wicks better one way a stain is an ellipse.
    const double expected = std::sqrt(fabric_.permeabilityWarp / fabric_.permeabilityWeft);
    const double round = stain().roundness() / expected;
    check(round > 0.85 && round < 1.18, "the stain is not as round as the fabric wicks", round);
    return list;
}

}  // namespace drench::demo
