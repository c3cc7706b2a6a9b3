#include "bullet/cloth_contact/contact_blocks.h"

#include <algorithm>

namespace drench {

namespace {

void put(float (*values)[blockWidth], std::size_t lane, const Eigen::Vector3f& v) {
    for (std::size_t axis = 0; axis < 3; ++axis) values[axis][lane] = v[static_cast<int>(axis)];
}

Eigen::Vector3f vectorIn(const float (*values)[blockWidth], std::size_t lane) {
    return {values[0][lane], values[1][lane], values[2][lane]};
}

// What changes when the plane is found again.
void putPlane(ContactBlock& block, std::size_t lane, const ClothContact& contact) {
    for (std::size_t i = 0; i < 4; ++i) {
        block.weights[i][lane] = contact.weights[static_cast<int>(i)];
        block.slipWeights[i][lane] = contact.slipWeights[static_cast<int>(i)];
    }
    put(block.normal, lane, contact.normal);
    put(block.axis, lane, contact.axis);
    put(block.turning[0], lane, contact.turning[0]);
    put(block.turning[1], lane, contact.turning[1]);
    put(block.renewedAt, lane, contact.renewedAt);
    block.gap[lane] = contact.gap - contact.normal.dot(contact.renewedAt);
    block.response[lane] = contact.response;
    block.isActive[lane] = contact.isActive ? 1.0f : 0.0f;
    if (contact.isActive) return;
    block.force[lane] = 0;
    put(block.drag, lane, Eigen::Vector3f::Zero());
}

void put(ContactBlock& block, std::size_t lane, const ClothContact& contact, const ContactTimes& times) {
    for (std::size_t i = 0; i < 4; ++i) {
        block.nodes[i][lane] = contact.nodes[i];
        block.inverseMass[i][lane] = contact.moved[i]->inverseMass;
    }
    block.distance[lane] = contact.distance;
    block.friction[lane] = contact.friction;
    block.adhesion[lane] = contact.adhesion;
    block.reach[lane] = contact.reach;
    block.adheres[lane] = contact.adheres ? 1.0f : 0.0f;
    block.touched[lane] = contact.touched ? 1.0f : 0.0f;
    block.force[lane] = contact.forces.push;
    put(block.drag, lane, contact.forces.drag * times.square);
    putPlane(block, lane, contact);
}

}  // namespace

void ContactBlocks::clear(float step) {
    constexpr float time = 0.1f;     // in which an overlap is resolved, s (assumed)
    constexpr float perSecond = 10;  // distances, at most (assumed)
    times_ = {step * step, std::min(step / time, 1.0f), perSecond * step};
    groups_.clear();
    blocks_.clear();
    contacts_.clear();
}

std::size_t ContactBlocks::add(const Sides& sides, const std::vector<ClothContact*>& contacts) {
    const std::size_t first = contacts_.size();
    const bool areOfEdges = !contacts.empty() && contacts.front()->isOfEdges;
    fill(sides, contacts);
    groups_.push_back({sides, areOfEdges, false, false, false, first, contacts_.size() - first});
    blocks_.resize(contacts_.size());
    strays_.resize(contacts_.size());
    places_.resize(contacts_.size());
    for (std::size_t b = first; b < blocks_.size(); ++b) {
        ContactBlock& block = blocks_[b];
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            // Those that are not used add nothing to the nodes of the first.
            const ClothContact* const contact = contacts_[b][lane];
            put(block, lane, *(contact ? contact : contacts_[b][0]), times_);
            if (!contact) block.isActive[lane] = block.response[lane] = 0;
        }
    }
    return groups_.size() - 1;
}

