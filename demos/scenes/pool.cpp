#include "pool.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "../pictures.h"

namespace drench::demo {

namespace {

constexpr double width = 0.6;   // m, of the sheet
constexpr double height = 0.5;  // m
constexpr double waterLevel = 0.72;
constexpr double waterBottom = 0.04;
constexpr double tankHalfLength = 0.50, tankHalfWidth = 0.26;  // m, inside
constexpr double barHigh = 1.38, barLow = 0.64;                // m, of the bar
constexpr double lowersAt = 0.5, liftsAt = 11, moves = 2.5;    // s: when it begins to, and for how long
constexpr int heldNodes = 2;                                   // of each clip
constexpr int mostSubsteps = 40;
constexpr double barRadius = 0.012;

/// From 0 to 1, gently at both ends.
double eased(double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace

Dip::Dip(const SceneOptions& options) : TimedScene(options, 26) {
    const int nodes = options.resolution > 0 ? options.resolution : 36;
    bullet_->addGround(waterBottom);
    const Corners corners = flatCorners({btScalar(-width / 2), btScalar(barHigh), 0}, {btScalar(width), 0, 0},
                                        {0, btScalar(-height), 0});
    cloth_ = std::make_unique<SceneCloth>("sheet", *bullet_, fabric_, corners, nodes,
                                          std::max(2, int(std::lround(nodes * height / width))));
    cloth_->wet().air().vapourExchange = 0;  // so that the ledger tells of the dip alone
    for (int i = 0; i < heldNodes; ++i) held_.insert(held_.end(), {i, nodes - 1 - i});
    for (const int node : held_) {
        cloth_->body().m_nodes[node].m_im = 0;
        fromBar_.push_back(cloth_->body().m_nodes[node].m_x - btVector3(0, btScalar(barHigh), 0));
    }
    Pool pool(waterLevel);
    pool.from = {-tankHalfLength, -tankHalfWidth};
    pool.to = {tankHalfLength, tankHalfWidth};
    cloth_->wet().add(pool);
    drops_ = std::make_unique<FallingDrops>(bullet_->world());
    drops_->add(cloth_->wet());
    effects_ = std::make_unique<WaterEffects>(bullet_->world(), WaterEffectsLimits{options.seed});
    effects_->setPools({{Eigen::Vector3d(-tankHalfLength, 0, -tankHalfWidth),
                         Eigen::Vector3d(tankHalfLength, waterLevel, tankHalfWidth)}});
    chooseSubsteps(cloth_->wet().stepBound(), mostSubsteps);
    table_.columns = columns();
    table_.columns.insert(table_.columns.begin(), {"time_s", 1});
}

Dip::~Dip() = default;

double Dip::barHeight() const {
    const double down = eased((time_ - lowersAt) / moves) - eased((time_ - liftsAt) / moves);
    return barHigh + (barLow - barHigh) * down;
}

void Dip::moveBar() {
    const btVector3 bar(0, btScalar(barHeight()), 0);
    for (std::size_t i = 0; i < held_.size(); ++i) cloth_->body().m_nodes[held_[i]].m_x = bar + fromBar_[i];
}

void Dip::advance() {
    cloth_->wet().air().wind = {0, 0, windSpeed_};
    moveBar();
    stepWorld();
    drops_->step(frameTime);
    effects_->follow(*drops_);
    effects_->step(frameTime, cloth_->wet().air());
    if (time_ <= liftsAt) saturationUnderWater_ = meanSaturation();
    if (!isDue(60)) return;
    table_.rows.push_back(row());
    table_.rows.back().insert(table_.rows.back().begin(), time_);
}

/// Of the lowest point under the surface, m; below 0 while it is above.
double Dip::depth() const {
    return waterLevel - cloth_->lowest();
}

double Dip::meanSaturation() const {
    return cloth_->wet().moisture().meanSaturation();
}

std::vector<Column> Dip::columns() const {
    return {{"bar_m", 3}, {"depth_m", 3}, {"saturation", 3}, {"mass_kg", 4}, {"held_g", 2}, {"dripped_g", 2}};
}

std::vector<double> Dip::row() const {
    return {barHeight(),
            depth(),
            meanSaturation(),
            cloth_->mass(),
            1e3 * cloth_->wet().waterMass(),
            1e3 * cloth_->wet().ledger().dripped};
}

std::string Dip::doing() const {
    if (time_ < lowersAt) return "dry";
    if (time_ < lowersAt + moves) return "dry above the water, wet below";
    if (time_ < liftsAt + frameTime / 2)
        return "under water, pores " + std::to_string(int(100 * meanSaturation())) + " % full";
    return "wet";
}

std::string Dip::status() const {
    return doing() + ", " + timeText(1);
}

viewer::Picture Dip::picture() const {
    viewer::Picture picture;
    picture.sheets.push_back(sheetMesh(cloth_->body(), cloth_->wet()));
    viewer::Water water;
    water.centre = {0, float(waterLevel + waterBottom) / 2, 0};
    water.halfExtents = {float(tankHalfLength), float(waterLevel - waterBottom) / 2, float(tankHalfWidth)};
    water.time = float(time_);
    picture.waters.push_back(water);
    showTank(picture);
    showBar(picture);
    effects_->show(picture);
    picture.camera.target = {0, 0.76f, 0};
    picture.camera.distance = 2.15f;
    picture.camera.yaw = 0.38f;
    picture.camera.pitch = 0.26f;
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << doing() << "; cloth " << 1e3 * cloth_->wet().dryMass()
         << " g, water " << 1e3 * cloth_->wet().waterMass() << " g";
    if (const double dripped = cloth_->wet().ledger().dripped; dripped > 0)
        text << ", dripped " << 1e3 * dripped << " g";
    picture.caption.push_back(text.str());
    return picture;
}

/// A tray with four posts and a rim, as the glass itself is not to be seen.
void Dip::showTank(viewer::Picture& picture) const {
    const Eigen::Vector3f metal(0.33f, 0.34f, 0.35f);
    constexpr float rim = float(waterLevel) + 0.05f, radius = 0.008f;
    constexpr float x = float(tankHalfLength) + radius, z = float(tankHalfWidth) + radius;
    viewer::Box tray;
    tray.centre = {0, float(waterBottom) / 2, 0};
    tray.halfExtents = {x, float(waterBottom) / 2, z};
    tray.albedo = {0.50f, 0.49f, 0.46f};
    picture.boxes.push_back(tray);
    const Eigen::Vector3f corners[] = {{-x, 0, -z}, {x, 0, -z}, {x, 0, z}, {-x, 0, z}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector3f up(0, rim, 0);
        picture.rods.push_back({corners[i], corners[i] + up, radius, metal, viewer::Material::metal});
        picture.rods.push_back(
            {corners[i] + up, corners[(i + 1) % 4] + up, radius, metal, viewer::Material::metal});
    }
}

void Dip::showBar(viewer::Picture& picture) const {
    const float y = float(barHeight()) + 0.03f, reach = float(width) / 2 + 0.05f;
    picture.rods.push_back({{-reach, y, 0}, {reach, y, 0}, float(barRadius), {0.30f, 0.22f, 0.15f}});
    for (const int node : held_) {
        const Eigen::Vector3f clip = toEigen(cloth_->body().m_nodes[node].m_x);
        picture.rods.push_back(
            {clip, {clip.x(), y, clip.z()}, 0.006f, {0.5f, 0.5f, 0.5f}, viewer::Material::metal});
    }
    for (const float x : {-reach + 0.02f, reach - 0.02f})
        picture.rods.push_back({{x, y, 0}, {x, 2, 0}, 0.003f, {0.4f, 0.4f, 0.4f}, viewer::Material::metal});
}

std::optional<std::string> Dip::moment() const {
    if (!isDue(120)) return std::nullopt;
    return momentName("pool");
}

void Dip::report(std::ostream& out) const {
    print(out, table_);
    out << '\n';
    reportSteps(out, cloth_->wet().stepBound());
}

std::vector<std::string> Dip::failures() const {
    std::vector<std::string> list;
    const Ledger ledger = cloth_->wet().ledger();
    checkLedger(list, cloth_->wet());
    if (time_ < liftsAt + moves) return list;
    if (!(saturationUnderWater_ > 0.97))
        list.push_back("under water the pores were filled to " + std::to_string(saturationUnderWater_) +
                       " only");
    if (!(meanSaturation() > 0.9))
        list.push_back("at the end the pores are filled to " + std::to_string(meanSaturation()) + " only");
    if (!(ledger.dripped > 0 && ledger.returned > 0))
        list.push_back("nothing ran back to the pool, or nothing dripped");
    double lifted = 0;
    for (int n = 0; n < cloth_->body().m_nodes.size(); ++n) lifted += cloth_->wet().nodeMass(n);
    const double owed = cloth_->wet().dryMass() + ledger.supplied - ledger.returned - ledger.dripped;
    if (std::abs(lifted - owed) > 1e-6 * owed)
        list.push_back("the nodes weigh " + std::to_string(lifted) + " kg instead of " +
                       std::to_string(owed) + " kg");
    return list;
}

}  // namespace drench::demo
