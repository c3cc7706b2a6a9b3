#include "bullet/small_steps/untangler.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "bullet/world/vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// With which both sides are moved apart, as a multiple of the distance that contacts keep, 1/s (assumed).
constexpr float distancesPerSecond = 40;

// For how long cloth is moved apart, s (assumed): most gets apart within one.
constexpr double longest = 2;

// More are left to the next substep.
constexpr CrossingLimits limits = {20000, 500000};

const std::array<int, 3>& nodesOf(const MeetingCloth& cloth, int face) {
    return cloth.tree->faces()[static_cast<std::size_t>(face)].nodes;
}

Eigen::Vector3d normalOf(const FaceCorners& face) {
    return (face[1] - face[0]).cross(face[2] - face[0]).normalized();
}

}  // namespace

void Untangler::clear() {
    count_ = 0;
}

Untangler::Tangle& Untangler::newTangle(const MeetingCloth& one, const MeetingCloth& other) {
    if (count_ == tangles_.size()) tangles_.emplace_back();
    Tangle& tangle = tangles_[count_++];
    tangle.one = &one;
    tangle.other = &other;
    tangle.sides[0].cloth = &one;
    tangle.sides[1].cloth = &other;
    for (Side& side : tangle.sides) {
        side.velocities.assign(side.cloth->tree->nodeCount(), Eigen::Vector3f::Zero());
        side.crosses.assign(side.cloth->tree->nodeCount(), 0);
    }
    return tangle;
}

bool Untangler::find(const ClothPair& pair, const MeetingCloth& one, const MeetingCloth& other) {
    if (&one == &other)
        crossings_.findWithin(*one.tree, limits, false);
    else
        crossings_.find(*one.tree, *other.tree, toEigen(other.origin - one.origin), limits);
    if (crossings_.pairs().empty()) return false;
    if (std::max(one.memory->crossing(), other.memory->crossing()) > longest) return true;
    Tangle& tangle = newTangle(one, other);
    passages_.clear();
    for (std::size_t i = 0; i < crossings_.pairs().size(); ++i)
        addPassages(tangle, crossings_.pairs()[i], static_cast<int>(i));
    mergePassages();
    moveLinesAsOne();
    const float speed = distancesPerSecond * pair.distance;
    for (const Passage& passage : passages_) moveApart(tangle, passage, speed);
    for (Side& side : tangle.sides)
        for (Eigen::Vector3f& velocity : side.velocities)
            velocity *= std::min(1.0f, speed / std::max(velocity.norm(), speed));
    return true;
}

void Untangler::addPassages(const Tangle& tangle, const CrossingPair& pair, int index) {
    const MeetingCloth &one = *tangle.one, &other = *tangle.other;
    const bool areOne = &one == &other;
    const FaceCorners face = Crossings::cornersOf(*one.tree, pair.face, Eigen::Vector3d::Zero());
    const FaceCorners second =
        Crossings::cornersOf(*other.tree, pair.other, toEigen(other.origin - one.origin));
    const int sideOfOther = areOne ? 0 : 1;
    const auto add = [&](const FaceCorners& ofEdges, const FaceCorners& through, bool isOfFirst) {
        EdgeAndFace of;
        of.side = isOfFirst ? 0 : sideOfOther;
        of.faceSide = isOfFirst ? sideOfOther : 0;
        of.face = isOfFirst ? pair.other : pair.face;
        of.pair = index;
        of.isOfFirst = isOfFirst;
        const std::array<int, 3>& nodes =
            nodesOf(*tangle.sides[of.side].cloth, isOfFirst ? pair.face : pair.other);
        for (std::size_t edge = 0; edge < 3; ++edge) {
            of.ends = {nodes[edge], nodes[(edge + 1) % 3]};
            addPassage(ofEdges, through, edge, of);
        }
    };
    add(face, second, true);
    add(second, face, false);
}

