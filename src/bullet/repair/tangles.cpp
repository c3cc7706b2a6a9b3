#include "bullet/repair/tangles.h"

#include <algorithm>

#include "bullet/repair/health.h"
#include "bullet/world/body_watch.h"
#include "bullet/world/soft_world.h"
#include "bullet/world/vectors.h"
#include "checks/text.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

bool boundsMeet(const btSoftBody& one, const btSoftBody& other) {
    for (int axis = 0; axis < 3; ++axis)
        if (one.m_bounds[0][axis] > other.m_bounds[1][axis] ||
            one.m_bounds[1][axis] < other.m_bounds[0][axis])
            return false;
    return true;
}

// Positions in single precision are taken as they are, so that no crossing depends on rounding.
btVector3 originFor(const btSoftBody& body) {
    return sizeof(btScalar) == sizeof(float) ? btVector3(0, 0, 0) : body.m_nodes[0].m_x;
}

// Whether small steps keep a sheet apart from others.
bool isKeptFromOthers(const SheetMechanics& mechanics) {
    return mechanics.movedBySmallSteps && mechanics.meetsSheets;
}

std::string tangleOf(const CrossingCount& found, bool isKeptApart) {
    const std::string many = textOf(found.areAll ? "" : "at least ", found.ofItself + found.withOthers);
    if (!isKeptApart)
        return textOf(many,
                      " pairs of faces of the sheet have crossed each other for a second; without a "
                      "SmallStepSolver nothing keeps a sheet apart from itself: use one, or set "
                      "SheetSettings::meetsItself to false if it may pass through itself");
    return textOf(
        many, " pairs of faces, ", found.withOthers,
        " of them with other sheets, have crossed for a "
        "second, and the SmallStepSolver does not get them apart; look for sheets that begin inside "
        "each other, for solids that squeeze cloth, and for speeds of more than a margin per small "
        "step: a coarser mesh, a wider margin or more small steps help against those");
}

}  // namespace

SurfaceTree& CrossingSearch::follow(btSoftBody& body, SheetMechanics& mechanics, const btVector3& origin) {
    SurfaceTree& tree = mechanics.treeFor(body.getCollisionShape()->getMargin());
    positions_.clear();
    for (int n = 0; n < body.m_nodes.size(); ++n) {
        const btVector3 at = body.m_nodes[n].m_x - origin;
        positions_.push_back({float(at.x()), float(at.y()), float(at.z()), 0});
    }
    still_.resize(positions_.size(), MovingNode{0, 0, 0, 0});
    tree.follow(positions_.data(), still_.data());
    return tree;
}

CrossingCount CrossingSearch::count(btSoftBody& body, SheetMechanics& mechanics,
                                    const std::vector<btSoftBody*>& others, const CrossingLimits& limits,
                                    bool looksEverywhere) {
    const btVector3 origin = originFor(body);
    const SurfaceTree& tree = follow(body, mechanics, origin);
    CrossingCount found;
    CrossingLimits left = limits;
    const auto take = [&](int& pairs) {
        const std::vector<CrossingPair>& all = crossings_.pairs();
        pairs += static_cast<int>(all.size());
        left.pairs -= static_cast<std::int64_t>(all.size());
        left.looks -= crossings_.looks();
        found.areAll = found.areAll && crossings_.areAll();
        if (found.firstNode < 0 && !all.empty())
            found.firstNode = tree.faces()[static_cast<std::size_t>(all.front().face)].nodes[0];
    };
    crossings_.findWithin(tree, left, looksEverywhere);
    take(found.ofItself);
    for (btSoftBody* const other : others) {
        const SurfaceTree& tree2 = follow(*other, *BodyWatch::mechanicsOf(*other), origin);
        crossings_.find(tree, tree2, Eigen::Vector3d::Zero(), left);
        take(found.withOthers);
    }
    return found;
}

std::vector<btSoftBody*> sheetsNear(btDiscreteDynamicsWorld& world, const btSoftBody& body) {
    std::vector<btSoftBody*> near;
    const auto& all = softBodiesOf(world);
    for (int i = 0; i < all.size(); ++i) {
        if (all[i] == &body || !boundsMeet(body, *all[i])) continue;
        const SheetMechanics* const mechanics = BodyWatch::mechanicsOf(*all[i]);
        if (mechanics && mechanics->fits && hasCountsOf(*all[i], mechanics->shape) && isFinite(*all[i]))
            near.push_back(all[i]);
    }
    return near;
}

void TangleCheck::step(btDiscreteDynamicsWorld& world, btSoftBody& body, SheetMechanics& mechanics,
                       double bodyStep, Diagnostics& diagnostics) {
    // Three looks in a row make a second.
    constexpr double between = 0.5;
    constexpr int lasts = 3;
    constexpr CrossingLimits limits = {10000, 2000000};
    // Where nothing keeps the layers apart, every fold crosses a little.
    constexpr double bad = 0.01;  // of the faces (assumed)
    untilNext_ -= bodyStep;
    // Before the first substep it is unknown what moves the sheet.
    if (untilNext_ > bodyStep / 2 || mechanics.times.substeps == 0 || !body.isActive()) return;
    const bool isKeptApart = mechanics.movedBySmallSteps;
    if (!mechanics.meetsItself && !isKeptFromOthers(mechanics)) return;
    std::vector<btSoftBody*> others;
    if (isKeptFromOthers(mechanics)) others = sheetsNear(world, body);
    // Those have the same solver.
    const auto isLeftAlone = [](btSoftBody* other) { return !BodyWatch::mechanicsOf(*other)->meetsSheets; };
    others.erase(std::remove_if(others.begin(), others.end(), isLeftAlone), others.end());
    CrossingCount found = search_.count(body, mechanics, others, limits, false);
    if (!mechanics.meetsItself) found.ofItself = 0;
    const int crossing = found.ofItself + found.withOthers;
    const bool isTangled =
        isKeptApart ? crossing > 0 : crossing > bad * double(mechanics.mesh.triangles.size());
    lasting_ = isTangled ? std::min(lasting_ + 1, lasts) : 0;
    if (lasting_ == lasts)
        diagnostics.note(Trouble::crossing, tangleOf(found, isKeptApart), found.firstNode, crossing);
    untilNext_ = between;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
