#include "drench/wet_contact.h"

#include <algorithm>
#include <cmath>

#include "../water/checks.h"
#include "drench/water.h"
#include "layer.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

constexpr double filmTime = 0.1;  // s, time constant in which films between touching faces even out (assumed)

bool isNodeOf(const btSoftBody& body, const btSoftBody::Node* node) {
    return body.m_nodes.size() > 0 && node >= &body.m_nodes[0] &&
           node < &body.m_nodes[0] + body.m_nodes.size();
}

}  // namespace

void WetBody::supply(const SheetPose& sheet, double dt, Supply& supply) {
    checkRange("WetBody::filmThickness", filmThickness, "m", 0, 0.01);
    if (!(amount >= 0)) checkRange("WetBody::amount", amount, "kg", 0, 1e6);
    const double share = -std::expm1(-dt / filmTime);
    for (int i = 0; i < sheet_->m_rcontacts.size(); ++i) {
        const btSoftBody::RContact& contact = sheet_->m_rcontacts[i];
        if (contact.m_cti.m_colObj != body_ || !isNodeOf(*sheet_, contact.m_node)) continue;
        const auto node = static_cast<std::size_t>(indexOf(*sheet_, contact.m_node));
        if (!(sheet.mesh.areas[node] > 0)) continue;
        const double missing = waterDensity * sheet.mesh.areas[node] * filmThickness - sheet.filmMass[node];
        const double mass = std::min(std::max(missing, 0.0) * share, amount);
        supply.addFilm(node, mass);
        amount -= mass;
    }
}

Touch::Touch(const btSoftBody& sheet, WetCloth& other) : sheet_(&sheet), other_(other.layer_) {}

/// What passes between one node here and one node there.
struct Touch::Exchange {
    const SheetPose& here;
    WetCloth::Layer& there;
    Supply& supplyHere;
    Supply& supplyThere;
    double poreShare;  // of what would even them out, in this step
    double filmShare;

    void pass(std::size_t node, std::size_t other, double weight) {
        const double areaHere = here.mesh.areas[node], areaThere = there.mesh.areas[other];
        if (!(areaHere > 0) || !(areaThere > 0) || !(weight > 0)) return;
        const Moisture& water = there.moisture;
        passPores(node, other,
                  weight * evenOut(here.poreMass[node], here.poreCapacity * areaHere, water.poreMass()[other],
                                   water.poreCapacity(other)));
        passFilm(node, other,
                 weight * evenOut(here.filmMass[node], areaHere, water.filmMass()[other], areaThere));
    }

    /// What has to pass from one store to another until both are equally full.
    static double evenOut(double mass, double room, double otherMass, double otherRoom) {
        return (mass * otherRoom - otherMass * room) / (room + otherRoom);
    }

    void passPores(std::size_t node, std::size_t other, double surplus) {
        const double mass = std::abs(surplus) * poreShare;
        if (surplus > 0)
            supplyThere.addPores(other, supplyHere.takePores(node, mass));
        else
            supplyHere.addPores(node, supplyThere.takePores(other, mass));
    }

    void passFilm(std::size_t node, std::size_t other, double surplus) {
        const double mass = std::abs(surplus) * filmShare;
        if (surplus > 0)
            supplyThere.addFilm(other, supplyHere.takeFilm(node, mass));
        else
            supplyHere.addFilm(node, supplyThere.takeFilm(other, mass));
    }
};

void Touch::supply(const SheetPose& sheet, double dt, Supply& supply) {
    const std::shared_ptr<WetCloth::Layer> other = other_.lock();
    if (!other || !other->watch.bodyIsAlive()) return;
    Exchange exchange{sheet,
                      *other,
                      supply,
                      other->account(name()),
                      -std::expm1(-dt / std::max(sheet.wettingTime, other->moisture.wettingTime())),
                      -std::expm1(-dt / filmTime)};
    // A contact joins a node of one to a face of the other; each body keeps those of its own nodes.
    for (const btSoftBody* body : {sheet_, static_cast<const btSoftBody*>(&other->body)}) {
        const btSoftBody& faces = body == sheet_ ? other->body : *sheet_;
        for (int i = 0; i < body->m_scontacts.size(); ++i) {
            const btSoftBody::SContact& contact = body->m_scontacts[i];
            if (!isNodeOf(*body, contact.m_node) || !isNodeOf(faces, contact.m_face->m_n[0])) continue;
            const auto node = static_cast<std::size_t>(indexOf(*body, contact.m_node));
            for (int corner = 0; corner < 3; ++corner) {
                const auto at = static_cast<std::size_t>(indexOf(faces, contact.m_face->m_n[corner]));
                const double weight = std::clamp(double(contact.m_weights[corner]), 0.0, 1.0);
                if (body == sheet_)
                    exchange.pass(node, at, weight);
                else
                    exchange.pass(at, node, weight);
            }
        }
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
