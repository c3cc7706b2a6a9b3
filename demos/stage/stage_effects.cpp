#include "stage/stage_effects.h"

#include <algorithm>
#include <cmath>

namespace drench::demo {

namespace {

// Around the target of the camera, down to the ground; more behind it than in front, because drops close to
// the camera would look as large as posts.
Eigen::AlignedBox3d showerOf(const SceneDescription& scene) {
    constexpr double narrowest = 1.5, widest = 6, height = 0.7,
                     behind = 0.2;  // the last two relative to the half width
    const double half = std::clamp(0.95 * double(scene.camera.distance), narrowest, widest);
    const Eigen::Vector3d target = scene.camera.target.cast<double>(),
                          middle = target + behind * half * scene.camera.forward().cast<double>();
    double ground = 0;
    for (const SolidDescription& solid : scene.solids)
        if (solid.shape == SolidDescription::Shape::ground) ground = solid.position.y();
    const double top = std::max(target.y(), ground) + height * half;
    return {Eigen::Vector3d(middle.x() - half, ground, middle.z() - half),
            Eigen::Vector3d(middle.x() + half, top, middle.z() + half)};
}

// Fraction of the sunlight that passes the clouds of rain of this intensity, mm/h (assumed).
double sunshineIn(double rain) {
    constexpr double min = 0.24, half = 8;
    return min + (1 - min) * std::exp2(-rain / half);
}

}  // namespace

StageEffects::StageEffects(const btCollisionWorld& world, const SceneDescription& description)
    : world_(world),
      shower_(showerOf(description)),
      sunshine_(sunshineIn(description.water ? description.weather.rain : 0)) {
    limits_.seed = description.seed;
    limits_.streaks = 4500;
    limits_.spots = 3000;
}

void StageEffects::setPools(const std::vector<StageSource>& sources) {
    std::vector<Eigen::AlignedBox3d> pools;
    for (const StageSource& source : sources)
        if (const auto* pool = std::get_if<PoolDescription>(&source.description().water);
            pool && pool->isBounded())
            pools.emplace_back(Eigen::Vector3d(pool->from.x(), pool->bottom, pool->from.y()),
                               Eigen::Vector3d(pool->to.x(), pool->level, pool->to.y()));
    effects_->setPools(std::move(pools));
}

// Clouds appear and disappear gradually.
void StageEffects::cloudOver(double rain, double frameTime) {
    constexpr double gathering = 1.5;  // s
    sunshine_ += (sunshineIn(rain) - sunshine_) * (1 - std::exp(-frameTime / gathering));
}

void StageEffects::step(double frameTime, double time, const Weather& weather,
                        const std::vector<StageSource>& sources,
                        const std::vector<std::unique_ptr<SceneCloth>>& sheets, const FallingDrops* drops) {
    cloudOver(weather.rain, frameTime);
    for (const StageSource& source : sources)
        if (const auto nozzle = source.nozzle(time, frameTime)) nozzles_.push_back(*nozzle);
    const bool drips = drops && (!drops->inFlight().empty() || !drops->landed().empty());
    if (!effects_ && !drips && nozzles_.empty() && !(weather.rain > 0)) return;
    if (!effects_) effects_ = std::make_unique<WaterEffects>(world_, limits_);
    setPools(sources);
    effects_->rain(weather.rain, velocityOfRain(weather), shower_);
    for (const Nozzle& nozzle : nozzles_) effects_->spray(nozzle);
    nozzles_.clear();
    if (drops) effects_->follow(*drops);
    if (sheets.empty()) return effects_->step(frameTime, Air());
    effects_->step(frameTime, sheets.front()->wet().air(), sheets.front()->waterSpeed());
}

void StageEffects::show(viewer::Picture& picture) const {
    picture.sunshine = float(sunshine_);
    if (effects_) effects_->show(picture);
}

}  // namespace drench::demo
