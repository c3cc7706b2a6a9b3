// Axis-aligned boxes.
#pragma once

#include <LinearMath/btTransform.h>

#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// An axis-aligned box, m.
struct Bounds {
    btVector3 low, high;

    void grow(btScalar by) {
        low -= btVector3(by, by, by);
        high += btVector3(by, by, by);
    }
    void take(const btVector3& point) {
        low.setMin(point);
        high.setMax(point);
    }
    void take(const Bounds& other) {
        low.setMin(other.low);
        high.setMax(other.high);
    }
    bool meets(const Bounds& other) const {
        // Without branches, because boxes that miss each other do so along any axis.
        return (high.x() >= other.low.x()) & (low.x() <= other.high.x()) & (high.y() >= other.low.y()) &
               (low.y() <= other.high.y()) & (high.z() >= other.low.z()) & (low.z() <= other.high.z());
    }
    // Of a point from the box, m2.
    btScalar squaredDistance(const btVector3& point) const {
        btVector3 apart = low - point;
        apart.setMax(point - high);
        apart.setMax({0, 0, 0});
        return apart.length2();
    }
    // Half of its surface, m2.
    btScalar halfSurface() const {
        const btVector3 size = high - low;
        return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
    }
    btScalar halfDiagonal() const { return (high - low).length() / 2; }
    // The box around this one in the coordinates of a frame.
    Bounds seenFrom(const btTransform& frame) const {
        const btMatrix3x3 turn = frame.getBasis().transpose();
        const btVector3 centre = frame.invXform((low + high) / 2);
        const btVector3 half = turn.absolute() * ((high - low) / 2);
        return {centre - half, centre + half};
    }
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
