#include "bullet/small_steps/solid_contacts.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bullet/contact/contact_law.h"
#include "bullet/contact/flat_neighbours.h"
#include "bullet/sheet/rest_shape.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

namespace {

// Distance of the surroundings that are searched from a node that stays where it is, in margins.
constexpr auto slack = btScalar(1.5);

constexpr std::size_t notKept = std::numeric_limits<std::size_t>::max();

// Of a path that turns around the origin by an angle: its largest distance from its chord, m.
btScalar sagitta(btScalar farthest, btScalar angle) {
    return angle > 0 ? farthest * (1 - btCos(std::min(angle, SIMD_PI) / 2)) : 0;
}

btVector3 vector(const float (&of)[3]) {
    return {btScalar(of[0]), btScalar(of[1]), btScalar(of[2])};
}

}  // namespace

void SolidContacts::clear() {
    met_.clear();
    touching_.clear();
    nodes_.clear();
    contacts_.clear();
}

void SolidContacts::meet(const btCollisionObject& object) {
    // Bullet reports meshes once for each triangle.
    const auto isSame = [&](const Met& met) { return met.object == &object; };
    if (!object.hasContactResponse() || !object.getBroadphaseHandle()) return;
    if (std::any_of(met_.rbegin(), met_.rend(), isSame)) return;
    met_.push_back({&object, object.getBroadphaseHandle()->m_uniqueId, object.getWorldTransform(), false});
}

// Marks the reported solids whose proxy is still in the broadphase.
class SolidContacts::ProxySearch final : public btBroadphaseAabbCallback {
  public:
    explicit ProxySearch(std::vector<Met>& met) : met_(met) {}

    bool process(const btBroadphaseProxy* proxy) override {
        for (Met& met : met_)
            if (proxy->m_clientObject == met.object && proxy->m_uniqueId == met.number) met.isThere = true;
        return true;
    }

  private:
    std::vector<Met>& met_;
};

void SolidContacts::addSolids(const btSoftBody& body, const Friction& sheetFriction, const NearSolids& near,
                              Solids& solids) {
    if (met_.empty()) return;
    ProxySearch search(met_);
    body.m_worldInfo->m_broadphase->aabbTest(body.m_bounds[0], body.m_bounds[1], search);
    met_.erase(std::remove_if(met_.begin(), met_.end(), [](const Met& met) { return !met.isThere; }),
               met_.end());
    // Bullet reports solids in the order in which they first met, which is unknown to restored sheets.
    std::sort(met_.begin(), met_.end(), [](const Met& a, const Met& b) {
        return a.object->getWorldArrayIndex() < b.object->getWorldArrayIndex();
    });
    for (const Met& met : met_) {
        const SolidPath path = movesInStep(*met.object)
                                   ? SolidPath{met.start, met.object->getWorldTransform()}
                                   : near.pathOf(*met.object);
        // Bullet passes solids as const, although they may be pushed.
        auto& object = *const_cast<btCollisionObject*>(met.object);
        touching_.push_back({solids.add(object, path), sheetFriction.surfaceAt(object, body.m_cfg.kDF)});
    }
}

void SolidContacts::begin(btSoftBody& body, SmallStepSheet& sheet, const Friction& sheetFriction,
                          const Solids& solids) {
    body_ = &body;
    sheetFriction_ = &sheetFriction;
    margin_ = body.getCollisionShape()->getMargin();
    reach_ = btScalar(sheetFriction.reach());
    sheet.clearCarried();
    parts_.clear();
    candidates_.clear();
    startPoses_.clear();
    for (std::size_t i = 0; i < touching_.size(); ++i) {
        const Solid& solid = solids[touching_[i].solid];
        startPoses_.push_back(solid.path().start);
        find(sheet, solid, i);
    }
    gatherNodes();
    for (NodeContacts& of : nodes_) {
        const btVector3& start = body.m_nodes[static_cast<int>(of.node)].m_x;
        sights_.clear();
        for (std::size_t i = 0; i < of.candidates; ++i) {
            const Candidate& candidate = candidates_[of.firstCandidate + i];
            sights_.push_back({of.firstCandidate + i, candidate.distance, candidate.normal, candidate.reach});
        }
        choose(of, start, startPoses_);
        writeContacts(of, start, startPoses_, sheet, solids);
        lift(sheet, of, solids);
    }
}