// @param edge  of the face, from this corner to the next
void Untangler::addPassage(const FaceCorners& ofEdge, const FaceCorners& through, std::size_t edge,
                           EdgeAndFace of) {
    std::size_t from = edge, to = (edge + 1) % 3;
    const std::size_t opposite = (edge + 2) % 3;
    if (of.ends[0] > of.ends[1]) {
        std::swap(of.ends[0], of.ends[1]);
        std::swap(from, to);
    }
    const auto at = edgeThroughFace(ofEdge[from], ofEdge[to], through);
    if (!at) return;
    const Eigen::Vector3d along = (ofEdge[to] - ofEdge[from]).normalized(), normal = normalOf(through);
    // Along the line, from the edge into the face that it is of.
    const Eigen::Vector3d line = normalOf(ofEdge).cross(normal).normalized();
    const Eigen::Vector3d toOpposite = ofEdge[opposite] - ofEdge[from];
    const Eigen::Vector3d across = toOpposite - along * along.dot(toOpposite);
    const Eigen::Vector3d inward = line.dot(across) < 0 ? Eigen::Vector3d(-line) : line;
    constexpr double level = 0.05;  // sine of the angle of an edge along the face
    const double slope = along.dot(normal);
    const double limited = std::copysign(std::max(std::abs(slope), level), slope);
    const Eigen::Vector3d shrinks = inward - normal * (2 * along.dot(inward) / limited);
    if (shrinks.allFinite()) passages_.push_back({of, *at, shrinks});
}

// An edge passes through a face with each of the faces at it.
void Untangler::mergePassages() {
    const auto name = [](const Passage& passage) {
        const EdgeAndFace& of = passage.of;
        return std::tie(of.side, of.ends, of.faceSide, of.face);
    };
    std::stable_sort(passages_.begin(), passages_.end(),
                     [&](const Passage& a, const Passage& b) { return name(a) < name(b); });
    lines_.clear();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < passages_.size(); ++i) {
        if (kept > 0 && name(passages_[kept - 1]) == name(passages_[i]))
            passages_[kept - 1].shrinks += passages_[i].shrinks;
        else
            passages_[kept++] = passages_[i];
        lines_.push_back({passages_[i].of.pair, kept - 1, passages_[i].of.isOfFirst});
    }
    passages_.resize(kept);
}

// All points of a line move in the direction in which it shrinks as a whole: only its ends and its bends tell, and each
// for itself would pull at the cloth between them in vain.
void Untangler::moveLinesAsOne() {
    contours_.clear(passages_.size());
    std::sort(lines_.begin(), lines_.end(), [](const OnLine& a, const OnLine& b) {
        return std::tie(a.pair, a.passage, a.isOfFirst) < std::tie(b.pair, b.passage, b.isOfFirst);
    });
    for (std::size_t i = 1; i < lines_.size(); ++i)
        if (lines_[i].pair == lines_[i - 1].pair)
            contours_.join(lines_[i - 1].passage, lines_[i].passage,
                           lines_[i].isOfFirst == lines_[i - 1].isOfFirst);
    for (std::size_t i = 0; i < passages_.size(); ++i) {
        const auto [first, areAlike] = contours_.firstOf(i);
        if (first != i) passages_[first].shrinks += areAlike ? passages_[i].shrinks : -passages_[i].shrinks;
    }
    for (std::size_t i = 0; i < passages_.size(); ++i) {
        const auto [first, areAlike] = contours_.firstOf(i);
        if (first != i)
            passages_[i].shrinks =
                areAlike ? passages_[first].shrinks : Eigen::Vector3d(-passages_[first].shrinks);
    }
}

void ContourLines::clear(std::size_t points) {
    before_.resize(points);
    for (std::size_t i = 0; i < points; ++i) before_[i] = i;
    isAlike_.assign(points, 1);
}

std::pair<std::size_t, bool> ContourLines::firstOf(std::size_t point) const {
    bool areAlike = true;
    for (; before_[point] != point; point = before_[point]) areAlike = areAlike == (isAlike_[point] != 0);
    return {point, areAlike};
}

void ContourLines::join(std::size_t one, std::size_t other, bool areAlike) {
    const auto [first, isOneAlike] = firstOf(one);
    const auto [second, isOtherAlike] = firstOf(other);
    if (first == second)
        return;  // a line that comes back to the other sheet has no sides; it keeps those that it has
    const std::size_t low = std::min(first, second), high = std::max(first, second);
    before_[high] = low;
    isAlike_[high] = (isOneAlike == isOtherAlike) == areAlike ? 1 : 0;
}

