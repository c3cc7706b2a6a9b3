#include "effects/water_effects.h"

#include <BulletSoftBody/btSoftBody.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "bullet/fluid/rigid_shelter.h"
#include "checks/checks.h"
#include "world/angles.h"
#include "world/vectors.h"

namespace drench::demo {

namespace {

const Eigen::Vector3d gravityVector(0, -9.81, 0);  // m/s2

constexpr double waterDensity = 1000;       // kg/m3
constexpr double exposure = 1.0 / 100;      // s, exposure time for streaks of rain
constexpr double sprayExposure = 1.0 / 50;  // s, the same for sprays
constexpr double streakWidth = 0.0016;      // m
constexpr double farDown = 100;             // m, distance below its region that rain falls
constexpr double shelterAbove = 30;         // m, height above the region in which a roof gives shelter
constexpr double sprayLife = 1.5;           // s
constexpr double finestDrop = 0.6e-3;       // m, radius below which drops of a spray are streaks
constexpr std::int64_t maxTogether = 4;
constexpr double dropsPerSecond = 1500;  // number that represents the water of a nozzle
constexpr double patchLength = 0.5;      // m, length of a wet spot along the air flow, for its drying

// Number of drops above 1 mm per cubic metre of rain (Marshall & Palmer 1948).
double dropsPerVolume(double intensity) {
    const double slope = 4.1 * std::pow(intensity, -0.21);  // 1/mm
    return 8000 / slope * std::exp(-slope);
}

double dropRadius(double mass) {
    return std::cbrt(3 * mass / (4 * pi * waterDensity));
}

// Random numbers for the drops of sprays, which may be threads of water.
std::size_t jetThreads(const WaterEffectsLimits& limits) {
    return limits.drops / 8;
}

viewer::WaterDrop seen(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity, double radius) {
    return {position.cast<float>(), velocity.cast<float>(), float(radius)};
}

template <typename... Parts>
void require(bool holds, const Parts&... what) {
    if (!holds) refuse(what...);
}

template <typename Element, typename Condition>
void removeWhere(std::vector<Element>& list, Condition condition) {
    list.erase(std::remove_if(list.begin(), list.end(), condition), list.end());
}

}  // namespace

WaterEffects::WaterEffects(const btCollisionWorld& world, const WaterEffectsLimits& limits)
    : world_(world), limits_(limits), generator_(limits.seed), spots_(limits.spots) {}

void WaterEffects::rain(double intensity, const Eigen::Vector3d& velocity,
                        const Eigen::AlignedBox3d& region) {
    require(intensity >= 0 && std::isfinite(intensity), "rain of ", intensity,
            " mm/h is not possible; give a finite number of at least 0");
    require(velocity.allFinite() && velocity.y() < -0.1, "the velocity of rain is ", velocity,
            " m/s; give finite numbers, and y below -0.1");
    require(!region.isEmpty() && region.min().allFinite() && region.max().allFinite() && region.volume() > 0,
            "the region of the rain is empty or not finite; give it a volume");
    shower_.intensity = intensity;
    shower_.velocity = velocity;
    shower_.region = region;
}

void WaterEffects::spray(const Nozzle& nozzle) {
    require(nozzle.position.allFinite() && nozzle.direction.allFinite() && nozzle.direction.norm() > 0,
            "a nozzle is at ", nozzle.position, " m and points along ", nozzle.direction,
            "; give finite numbers, and a direction longer than 0");
    require(nozzle.halfAngle >= 0 && nozzle.halfAngle <= pi / 2, "the half angle of a nozzle is ",
            nozzle.halfAngle, " rad; give 0 to pi/2");
    require(nozzle.speed > 0 && std::isfinite(nozzle.speed), "the speed of a nozzle is ", nozzle.speed,
            " m/s; give a finite number above 0");
    require(nozzle.rate >= 0 && std::isfinite(nozzle.rate), "the rate of a nozzle is ", nozzle.rate,
            " kg/s; give a finite number of at least 0");
    nozzles_.push_back(nozzle);
}

void WaterEffects::follow(const FallingDrops& drops) {
    falling_.clear();
    constexpr double frame = 1.0 / 60;  // s
    for (const FallingDrops::Flight& flight : drops.inFlight()) {
        if (falling_.size() >= limits_.drops) break;
        if (const Eigen::AlignedBox3d* const pool = poolRound(flight.position)) {
            const Eigen::Vector3d before = flight.position - frame * flight.velocity;
            if (!pool->contains(before))
                splash({flight.position.x(), pool->max().y(), flight.position.z()}, flight.velocity.norm());
            continue;
        }
        // Drops that fall together are drawn one behind the other, as a thread of water.
        const auto together = std::min<std::int64_t>(flight.count, maxTogether);
        for (std::int64_t i = 0; i < together && falling_.size() < limits_.drops; ++i)
            falling_.push_back(seen(flight.position - frame * double(i) / double(together) * flight.velocity,
                                    flight.velocity, dropRadius(flight.mass)));
    }
    for (const FallingDrops::Landing& landing : drops.landed()) {
        if (poolRound(landing.position) != nullptr) continue;
        splash(landing.position, 2.5);
        wet({landing.position, landing.object}, landing.mass);
    }
}

void WaterEffects::step(double frameTime, const Air& air, double waterSpeed) {
    require(frameTime >= 0 && std::isfinite(frameTime), "a frame of ", frameTime,
            " s is not possible; give a finite time of at least 0 s");
    require(waterSpeed >= 0 && std::isfinite(waterSpeed), "a water speed of ", waterSpeed,
            " is not possible; give 0 or more");
    spots_.keepOnlyIn(world_);
    findSheets();
    beginRain(frameTime);
    fallRain(frameTime);
    removeWhere(spray_, [&](Bead& drop) { return sprayEnds(drop, frameTime); });
    jets_.clear();
    for (const Nozzle& nozzle : nozzles_) emit(nozzle, frameTime);
    nozzles_.clear();
    flySplashes(frameTime);
    drift(frameTime, air);
    // Wet spots have one wet face only.
    const double speed = std::min(air.wind.norm(), 100.0);
    const double dried = evaporation(air, speed, patchLength).rate / 2 * frameTime * waterSpeed;
    spots_.dry(dried);
    openGround_.dry(dried);
}

// A number from 0 to below 1, the same on every machine.
double WaterEffects::random() {
    return double(generator_()) / 4294967296.0;
}

Eigen::Vector3d WaterEffects::randomDirection() {
    const double height = random(-1, 1), angle = random(0, 2 * pi), across = std::sqrt(1 - height * height);
    return {across * std::cos(angle), height, across * std::sin(angle)};
}

std::optional<WaterEffects::Hit> WaterEffects::hitBody(const Eigen::Vector3d& from,
                                                       const Eigen::Vector3d& to) const {
    SolidRay ray(toBullet(from), toBullet(to));
    world_.rayTest(ray.m_rayFromWorld, ray.m_rayToWorld, ray);
    if (!ray.hasHit()) return std::nullopt;
    return Hit{from + double(ray.m_closestHitFraction) * (to - from), ray.m_collisionObject};
}

std::optional<WaterEffects::Hit> WaterEffects::hitAnything(const Eigen::Vector3d& from,
                                                           const Eigen::Vector3d& to) const {
    std::optional<Hit> nearest = hitBody(from, to);
    for (const SheetCells& sheet : sheets_) {
        const Eigen::Vector3d end = nearest ? nearest->position : to;
        if (const auto fraction = sheet.firstMet(from, end))
            nearest = Hit{from + *fraction * (end - from), nullptr};
    }
    if (!nearest && poolRound(to) != nullptr) nearest = Hit{to, nullptr};
    return nearest;
}

const Eigen::AlignedBox3d* WaterEffects::poolRound(const Eigen::Vector3d& position) const {
    for (const Eigen::AlignedBox3d& pool : pools_)
        if (pool.contains(position)) return &pool;
    return nullptr;
}

// Only where there is falling water that they could stop.
void WaterEffects::findSheets() {
    sheets_.clear();
    if (rain_.empty() && spray_.empty() && nozzles_.empty() && !(shower_.intensity > 0)) return;
    const btCollisionObjectArray& objects = world_.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
        if (const btSoftBody* const sheet =
                btSoftBody::upcast(static_cast<const btCollisionObject*>(objects[i])))
            sheets_.emplace_back(*sheet);
}

void WaterEffects::beginRain(double frameTime) {
    if (!(shower_.intensity > 0)) return;
    const Eigen::Vector3d sides = shower_.region.sizes();
    const double fallTime = sides.y() / -shower_.velocity.y();
    const double number =
        std::min(dropsPerVolume(shower_.intensity) * shower_.region.volume(), double(limits_.streaks));
    if (!(number > 0)) return;
    const double massPerTime = shower_.intensity / 3600 * sides.x() * sides.z();
    // Slanting rain reaches the ground beside the middle of its region.
    Eigen::AlignedBox3d below = shower_.region;
    below.translate(fallTime / 2 * shower_.velocity);
    openGround_.rain(shower_.intensity / 3600 * frameTime, below);
    shower_.owed += number * frameTime / fallTime;
    for (; shower_.owed >= 1; shower_.owed -= 1)
        if (rain_.size() < limits_.streaks) beginDrop(massPerTime * fallTime / number, random(0, frameTime));
}

// A drop that crosses the region, unless a roof above stops it. It starts `age` seconds earlier, so that
// drops do not fall in rows.
void WaterEffects::beginDrop(double mass, double age) {
    const Eigen::Vector3d low = shower_.region.min(), high = shower_.region.max();
    const Eigen::Vector3d& velocity = shower_.velocity;
    const double fallTime = (high.y() - low.y()) / -velocity.y();
    // Chosen at half the height, so that slanting rain stays over its region.
    const Eigen::Vector3d middle(random(low.x(), high.x()), (low.y() + high.y()) / 2,
                                 random(low.z(), high.z()));
    const Eigen::Vector3d start = middle - velocity * (fallTime / 2 - age);
    if (hitBody(start - velocity * (shelterAbove / -velocity.y()), start)) return;
    const double longest = fallTime + farDown / -velocity.y();
    const std::optional<Hit> end = hitBody(start, start + velocity * longest);
    const double left = end ? (end->position - start).norm() / velocity.norm() : fallTime;
    // Sizes of drops vary by Marshall and Palmer's law.
    const double size = -std::log(1 - random());
    rain_.push_back({start, velocity, left, end ? end->body : nullptr, size * mass});
}

void WaterEffects::fallRain(double frameTime) {
    removeWhere(rain_, [&](RainDrop& drop) {
        const double time = std::min(frameTime, drop.left);
        const Eigen::Vector3d from = drop.position;
        drop.position += time * drop.velocity;
        drop.left -= time;
        for (const SheetCells& sheet : sheets_) {
            if (const auto fraction = sheet.firstMet(from, drop.position)) {
                splash(from + *fraction * (drop.position - from), 1.2);
                return true;
            }
        }
        if (const Eigen::AlignedBox3d* const pool = poolRound(drop.position)) {
            splash({drop.position.x(), pool->max().y(), drop.position.z()}, 2.5);
            return true;
        }
        if (drop.left > 0) return false;
        if (drop.body != nullptr) {
            splash(drop.position, 2.5);
            wet({drop.position, drop.body}, drop.mass);
        }
        return true;
    });
}

void WaterEffects::emit(const Nozzle& nozzle, double frameTime) {
    const Eigen::Vector3d axis = nozzle.direction.normalized();
    const int count = nozzle.rate > 0 ? int(std::ceil(dropsPerSecond * frameTime)) : 0;
    for (int i = 0; i < count && spray_.size() < limits_.drops - jetThreads(limits_); ++i) {
        const Eigen::Vector3d aside = axis.cross(randomDirection());
        const double angle = nozzle.halfAngle * std::sqrt(random());
        const Eigen::Vector3d direction = std::cos(angle) * axis + std::sin(angle) * aside.normalized();
        Bead drop{nozzle.position, nozzle.speed * random(0.75, 1.1) * direction, random(0.3e-3, 1.1e-3),
                  nozzle.rate * frameTime / count, sprayLife};
        if (!sprayEnds(drop, random(0, frameTime))) spray_.push_back(drop);
    }
    if (count == 0) return;
    showJet(nozzle);
    if (random() < 10 * frameTime)
        addPuff(nozzle.position + 0.3 * axis, 0.35 * nozzle.speed * axis, 0.02, 0.05);
}

// Water that still holds together near the nozzle: threads that diverge and end one after the other.
void WaterEffects::showJet(const Nozzle& nozzle) {
    constexpr int threads = 70;
    constexpr double breakUp = 0.08, spread = 0.7;  // s; fraction of the cone
    const Eigen::Vector3d axis = nozzle.direction.normalized();
    for (int i = 0; i < threads && jets_.size() < jetThreads(limits_); ++i) {
        const double angle = spread * nozzle.halfAngle * random() * random();
        const Eigen::Vector3d aside = axis.cross(randomDirection()).normalized();
        const Eigen::Vector3d direction = std::cos(angle) * axis + std::sin(angle) * aside;
        const double length = nozzle.speed * breakUp * random(0.3, 1);
        const Eigen::Vector3d end = nozzle.position + length * direction;
        if (hitAnything(nozzle.position, end)) continue;
        jets_.push_back(
            {nozzle.position.cast<float>(), end.cast<float>(), float(random(1.5e-3, 4e-3)), 0.6f});
    }
}

// Moves a drop of a spray. @return whether it has hit something, or is out of sight
bool WaterEffects::sprayEnds(Bead& drop, double time) {
    const Eigen::Vector3d from = drop.position;
    drop.position += time * drop.velocity + 0.5 * time * time * gravityVector;
    drop.velocity += time * gravityVector;
    drop.left -= time;
    const std::optional<Hit> hit = hitAnything(from, drop.position);
    if (!hit) return drop.left <= 0;
    wet(*hit, drop.mass);
    if (random() < 0.8) splash(hit->position, 0.6 * drop.velocity.norm());
    if (random() < 0.03) addPuff(hit->position, 0.05 * drop.velocity.norm() * randomDirection(), 0.012, 0.06);
    return true;
}

void WaterEffects::flySplashes(double frameTime) {
    removeWhere(splashes_, [&](Bead& drop) {
        drop.position += frameTime * drop.velocity + 0.5 * frameTime * frameTime * gravityVector;
        drop.velocity += frameTime * gravityVector;
        drop.left -= frameTime;
        return drop.left <= 0;
    });
}

// Mist slows down to the wind, spreads and thins out.
void WaterEffects::drift(double frameTime, const Air& air) {
    constexpr double slowing = 4;  // 1/s
    removeWhere(puffs_, [&](Puff& puff) {
        puff.velocity += (1 - std::exp(-slowing * frameTime)) * (air.wind - puff.velocity);
        puff.centre += frameTime * puff.velocity;
        puff.age += frameTime;
        return puff.age >= puff.life;
    });
}

// One to four small drops that vanish when they are back at their initial height.
void WaterEffects::splash(const Eigen::Vector3d& position, double vigour) {
    const int count = 1 + int(random(0, 4));
    for (int i = 0; i < count && splashes_.size() < limits_.drops; ++i) {
        const double angle = random(0, 2 * pi), outwards = vigour * random(0.08, 0.25);
        const double upwards = std::min(vigour * random(0.2, 0.5), 1.6);
        const Eigen::Vector3d velocity(outwards * std::cos(angle), upwards, outwards * std::sin(angle));
        splashes_.push_back(
            {position, velocity, random(0.3e-3, 0.9e-3), 0, 2 * upwards / -gravityVector.y()});
    }
}

void WaterEffects::wet(const Hit& hit, double mass) {
    if (hit.body != nullptr) spots_.wet(*hit.body, hit.position, mass, float(random()));
}

void WaterEffects::addPuff(const Eigen::Vector3d& centre, const Eigen::Vector3d& velocity, double radius,
                           double density) {
    if (puffs_.size() < limits_.puffs)
        puffs_.push_back({centre, velocity, 0, random(0.4, 0.9), radius, density});
}

void WaterEffects::show(viewer::Picture& picture) const {
    for (const RainDrop& drop : rain_)
        picture.streaks.push_back({drop.position.cast<float>(),
                                   (drop.position - exposure * drop.velocity).cast<float>(),
                                   float(streakWidth), 0.5f});
    picture.drops.insert(picture.drops.end(), falling_.begin(), falling_.end());
    for (const Bead& drop : splashes_)
        picture.drops.push_back(seen(drop.position, drop.velocity, drop.radius));
    picture.streaks.insert(picture.streaks.end(), jets_.begin(), jets_.end());
    for (const Bead& drop : spray_) {
        if (drop.radius > finestDrop)
            picture.drops.push_back(seen(drop.position, drop.velocity, drop.radius));
        else
            picture.streaks.push_back({drop.position.cast<float>(),
                                       (drop.position - sprayExposure * drop.velocity).cast<float>(),
                                       float(2 * drop.radius), 0.8f});
    }
    for (const Puff& puff : puffs_) {
        const double fraction = puff.age / puff.life;
        picture.mist.push_back({puff.centre.cast<float>(), float(puff.radius * (1 + 4 * fraction)),
                                float(puff.density * (1 - fraction) * std::min(1.0, 8 * fraction))});
    }
    spots_.show(picture);
    openGround_.show(picture);
}

}  // namespace drench::demo