// A solid, and how far its surroundings are searched.
struct SolidContacts::Search {
    const SmallStepSheet& sheet;
    const Solid& solid;
    std::size_t touching;
    Bounds bounds;  // of the shape, in the coordinates of the solid
    btScalar turn;  // angle by which the solid turns in the substep, rad
    // How much farther than by its velocity a node may get, because others pull it, m: they may be as fast as any,
    // or meet the solid at full speed.
    btScalar pull;
};

void SolidContacts::find(const SmallStepSheet& sheet, const Solid& solid, std::size_t touching) {
    const btCollisionShape& shape = *solid.object().getCollisionShape();
    const Twist motion = solid.path().motion();
    Search search = {sheet, solid, touching, {}, motion.angular.length(), sheet.farthestPull()};
    shape.getAabb(btTransform::getIdentity(), search.bounds.low, search.bounds.high);
    search.pull +=
        ((sheet.meanReach() - motion.linear).length() + search.turn * search.bounds.halfDiagonal()) / 2;
    const btScalar around = slack * margin_ + search.pull + (sheetFriction_->canAdhere() ? reach_ : 0);
    if (shape.isConvex()) gather(shape, search.bounds);
    const auto pathOf = [&](std::size_t group) {
        const Bounds& nodes = sheet.bounds()[group];
        Bounds path = nodes.seenFrom(solid.path().start);
        if (solid.path().isMoving()) path.take(nodes.seenFrom(solid.path().end));
        path.grow(around + sagitta(std::max(path.low.length(), path.high.length()), search.turn));
        return path;
    };
    std::size_t gathered = 0;  // groups whose surroundings have been gathered
    for (std::size_t group = 0; group < sheet.bounds().size(); ++group) {
        const Bounds path = pathOf(group);
        if (!path.meets(search.bounds)) continue;
        if (!shape.isConvex() && group >= gathered) {
            // Together with the next groups, where these lie side by side, so that few parts are gathered twice.
            constexpr std::size_t most = 16;
            constexpr auto wasted = btScalar(1.1);
            Bounds all = path;
            for (gathered = group + 1; gathered < std::min(group + most, sheet.bounds().size()); ++gathered) {
                const Bounds next = pathOf(gathered);
                Bounds both = all;
                both.take(next);
                if (both.halfSurface() > wasted * (all.halfSurface() + next.halfSurface())) break;
                all = both;
            }
            gather(shape, all);
        }
        const std::size_t first = group * SmallStepSheet::nodesOfBounds;
        const std::size_t end = std::min(first + SmallStepSheet::nodesOfBounds, sheet.size());
        for (std::size_t n = first; n < end; ++n) findNode(search, n);
    }
}

void SolidContacts::gather(const btCollisionShape& shape, const Bounds& box) {
    gathered_.clear();
    addParts(gathered_, shape, btTransform::getIdentity(), box);
    cells_.assign(gathered_, box);
    keptAs_.assign(gathered_.size(), notKept);
}

void SolidContacts::findNode(const Search& search, std::size_t n) {
    const btSoftBody::Node& node = body_->m_nodes[static_cast<int>(n)];
    if (!(node.m_im > 0) || node.m_battach) return;
    const SolidPath& path = search.solid.path();
    const btVector3 from = path.start.invXform(node.m_x);
    const btVector3 to = path.end.invXform(node.m_x + vectorOf(search.sheet.reach(n)));
    const btScalar around =
        slack * margin_ + search.pull + sagitta(std::max(from.length(), to.length()), search.turn);
    const std::size_t first = candidates_.size();
    findParts(search, n, from, to, around);
    // A bond may be longer than what comes near is away; it is with the nearest part.
    if (candidates_.size() > first || sheetFriction_->adheresTo[n] != &search.solid.object()) return;
    findParts(search, n, from, to, around + reach_);
    if (candidates_.size() <= first + 1) return;
    const auto begin = candidates_.begin() + static_cast<std::ptrdiff_t>(first);
    *begin = *std::min_element(begin, candidates_.end(), [](const Candidate& a, const Candidate& b) {
        return a.distance < b.distance;
    });
    candidates_.resize(first + 1);
}

