#include "bullet/layer/cloth_layers.h"

#include <algorithm>
#include <cmath>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Time over which the force of a contact is averaged, s (assumed): water needs about as long to get out, and forces of
// contacts vary from step to step.
constexpr double pressingTime = 0.05;

}  // namespace

ClothLayers::ClothLayers(const Fabric& fabric, std::size_t nodes, double lightPressure)
    : fabric_(fabric), film_(fabric), leastPressure_(lightPressure), pressures_(nodes) {
    sides_.clear(nodes);
}

void ClothLayers::read(const LayerTouches& touches, const std::vector<double>& areas, double bodyStep) {
    if (touches.contacts.empty() && sides_.nodes().empty() && !isPressed_) return;
    sides_.clear(areas.size());
    LayerContacts::addAll(touches.contacts, sides_);
    average(areas, bodyStep);
}

void ClothLayers::average(const std::vector<double>& areas, double bodyStep) {
    constexpr float none = 1e-3f;  // Pa
    const double fraction = -std::expm1(-bodyStep / pressingTime);
    for (float& pressure : pressures_) pressure = pressure > none ? float(1 - fraction) * pressure : 0.0f;
    for (const std::size_t node : sides_.nodes()) {
        constexpr double most = 1e8;  // Pa
        const double now = areas[node] > 0 ? std::min(sides_.force(node) / areas[node], most) : 0.0;
        pressures_[node] += static_cast<float>(fraction * now);
    }
    isPressed_ =
        std::any_of(pressures_.begin(), pressures_.end(), [](float pressure) { return pressure > 0; });
}

double ClothLayers::covered(std::size_t node, const Eigen::Vector3d& towards, double area) const {
    if (sides_.nodes().empty() || !(area > 0)) return 0;
    return std::min(sides_.area(node, towards.cast<float>()) / area, 1.0);
}

void ClothLayers::cover(const Sheet& sheet) const {
    constexpr double mostly = 0.5;
    for (const std::size_t node : sides_.nodes()) {
        const double area = sheet.areas[node];
        if (!(area > 0)) continue;
        sheet.moisture.cover(node, sides_.covered(node, area));
        // What comes out below goes into the layer there.
        if (!sheet.up.isZero() && covered(node, -sheet.up, area) > mostly) sheet.moisture.layDown(node);
    }
}

void ClothLayers::press(const Sheet& sheet) const {
    if (!isPressed_) return;
    for (std::size_t node = 0; node < pressures_.size(); ++node)
        if (pressure(node) > 0 && sheet.areas[node] > 0) sheet.moisture.press(node, pressure(node));
}

double ClothLayers::pressure(std::size_t node) const {
    return double(pressures_[node]) > leastPressure_ ? double(pressures_[node]) : 0.0;
}

bool ClothLayers::isWet(const Moisture& moisture, const std::vector<LayerPair>& pairs, bool isOther) const {
    return std::any_of(pairs.begin(), pairs.end(), [&](const LayerPair& pair) {
        const std::size_t node = isOther ? pair.other : pair.node;
        return moisture.poreMass()[node] > 0 || moisture.filmMass()[node] > 0;
    });
}

void ClothLayers::join(const Sheet& sheet, const LayerTouches& touches) {
    const auto isItself = [](const LayerContact& contact) { return contact.with == LayerContact::itself; };
    if (std::none_of(touches.contacts.begin(), touches.contacts.end(), isItself)) return;
    const std::vector<LayerPair>& pairs =
        contacts_.pairsWith(LayerContact::itself, touches.contacts, sheet.areas, sheet.areas, -sheet.up);
    if (isWet(sheet.moisture, pairs, false) || isWet(sheet.moisture, pairs, true))
        sheet.moisture.joinLayers(pairs);
}

void ClothLayers::exchange(const Sheet& sheet, Supply& supply, const LayerTouches& touches,
                           const Partner& partner, double waterTime) {
    const std::vector<LayerPair>& pairs =
        contacts_.pairsWith(partner.number, touches.contacts, sheet.areas, partner.areas, -sheet.up);
    const bool isWetHere = isWet(sheet.moisture, pairs, false);
    if (partner.movesPores && (isWetHere || isWet(partner.water.water(), pairs, true)))
        movePores(sheet, supply, partner, pairs, waterTime);
    if (isWetHere) moveFilm(sheet, supply, partner, pairs, waterTime);
}

void ClothLayers::movePores(const Sheet& sheet, Supply& supply, const Partner& partner,
                            const std::vector<LayerPair>& pairs, double waterTime) {
    const Moisture& there = partner.water.water();
    Supply& supplyThere = partner.water.touchAccount();
    const LayerWicking wicking(LayerLaw(fabric_), LayerLaw(partner.water.fabricOfWater()));
    poresHere_ = sheet.moisture.poreMass();
    poresThere_ = there.poreMass();
    // The other sheet is pressed only within its own step.
    const Fabric& fabricThere = partner.water.fabricOfWater();
    roomThere_ = there.poreCapacities();
    for (const LayerPair& pair : pairs)
        if (const double on = partner.water.pressureOn(pair.other); on > 0)
            roomThere_[pair.other] = partner.areas[pair.other] * fabricThere.poreCapacityUnder(on);
    wicking.step(waterTime, pairs, {sheet.moisture.poreCapacities().data(), poresHere_.data()},
                 {roomThere_.data(), poresThere_.data()});
    const auto apply = [](std::vector<double>& pores, const Moisture& moisture, Supply& of,
                          std::size_t node) {
        const double more = pores[node] - moisture.poreMass()[node];
        if (more < 0) of.takePores(node, -more);
        if (more > 0) of.addPores(node, more);
        pores[node] = moisture.poreMass()[node];  // a node of several pairs changes once
    };
    for (const LayerPair& pair : pairs) {
        apply(poresHere_, sheet.moisture, supply, pair.node);
        apply(poresThere_, there, supplyThere, pair.other);
    }
}

void ClothLayers::moveFilm(const Sheet& sheet, Supply& supply, const Partner& partner,
                           const std::vector<LayerPair>& pairs, double waterTime) {
    const std::vector<double>& leaving =
        film_.leaving(waterTime, sheet.gravity, pairs, false, sheet.moisture);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (leaving[i] > 0)
            partner.water.touchAccount().addFilm(pairs[i].other, supply.takeFilm(pairs[i].node, leaving[i]));
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
