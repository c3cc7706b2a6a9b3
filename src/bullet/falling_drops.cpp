#include "drench/falling_drops.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "layer.h"
#include "vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

constexpr double longestFall = 20;  // s
// A drop starts on the cloth that it leaves and must not land there at once.
constexpr double clearAfter = 0.02;  // m of fall

/// Where a way through the air meets a sheet.
struct Hit {
    double fraction;  // of the way
    int face;
    Eigen::Vector3d weights;  // of the face's corners
};

/// Moeller & Trumbore (1997), from both sides.
std::optional<Hit> meet(const btSoftBody::Face& face, const Eigen::Vector3d& from,
                        const Eigen::Vector3d& way) {
    const Eigen::Vector3d origin = toEigen(face.m_n[0]->m_x);
    const Eigen::Vector3d one = toEigen(face.m_n[1]->m_x) - origin, two = toEigen(face.m_n[2]->m_x) - origin;
    const Eigen::Vector3d across = way.cross(two);
    const double volume = one.dot(across);
    if (std::abs(volume) < 1e-15 * way.norm() * one.norm() * two.norm()) return std::nullopt;
    const Eigen::Vector3d offset = from - origin, turned = offset.cross(one);
    const double u = offset.dot(across) / volume, v = way.dot(turned) / volume, t = two.dot(turned) / volume;
    if (u < 0 || v < 0 || u + v > 1 || t < 0 || t > 1) return std::nullopt;
    return Hit{t, 0, {1 - u - v, u, v}};
}

std::optional<Hit> meet(const btSoftBody& body, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    btVector3 low, high;
    body.getAabb(low, high);
    const Eigen::AlignedBox3d box(toEigen(low), toEigen(high));
    Eigen::AlignedBox3d path(from);
    path.extend(to);
    if (!box.intersects(path)) return std::nullopt;
    std::optional<Hit> first;
    for (int f = 0; f < body.m_faces.size(); ++f) {
        const auto hit = meet(body.m_faces[f], from, to - from);
        if (!hit || (first && hit->fraction >= first->fraction)) continue;
        first = hit;
        first->face = f;
    }
    return first;
}

}  // namespace

struct FallingDrops::Sheets {
    std::vector<std::weak_ptr<WetCloth::Layer>> all;
};

FallingDrops::FallingDrops(btSoftRigidDynamicsWorld& world)
    : world_(world), sheets_(std::make_unique<Sheets>()) {}

FallingDrops::~FallingDrops() = default;

void FallingDrops::add(WetCloth& cloth) {
    sheets_->all.push_back(cloth.layer_);
}

void FallingDrops::takeDrops() {
    for (const auto& sheet : sheets_->all) {
        const auto layer = sheet.lock();
        if (!layer) continue;
        for (const Drop& drop : layer->drops)
            flights_.push_back({drop.position, drop.velocity, drop.mass * double(drop.count), 0});
        layer->drops.clear();
    }
}

void FallingDrops::step(double dt) {
    if (!(dt >= 0) || !std::isfinite(dt))
        throw std::invalid_argument("drench: drops cannot fall for " + std::to_string(dt) +
                                    " s; give a finite time of at least 0 s");
    takeDrops();
    landed_.clear();
    const Eigen::Vector3d gravity = toEigen(world_.getWorldInfo().m_gravity);
    const auto done = [&](Flight& flight) {
        const Eigen::Vector3d to = flight.position + flight.velocity * dt + 0.5 * gravity * dt * dt;
        if (land(flight, to)) return true;
        flight.position = to;
        flight.velocity += gravity * dt;
        flight.age += dt;
        if (flight.age < longestFall) return false;
        massLost_ += flight.mass;
        return true;
    };
    flights_.erase(std::remove_if(flights_.begin(), flights_.end(), done), flights_.end());
}

bool FallingDrops::land(const Flight& flight, const Eigen::Vector3d& to) {
    const Eigen::Vector3d from = flight.position;
    SolidRay ray(toBullet(from), toBullet(to));
    world_.rayTest(ray.m_rayFromWorld, ray.m_rayToWorld, ray);
    double nearest =
        ray.hasHit() ? double(ray.m_closestHitFraction) : std::numeric_limits<double>::infinity();

    std::shared_ptr<WetCloth::Layer> wetted;
    Hit place{};
    for (const auto& sheet : sheets_->all) {
        const auto layer = sheet.lock();
        if (!layer || !layer->isInWorld()) continue;
        // Fallen less than that, it still touches the cloth that it left.
        if (flight.velocity.norm() * flight.age < 2 * clearAfter) continue;
        const auto hit = meet(layer->body, from, to);
        if (!hit || hit->fraction >= nearest) continue;
        nearest = hit->fraction;
        wetted = layer;
        place = *hit;
    }
    if (wetted) {
        const btSoftBody::Face& face = wetted->body.m_faces[place.face];
        Supply& drops = wetted->account("drops");
        for (int corner = 0; corner < 3; ++corner)
            drops.addFilm(static_cast<std::size_t>(indexOf(wetted->body, face.m_n[corner])),
                          flight.mass * place.weights[corner], flight.velocity);
        massOnSheets_ += flight.mass;
        return true;
    }
    if (!ray.hasHit()) return false;
    landed_.push_back({from + nearest * (to - from), flight.mass, ray.m_collisionObject});
    massElsewhere_ += flight.mass;
    return true;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