// Adds the parts around the way of a node, in the coordinates of the solid.
void SolidContacts::findParts(const Search& search, std::size_t n, const btVector3& from, const btVector3& to,
                              btScalar around) {
    Bounds way = {from, from};
    way.take(to);
    way.grow(around);
    if (!way.meets(search.bounds)) return;
    const btScalar reach = (to - from).length();
    const btScalar farthest = around + reach, fromMiddle = around + reach / 2;
    const btVector3 middle = (from + to) / 2;
    cells_.forEach(way, [&](std::size_t i) {
        if (gathered_[i].bounds.squaredDistance(middle) > fromMiddle * fromMiddle) return;
        const SurfacePoint surface = nearestOn(gathered_[i], from, body_->m_worldInfo->m_sparsesdf);
        if (!(surface.distance <= farthest)) return;
        if (keptAs_[i] == notKept) {
            keptAs_[i] = parts_.size();
            parts_.push_back(gathered_[i]);
        }
        candidates_.push_back({n, keptAs_[i], search.touching, candidates_.size(), surface.distance,
                               search.solid.path().start.getBasis() * surface.normal, reach});
    });
}

// Puts the candidates of each node side by side.
void SolidContacts::gatherNodes() {
    const auto isBefore = [](const Candidate& a, const Candidate& b) {
        return a.node != b.node ? a.node < b.node : a.rank < b.rank;
    };
    if (!std::is_sorted(candidates_.begin(), candidates_.end(), isBefore))
        std::sort(candidates_.begin(), candidates_.end(), isBefore);
    nodes_.clear();
    std::size_t slots = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
        if (nodes_.empty() || nodes_.back().node != candidates_[i].node) {
            if (!nodes_.empty()) slots += std::min(nodes_.back().candidates, maxContacts);
            nodes_.push_back({candidates_[i].node, i, 0, slots, 0});
        }
        ++nodes_.back().candidates;
    }
    if (!nodes_.empty()) slots += std::min(nodes_.back().candidates, maxContacts);
    contacts_.resize(slots);
    planes_.resize(slots);
}

void SolidContacts::choose(NodeContacts& of, const btVector3& position,
                           const std::vector<btTransform>& poses) {
    chosen_.clear();
    const auto isNearer = [](const Sight& a, const Sight& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.candidate < b.candidate;
    };
    if (!sights_.empty()) {
        std::iter_swap(sights_.begin(), std::min_element(sights_.begin(), sights_.end(), isNearer));
        chosen_.push_back(sights_.front());
        const auto end = removeBelowPlane(position, poses);
        std::sort(sights_.begin() + 1, end, isNearer);
        for (auto sight = sights_.begin() + 1; sight != end && chosen_.size() < maxContacts; ++sight)
            if (rises(*sight, position, poses)) chosen_.push_back(*sight);
    }
    of.contacts = chosen_.size();
}

// Of the other parts, mostly few rise above the plane of the nearest one.
// @return the end of those
std::vector<SolidContacts::Sight>::iterator SolidContacts::removeBelowPlane(
    const btVector3& position, const std::vector<btTransform>& poses) {
    const Sight& nearest = chosen_.front();
    std::size_t solid = notKept;  // of which these are
    btVector3 normal(0, 0, 0);
    btScalar height = 0;
    return std::remove_if(sights_.begin() + 1, sights_.end(), [&](const Sight& other) {
        const Candidate& candidate = candidates_[other.candidate];
        if (std::exchange(solid, candidate.touching) != candidate.touching) {
            const btTransform& pose = poses[candidate.touching];
            normal = nearest.normal * pose.getBasis();
            height = nearest.normal.dot(pose.getOrigin() - position) + nearest.distance;
        }
        return !risesAbove(parts_[candidate.part].farthestAlong(normal) + height, margin_);
    });
}

// Whether that part counts. Of a triangle the plane in which it lies then does, if the node may come to it: beyond its
// edges that plane does not belong to the surface.
bool SolidContacts::rises(Sight& other, const btVector3& position,
                          const std::vector<btTransform>& poses) const {
    const Candidate& candidate = candidates_[other.candidate];
    const SolidPart& part = parts_[candidate.part];
    const btTransform& pose = poses[candidate.touching];
    if (part.convex) return true;
    const btVector3 local = pose.invXform(position);
    const btVector3 normal = normalOfTriangle(part.corners, local);
    const btScalar height = normal.dot(local - part.corners[0]);
    const btScalar beside =
        std::sqrt(std::max(btScalar(0), other.distance * other.distance - height * height));
    if (beside > other.reach + margin_ / 4) return false;
    other.normal = pose.getBasis() * normal;
    other.distance = height;
    return std::none_of(chosen_.begin(), chosen_.end(), [&](const Sight& known) {
        const Candidate& knownCandidate = candidates_[known.candidate];
        return knownCandidate.touching == candidate.touching && faceAlike(known.normal, other.normal);
    });
}

