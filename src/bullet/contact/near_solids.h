// The paths of solids that the application moves, near a sheet.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletSoftBody/btSoftBody.h>

#include <vector>

#include "bullet/contact/rigid_motion.h"
#include "bullet/world/bounds.h"
#include "drench/config.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Whether Bullet itself moves an object within a substep: a dynamic rigid body or a link of a btMultiBody. The
// application moves kinematic bodies, static bodies and ghosts between frames.
bool movesInStep(const btCollisionObject& object);

// Remembers where the application's solids were. Bullet knows the velocity of kinematic rigid bodies only, and
// puts these at their place at the end of a frame when the frame starts, even if it has several substeps.
class NearSolids {
  public:
    // A motion between two frames that is longer than this, m, and faster than this, m/s, or a larger turn than
    // this, rad, counts as a jump: the solid is where it is now, and pushes nothing on its way.
    static constexpr double jumpDistance = 0.5, jumpSpeed = 30, jumpTurn = 2.1;

    // Finds the solids near a sheet or anchored to it, and their paths in this substep.
    // @param bounds     of the sheet
    // @param hasJumped  whether the application has put sheet and solids to another place; nothing then moves
    void begin(const btSoftBody& sheet, Bounds bounds, double substep, bool hasJumped);

    // Only remembers where they are now. For a sheet that is new or was restored.
    void observe(const btSoftBody& sheet);

    // Path of a solid in this substep; of one that is not near or moves by itself, that it stays.
    SolidPath pathOf(const btCollisionObject& object) const;
    // The path on which a solid has jumped since the last substep; null if it has not.
    const SolidPath* jumpOf(const btCollisionObject& object) const;

    // Calls `each(object, path)` for all solids that move in this substep.
    template <typename Each>
    void forEachMoving(Each each) const {
        for (const Seen& seen : seen_)
            if (seen.path.isMoving()) each(*seen.object, seen.path);
    }

  private:
    struct Seen {
        int number;  // that Bullet gives to each proxy; the address alone may be that of a new object
        const btCollisionObject* object;
        SolidPath path;
        SolidPath jump;
        bool hasJumped;

        bool operator<(const Seen& other) const {
            return number != other.number ? number < other.number : object < other.object;
        }
        bool operator==(const Seen& other) const { return number == other.number && object == other.object; }
    };
    class Finder;
    void add(const btCollisionObject& object);
    const Seen* find(const btCollisionObject& object) const;
    static void follow(Seen& seen, const Seen* last, btScalar substep);
    static void followKinematic(Seen& seen, const Seen* last, const Twist& perSubstep, btScalar substep);

    std::vector<Seen> seen_, last_;  // sorted
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
