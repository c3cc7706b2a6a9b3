// The states of the parts of a layer.
#include <limits>
#include <stdexcept>
#include <vector>

#include "bullet/bullet_solvers/stock_contacts.h"
#include "bullet/contact/friction.h"
#include "bullet/fluid/fluid_forces.h"
#include "bullet/fluid/submersion.h"
#include "bullet/fluid/wind_at_nodes.h"
#include "bullet/layer/account_supply.h"
#include "bullet/layer/cloth_layers.h"
#include "bullet/sheet/layer_touches.h"
#include "bullet/small_steps/contact_memory.h"
#include "bullet/small_steps/small_step_sheet.h"
#include "bullet/state/bullet_pass.h"
#include "bullet/world/limits.h"
#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

void AccountSupply::state(BulletPass& pass) {
    pass.number(unnoticed_, 0);
}

void FluidForces::state(BulletPass& pass) {
    const std::size_t count = areas_.size();
    pass.nodes(accelerations_, count);
    pass.nodes(forces_, count);
    for (auto* nodes : {&lastVelocities_, &meantChanges_, &changes_}) pass.nodes(*nodes, count);
    for (std::size_t n = 0; n < count; ++n) {
        pass.number(fluid_[n].fraction, 0, 1);
        pass.number(fluid_[n].fractionBefore, 0, 1);
        pass.number(fluid_[n].massPerArea, 0);
        pass.number(fluid_[n].permeability, 0);
    }
    pass.list(
        wet_, [&](std::size_t& node) { pass.index(node, count - 1); }, count);
    pass.flag(isGoingOn_);
    pass.flag(hasRested_);
    pass.number(lastSubstep_, 0);
    for (PackedVector* gravity : {&gravity_, &lastGravity_})
        for (float* part : {&gravity->x, &gravity->y, &gravity->z, &gravity->unused})
            pass.number(*part, -strongestGravity, strongestGravity);
}

void Friction::state(BulletPass& pass) {
    for (const btCollisionObject*& partner : adheresTo) {
        const btCollisionObject* const solid = pass.object(partner, BulletPass::Which::solid);
        if (pass.restores()) partner = solid;
    }
    for (const btCollisionObject*& partner : adheresToCloth) {
        const btCollisionObject* const cloth = pass.object(partner, BulletPass::Which::soft);
        if (pass.restores()) partner = cloth;
    }
}

void SmallStepSheet::state(BulletPass& pass) {
    const std::size_t size = pass.count(end_.size(), count_);
    if (size != 0 && size != count_)
        refuse<std::runtime_error>("a saved sheet has ended its last step with ", size, " of its ", count_,
                                   " nodes");
    if (pass.restores()) end_.resize(size);
    btVector3 unused(0, 0, 0);
    for (std::size_t n = 0; n < size; ++n) pass.vector(n < end_.size() ? end_[n] : unused);
    for (std::size_t first = 0; first < plateOf_.size(); first += blockWidth)
        for (std::size_t component = 0; component < 3; ++component)
            for (std::size_t lane = 0; lane < blockWidth; ++lane) {
                float none = 0;
                float* const curvature = slid(first + lane, component);
                pass.number(curvature ? *curvature : none);
            }
    // Drench 0.2 did not remember steps.
    if (pass.saves() ? longestStep_ == 0 : !pass.hasMore()) return;
    for (double* const time : {&longestStep_, &longestInWindow_, &longestBefore_, &sinceWindow_})
        pass.number(*time, 0, 1e6);
}

void ContactMemory::state(BulletPass& pass) {
    // Drench 0.2 remembered no contacts.
    const bool isEmpty = pass.saves() ? contacts_.empty() && crossing_ == 0 : !pass.hasMore();
    if (isEmpty && pass.restores()) *this = ContactMemory();
    if (isEmpty) return;
    constexpr double farthest = std::numeric_limits<int>::max();
    std::vector<Contact> all;
    if (pass.saves()) all = contacts_;
    pass.list(
        all,
        [&](Contact& contact) {
            for (int* const node : {&contact.node, &contact.otherEnd, &contact.corners[0],
                                    &contact.corners[1], &contact.corners[2]})
                *node = pass.value(*node, -1, farthest);
            contact.other = static_cast<const btSoftBody*>(
                pass.object(pass.saves() ? contact.other : nullptr, BulletPass::Which::soft));
            for (float* const part : {&contact.normal.x(), &contact.normal.y(), &contact.normal.z(),
                                      &contact.side, &contact.forces.push, &contact.forces.drag.x(),
                                      &contact.forces.drag.y(), &contact.forces.drag.z()})
                *part = pass.value(*part, -1e9, 1e9);
        },
        1u << 24);
    if (pass.restores()) contacts_ = all;
    if (pass.saves() ? crossing_ == 0 : !pass.hasMore()) {
        if (pass.restores()) crossing_ = 0;
        return;
    }
    pass.number(crossing_, 0, 1e9);
}