void SolidContacts::writeContacts(const NodeContacts& of, const btVector3& position,
                                  const std::vector<btTransform>& poses, SmallStepSheet& sheet,
                                  const Solids& solids) {
    constexpr btScalar otherFace = btScalar(-0.5);
    for (std::size_t i = 0; i < of.contacts; ++i) {
        const Sight& sight = chosen_[i];
        const Candidate& candidate = candidates_[sight.candidate];
        const Touching& touching = touching_[candidate.touching];
        const Solid& solid = solids[touching.solid];
        Contact& contact = contacts_[of.firstContact + i];
        Plane& plane = planes_[of.firstContact + i];
        plane.candidate = sight.candidate;
        plane.rest = 0;
        contact.solid = static_cast<std::uint32_t>(touching.solid);
        contact.touched = false;
        contact.pressed = contact.pushed = 0;
        std::fill(contact.dragged, contact.dragged + 3, 0.0f);
        contact.isDragged = false;
        contact.friction = float(sheetFriction_->friction(touching.surface, of.node));
        // A face of the cloth adheres only once.
        const bool isFirstOfFace = i == 0 || chosen_.front().normal.dot(sight.normal) <= otherFace;
        contact.adhesion = isFirstOfFace ? float(sheetFriction_->adhesion(touching.surface, of.node)) : 0.0f;
        contact.adheres = contact.adhesion > 0 && sheetFriction_->adheresTo[of.node] == &solid.object();
        const btTransform& pose = poses[candidate.touching];
        writePlane(of.firstContact + i, pose.invXform(position - sight.normal * sight.distance),
                   sight.normal * pose.getBasis(), of.node, sheet, solid);
    }
}

// @param point, normal  in the coordinates of the solid
void SolidContacts::writePlane(std::size_t contact, const btVector3& point, const btVector3& normal,
                               std::size_t n, SmallStepSheet& sheet, const Solid& solid) {
    Contact& written = contacts_[contact];
    Plane& plane = planes_[contact];
    const btTransform& start = solid.path().start;
    const btVector3 atStart = start.getBasis() * normal;
    plane.arm = start.getBasis() * point;
    plane.offset = body_->m_nodes[static_cast<int>(n)].m_x - (start.getOrigin() + plane.arm);
    const btVector3 along = alongSolid(contact, n, sheet, solid);
    for (int axis = 0; axis < 3; ++axis) {
        written.normal[axis] = float(atStart[axis]);
        written.found[axis] = float(along[axis]);
    }
    written.gap = float(atStart.dot(plane.offset) - margin_ + plane.rest);
    written.response = float(solid.response(plane.arm, solid.turned(atStart)));
}

// Moves a node out without changing its velocity, and by at most the margin of the cloth at a time; the rest
// is left to the next substep.
void SolidContacts::lift(SmallStepSheet& sheet, const NodeContacts& of, const Solids& solids) {
    for (std::size_t i = of.firstContact; i < of.firstContact + of.contacts; ++i) {
        Contact& contact = contacts_[i];
        const Solid& solid = solids[contact.solid];
        const btScalar inside = -gapOf(i, solid, alongSolid(i, of.node, sheet, solid));
        constexpr auto near = btScalar(0.05);
        if (inside > -near * margin_) sheet.setCarried(of.node);
        if (inside <= 0) continue;
        contact.adheres = contact.adhesion > 0;
        const btScalar lifted = std::min(inside, margin_);
        sheet.place(of.node, vector(contact.normal) * lifted);
        planes_[i].rest = inside - lifted;
        contact.gap += float(inside - lifted);
    }
}

void SolidContacts::solve(SmallStepSheet& sheet, Solids& solids) {
    posesAreOfThisStep_ = false;
    sheet.clearCarried();
    for (NodeContacts& of : nodes_) solveNode(of, sheet, solids);
}

// Of a node along a solid in the small step, and how much both yield to a force along it, 1/kg.
inline SolidContacts::Slip SolidContacts::slipOf(std::size_t contact, SmallStepSheet& sheet, std::size_t n,
                                                 const Solid& solid, const btVector3& normal) const {
    Slip slip;
    slip.along = sheet.step(n);
    if (!solid.isStill()) slip.along -= solid.step(planes_[contact].arm);
    slip.along = alongSurface(slip.along, normal);
    slip.length = slip.along.length();
    slip.giving = btScalar(sheet.moved(n).inverseMass);
    // A solid that can rotate yields more to a tangential force than to a normal one.
    if (slip.length > 0 && solid.isMovable())
        slip.giving += solid.response(planes_[contact].arm, slip.along / slip.length);
    return slip;
}

