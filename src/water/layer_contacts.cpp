#include "water/layer_contacts.h"

#include <algorithm>

namespace drench {

namespace {

std::size_t nodeOf(const LayerContact& contact, int corner) {
    return static_cast<std::size_t>(contact.nodes[static_cast<std::size_t>(corner)]);
}

double weightOf(const LayerContact& contact, int corner) {
    return std::max(double(contact.weights[static_cast<std::size_t>(corner)]), 0.0);
}

// @param sidesOfOther  null where they do not matter; the same as `sides` for a sheet with itself
void addSides(const LayerContact& contact, ContactSides& sides, ContactSides* sidesOfOther) {
    const int count = contact.with == LayerContact::solid ? contact.ofSheet : 4;
    for (int corner = 0; corner < count; ++corner) {
        const bool isHere = corner < contact.ofSheet;
        ContactSides* const of = isHere ? &sides : sidesOfOther;
        const double weight = weightOf(contact, corner);
        if (!of || !(weight > 0)) continue;
        of->add(nodeOf(contact, corner), isHere ? contact.towards : -contact.towards,
                weight * double(contact.area), weight * double(contact.force));
    }
}

}  // namespace

void ContactSides::clear(std::size_t nodes) {
    if (sides_.size() != nodes)
        sides_.assign(nodes, Sides());
    else
        for (const std::size_t node : touched_) sides_[node] = Sides();
    touched_.clear();
}

void ContactSides::add(std::size_t node, const Eigen::Vector3f& towards, double area, double force) {
    Sides& sides = sides_[node];
    if (sides.first.isZero(0)) {
        sides.first = towards;
        touched_.push_back(node);
    }
    const std::size_t side = sideOf(sides, towards);
    sides.areas[side] += area;
    sides.forces[side] += force;
}

double ContactSides::area(std::size_t node, const Eigen::Vector3f& towards) const {
    return node < sides_.size() ? sides_[node].areas[sideOf(sides_[node], towards)] : 0.0;
}

double ContactSides::covered(std::size_t node, double area) const {
    const std::array<double, 2>& areas = sides_[node].areas;
    return area > 0 ? (std::min(areas[0] / area, 1.0) + std::min(areas[1] / area, 1.0)) / 2 : 0.0;
}

double ContactSides::force(std::size_t node) const {
    return std::max(sides_[node].forces[0], sides_[node].forces[1]);
}

void LayerContacts::addAll(const std::vector<LayerContact>& contacts, ContactSides& sides) {
    for (const LayerContact& contact : contacts)
        addSides(contact, sides, contact.with == LayerContact::itself ? &sides : nullptr);
}

const std::vector<LayerPair>& LayerContacts::pairsWith(int with, const std::vector<LayerContact>& contacts,
                                                       const std::vector<double>& areas,
                                                       const std::vector<double>& areasOfOther,
                                                       const Eigen::Vector3d& down) {
    const bool isSelf = with == LayerContact::itself;
    ContactSides& there = isSelf ? here_ : there_;
    here_.clear(areas.size());
    if (!isSelf) there_.clear(areasOfOther.size());
    const auto isOne = [&](const LayerContact& contact) { return contact.with == with && contact.area > 0; };
    for (const LayerContact& contact : contacts)
        if (isOne(contact)) addSides(contact, here_, &there);
    pairs_.clear();
    for (const LayerContact& contact : contacts) {
        if (!isOne(contact)) continue;
        const double descent = std::clamp(contact.towards.cast<double>().dot(down), -1.0, 1.0);
        for (int corner = 0; corner < contact.ofSheet; ++corner)
            for (int other = contact.ofSheet; other < 4; ++other) {
                const double weight = weightOf(contact, corner) * weightOf(contact, other);
                const std::size_t node = nodeOf(contact, corner), otherNode = nodeOf(contact, other);
                if (!(weight > 0 && areas[node] > 0 && areasOfOther[otherNode] > 0)) continue;
                const double times =
                    std::max({here_.area(node, contact.towards) / areas[node],
                              there.area(otherNode, -contact.towards) / areasOfOther[otherNode], 1.0});
                pairs_.push_back({node, otherNode, weight * double(contact.area) / times, descent});
            }
    }
    return pairs_;
}

}  // namespace drench
