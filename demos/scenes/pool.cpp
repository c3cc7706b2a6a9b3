#include "scenes/pool.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "checks/text.h"
#include "scenes/scene_texts.h"
#include "world/vectors.h"

namespace drench::demo {

namespace {

constexpr double barLow = 0.64;                              // m, of the bar
constexpr double lowersAt = 0.5, liftsAt = 11, moves = 2.5;  // s: when it begins to, and for how long
constexpr double barRadius = 0.012;                          // m

/// From 0 to 1, gently at both ends.
double eased(double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double levelOf(const SceneDescription& scene) {
    return std::get<PoolDescription>(scene.sources.front().water).level;
}

}  // namespace

Dip::Dip(const SceneOptions& options)
    : StagedScene(fitted(sceneFile("pool"), options), {60, 120}),
      waterLevel_(levelOf(sceneFile("pool"))),
      barHigh_(cloth().madeFrom().corner.y()) {
    for (int n = 0; n < cloth().body().m_nodes.size(); ++n) {
        const btSoftBody::Node& node = cloth().body().m_nodes[n];
        if (node.m_im > 0) continue;
        held_.push_back(n);
        fromBar_.push_back(node.m_x - btVector3(0, btScalar(barHigh_), 0));
    }
}

double Dip::barHeight() const {
    const double down = eased((time() - lowersAt) / moves) - eased((time() - liftsAt) / moves);
    return barHigh_ + (barLow - barHigh_) * down;
}

void Dip::direct() {
    const btVector3 bar(0, btScalar(barHeight()), 0);
    for (std::size_t i = 0; i < held_.size(); ++i) cloth().body().m_nodes[held_[i]].m_x = bar + fromBar_[i];
}

void Dip::measure() {
    if (time() <= liftsAt) saturationUnderWater_ = meanSaturation();
}

/// Of the lowest point under the surface, m; below 0 while it is above.
double Dip::depth() const {
    return waterLevel_ - cloth().lowest();
}

double Dip::meanSaturation() const {
    return cloth().wet().moisture().meanSaturation();
}

std::vector<Column> Dip::columns() const {
    return {{"bar_m", 3}, {"depth_m", 3}, {"saturation", 3}, {"mass_kg", 4}, {"held_g", 2}, {"dripped_g", 2}};
}

std::vector<double> Dip::row() const {
    return {barHeight(),
            depth(),
            meanSaturation(),
            cloth().mass(),
            1e3 * cloth().wet().waterMass(),
            1e3 * cloth().wet().ledger().dripped};
}

std::string Dip::doing() const {
    if (time() < lowersAt) return "dry";
    if (time() < lowersAt + moves) return "dry above the water, wet below";
    if (time() < liftsAt + frameTime / 2)
        return "under water, pores " + std::to_string(int(100 * meanSaturation())) + " % full";
    return "wet";
}

std::string Dip::status() const {
    return doing() + ", " + timeText(1);
}

void Dip::adorn(viewer::Picture& picture) const {
    showBar(picture);
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << doing() << "; cloth " << 1e3 * cloth().wet().dryMass()
         << " g, water " << 1e3 * cloth().wet().waterMass() << " g";
    if (const double dripped = cloth().wet().ledger().dripped; dripped > 0)
        text << ", dripped " << 1e3 * dripped << " g";
    picture.caption.push_back(text.str());
}

void Dip::showBar(viewer::Picture& picture) const {
    const float y = float(barHeight()) + 0.03f, reach = float(cloth().madeFrom().warp.norm()) / 2 + 0.05f;
    picture.rods.push_back({{-reach, y, 0}, {reach, y, 0}, float(barRadius), {0.30f, 0.22f, 0.15f}});
    for (const int node : held_) {
        const Eigen::Vector3f clip = pictureVector(cloth().body().m_nodes[node].m_x);
        picture.rods.push_back(
            {clip, {clip.x(), y, clip.z()}, 0.006f, {0.5f, 0.5f, 0.5f}, viewer::Material::metal});
    }
    for (const float x : {-reach + 0.02f, reach - 0.02f})
        picture.rods.push_back({{x, y, 0}, {x, 2, 0}, 0.003f, {0.4f, 0.4f, 0.4f}, viewer::Material::metal});
}

void Dip::check(std::vector<std::string>& list) const {
    const Ledger ledger = cloth().wet().ledger();
    if (time() < liftsAt + moves) return;
    if (!(saturationUnderWater_ > 0.97))
        list.push_back(
            textOf("under water the pores were filled to ", sixDigits(saturationUnderWater_), " only"));
    if (!(meanSaturation() > 0.9))
        list.push_back(textOf("at the end the pores are filled to ", sixDigits(meanSaturation()), " only"));
    if (!(ledger.dripped > 0 && ledger.returned > 0))
        list.emplace_back("nothing ran back to the pool, or nothing dripped");
    double lifted = 0;
    for (int n = 0; n < cloth().body().m_nodes.size(); ++n) lifted += cloth().wet().nodeMass(n);
    const double owed = cloth().wet().dryMass() + ledger.supplied - ledger.returned - ledger.dripped;
    if (std::abs(lifted - owed) > 1e-6 * owed)
        list.push_back(
            textOf("the nodes weigh ", sixDigits(lifted), " kg instead of ", sixDigits(owed), " kg"));
}

}  // namespace drench::demo