void SolidContacts::carry(SmallStepSheet& sheet, Solids& solids) {
    for (const NodeContacts& of : nodes_)
        for (std::size_t i = of.firstContact; i < of.firstContact + of.contacts; ++i) {
            Contact& contact = contacts_[i];
            Solid& solid = solids[contact.solid];
            const btScalar depth = -gapOf(i, solid, alongSolid(i, of.node, sheet, solid));
            MovingNode& node = sheet.moved(of.node);
            const btScalar response = btScalar(node.inverseMass) + btScalar(contact.response);
            const bool isCarried = depth > 0 || contact.pushed > 0;
            if (!(isCarried && response > 0 && std::abs(depth) < std::numeric_limits<btScalar>::max()))
                continue;
            const btVector3 normal = solid.turned(vector(contact.normal));
            const btScalar more = std::max(depth, btScalar(0)) / response;
            contact.pushed += float(more);
            const btScalar most = lawOf(contact, sheet).maxFriction(btScalar(contact.pushed));
            const btVector3 push =
                normal * more + rub(contact, slipOf(i, sheet, of.node, solid, normal), most);
            contact.isDragged = true;
            shift(node, push * btScalar(node.inverseMass));
            if (!solid.isStill()) solid.push(planes_[i].arm, -push);
        }
}

void SolidContacts::solveNode(NodeContacts& of, SmallStepSheet& sheet, Solids& solids) {
    for (std::size_t i = of.firstContact; i < of.firstContact + of.contacts; ++i) {
        Solid& solid = solids[contacts_[i].solid];
        const btVector3 along = alongSolid(i, of.node, sheet, solid);
        const btScalar gap = gapOf(i, solid, along);
        // A convex part lies behind its tangent plane, so that plane need not be found again before the node
        // comes to it.
        const bool mayTouchElse = gap < 0 || of.candidates > 1;
        if (mayTouchElse && (along - vector(contacts_[i].found)).length2() > margin_ * margin_ / 4)
            return solveAnew(of, sheet, solids);
        solveContact(i, of.node, gap, sheet, solid);
    }
}

void SolidContacts::solveAnew(NodeContacts& of, SmallStepSheet& sheet, Solids& solids) {
    renew(of, sheet, solids);
    for (std::size_t i = of.firstContact; i < of.firstContact + of.contacts; ++i) {
        Solid& solid = solids[contacts_[i].solid];
        btScalar gap = gapOf(i, solid, alongSolid(i, of.node, sheet, solid));
        if (gap < 0) {
            if (!reaches(of, i, sheet, solid)) continue;
            gap = gapOf(i, solid, alongSolid(i, of.node, sheet, solid));
        }
        solveContact(i, of.node, gap, sheet, solid);
    }
}

void SolidContacts::solveContact(std::size_t contact, std::size_t n, btScalar gap, SmallStepSheet& sheet,
                                 Solid& solid) {
    Contact& solved = contacts_[contact];
    solved.adheres =
        adhesionHolds(double(solved.adhesion), solved.adheres || gap < 0, double(gap), double(reach_));
    // Not for values that are not finite either.
    const bool holds = gap < 0 || solved.adheres || solved.pushed > 0;
    if (!(holds && std::abs(gap) < std::numeric_limits<btScalar>::max())) return;
    solved.touched = true;
    solid.touch();
    hold(contact, sheet, n, solid, -gap);
}

btVector3 SolidContacts::alongSolid(std::size_t contact, std::size_t n, SmallStepSheet& sheet,
                                    const Solid& solid) const {
    const btVector3 moved = vectorOf(sheet.moved(n));
    return solid.isStill() ? moved : moved - solid.displacement(planes_[contact].arm);
}

btScalar SolidContacts::gapOf(std::size_t contact, const Solid& solid, const btVector3& along) const {
    const Contact& of = contacts_[contact];
    if (!solid.isTurning()) return btScalar(of.gap) + vector(of.normal).dot(along);
    const Plane& plane = planes_[contact];
    return solid.turned(vector(of.normal)).dot(plane.offset + along) - margin_ + plane.rest;
}

