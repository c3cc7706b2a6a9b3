#include "bullet/small_steps/touch_lists.h"

#include <algorithm>
#include <cmath>

#include "bullet/world/body_watch.h"
#include "bullet/world/vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

LayerContact contactOf(const SurfaceContacts::Acting& acting, int with) {
    return {with, acting.ofFirst, acting.nodes, acting.weights, -acting.normal, acting.area, acting.force};
}

// The same contact as the other cloth has it.
LayerContact turned(const LayerContact& contact, int with) {
    LayerContact other = contact;
    other.with = with;
    other.ofSheet = 4 - contact.ofSheet;
    for (int corner = 0; corner < 4; ++corner) {
        const auto from = static_cast<std::size_t>((corner + contact.ofSheet) % 4);
        other.nodes[static_cast<std::size_t>(corner)] = contact.nodes[from];
        other.weights[static_cast<std::size_t>(corner)] = contact.weights[from];
    }
    other.towards = -contact.towards;
    return other;
}

// Not of a sheet that is about to be put back, because a force was not finite.
bool isFinite(const SurfaceContacts::Acting& acting) {
    return acting.normal.allFinite() && std::isfinite(acting.force) && std::isfinite(acting.area) &&
           std::all_of(acting.weights.begin(), acting.weights.end(),
                       [](float weight) { return std::isfinite(weight); });
}

void listActing(const SurfaceContacts::Acting& acting) {
    if (!isFinite(acting)) return;
    SheetMechanics* const first = BodyWatch::mechanicsOf(*acting.first);
    if (acting.first == acting.second) {
        first->touches.contacts.push_back(contactOf(acting, LayerContact::itself));
        return;
    }
    SheetMechanics* const second = BodyWatch::mechanicsOf(*acting.second);
    if (first) first->touches.contacts.push_back(contactOf(acting, first->touches.numberOf(*acting.second)));
    if (second)
        second->touches.contacts.push_back(
            turned(contactOf(acting, 0), second->touches.numberOf(*acting.first)));
}

// Most cloth that lies on a solid is not squeezed, and is not listed. What varies around what counts is.
void listSolids(const TouchingSheet& sheet, const Solids& solids) {
    constexpr double ofWhatCounts = 0.5;
    const double light = ofWhatCounts * sheet.mechanics->lightPressure;
    const auto list = [&](std::size_t node, const btVector3& normal, double force) {
        if (!(force >= light * sheet.mechanics->shape.nodeAreas[node])) return;
        LayerContact contact{};
        contact.with = LayerContact::solid;
        contact.ofSheet = 1;
        contact.nodes[0] = static_cast<int>(node);
        contact.weights[0] = 1;
        contact.towards = -toFloat(normal);
        contact.force = static_cast<float>(force);
        sheet.mechanics->touches.contacts.push_back(contact);
    };
    const SmallStepSheet& cloth = sheet.sheet->cloth;
    sheet.sheet->contacts.forEachForce(solids, cloth.substep(), cloth.smallStep(), list);
}

}  // namespace

void listTouches(const std::vector<TouchingSheet>& sheets, const std::vector<SheetMechanics*>& sleeping,
                 const SurfaceContacts& contacts, const Solids& solids) {
    for (const TouchingSheet& each : sheets) {
        each.mechanics->touches.begin();
        listSolids(each, solids);
        for (SheetMechanics* const other : sleeping) other->touches.forget(*each.body);
    }
    contacts.forEachActing(listActing);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
