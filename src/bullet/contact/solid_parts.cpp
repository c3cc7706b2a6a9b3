#include "bullet/contact/solid_parts.h"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <algorithm>

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

class TrianglesInBox final : public btTriangleCallback {
  public:
    TrianglesInBox(std::vector<SolidPart>& parts, const btTransform& inSolid, const Bounds& box)
        : parts_(parts), inSolid_(inSolid), isWholeSolid_(inSolid == btTransform::getIdentity()), box_(box) {}

    void processTriangle(btVector3* corners, int, int) override {
        std::array<btVector3, 3> placed = {corners[0], corners[1], corners[2]};
        if (!isWholeSolid_)
            for (btVector3& corner : placed) corner = inSolid_ * corner;
        Bounds bounds = {placed[0], placed[0]};
        bounds.take(placed[1]);
        bounds.take(placed[2]);
        if (bounds.meets(box_)) parts_.push_back({nullptr, inSolid_, placed, bounds});
    }

  private:
    std::vector<SolidPart>& parts_;
    const btTransform& inSolid_;
    const bool isWholeSolid_;
    const Bounds& box_;
};

void addChild(std::vector<SolidPart>& parts, const btCollisionShape& child, const btTransform& inSolid,
              const Bounds& box) {
    Bounds bounds;
    child.getAabb(inSolid, bounds.low, bounds.high);
    if (bounds.meets(box)) addParts(parts, child, inSolid, box);
}

class ChildrenInBox final : public btDbvt::ICollide {
  public:
    ChildrenInBox(std::vector<SolidPart>& parts, const btCompoundShape& compound, const btTransform& inSolid,
                  const Bounds& box)
        : parts_(parts), compound_(compound), inSolid_(inSolid), box_(box) {}

    void Process(const btDbvtNode* leaf) override {
        const int child = leaf->dataAsInt;
        addChild(parts_, *compound_.getChildShape(child), inSolid_ * compound_.getChildTransform(child),
                 box_);
    }

  private:
    std::vector<SolidPart>& parts_;
    const btCompoundShape& compound_;
    const btTransform& inSolid_;
    const Bounds& box_;
};

void addChildren(std::vector<SolidPart>& parts, const btCompoundShape& compound, const btTransform& inSolid,
                 const Bounds& box) {
    if (const btDbvt* const tree = compound.getDynamicAabbTree()) {
        const Bounds local = box.seenFrom(inSolid);
        ChildrenInBox children(parts, compound, inSolid, box);
        ATTRIBUTE_ALIGNED16(btDbvtVolume) volume = btDbvtVolume::FromMM(local.low, local.high);
        tree->collideTV(tree->m_root, volume, children);
        return;
    }
    for (int i = 0; i < compound.getNumChildShapes(); ++i)
        addChild(parts, *compound.getChildShape(i), inSolid * compound.getChildTransform(i), box);
}

// A GImpact compound has children, although its class is that of meshes; null for any other shape.
const btGImpactShapeInterface* gimpactCompound(const btCollisionShape& shape) {
    if (shape.getShapeType() != GIMPACT_SHAPE_PROXYTYPE) return nullptr;
    const auto& gimpact = static_cast<const btGImpactShapeInterface&>(shape);
    return gimpact.getGImpactShapeType() == CONST_GIMPACT_COMPOUND_SHAPE ? &gimpact : nullptr;
}

}  // namespace

btScalar SolidPart::farthestAlong(const btVector3& direction) const {
    if (convex)
        return direction.dot(inSolid * convex->localGetSupportingVertex(direction * inSolid.getBasis()));
    return std::max({direction.dot(corners[0]), direction.dot(corners[1]), direction.dot(corners[2])});
}

void addParts(std::vector<SolidPart>& parts, const btCollisionShape& shape, const btTransform& inSolid,
              const Bounds& box) {
    if (shape.isConvex()) {
        const btVector3 none(0, 0, 0);
        parts.push_back({static_cast<const btConvexShape*>(&shape), inSolid, {none, none, none}, {}});
        shape.getAabb(inSolid, parts.back().bounds.low, parts.back().bounds.high);
    } else if (shape.isCompound()) {
        addChildren(parts, static_cast<const btCompoundShape&>(shape), inSolid, box);
    } else if (const btGImpactShapeInterface* const compound = gimpactCompound(shape)) {
        compound->lockChildShapes();
        for (int i = 0; i < compound->getNumChildShapes(); ++i)
            addChild(parts, *const_cast<btGImpactShapeInterface*>(compound)->getChildShape(i),
                     inSolid * compound->getChildTransform(i), box);
        compound->unlockChildShapes();
    } else if (shape.isConcave()) {
        const Bounds local = box.seenFrom(inSolid);
        TrianglesInBox triangles(parts, inSolid, box);
        static_cast<const btConcaveShape&>(shape).processAllTriangles(&triangles, local.low, local.high);
    }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
