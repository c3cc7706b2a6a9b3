#include "bullet/small_steps/meeting_cloth.h"

#include <Eigen/Core>
#include <algorithm>
#include <utility>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// How far a node may leave its way and is still found where it comes near; and how far it may leave it before contacts
// are found again, as fractions of the cell. What comes nearer in between overlaps at first, on the side where it was.
constexpr float allowed = 0.2f, missed = 0.5f;

Eigen::Map<Eigen::Array4f> arrayOf(MovingNode& node) {
    return Eigen::Map<Eigen::Array4f>(&node.x);
}

}  // namespace

void MeetingCloth::startMotion(int stepsOfSubstep) {
    movedBefore.assign(moved, moved + tree->nodeCount());
    stepsLeft = stepsOfWay = stepsOfSubstep;
    expectMotion();
    followNodes();
}

void MeetingCloth::expectMotion() {
    from = movedBefore;
    waySteps = steps;
    horizon = std::min(stepsLeft, 2 * stepsOfWay + 1);
    stepsOfWay = seenAt = 0;
    stepsUnseen = 1;
    isFollowed = false;
}

bool MeetingCloth::isOnItsWay() {
    isFollowed = false;
    --stepsLeft;
    ++stepsOfWay;
    if (--stepsUnseen > 0 && stepsOfWay < horizon) return true;
    // Since the last look there were one or two steps.
    const float perStep = 1 / float(stepsOfWay - seenAt), next = float(stepsOfWay + 1);
    seenAt = stepsOfWay;
    Eigen::Array4f farthest = Eigen::Array4f::Zero();
    for (std::size_t n = 0; n < movedBefore.size(); ++n) {
        const auto now = arrayOf(moved[n]);
        arrayOf(steps[n]) = (now - arrayOf(movedBefore[n])) * perStep;
        arrayOf(movedBefore[n]) = now;
        const Eigen::Array4f off = now + arrayOf(steps[n]) - arrayOf(from[n]) - arrayOf(waySteps[n]) * next;
        farthest = farthest.max(off.abs());
    }
    const float off = farthest.head<3>().matrix().norm() / cell;
    stepsUnseen = off <= missed / 4 ? 2 : 1;
    return stepsOfWay < horizon && off <= missed;
}

// Those who began at another time may be off their ways by now.
void MeetingCloth::followNodes() {
    if (std::exchange(isFollowed, true)) return;
    const float deviation = (stepsOfWay == 0 ? 1 : 2) * allowed * cell;
    tree->follow(start, moved, {waySteps.data(), float(horizon - stepsOfWay), deviation});
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
