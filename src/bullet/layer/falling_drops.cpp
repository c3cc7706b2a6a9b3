#include "drench/falling_drops.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "bullet/layer/layer.h"
#include "bullet/world/gravity.h"
#include "bullet/world/soft_world.h"
#include "bullet/world/vectors.h"
#include "checks/checks.h"
#include "state/state_pass.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

constexpr double longestFall = 20;  // s
// A drop starts on the cloth that it leaves, and must not land there at once.
constexpr double clearance = 0.02;  // m

// Where the path of a drop hits a sheet.
struct Hit {
    double fraction;  // of the path, 0 to 1
    int face;
    Eigen::Vector3d weights;  // of the face's corners; at least 0, sum 1
};

// Moeller & Trumbore (1997), from both sides; an edge that two faces share belongs to both.
std::optional<Hit> meet(const btSoftBody& body, int f, const Eigen::Vector3d& from,
                        const Eigen::Vector3d& displacement) {
    const btSoftBody::Face& face = body.m_faces[f];
    const Eigen::Vector3d origin = toEigen(face.m_n[0]->m_x);
    const Eigen::Vector3d one = toEigen(face.m_n[1]->m_x) - origin, two = toEigen(face.m_n[2]->m_x) - origin;
    const Eigen::Vector3d across = displacement.cross(two);
    const double volume = one.dot(across);
    if (!(std::abs(volume) > 1e-15 * displacement.norm() * one.norm() * two.norm())) return std::nullopt;
    const Eigen::Vector3d offset = from - origin, turned = offset.cross(one);
    const double u = offset.dot(across) / volume, v = displacement.dot(turned) / volume,
                 t = two.dot(turned) / volume;
    constexpr double rounding = 1e-9;
    if (u < -rounding || v < -rounding || u + v > 1 + rounding || t < 0 || t > 1) return std::nullopt;
    Eigen::Vector3d weights = Eigen::Vector3d(1 - u - v, u, v).cwiseMax(0.0);
    weights /= weights.sum();
    return Hit{t, f, weights};
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
        const auto hit = meet(body, f, from, to - from);
        if (hit && (!first || hit->fraction < first->fraction)) first = hit;
    }
    return first;
}

struct SavedDrops {
    struct Flying {
        FallingDrops::Flight flight;
        Eigen::Vector3d origin;
        double momentumFraction;
        std::int32_t sheet;  // index of the sheet; -1 if it was destroyed
    };

    void state(StatePass& pass) {
        for (double* mass : {&massOnSheets, &massElsewhere, &massLost}) pass.number(*mass, 0);
        pass.list(all, [&](Flying& each) {
            pass.vector(each.flight.position);
            pass.vector(each.flight.velocity);
            pass.number(each.flight.mass, 0);
            pass.number(each.flight.count, 0);
            pass.number(each.flight.age, 0, longestFall);
            pass.vector(each.origin);
            pass.number(each.momentumFraction, 0, 1);
            pass.number(each.sheet, -1);
        });
    }

    double massOnSheets = 0, massElsewhere = 0, massLost = 0;  // kg
    std::vector<Flying> all;
};

}  // namespace

struct FallingDrops::Sheets {
    std::vector<std::weak_ptr<WetCloth::Layer>> all;
};

struct FallingDrops::Origins {
    // Origin of a flight.
    struct Origin {
        Eigen::Vector3d position;
        const void* sheet;        // its layer; address only
        double momentumFraction;  // fraction of the momentum that acts on landing; see WetCloth::Layer::add
    };
    std::vector<Origin> all;
};

FallingDrops::FallingDrops(btDiscreteDynamicsWorld& world)
    : world_(checkedSoftWorld(world)),
      sheets_(std::make_unique<Sheets>()),
      origins_(std::make_unique<Origins>()) {}

FallingDrops::~FallingDrops() = default;

void FallingDrops::add(WetCloth& cloth) {
    sheets_->all.push_back(cloth.layer_);
}

void FallingDrops::takeDrops() {
    auto& sheets = sheets_->all;
    sheets.erase(
        std::remove_if(sheets.begin(), sheets.end(), [](const auto& sheet) { return sheet.expired(); }),
        sheets.end());
    for (const auto& sheet : sheets) {
        const auto layer = sheet.lock();
        for (const Drop& drop : layer->drops) {
            flights_.push_back({drop.position, drop.velocity, drop.mass, drop.count, 0});
            origins_->all.push_back({drop.position, layer.get(), std::min(1.0, 1 / layer->waterSpeed)});
        }
        layer->drops.clear();
    }
}