void LayerTouches::state(BulletPass& pass, std::size_t nodes) {
    std::vector<const btSoftBody*> cloths = others;
    pass.list(
        cloths,
        [&](const btSoftBody*& other) {
            other = static_cast<const btSoftBody*>(
                pass.object(pass.saves() ? other : nullptr, BulletPass::Which::soft));
        },
        1u << 16);
    std::vector<LayerContact> all;
    if (pass.saves()) all = contacts;
    pass.list(
        all,
        [&](LayerContact& contact) {
            contact.with = pass.value(contact.with, -1, 1 << 16);
            contact.ofSheet = pass.value(contact.ofSheet, 1, 3);
            const int ofSheet = contact.with == LayerContact::itself ? 4 : contact.ofSheet;
            for (int i = 0; i < 4; ++i) {
                const double last = i < ofSheet ? double(nodes) - 1 : std::numeric_limits<int>::max();
                int& node = contact.nodes[static_cast<std::size_t>(i)];
                node = pass.value(node, 0, last);
            }
            for (float& weight : contact.weights) weight = pass.value(weight, 0, 1);
            for (float* const part : {&contact.towards.x(), &contact.towards.y(), &contact.towards.z(),
                                      &contact.area, &contact.force})
                *part = pass.value(*part, -1e9, 1e9);
        },
        1u << 24);
    pass.flag(areListed);
    if (!pass.restores()) return;
    others = cloths;
    contacts = all;
}

void ClothLayers::state(BulletPass& pass) {
    pass.numbers(pressures_, 0, 1e12);
    pass.flag(isPressed_);
}

void StockContacts::state(BulletPass& pass) {
    const std::size_t size = pass.count(stuck_.size());
    if (pass.restores()) stuck_.assign(size, {});
    for (std::size_t n = 0; n < size; ++n) {
        Stuck read;
        Stuck& stuck = pass.saves() ? stuck_[n] : read;
        const btCollisionObject* const object = pass.object(stuck.object, BulletPass::Which::solid);
        if (!object || (pass.saves() && !pass.knows(object))) continue;
        pass.vector(stuck.position);
        read.object = object;
        if (pass.restores()) stuck_[n] = read;
    }
}

void Submersion::state(BulletPass& pass) {
    struct Under {
        std::size_t node = 0;
        float depth = 0;
        PackedVector velocity = {0, 0, 0, 0};
    };
    std::vector<Under> all;
    if (pass.saves())
        for (const std::size_t node : nodes_) all.push_back({node, depths_[node], velocities_[node]});
    pass.list(
        all,
        [&](Under& under) {
            pass.index(under.node, isUnder_.size() - 1);
            pass.number(under.depth, -1e9, 1e9);
            pass.node(under.velocity);
        },
        isUnder_.size());
    if (!pass.restores()) return;
    forget();
    for (const Under& under : all)
        submerge(under.node, double(under.depth),
                 {double(under.velocity.x), double(under.velocity.y), double(under.velocity.z)});
}

void WindAtNodes::state(BulletPass& pass) {
    for (std::size_t& points : points_) {
        const auto passed = pass.value(static_cast<std::uint64_t>(points), 2, maxPoints);
        if (pass.restores()) points = static_cast<std::size_t>(passed);
    }
    for (Patch& patch : patches_) {
        pass.number(patch.passing, 0, 1);
        pass.number(patch.fraction, 0, 1);
    }
    pass.index(nextRay_, patches_.empty() ? 0 : patches_.size() - 1);
    pass.flag(isSheltered_);
    if (pass.restores()) isUniform_ = false;  // so that the next step recomputes the velocities
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
