#include "bullet/small_steps/touch_lists.h"

#include <algorithm>

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

void listActing(const SurfaceContacts::Acting& acting) {
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

}  // namespace

void listTouches(const std::vector<TouchingSheet>& sheets, const std::vector<SheetMechanics*>& sleeping,
                 const SurfaceContacts& contacts, const Solids& solids) {
    for (const TouchingSheet& each : sheets) {
        LayerTouches& touches = each.mechanics->touches;
        touches.begin();
        each.sheet->contacts.forEachForce(solids, each.sheet->cloth.substep(), each.sheet->cloth.smallStep(),
                                          [&](std::size_t node, const btVector3& normal, double force) {
                                              // Most cloth that lies on a solid is not squeezed. What varies around what counts is listed.
                                              constexpr double ofWhatCounts = 0.5;
                                              const double light =
                                                  ofWhatCounts * each.mechanics->lightPressure;
                                              if (force < light * each.mechanics->shape.nodeAreas[node])
                                                  return;
                                              touches.contacts.push_back({LayerContact::solid,
                                                                          1,
                                                                          {static_cast<int>(node), 0, 0, 0},
                                                                          {1, 0, 0, 0},
                                                                          -toFloat(normal),
                                                                          0,
                                                                          static_cast<float>(force)});
                                          });
        for (SheetMechanics* const other : sleeping) other->touches.forget(*each.body);
    }
    contacts.forEachActing(listActing);
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