// Each contact comes into the first of a few open blocks that uses none of its nodes. So neighbours stay near each
// other, and a sweep finds their nodes in the cache.
void ContactBlocks::fill(const Sides& sides, const std::vector<ClothContact*>& contacts) {
    constexpr std::size_t most = 16;
    const bool isOne = sides.moved[0] == sides.moved[1];
    uses_[0].assign(sides.nodeCounts[0], 0);
    if (!isOne) uses_[1].assign(sides.nodeCounts[1], 0);
    const std::array<std::uint32_t*, 2> uses = {uses_[0].data(), (isOne ? uses_[0] : uses_[1]).data()};
    std::array<Filling, most> open = {};
    const auto bitOf = [](std::size_t which) { return std::uint32_t(1) << which; };
    const auto useOf = [&](const ClothContact& contact, std::size_t i) -> std::uint32_t& {
        const bool isSecond = i >= (contact.isOfEdges ? 2u : 1u);
        return uses[isSecond ? 1 : 0][contact.nodes[i]];
    };
    for (ClothContact* const contact : contacts) {
        std::uint32_t used = 0;
        for (std::size_t i = 0; i < 4; ++i) used |= useOf(*contact, i);
        std::size_t chosen = 0;
        while (chosen < most && (used & bitOf(chosen))) ++chosen;
        if (chosen == most) {
            chosen = 0;
            for (std::size_t other = 1; other < most; ++other)
                if (open[other].count > open[chosen].count) chosen = other;
            close(open[chosen], bitOf(chosen), uses);
        }
        Filling& filling = open[chosen];
        filling.contacts[filling.count++] = contact;
        for (std::size_t i = 0; i < 4; ++i) useOf(*contact, i) |= bitOf(chosen);
        if (filling.count == blockWidth) close(filling, bitOf(chosen), uses);
    }
    for (Filling& filling : open)
        if (filling.count > 0) contacts_.push_back(filling.contacts);
}

void ContactBlocks::close(Filling& filling, std::uint32_t bit, const std::array<std::uint32_t*, 2>& uses) {
    contacts_.push_back(filling.contacts);
    for (std::size_t lane = 0; lane < filling.count; ++lane) {
        const ClothContact& contact = *filling.contacts[lane];
        for (std::size_t i = 0; i < 4; ++i)
            uses[i >= (contact.isOfEdges ? 2u : 1u) ? 1 : 0][contact.nodes[i]] &= ~bit;
    }
    filling = {};
}

void ContactBlocks::readBack() const {
    for (std::size_t b = 0; b < blocks_.size(); ++b)
        for (std::size_t lane = 0; lane < blockWidth; ++lane) {
            if (!contacts_[b][lane]) continue;
            const ContactBlock& block = blocks_[b];
            ClothContact& contact = *contacts_[b][lane];
            contact.forces.push = block.force[lane];
            contact.forces.drag = vectorIn(block.drag, lane) / times_.square;
            contact.push = block.push[lane];
            contact.adheres = block.adheres[lane] > 0;
            contact.touched = block.touched[lane] > 0;
        }
}

ContactGroup ContactBlocks::of(const Group& group) {
    const Sides& sides = group.sides;
    return {{sides.moved[0], sides.moved[1]},
            {sides.reference[0], sides.reference[1]},
            {sides.isCarried[0], sides.isCarried[1]},
            group.areOfEdges,
            blocks_.data() + group.first,
            strays_.data() + group.first,
            places_.data() + group.first,
            group.count};
}

void ContactBlocks::beginStep() {
    for (Group& group : groups_) {
        group.places = kernels_.separate(of(group), times_);
        group.hasTouched = group.hasTouched || group.places;
        group.isPushing = false;
    }
    for (const Group& group : groups_)
        if (kernels_.begin(of(group))) renewStrays(group);
}

void ContactBlocks::renewStrays(const Group& group) {
    for (std::size_t b = group.first; b < group.first + group.count; ++b) {
        if (!strays_[b]) continue;
        for (std::size_t lane = 0; lane < blockWidth; ++lane)
            if (strays_[b] & (1u << lane)) {
                contacts_[b][lane]->renew();
                putPlane(blocks_[b], lane, *contacts_[b][lane]);
            }
        ContactGroup alone = of(group);
        alone.blocks = &blocks_[b];
        alone.strays = &strays_[b];
        alone.count = 1;
        kernels_.begin(alone);
    }
}

void ContactBlocks::goOn() {
    for (Group& group : groups_) group.isPushing = kernels_.goOn(of(group), times_);
}

float ContactBlocks::solve(bool backwards) {
    float most = 0;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        Group& group = groups_[backwards ? groups_.size() - 1 - i : i];
        const ContactsSolved solved = kernels_.solve(of(group), times_, backwards);
        most = std::max(most, solved.most);
        group.isPushing = group.isPushing || solved.isPushing;
        group.hasTouched = group.hasTouched || solved.hasTouched;
    }
    return most;
}

void ContactBlocks::endStep() {
    for (const Group& group : groups_)
        if (group.places) kernels_.beginSettling(of(group));
    constexpr int passes = 4;  // where layers are squeezed, what settles in one contact opens another
    for (int pass = 0; pass < passes; ++pass)
        for (const Group& group : groups_)
            if (group.places) kernels_.settle(of(group));
    for (const Group& group : groups_) kernels_.finish(of(group), times_);
}

}  // namespace drench