void SolidContacts::renew(NodeContacts& of, SmallStepSheet& sheet, const Solids& solids) {
    if (!posesAreOfThisStep_) {
        poses_.clear();
        for (const Touching& touching : touching_) poses_.push_back(solids[touching.solid].poseBefore());
        posesAreOfThisStep_ = true;
    }
    const btVector3 step = sheet.step(of.node);
    const btVector3 position =
        body_->m_nodes[static_cast<int>(of.node)].m_x + vectorOf(sheet.moved(of.node)) - step;
    sights_.clear();
    for (std::size_t i = 0; i < of.candidates; ++i) {
        const Candidate& candidate = candidates_[of.firstCandidate + i];
        const btTransform& pose = poses_[candidate.touching];
        const Solid& solid = solids[touching_[candidate.touching].solid];
        const SurfacePoint surface =
            nearestOn(parts_[candidate.part], pose.invXform(position), body_->m_worldInfo->m_sparsesdf);
        const btVector3 arm = solid.unturned(position - pose.getOrigin());
        sights_.push_back({of.firstCandidate + i, surface.distance, pose.getBasis() * surface.normal,
                           (step - solid.step(arm)).length()});
    }
    const auto first = static_cast<std::ptrdiff_t>(of.firstContact);
    const auto end = first + static_cast<std::ptrdiff_t>(of.contacts);
    contactsBefore_.assign(contacts_.begin() + first, contacts_.begin() + end);
    planesBefore_.assign(planes_.begin() + first, planes_.begin() + end);
    choose(of, position, poses_);
    writeContacts(of, position, poses_, sheet, solids);
    for (std::size_t i = 0; i < of.contacts; ++i)
        goOn(of.firstContact + i, std::max(btScalar(0), margin_ - chosen_[i].distance));
}

// A contact goes on with what it has been through in this substep, on the same part or on a neighbour that
// faces alike.
void SolidContacts::goOn(std::size_t contact, btScalar depth) {
    Contact& now = contacts_[contact];
    Plane& plane = planes_[contact];
    for (std::size_t i = 0; i < contactsBefore_.size(); ++i) {
        Contact& before = contactsBefore_[i];
        if (before.solid != now.solid) continue;
        if (planesBefore_[i].candidate != plane.candidate &&
            !faceAlike(vector(before.normal), vector(now.normal)))
            continue;
        now.touched = now.touched || before.touched;
        now.pressed += std::exchange(before.pressed, 0.0f);
        if (before.pushed > now.pushed) {
            now.pushed = before.pushed;
            std::copy(before.dragged, before.dragged + 3, now.dragged);
            now.isDragged = before.isDragged;
        }
        now.adheres = now.adhesion > 0 && (now.adheres || before.adheres);
        plane.rest = std::max(plane.rest, std::min(planesBefore_[i].rest, depth));
    }
    now.gap += float(plane.rest);
}

bool SolidContacts::reaches(const NodeContacts& of, std::size_t contact, SmallStepSheet& sheet,
                            const Solid& solid) {
    const btVector3 end = body_->m_nodes[static_cast<int>(of.node)].m_x + vectorOf(sheet.moved(of.node));
    const btVector3 from = solid.poseBefore().invXform(end - sheet.step(of.node));
    const btVector3 to = solid.pose().invXform(end);
    const btScalar length = (to - from).length();
    if (length < margin_ / 2) return true;
    // Conservative advancement: as far at a time as the surface is away.
    constexpr int most = 16;
    constexpr auto touching = btScalar(1.05);  // margins
    const std::size_t onSolid = candidates_[planes_[contact].candidate].touching;
    btScalar time = 0;
    SurfacePoint surface;
    btVector3 point;
    for (int i = 0; i < most; ++i) {
        point = from + (to - from) * time;
        surface = nearestOf(of, onSolid, point);
        if (surface.distance < touching * margin_) break;
        time += (surface.distance - margin_) / length;
        if (time >= 1) return false;
    }
    if (time > 0)
        writePlane(contact, point - surface.normal * surface.distance, surface.normal, of.node, sheet, solid);
    return true;
}