void Untangler::moveApart(Tangle& tangle, const Passage& passage, float speed) const {
    Side &ofEdge = tangle.sides[passage.of.side], &ofFace = tangle.sides[passage.of.faceSide];
    const std::array<int, 3>& corners = nodesOf(*ofFace.cloth, passage.of.face);
    for (const int node : passage.of.ends) ofEdge.crosses[static_cast<std::size_t>(node)] = 1;
    for (const int node : corners) ofFace.crosses[static_cast<std::size_t>(node)] = 1;
    constexpr double half = 0.3;  // at which it moves with 0.7 of the greatest speed (assumed)
    const Eigen::Vector3f velocity =
        (passage.shrinks * (double(speed) / std::sqrt(passage.shrinks.squaredNorm() + half * half)))
            .cast<float>();
    const auto along = float(passage.at.along);
    const float weights[5] = {1 - along, along, -float(passage.at.weights[0]), -float(passage.at.weights[1]),
                              -float(passage.at.weights[2])};
    const int nodes[5] = {passage.of.ends[0], passage.of.ends[1], corners[0], corners[1], corners[2]};
    float shares[5], response = 0, largest = 0;
    for (int i = 0; i < 5; ++i) {
        const MeetingCloth& cloth = *(i < 2 ? ofEdge : ofFace).cloth;
        shares[i] = weights[i] * cloth.moved[nodes[i]].inverseMass;
        response += shares[i] * weights[i];
        largest = std::max(largest, std::abs(shares[i]));
    }
    if (!(largest > 0)) return;
    response = std::max(response, largest);
    for (int i = 0; i < 5; ++i)
        (i < 2 ? ofEdge : ofFace).velocities[static_cast<std::size_t>(nodes[i])] +=
            velocity * (shares[i] / response);
}

void Untangler::leaveOut(ClothPair& pair, const MeetingCloth& one, const MeetingCloth& other) const {
    const auto of = [&](const Tangle& tangle) { return tangle.one == &one && tangle.other == &other; };
    const auto end = tangles_.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto found = std::find_if(tangles_.begin(), end, of);
    if (found == end) return;
    pair.contacts.erase(
        std::remove_if(pair.contacts.begin(), pair.contacts.end(),
                       [&](const PairContact& contact) { return holdsCrossing(*found, contact); }),
        pair.contacts.end());
}

// Whether both sides of a contact cross something, and are not moved apart along its normal.
bool Untangler::holdsCrossing(const Tangle& tangle, const PairContact& contact) {
    const MeetingCloth &one = *tangle.one, &other = *tangle.other;
    const auto sideOf = [&](bool isOfOther) -> const Side& {
        return tangle.sides[isOfOther && &one != &other ? 1 : 0];
    };
    bool cross[2] = {false, false};
    Eigen::Vector3f apart = Eigen::Vector3f::Zero();
    const auto take = [&](bool isOfOther, int node, std::size_t slot, bool isSecond) {
        const Side& side = sideOf(isOfOther);
        const auto n = static_cast<std::size_t>(node);
        cross[isSecond ? 1 : 0] = cross[isSecond ? 1 : 0] || side.crosses[n];
        apart += side.velocities[n] * contact.weights[static_cast<int>(slot)];
    };
    if (contact.isOfEdges) {
        const auto &ends = one.tree->edges()[static_cast<std::size_t>(contact.edge)].nodes,
                   &others = other.tree->edges()[static_cast<std::size_t>(contact.face)].nodes;
        for (std::size_t i = 0; i < 2; ++i) {
            take(false, ends[i], i, false);
            take(true, others[i], i + 2, true);
        }
    } else {
        const std::array<int, 3>& corners = nodesOf(contact.isOfOther ? one : other, contact.face);
        take(contact.isOfOther, contact.node, 0, false);
        for (std::size_t i = 0; i < 3; ++i) take(!contact.isOfOther, corners[i], i + 1, true);
    }
    return cross[0] && cross[1] && !(apart.dot(contact.normal) > 0);
}

void Untangler::pull(double smallStep) {
    const auto step = float(smallStep);
    for (std::size_t t = 0; t < count_; ++t)
        for (const Side& side : tangles_[t].sides)
            for (std::size_t n = 0; n < side.velocities.size(); ++n) {
                if (side.velocities[n].isZero(0)) continue;
                const Eigen::Vector3f by = side.velocities[n] * step;
                for (MovingNode* const node : {&side.cloth->moved[n], &side.cloth->reference[n]}) {
                    node->x += by.x();
                    node->y += by.y();
                    node->z += by.z();
                }
            }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
