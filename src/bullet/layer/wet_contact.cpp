#include "drench/wet_contact.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bullet/bullet_solvers/contact_order.h"
#include "bullet/layer/layer.h"
#include "checks/checks.h"
#include "drench/water.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

constexpr double filmTime = 0.1;  // time constant with which films of touching faces even out, s (assumed)

bool isNodeOf(const btSoftBody& body, const btSoftBody::Node* node) {
    return body.m_nodes.size() > 0 && node >= &body.m_nodes[0] &&
           node < &body.m_nodes[0] + body.m_nodes.size();
}

// Compares addresses only, because the body of the face may have been destroyed.
bool isFaceOf(const btSoftBody& body, const btSoftBody::Face* face) {
    return body.m_faces.size() > 0 && face >= &body.m_faces[0] &&
           face < &body.m_faces[0] + body.m_faces.size();
}

}  // namespace

void WetBody::supply(const SheetPose& sheet, double dt, Supply& supply) {
    checkRange("WetBody::filmThickness", filmThickness, "m", 0, 0.01);
    if (!(amount >= 0)) checkRange("WetBody::amount", amount, "kg", 0, 1e6);
    if (!sheet.body) return;
    const auto& body = *static_cast<const btSoftBody*>(sheet.body);
    const double fraction = -std::expm1(-dt / filmTime);
    forEachSolidContact(body, [&](const btSoftBody::Node* touching, const btSoftBody::sCti& contact) {
        if (contact.m_colObj != body_ || !isNodeOf(body, touching)) return;
        const auto node = static_cast<std::size_t>(indexOf(body, touching));
        if (!(sheet.mesh.areas[node] > 0)) return;
        const double ofOneFace = sheet.filmMass[node] / 2;
        const double missing = waterDensity * sheet.mesh.areas[node] * filmThickness - ofOneFace;
        const double mass = std::min(std::max(missing, 0.0) * fraction, amount);
        supply.addFilm(node, mass);
        amount -= mass;
    });
}

void WetBody::load(StateReader& reader) {
    const auto left = reader.read<double>();
    if (!(left >= 0)) refuse<std::runtime_error>("a wet body cannot have ", left, " kg left");
    amount = left;
}

Touch::Touch(WetCloth& other) : other_(other.layer_) {}

// Exchanges water between the nodes of both sheets.
struct Touch::Exchange {
    const SheetPose& here;
    WetCloth::Layer& there;
    Supply& supplyHere;
    Supply& supplyThere;
    double poreFraction;  // fractions of a complete equalization in this step
    double filmFraction;

    void pass(const Pair& pair, double weight) {
        const double areaHere = here.mesh.areas[pair.here], areaThere = there.mesh.areas[pair.there];
        const Moisture& water = there.moisture;
        passPores(pair, weight * evenOut(here.poreMass[pair.here], here.poreCapacity * areaHere,
                                         water.poreMass()[pair.there], water.poreCapacity(pair.there)));
        passFilm(pair, weight * evenOut(here.filmMass[pair.here], areaHere, water.filmMass()[pair.there],
                                        areaThere));
    }

    // Mass to move from one store to another so that both are equally full.
    static double evenOut(double mass, double room, double otherMass, double otherRoom) {
        return (mass * otherRoom - otherMass * room) / (room + otherRoom);
    }

    void passPores(const Pair& pair, double surplus) {
        const double mass = std::abs(surplus) * poreFraction;
        if (surplus > 0)
            supplyThere.addPores(pair.there, supplyHere.takePores(pair.here, mass));
        else
            supplyHere.addPores(pair.here, supplyThere.takePores(pair.there, mass));
    }

    void passFilm(const Pair& pair, double surplus) {
        const double mass = std::abs(surplus) * filmFraction;
        if (surplus > 0)
            supplyThere.addFilm(pair.there, supplyHere.takeFilm(pair.here, mass));
        else
            supplyHere.addFilm(pair.here, supplyThere.takeFilm(pair.there, mass));
    }
};

// A contact joins a node of one body to a face of the other; each body lists the contacts of its own nodes.
void Touch::findPairs(const btSoftBody& here, const btSoftBody& there) {
    pairs_.clear();
    for (const btSoftBody* nodes : {&here, &there}) {
        const btSoftBody& faces = nodes == &here ? there : here;
        forEachSoftContact(*nodes, [&](const btSoftBody::Node* touching, const btSoftBody::Face* face,
                                       const btVector3& weights) {
            if (!isNodeOf(*nodes, touching) || !isFaceOf(faces, face)) return;
            const auto node = static_cast<std::size_t>(indexOf(*nodes, touching));
            for (int corner = 0; corner < 3; ++corner) {
                const auto at = static_cast<std::size_t>(indexOf(faces, face->m_n[corner]));
                const double weight = std::clamp(double(weights[corner]), 0.0, 1.0);
                pairs_.push_back(nodes == &here ? Pair{node, at, weight} : Pair{at, node, weight});
            }
        });
    }
}

void Touch::supply(const SheetPose& sheet, double dt, Supply& supply) {
    const std::shared_ptr<WetCloth::Layer> other = other_.lock();
    if (!sheet.body || !other || !other->watch.bodyIsAlive() || !other->body.getBroadphaseHandle()) return;
    if (!other->fits() || other->topology.hasMoved(other->body)) return;
    if (other->mechanics.touches.areListed) return;
    findPairs(*static_cast<const btSoftBody*>(sheet.body), other->body);
    weightsHere_.assign(sheet.mesh.size(), 0.0);
    weightsThere_.assign(other->mesh.size(), 0.0);
    const auto usable = [&](const Pair& pair) {
        return pair.weight > 0 && sheet.mesh.areas[pair.here] > 0 && other->mesh.areas[pair.there] > 0;
    };
    for (const Pair& pair : pairs_) {
        if (!usable(pair)) continue;
        weightsHere_[pair.here] += pair.weight;
        weightsThere_[pair.there] += pair.weight;
    }
    Supply& otherSupply = other->account(name());
    Exchange exchange{sheet,
                      *other,
                      supply,
                      otherSupply,
                      -std::expm1(-dt / std::max(sheet.wettingTime, other->moisture.wettingTime())),
                      -std::expm1(-dt / filmTime)};
    constexpr double oneFace = 0.5;
    for (const Pair& pair : pairs_) {
        if (!usable(pair)) continue;
        // If a node has many contacts, their weights are scaled so that its face is covered only once.
        const double here = std::max(weightsHere_[pair.here], 1.0),
                     there = std::max(weightsThere_[pair.there], 1.0);
        exchange.pass(pair, pair.weight / std::max(here, there));
        supply.cover(pair.here, oneFace * pair.weight / here);
        otherSupply.cover(pair.there, oneFace * pair.weight / there);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