// The nearest surface point of the candidates of a node on one solid, in the coordinates of the solid.
SurfacePoint SolidContacts::nearestOf(const NodeContacts& of, std::size_t touching,
                                      const btVector3& point) const {
    SurfacePoint nearest = {BT_LARGE_FLOAT, {0, 1, 0}};
    for (std::size_t i = of.firstCandidate; i < of.firstCandidate + of.candidates; ++i) {
        if (candidates_[i].touching != touching) continue;
        const SurfacePoint found =
            nearestOn(parts_[candidates_[i].part], point, body_->m_worldInfo->m_sparsesdf);
        if (found.distance < nearest.distance) nearest = found;
    }
    return nearest;
}

// Friction together with what `carry` has applied in this small step.
// @return what is to be added to that, kg m
btVector3 SolidContacts::rub(Contact& contact, const Slip& slip, btScalar most) {
    const btVector3 before = vector(contact.dragged);
    btVector3 all = before;
    if (slip.length > 0) all -= slip.along / slip.giving;
    const btScalar needed = all.length();
    if (needed > most) all *= std::max(most, btScalar(0)) / needed;
    for (int axis = 0; axis < 3; ++axis) contact.dragged[axis] = float(all[axis]);
    return all - before;
}

void SolidContacts::hold(std::size_t contact, SmallStepSheet& sheet, std::size_t n, Solid& solid,
                         btScalar depth) {
    Contact& holding = contacts_[contact];
    MovingNode& node = sheet.moved(n);
    const btVector3 normal = solid.turned(vector(holding.normal));
    const auto inverseMass = btScalar(node.inverseMass);
    const ContactLaw law = lawOf(holding, sheet);
    // With what it has pushed before in this small step.
    const auto before = btScalar(std::exchange(holding.pushed, 0.0f));
    if (depth > 0 || before > 0) sheet.setCarried(n);
    const btScalar push = law.push(before + depth / (inverseMass + btScalar(holding.response)));
    holding.pressed += std::max(float(push), 0.0f);
    const btScalar most = law.maxFriction(push);
    const Slip slip = slipOf(contact, sheet, n, solid, normal);
    btVector3 total = normal * (push - before);
    if (holding.isDragged) {
        total += rub(holding, slip, most);
        std::fill(holding.dragged, holding.dragged + 3, 0.0f);
        holding.isDragged = false;
    } else if (slip.length > 0)
        total -= drag(slip.along, slip.length, slip.length / slip.giving, most);
    shift(node, total * inverseMass);
    if (!solid.isStill()) solid.push(planes_[contact].arm, -total);
}

ContactLaw SolidContacts::lawOf(const Contact& contact, const SmallStepSheet& sheet) {
    const auto h = btScalar(sheet.smallStep());
    return {btScalar(contact.friction), contact.adheres ? btScalar(contact.adhesion) * h * h : btScalar(0)};
}

btVector3 SolidContacts::normalOf(const Contact& contact, const Solids& solids) {
    return solids[contact.solid].turned(vector(contact.normal));
}

bool SolidContacts::hasTouched() const {
    return std::any_of(contacts_.begin(), contacts_.end(),
                       [](const Contact& contact) { return contact.touched; });
}

void SolidContacts::finish(btSoftBody& body, Friction& sheetFriction, const Solids& solids,
                           double substep) const {
    std::fill(sheetFriction.adheresTo.begin(), sheetFriction.adheresTo.end(), nullptr);
    for (const NodeContacts& of : nodes_)
        for (std::size_t i = of.firstContact; i < of.firstContact + of.contacts; ++i) {
            const Contact& contact = contacts_[i];
            if (!contact.touched) continue;
            const Solid& solid = solids[contact.solid];
            if (contact.adheres) sheetFriction.adheresTo[of.node] = &solid.object();
            const btVector3 normal = solid.turned(vector(contact.normal));
            const btVector3& arm = planes_[i].arm;
            const btVector3 point = solid.path().start.getOrigin() + arm + solid.displacement(arm);
            btSoftBody::RContact found;
            btSoftBody::Node& node = body.m_nodes[static_cast<int>(of.node)];
            found.m_cti.m_colObj = &solid.object();
            found.m_cti.m_normal = normal;
            found.m_cti.m_offset = -normal.dot(point) - margin_;
            found.m_node = &node;
            found.m_c0.setIdentity();
            found.m_c1 = solid.turned(arm);
            found.m_c2 = node.m_im * btScalar(substep);
            found.m_c3 = btScalar(contact.friction);
            found.m_c4 = 1;
            found.t1.setZero();
            found.t2.setZero();
            body.m_rcontacts.push_back(found);
        }
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