void FallingDrops::step(double dt) {
    if (!(dt >= 0) || !std::isfinite(dt))
        refuse("drops cannot fall for ", dt, " s; give a finite time of at least 0 s");
    takeDrops();
    landed_.clear();
    const btVector3 found = gravityOf(world_).value;
    const Eigen::Vector3d gravity = isValidGravity(found) ? toEigen(found) : Eigen::Vector3d(0, 0, 0);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < flights_.size(); ++i) {
        Flight flight = flights_[i];
        const Eigen::Vector3d to = flight.position + flight.velocity * dt + 0.5 * gravity * dt * dt;
        if (land(i, to)) continue;
        flight.position = to;
        flight.velocity += gravity * dt;
        flight.age += dt;
        if (flight.age >= longestFall) {
            massLost_ += flight.mass * double(flight.count);
            continue;
        }
        flights_[kept] = flight;
        origins_->all[kept++] = origins_->all[i];
    }
    flights_.resize(kept);
    origins_->all.resize(kept);
}

void FallingDrops::save(StateWriter& writer) const {
    const auto& sheets = sheets_->all;
    const auto sheetIndexOf = [&](const void* sheet) {
        const auto found = std::find_if(sheets.begin(), sheets.end(),
                                        [&](const auto& each) { return each.lock().get() == sheet; });
        return found == sheets.end() ? std::int32_t{-1} : static_cast<std::int32_t>(found - sheets.begin());
    };
    SavedDrops saved{massOnSheets_, massElsewhere_, massLost_, {}};
    for (std::size_t i = 0; i < flights_.size(); ++i) {
        const Origins::Origin& origin = origins_->all[i];
        saved.all.push_back(
            {flights_[i], origin.position, origin.momentumFraction, sheetIndexOf(origin.sheet)});
    }
    StatePass pass(writer);
    pass.part(saved);
}

void FallingDrops::load(StateReader& reader) {
    SavedDrops saved;
    StatePass pass(reader, StatePass::Kind::restore);
    pass.part(saved);
    std::vector<Flight> flights;
    Origins origins;
    for (const SavedDrops::Flying& each : saved.all) {
        const auto index = static_cast<std::size_t>(each.sheet);
        if (each.sheet >= 0 && index >= sheets_->all.size())
            refuse<std::runtime_error>("saved drops fell from sheet ", index, " of ", sheets_->all.size(),
                                       "; add the same sheets in the same order");
        const void* const sheet = each.sheet < 0 ? nullptr : sheets_->all[index].lock().get();
        flights.push_back(each.flight);
        origins.all.push_back({each.origin, sheet, each.momentumFraction});
    }
    flights_ = std::move(flights);
    *origins_ = std::move(origins);
    landed_.clear();
    massOnSheets_ = saved.massOnSheets;
    massElsewhere_ = saved.massElsewhere;
    massLost_ = saved.massLost;
}

// Lands a flight if it hits something on its path. @return whether it does
bool FallingDrops::land(std::size_t i, const Eigen::Vector3d& to) {
    const Flight& flight = flights_[i];
    const Origins::Origin& origin = origins_->all[i];
    const Eigen::Vector3d from = flight.position;
    SolidRay ray(toBullet(from), toBullet(to));
    world_.rayTest(ray.m_rayFromWorld, ray.m_rayToWorld, ray);
    double nearest =
        ray.hasHit() ? double(ray.m_closestHitFraction) : std::numeric_limits<double>::infinity();

    std::shared_ptr<WetCloth::Layer> wetted;
    Hit landing{};
    for (const auto& sheet : sheets_->all) {
        const auto layer = sheet.lock();
        if (!layer || !layer->isInWorld() || !layer->fits()) continue;
        if (layer.get() == origin.sheet && (from - origin.position).norm() < clearance) continue;
        const auto hit = meet(layer->body, from, to);
        if (!hit || hit->fraction >= nearest) continue;
        nearest = hit->fraction;
        wetted = layer;
        landing = *hit;
    }
    const double mass = flight.mass * double(flight.count);
    if (wetted) {
        Supply& drops = wetted->account("drops");
        for (int corner = 0; corner < 3; ++corner) {
            const auto node = static_cast<std::size_t>(
                indexOf(wetted->body, wetted->body.m_faces[landing.face].m_n[corner]));
            const double here = mass * landing.weights[corner];
            drops.addFilm(node, here * origin.momentumFraction, flight.velocity);
            drops.addFilm(node, here * (1 - origin.momentumFraction));
        }
        massOnSheets_ += mass;
        return true;
    }
    if (!ray.hasHit()) return false;
    landed_.push_back({from + nearest * (to - from), mass, ray.m_collisionObject});
    massElsewhere_ += mass;
    return true;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
