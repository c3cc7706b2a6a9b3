// The inner loops of contacts, for lanes of one number or of eight.
#pragma once

#include <limits>

#include "bullet/simd/contact_kernels.h"
#include "bullet/simd/lanes.h"

namespace drench {
namespace lanes {

template <typename Real>
constexpr std::size_t widthOf = sizeof(Real) / sizeof(float);

template <typename Real>
DRENCH_LANES Real& in(float* values) {
    return *reinterpret_cast<Real*>(values);
}
template <typename Real>
DRENCH_LANES const Real& in(const float* values) {
    return *reinterpret_cast<const Real*>(values);
}
template <typename Real>
DRENCH_LANES Triple<Real> tripleIn(const float (*values)[blockWidth], std::size_t lane) {
    return {in<Real>(values[0] + lane), in<Real>(values[1] + lane), in<Real>(values[2] + lane)};
}
template <typename Real>
DRENCH_LANES void put(float (*values)[blockWidth], std::size_t lane, const Triple<Real>& v) {
    in<Real>(values[0] + lane) = v.x;
    in<Real>(values[1] + lane) = v.y;
    in<Real>(values[2] + lane) = v.z;
}

// To which cloth a corner belongs.
template <bool areOfEdges>
constexpr std::size_t sideOf(std::size_t corner) {
    return corner < (areOfEdges ? 2 : 1) ? 0 : 1;
}

// Four nodes of each lane.
template <typename Real>
struct Corners {
    Triple<Real> at[4];
    Real inverseMass[4];
};

template <typename Real, bool areOfEdges>
DRENCH_LANES void gather(Corners<Real>& corners, MovingNode* const* nodes, const ContactBlock& block,
                         std::size_t lane) {
    for (std::size_t k = 0; k < 4; ++k)
        gather(corners.at[k], corners.inverseMass[k], nodes[sideOf<areOfEdges>(k)], block.nodes[k] + lane);
}

template <typename Real>
DRENCH_LANES Triple<Real> apartOf(const Corners<Real>& corners, const ContactBlock& block, std::size_t lane) {
    Triple<Real> sum = corners.at[0] * in<Real>(block.weights[0] + lane);
    for (std::size_t k = 1; k < 4; ++k) sum = sum + corners.at[k] * in<Real>(block.weights[k] + lane);
    return sum;
}

// What turning adds to the slip, from how far the corners move along the axis; and what each corner gets of a drag, from
// its products with both vectors.
template <bool areOfEdges, typename Real>
DRENCH_LANES Triple<Real> turned(const Triple<Real>& p, const Triple<Real>& q, const Real* along) {
    const Real byP = areOfEdges ? along[1] - along[0] : along[2] - along[1];
    const Real byQ = areOfEdges ? along[3] - along[2] : along[3] - along[1];
    return p * byP + q * byQ;
}
template <bool areOfEdges, typename Real>
DRENCH_LANES void turningOf(Real* each, const Real& byP, const Real& byQ) {
    each[0] = areOfEdges ? -byP : byP - byP;
    each[1] = areOfEdges ? byP : -(byP + byQ);
    each[2] = areOfEdges ? -byQ : byP;
    each[3] = byQ;
}

template <bool areOfEdges, typename Real>
DRENCH_LANES Triple<Real> slidOf(const Corners<Real>& corners, const ContactBlock& block, std::size_t lane) {
    const Triple<Real> axis = tripleIn<Real>(block.axis, lane);
    Triple<Real> sum = corners.at[0] * in<Real>(block.slipWeights[0] + lane);
    Real along[4];
    dot(along[0], corners.at[0], axis);
    for (std::size_t k = 1; k < 4; ++k) {
        sum = sum + corners.at[k] * in<Real>(block.slipWeights[k] + lane);
        dot(along[k], corners.at[k], axis);
    }
    return sum + turned<areOfEdges>(tripleIn<Real>(block.turning[0], lane),
                                    tripleIn<Real>(block.turning[1], lane), along);
}

// Adds to each corner what a push, over the response, and a drag move it.
template <typename Real, bool areOfEdges>
DRENCH_LANES void move(MovingNode* const* nodes, const ContactBlock& block, std::size_t lane,
                       const Real& push, const Triple<Real>& drag) {
    const Triple<Real> axis = tripleIn<Real>(block.axis, lane), normal = tripleIn<Real>(block.normal, lane);
    Real byP, byQ, turning[4];
    dot(byP, tripleIn<Real>(block.turning[0], lane), drag);
    dot(byQ, tripleIn<Real>(block.turning[1], lane), drag);
    turningOf<areOfEdges>(turning, byP, byQ);
    for (std::size_t k = 0; k < 4; ++k) {
        const Real along = push * in<Real>(block.weights[k] + lane);
        const Triple<Real> by =
            normal * along + drag * in<Real>(block.slipWeights[k] + lane) + axis * turning[k];
        scatter(nodes[sideOf<areOfEdges>(k)], block.nodes[k] + lane,
                by * in<Real>(block.inverseMass[k] + lane));
    }
}
template <typename Real, bool areOfEdges>
DRENCH_LANES void move(MovingNode* const* nodes, const ContactBlock& block, std::size_t lane,
                       const Real& push) {
    const Triple<Real> normal = tripleIn<Real>(block.normal, lane);
    for (std::size_t k = 0; k < 4; ++k) {
        const Real by = push * in<Real>(block.weights[k] + lane) * in<Real>(block.inverseMass[k] + lane);
        scatter(nodes[sideOf<areOfEdges>(k)], block.nodes[k] + lane, normal * by);
    }
}

// How far each node moves where both sides are moved apart by one. Nodes that a solid carries stay: it would push them
// back, and that would become velocity.
template <typename Real, bool areOfEdges>
DRENCH_LANES void sharesOf(Real* shares, const ContactGroup& group, const ContactBlock& block,
                           std::size_t lane) {
    Real response = {}, farthest = {};
    for (std::size_t k = 0; k < 4; ++k) {
        alignas(32) float isFree[blockWidth];
        const char* const isCarried = group.isCarried[sideOf<areOfEdges>(k)];
        for (std::size_t i = 0; i < widthOf<Real>; ++i)
            isFree[i] = isCarried[block.nodes[k][lane + i]] ? 0.0f : 1.0f;
        const Real weight = in<Real>(block.weights[k] + lane);
        shares[k] = weight * in<Real>(block.inverseMass[k] + lane) * in<Real>(isFree);
        response += shares[k] * weight;
        Real size;
        sizeOf(size, shares[k]);
        largerOf(farthest, farthest, size);
    }
    const Real limit = farthest * (1 / longestLever);
    largerOf(response, response, limit);
    const Real none = {};
    for (std::size_t k = 0; k < 4; ++k) {
        const Real share = shares[k] / response;
        shares[k] = response > 0 ? share : none;
    }
}

template <typename Real, bool areOfEdges>
DRENCH_LANES bool separate(const ContactGroup& group, ContactBlock& block, const ContactTimes& times,
                           std::size_t lane) {
    Corners<Real> corners;
    gather<Real, areOfEdges>(corners, group.moved, block, lane);
    const Triple<Real> normal = tripleIn<Real>(block.normal, lane);
    const Real& distance = in<Real>(block.distance + lane);
    Real opened;
    dot(opened, normal, apartOf(corners, block, lane));
    const Real overlap = -(in<Real>(block.gap + lane) + opened), none = {};
    // What is through is only kept from going deeper: in a tangle, pulling it back would stretch the cloth for ever.
    const auto overlaps = (in<Real>(block.isActive + lane) > 0) & (overlap > 0) & (overlap < distance);
    const Real closed = overlap * times.closing, fastest = distance * times.fastest;
    Real placed;
    smallerOf(placed, closed, fastest);
    placed = overlaps ? placed : none;
    in<Real>(block.placed + lane) = placed;
    if (!any(overlaps)) return false;
    Real shares[4];
    sharesOf<Real, areOfEdges>(shares, group, block, lane);
    for (std::size_t k = 0; k < 4; ++k) {
        const Real share = placed * shares[k];
        const Triple<Real> by = normal * share;
        scatter(group.moved[sideOf<areOfEdges>(k)], block.nodes[k] + lane, by);
        scatter(group.reference[sideOf<areOfEdges>(k)], block.nodes[k] + lane, by);
    }
    return true;
}

template <typename Real, bool areOfEdges>
DRENCH_LANES unsigned begin(const ContactGroup& group, ContactBlock& block, std::size_t lane) {
    // Where the line between both is not along the normal, a push turns the cloth.
    constexpr float near = 0.1f, nearWherePushed = 0.01f;
    Corners<Real> corners;
    gather<Real, areOfEdges>(corners, group.moved, block, lane);
    const Triple<Real> apart = apartOf(corners, block, lane);
    Real opened, off;
    dot(opened, tripleIn<Real>(block.normal, lane), apart);
    in<Real>(block.gapBefore + lane) = in<Real>(block.gap + lane) + opened;
    put(block.slidBefore, lane, slidOf<areOfEdges>(corners, block, lane));
    const Triple<Real> since = apart - tripleIn<Real>(block.renewedAt, lane);
    dot(off, since, since);
    const Real& distance = in<Real>(block.distance + lane);
    const Real far = distance * near, farWherePushed = distance * nearWherePushed;
    const Real farthest = in<Real>(block.push + lane) > 0 ? farWherePushed : far;
    return bitsOf((off > farthest * farthest) & (in<Real>(block.response + lane) > 0)) << lane;
}

template <typename Real, bool areOfEdges>
DRENCH_LANES bool goOn(const ContactGroup& group, ContactBlock& block, const ContactTimes& times,
                       std::size_t lane) {
    constexpr float near = 0.02f;
    const Real none = {};
    const Real &force = in<Real>(block.force + lane), &response = in<Real>(block.response + lane);
    const auto adheres = in<Real>(block.adheres + lane) > 0;
    const auto touches =
        adheres | (in<Real>(block.gapBefore + lane) < in<Real>(block.distance + lane) * near);
    const auto acts = (in<Real>(block.isActive + lane) > 0) & (response > 0) & touches;
    const Real positive = force > 0 ? force : none;
    Real push = adheres ? force : positive;
    push = acts ? push * times.square : none;
    Triple<Real> drag = tripleIn<Real>(block.drag, lane);
    drag = {acts ? drag.x : none, acts ? drag.y : none, acts ? drag.z : none};
    in<Real>(block.push + lane) = push * response;
    put(block.drag, lane, drag);
    const auto isPushing = push != 0;
    if (!any(isPushing | (drag.x != 0) | (drag.y != 0) | (drag.z != 0))) return false;
    move<Real, areOfEdges>(group.moved, block, lane, push, drag);
    return any(isPushing);
}

// To an impulse of friction along a unit vector, 1/kg.
template <bool areOfEdges, typename Real>
DRENCH_LANES void slipResponse(Real& response, const Triple<Real>& direction, const ContactBlock& block,
                               std::size_t lane) {
    Real byP, byQ, turning[4];
    dot(byP, tripleIn<Real>(block.turning[0], lane), direction);
    dot(byQ, tripleIn<Real>(block.turning[1], lane), direction);
    turningOf<areOfEdges>(turning, byP, byQ);
    Real sum = {}, most = {};
    for (std::size_t k = 0; k < 4; ++k) {
        const Real &weight = in<Real>(block.slipWeights[k] + lane),
                   &inverseMass = in<Real>(block.inverseMass[k] + lane);
        const Real square = inverseMass * (weight * weight + turning[k] * turning[k]);
        sum += square;
        const Real moved = inverseMass * square;
        largerOf(most, most, moved);
    }
    rootOf(most);
    const Real limit = most * (1 / longestLever);
    largerOf(response, sum, limit);
}

// Friction in one sweep. @param most  its limit, kg m
// @return by how much the drag changes
template <bool areOfEdges, typename Real>
DRENCH_LANES Triple<Real> rub(const Corners<Real>& corners, const ContactBlock& block, const Real& most,
                              std::size_t lane) {
    const Triple<Real> normal = tripleIn<Real>(block.normal, lane), before = tripleIn<Real>(block.drag, lane);
    const Triple<Real> slid =
        slidOf<areOfEdges>(corners, block, lane) - tripleIn<Real>(block.slidBefore, lane);
    const Real none = {}, one = none + 1;
    Real along, distance, response, needed;
    dot(along, normal, slid);
    const Triple<Real> slip = slid - normal * along;
    dot(distance, slip, slip);
    rootOf(distance);
    const Real toUnit = distance > 0 ? 1 / distance : none;
    slipResponse<areOfEdges>(response, slip * toUnit, block, lane);
    const auto slips = (distance > 0) & (response > 0);
    const Real times = slips ? 1 / response : none;
    Triple<Real> drag = before - slip * times;
    dot(needed, drag, drag);
    rootOf(needed);
    const Real limit = most > 0 ? most : none;
    const Real held = needed > 0 ? limit / needed : none;
    drag = drag * (needed > most ? held : one);
    return drag - before;
}

template <typename Real, bool areOfEdges>
DRENCH_LANES void solve(ContactsSolved& solved, const ContactGroup& group, ContactBlock& block,
                        const ContactTimes& times, std::size_t lane) {
    const Real none = {}, one = none + 1;
    const Triple<Real> normal = tripleIn<Real>(block.normal, lane);
    const Real &response = in<Real>(block.response + lane), &gapBefore = in<Real>(block.gapBefore + lane),
               &adhesion = in<Real>(block.adhesion + lane);
    Real &pushNow = in<Real>(block.push + lane), &adheresNow = in<Real>(block.adheres + lane),
         &touchedNow = in<Real>(block.touched + lane);
    const Real push = pushNow, adhered = adheresNow, touched = touchedNow;

    Corners<Real> corners;
    gather<Real, areOfEdges>(corners, group.moved, block, lane);
    Real opened, gapSize;
    dot(opened, normal, apartOf(corners, block, lane));
    const Real gap = in<Real>(block.gap + lane) + opened;
    sizeOf(gapSize, gap);
    constexpr float infinite = std::numeric_limits<float>::max();
    const auto acts = (in<Real>(block.isActive + lane) > 0) & (response > 0) & (gapSize < infinite) &
                      ((gap <= 0) | (push != 0) | (adhered > 0));
    if (!any(acts)) return;

    const auto adheres = (adhesion > 0) & ((adhered > 0) | (gap < 0)) & (gap < in<Real>(block.reach + lane));
    const Real pull = adheres ? adhesion * response * times.square : none;
    const Real target = gapBefore > 0 ? -gapBefore : none;
    const Real wanted = push + target - (gap - gapBefore);
    const Real newPush = wanted > -pull ? wanted : -pull;
    const Real more = acts ? newPush - push : none, perResponse = response > 0 ? 1 / response : none;
    const Real moreOver = more * perResponse;
    for (std::size_t k = 0; k < 4; ++k) {
        const Real by = moreOver * in<Real>(block.weights[k] + lane) * corners.inverseMass[k];
        corners.at[k] = corners.at[k] + normal * by;
    }
    const Real most = in<Real>(block.friction + lane) * (newPush + pull) * perResponse;
    Triple<Real> drag = rub<areOfEdges>(corners, block, most, lane);
    drag = {acts ? drag.x : none, acts ? drag.y : none, acts ? drag.z : none};

    Real pushed, dragged;
    sizeOf(pushed, more);
    dot(dragged, drag, drag);
    rootOf(dragged);
    dragged *= response;
    largerOf(pushed, pushed, dragged);
    move<Real, areOfEdges>(group.moved, block, lane, moreOver, drag);
    pushNow = acts ? newPush : push;
    put(block.drag, lane, tripleIn<Real>(block.drag, lane) + drag);
    adheresNow = acts ? (adheres ? one : none) : adhered;
    const auto touches = acts & ((newPush > 0) | adheres);
    touchedNow = touches ? one : touched;
    const float farthest = largest(pushed / in<Real>(block.distance + lane));
    if (farthest > solved.most) solved.most = farthest;
    solved.isPushing |= any(pushNow != 0);
    solved.hasTouched |= any(touches);
}

template <typename Real, bool areOfEdges>
DRENCH_LANES void beginSettling(const ContactGroup& group, ContactBlock& block, std::size_t lane) {
    const Triple<Real> normal = tripleIn<Real>(block.normal, lane);
    Corners<Real> corners;
    Real moved, reference;
    gather<Real, areOfEdges>(corners, group.moved, block, lane);
    dot(moved, normal, apartOf(corners, block, lane));
    gather<Real, areOfEdges>(corners, group.reference, block, lane);
    dot(reference, normal, apartOf(corners, block, lane));
    in<Real>(block.opened + lane) =
        in<Real>(block.gap + lane) + moved - in<Real>(block.gapBefore + lane) + reference;
    in<Real>(block.notSettled + lane) = in<Real>(block.placed + lane);
}

// @return whether any of what was placed is left
template <typename Real, bool areOfEdges>
DRENCH_LANES bool settle(const ContactGroup& group, ContactBlock& block, std::size_t lane) {
    const Triple<Real> normal = tripleIn<Real>(block.normal, lane);
    const Real none = {};
    Real& notSettled = in<Real>(block.notSettled + lane);
    const Real& response = in<Real>(block.response + lane);
    Corners<Real> corners;
    Real reference, pulledBack;
    gather<Real, areOfEdges>(corners, group.reference, block, lane);
    dot(reference, normal, apartOf(corners, block, lane));
    const Real closed = reference - in<Real>(block.opened + lane);
    smallerOf(pulledBack, notSettled, closed);
    const auto acts = (pulledBack > 0) & (response > 0);
    if (!any(acts)) return any(notSettled > 0);
    pulledBack = acts ? pulledBack : none;
    notSettled -= pulledBack;
    move<Real, areOfEdges>(group.reference, block, lane, acts ? -pulledBack / response : none);
    return any(notSettled > 0);
}

template <typename Real>
DRENCH_LANES void finish(ContactBlock& block, const ContactTimes& times, std::size_t lane) {
    // A load goes on, an impact does not: what would hold the nodes at this acceleration may be added in a step.
    constexpr float growth = 1.5f, added = 60;  // m/s2 (assumed)
    const Real none = {}, one = none + 1;
    Real& force = in<Real>(block.force + lane);
    const Real& response = in<Real>(block.response + lane);
    const auto canMove = response > 0;
    const Real perResponse = canMove ? 1 / response : none;
    const Real push = in<Real>(block.push + lane) * perResponse * (1 / times.square);
    const Real most = (force > 0 ? force : none) * growth + perResponse * added;
    Real goesOn;
    smallerOf(goesOn, push, most);
    const Real share = push > 0 ? goesOn / push : one;
    put(block.drag, lane, tripleIn<Real>(block.drag, lane) * share);
    force = canMove ? goesOn : force;
}

// The loops over blocks.

template <typename Real, bool areOfEdges>
static bool separateEach(const ContactGroup& group, const ContactTimes& times) {
    bool are = false;
    for (std::size_t b = 0; b < group.count; ++b) {
        bool places = false;
        for (std::size_t lane = 0; lane < blockWidth; lane += widthOf<Real>)
            places |= separate<Real, areOfEdges>(group, group.blocks[b], times, lane);
        group.places[b] = places;
        are |= places;
    }
    return are;
}

template <typename Real, bool areOfEdges>
static bool beginEach(const ContactGroup& group) {
    unsigned all = 0;
    for (std::size_t b = 0; b < group.count; ++b) {
        unsigned strays = 0;
        for (std::size_t lane = 0; lane < blockWidth; lane += widthOf<Real>)
            strays |= begin<Real, areOfEdges>(group, group.blocks[b], lane);
        group.strays[b] = static_cast<std::uint8_t>(strays);
        all |= strays;
    }
    return all != 0;
}

template <typename Real, bool areOfEdges>
static bool goOnEach(const ContactGroup& group, const ContactTimes& times) {
    bool are = false;
    for (std::size_t b = 0; b < group.count; ++b)
        for (std::size_t lane = 0; lane < blockWidth; lane += widthOf<Real>)
            are |= goOn<Real, areOfEdges>(group, group.blocks[b], times, lane);
    return are;
}

template <typename Real, bool areOfEdges>
static ContactsSolved solveEach(const ContactGroup& group, const ContactTimes& times, bool backwards) {
    ContactsSolved solved;
    for (std::size_t b = 0; b < group.count; ++b)
        for (std::size_t lane = 0; lane < blockWidth; lane += widthOf<Real>)
            solve<Real, areOfEdges>(solved, group, group.blocks[backwards ? group.count - 1 - b : b], times,
                                    lane);
    return solved;
}

template <typename Real, bool areOfEdges>
static void beginSettlingEach(const ContactGroup& group) {
    for (std::size_t b = 0; b < group.count; ++b)
        for (std::size_t lane = 0; group.places[b] && lane < blockWidth; lane += widthOf<Real>)
            beginSettling<Real, areOfEdges>(group, group.blocks[b], lane);
}

template <typename Real, bool areOfEdges>
static void settleEach(const ContactGroup& group) {
    for (std::size_t b = 0; b < group.count; ++b) {
        if (!group.places[b]) continue;
        bool areLeft = false;
        for (std::size_t lane = 0; lane < blockWidth; lane += widthOf<Real>)
            areLeft |= settle<Real, areOfEdges>(group, group.blocks[b], lane);
        group.places[b] = areLeft;
    }
}

// The same, of both kinds of contacts.
template <typename Real>
static bool separateAll(const ContactGroup& group, const ContactTimes& times) {
    return group.areOfEdges ? separateEach<Real, true>(group, times)
                            : separateEach<Real, false>(group, times);
}
template <typename Real>
static bool beginAll(const ContactGroup& group) {
    return group.areOfEdges ? beginEach<Real, true>(group) : beginEach<Real, false>(group);
}
template <typename Real>
static bool goOnAll(const ContactGroup& group, const ContactTimes& times) {
    return group.areOfEdges ? goOnEach<Real, true>(group, times) : goOnEach<Real, false>(group, times);
}
template <typename Real>
static ContactsSolved solveAll(const ContactGroup& group, const ContactTimes& times, bool backwards) {
    return group.areOfEdges ? solveEach<Real, true>(group, times, backwards)
                            : solveEach<Real, false>(group, times, backwards);
}
template <typename Real>
static void beginSettlingAll(const ContactGroup& group) {
    group.areOfEdges ? beginSettlingEach<Real, true>(group) : beginSettlingEach<Real, false>(group);
}
template <typename Real>
static void settleAll(const ContactGroup& group) {
    group.areOfEdges ? settleEach<Real, true>(group) : settleEach<Real, false>(group);
}
template <typename Real>
static void finishAll(const ContactGroup& group, const ContactTimes& times) {
    for (std::size_t b = 0; b < group.count; ++b)
        for (std::size_t lane = 0; lane < blockWidth; lane += widthOf<Real>)
            finish<Real>(group.blocks[b], times, lane);
}

template <typename Real>
static ContactKernels kernelsFor() {
    return {separateAll<Real>,      beginAll<Real>,  goOnAll<Real>,  solveAll<Real>,
            beginSettlingAll<Real>, settleAll<Real>, finishAll<Real>};
}

}  // namespace lanes
}  // namespace drench
