#include "bullet/small_steps/guest_cloth.h"

#include <algorithm>
#include <cmath>

#include "bullet/sheet/rest_shape.h"
#include "bullet/world/vectors.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

MovingNode packed(const btVector3& v, float inverseMass) {
    return {float(v.x()), float(v.y()), float(v.z()), inverseMass};
}

std::array<int, 3> cornersOf(const btSoftBody& body, int face) {
    const auto& nodes = body.m_faces[face].m_n;
    return {indexOf(body, nodes[0]), indexOf(body, nodes[1]), indexOf(body, nodes[2])};
}

}  // namespace

bool GuestCloth::isSameCloth(const btSoftBody& body) const {
    if (!tree_ || start_.size() != static_cast<std::size_t>(body.m_nodes.size()) ||
        triangles_.size() != static_cast<std::size_t>(body.m_faces.size()))
        return false;
    for (int f = 0; f < body.m_faces.size(); ++f)
        if (cornersOf(body, f) != triangles_[static_cast<std::size_t>(f)]) return false;
    return true;
}

void GuestCloth::makeTree(const btSoftBody& body) {
    triangles_.clear();
    std::vector<SurfaceTree::Corners> corners;
    for (int f = 0; f < body.m_faces.size(); ++f) {
        triangles_.push_back(cornersOf(body, f));
        SurfaceTree::Corners& at = corners.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const btVector3 place = body.m_nodes[triangles_.back()[i]].m_x - origin_;
            at[i] = {float(place.x()), float(place.y()), float(place.z())};
        }
    }
    // A guest is not kept apart from itself.
    tree_ = std::make_unique<SurfaceTree>(triangles_, static_cast<std::size_t>(body.m_nodes.size()), corners,
                                          0.0f);
}

void GuestCloth::begin(const btSoftBody& body, float fraction) {
    origin_ = body.m_nodes[0].m_x;
    if (!isSameCloth(body)) {
        memory.clear();
        makeTree(body);
    }
    const auto count = static_cast<std::size_t>(body.m_nodes.size());
    for (auto* nodes : {&start_, &own_, &moved_, &before_}) nodes->resize(count);
    isCarried_.assign(count, 0);
    // Bullet does not move sleeping bodies, and neither does this.
    const bool isAwake = body.isActive();
    for (std::size_t n = 0; n < count; ++n) {
        const btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        const btVector3 start = isAwake ? node.m_q : node.m_x;
        start_[n] = packed(start - origin_, 0);
        own_[n] = packed(node.m_x - start, 0);
        moved_[n] = before_[n] = {0, 0, 0, isAwake ? float(node.m_im) : 0};
    }
    fraction_ = fraction;
    isFirstStep_ = true;
}

void GuestCloth::advance() {
    for (std::size_t n = 0; n < moved_.size(); ++n) {
        // The node continues with the velocity that it got from impulses.
        MovingNode &moved = moved_[n], &before = before_[n];
        const btVector3 step =
            isFirstStep_ ? vectorOf(own_[n]) * btScalar(fraction_) : vectorOf(moved) - vectorOf(before);
        before = moved;
        shift(moved, step);
    }
    isFirstStep_ = false;
}

void GuestCloth::finish(btSoftBody& body, double smallStep) const {
    for (std::size_t n = 0; n < moved_.size(); ++n) {
        const btVector3 moved = vectorOf(moved_[n]), own = vectorOf(own_[n]);
        btSoftBody::Node& node = body.m_nodes[static_cast<int>(n)];
        const btVector3 more = moved - own;
        if (!(moved_[n].inverseMass > 0) || more.isZero() || !std::isfinite(more.x() + more.y() + more.z()))
            continue;
        node.m_x += more;
        node.m_v += (moved - vectorOf(before_[n]) - own * btScalar(fraction_)) / btScalar(smallStep);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
